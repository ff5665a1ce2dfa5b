// The green cases (tests/emit/shaders/green), exported as pages: right values are right in a browser, too.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { openBrowser } from './browser.mjs';
import { openPlayer, playFrames, readPass, shadertwin } from './player.mjs';

const cases = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../emit/shaders/green');

// What GLSL leaves undefined (reference/glsl/README.md) is the browser's own in a page: these have to compile there.
const undefinedInGlsl = new Set(
  [
    'beyond-integers', 'constant-division', 'crossed-bounds', 'integer-division', 'modulo-by-zero', 'outside-of-domains',
    'power-of-zero', 'remainder', 'shifts-beyond-range', 'zero-numerator',
  ].map((name) => `${name}.glsl`),
);

let browser, folder;
before(async () => {
  browser = await openBrowser();
  folder = mkdtempSync(path.join(tmpdir(), 'green-'));
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

const files = readdirSync(cases);
test('there are green cases', () => assert.ok(files.length > 0));

for (const file of files) {
  test(file, async () => {
    const html = path.join(folder, `${file}.html`);
    execFileSync(shadertwin, [
      'export', path.join(cases, file), '--dialect', 'shadertoy', '--quiet', '--to', 'html', '-o', html,
    ]);
    const page = await openPlayer(browser, html, [64, 8]);
    assert.deepEqual(page.messages, []);
    await playFrames(page, { frames: 1 });
    const { rgba } = await readPass(page, file.endsWith('.json') ? 'Image' : path.basename(file, '.glsl'));
    assert.equal(rgba.length, 4 * 64 * 8);
    if (!undefinedInGlsl.has(file)) assert.equal([...rgba].filter((value, i) => value !== [0, 1, 0, 1][i % 4]).length, 0);
  });
}
