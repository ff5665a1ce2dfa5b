// One fact of shadertoy.com's semantics a probe: a small project in probes/NAME, played in the browser by the page that
// `export --to html` writes and by `shadertwin render`. Both must give what probe.json expects; where the latter can't
// yet, its `todo` says why.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { openBrowser } from './browser.mjs';
import { openPlayer, playFrames, readPass, renderPass, shadertwin } from './player.mjs';

const probes = path.join(path.dirname(fileURLToPath(import.meta.url)), 'probes');

let browser, folder;
before(async () => {
  browser = await openBrowser();
  folder = mkdtempSync(path.join(tmpdir(), 'probes-'));
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

function valueAt(picture, [x, y]) {
  const at = 4 * (y * picture.width + x);
  return [...picture.rgba.subarray(at, at + 4)];
}

// wanted: [{ pixel: [x, y], value: [r, g, b, a] }]; null in a value is anything.
function mismatches(picture, wanted, tolerance) {
  return wanted.flatMap(({ pixel, value }) => {
    const found = valueAt(picture, pixel);
    const near = (a, b) => a === null || Math.abs(Math.fround(a) - b) <= tolerance;
    return value.every((wanted, i) => near(wanted, found[i])) ? [] : [`${pixel}: ${found} instead of ${value}`];
  });
}

for (const name of readdirSync(probes).filter((name) => name.includes(process.env.PROBE ?? ''))) {
  const probe = { size: [8, 8], frames: 1, tolerance: 0, ...JSON.parse(readFileSync(path.join(probes, name, 'probe.json'))) };
  test(`${name}: ${probe.fact}`, async (t) => {
    const shader = path.join(probes, name, probe.shader ?? '');
    const page = path.join(folder, `${name}.html`);
    execFileSync(shadertwin, ['export', shader, '--quiet', '--to', 'html', '-o', page, ...(probe.options ?? [])]);
    const player = await openPlayer(browser, page, probe.size);
    assert.deepEqual(player.messages, []);
    await playFrames(player, probe);
    assert.deepEqual(player.problems, []);
    const inBrowser = [];
    const here = [];
    for (const [pass, wanted] of Object.entries(probe.expect)) {
      inBrowser.push(...mismatches(await readPass(player, pass), wanted, probe.tolerance));
      here.push(...mismatches(renderPass(shader, pass, probe, path.join(folder, 'probe.exr')), wanted, probe.tolerance));
    }
    assert.deepEqual(inBrowser, [], 'in the browser');
    await t.test('shadertwin render', { todo: probe.todo }, () => assert.deepEqual(here, []));
  });
}
