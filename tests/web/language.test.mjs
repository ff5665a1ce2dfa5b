// The language's constructs, tests/emit/shaders, in the page that plays tabs as shadertoy.com does: the browser's own
// compiler gets the text as it stands, and draws what `shadertwin render` draws.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { openBrowser, openPage, pictureOf } from './browser.mjs';
import { readExr } from './exr.mjs';
import { shadertwin } from './player.mjs';

const here = path.dirname(fileURLToPath(import.meta.url));
const shaders = path.resolve(here, '../emit/shaders');
const size = { width: 20, height: 12 };
// The browser's elementary functions are not Mesa's: relative to the value, or to 1 for smaller ones.
const tolerance = 2e-3;

let browser, folder, page;
before(async () => {
  browser = await openBrowser();
  page = await openPage(browser, size);
  await page.setContent('<body style="margin:0">');
  await page.addScriptTag({ path: path.join(here, 'site.js') });
  folder = mkdtempSync(path.join(tmpdir(), 'language-'));
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

// The shader as Buffer A, so that its floats can be read.
const image = 'void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }\n';

async function inBrowser(code) {
  const input = { channel: 0, type: 'buffer', source: 'Buffer A', sampler: { filter: 'nearest', wrap: 'clamp' } };
  const tabs = [
    { name: 'Buffer A', type: 'buffer', code, inputs: [] },
    { name: 'Image', type: 'image', code: image, inputs: [input] },
  ];
  const errors = await page.evaluate(
    ([passes, { width, height }]) => {
      const canvas = Object.assign(document.createElement('canvas'), { width, height });
      document.body.replaceChildren(canvas);
      window.site = new window.Site(canvas, passes);
      return window.site.compile();
    },
    [tabs, size],
  );
  assert.deepEqual(errors, []);
  await page.evaluate(async () => {
    await window.site.load();
    window.site.step(0, 1 / 60, [2024, 0, 1, 0]);
  });
  return pictureOf(await page.evaluate(() => window.site.read('Buffer A')));
}

function rendered(name, code) {
  const project = path.join(folder, name);
  mkdirSync(project);
  writeFileSync(path.join(project, 'buffer_a.glsl'), code);
  writeFileSync(path.join(project, 'image.glsl'), image);
  writeFileSync(path.join(project, 'shadertoy.json'), '{"Image": {"iChannel0": {"buffer": "Buffer A"}}}');
  const output = path.join(folder, `${name}.exr`);
  execFileSync(shadertwin, [
    'render', project, '--quiet', '--on', 'llvmpipe/fragment', '--pass', 'Buffer A',
    '--size', `${size.width}x${size.height}`, '-o', output,
  ]);
  return readExr(output);
}

for (const file of readdirSync(shaders).filter((name) => name.endsWith('.glsl'))) {
  const code = readFileSync(path.join(shaders, file), 'utf8');
  if (/^\s*#i[A-Z]/m.test(code)) continue; // the extension's directives
  if (code.includes('Not for browsers')) continue;
  test(path.basename(file, '.glsl'), async () => {
    const a = await inBrowser(code);
    const b = rendered(path.basename(file, '.glsl'), code);
    const apart = [];
    a.rgba.forEach((x, i) => {
      const y = b.rgba[i];
      const near = Math.abs(x - y) <= tolerance * Math.max(1, Math.abs(x), Math.abs(y));
      if (!near && !Object.is(x, y) && x !== y) apart.push(`${Math.floor(i / 4)}[${i % 4}]: ${x}, here ${y}`);
    });
    assert.ok(new Set(a.rgba).size > 2, 'the picture is empty');
    assert.deepEqual(apart.slice(0, 4), []);
  });
}
