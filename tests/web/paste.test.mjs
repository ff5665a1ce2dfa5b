// Every scene of the path tracer, pasted verbatim into a page that plays tabs as shadertoy.com does: it compiles there,
// and 16 frames with a hand on the mouse give the picture that `shadertwin render` gives.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { execFileSync } from 'node:child_process';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { openBrowser, openPage, pictureOf } from './browser.mjs';
import { compare } from './compare.mjs';
import { readExr } from './exr.mjs';
import { scenesOf, tabsOf, writeJson } from './tabs.mjs';

const here = path.dirname(fileURLToPath(import.meta.url));
const shaders = path.resolve(here, '../../shadertoy');
const shadertwin = process.env.SHADERTWIN ?? path.resolve(here, '../../build/shadertwin');

const size = { width: 96, height: 54 };
const frames = 16;
// Frame by frame what the hand does, in pixels from the lower left. The last one lets go. Short, so that the camera of a
// closed box stays inside.
const drag = [
  { frame: 3, x: 40, y: 20, down: true },
  { frame: 5, x: 43, y: 22, down: true },
  { frame: 8, x: 46, y: 27, down: true },
  { frame: 11, x: 46, y: 27, down: false },
];

// The two devices round differently, and a path that takes another turn gives another colour in that pixel. So few
// pixels may be far off, no more than a few slightly, and the mean must agree; a wrong uniform, binding, order of
// passes or sampler fails all three.
const limits = { far: 0.1, farPixels: 0.002, slight: 0.004, slightPixels: 0.005, mean: 0.0003 };

let browser, folder;
before(async () => {
  browser = await openBrowser();
  folder = mkdtempSync(path.join(tmpdir(), 'paste-'));
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

async function openSite(passes) {
  const page = await openPage(browser, size);
  await page.setContent(`<body style="margin:0"><canvas width="${size.width}" height="${size.height}"
    style="display:block"></canvas>`);
  await page.addScriptTag({ path: path.join(here, 'site.js') });
  const errors = await page.evaluate((tabs) => {
    window.site = new window.Site(document.querySelector('canvas'), tabs);
    return window.site.compile();
  }, passes);
  return { page, errors };
}

async function play(page) {
  await page.evaluate(() => window.site.load());
  for (let frame = 0; frame < frames; ++frame) {
    for (const { x, y, down } of drag.filter((step) => step.frame === frame)) {
      await page.mouse.move(x, size.height - y);
      await (down ? page.mouse.down() : page.mouse.up());
    }
    await page.evaluate((i) => window.site.step(i / 60, 1 / 60, [2024, 0, 1, i / 60]), frame);
  }
}

function render(arguments_, pass, hand = drag) {
  const output = path.join(folder, 'frame.exr');
  const mouse = hand.flatMap((s) => ['--mouse', `${s.x},${s.y}${s.down ? ',down' : ''}@${s.frame}`]);
  execFileSync(shadertwin, [
    'render', ...arguments_, '--quiet', '--on', 'llvmpipe/fragment', '--pass', pass, '--frames', String(frames),
    '--size', `${size.width}x${size.height}`, ...mouse, '-o', output,
  ]);
  return readExr(output);
}

// What the canvas would show of float colours.
function as8Bits(picture) {
  const rgba = picture.rgba.map((v) => Math.round(255 * Math.min(Math.max(v, 0), 1)) / 255);
  return { ...picture, rgba };
}

function assertAlike(t, name, browserPicture, ours) {
  const d = compare(browserPicture, ours, 3);
  const share = (limit) => d.above(limit) / d.pixels;
  t.diagnostic(
    `${name}: ${((100 * d.equal) / d.pixels).toFixed(1)} % of pixels equal, mean difference ${d.mean.toExponential(2)}, ` +
      `${(100 * share(limits.slight)).toFixed(2)} % above ${limits.slight}, ` +
      `${(100 * share(limits.far)).toFixed(2)} % above ${limits.far}, worst ${d.worst.toFixed(4)}` +
      (d.at ? ` at ${d.at}` : ''),
  );
  assert.ok(new Set(ours.rgba).size > 2, `${name}: the picture is empty`);
  assert.ok(share(limits.far) <= limits.farPixels, `${name}: too many pixels are far off`);
  assert.ok(share(limits.slight) <= limits.slightPixels, `${name}: too many pixels are off`);
  assert.ok(d.mean <= limits.mean, `${name}: the mean difference is too large`);
}

const scenes = scenesOf(shaders);

test('the scenes are found', () => assert.ok(scenes.length > 0));

for (const { number, file } of scenes)
  test(`scene ${number} pastes`, async (t) => {
    const passes = tabsOf(shaders, file);
    const { page, errors } = await openSite(passes);
    assert.deepEqual(errors, []);
    await play(page);
    const scene = [path.join(shaders, 'image.glsl'), '-D', `SCENE=${number}`];
    for (const pass of passes.filter((p) => p.type !== 'common')) {
      const shown = pictureOf(await page.evaluate((name) => window.site.read(name), pass.name));
      const ours = render(scene, path.basename(pass.file, '.glsl'));
      assertAlike(t, pass.name, shown, pass.type === 'image' ? as8Bits(ours) : ours);
      if (pass.type !== 'image') continue;
      const untouched = compare(shown, as8Bits(render(scene, 'image', [])), 3);
      assert.ok(untouched.mean > 10 * limits.mean, 'the hand on the mouse changes the picture');
    }
    assert.deepEqual(page.problems, []);
    await page.context().close();
  });

// Tabs made in the order of their letters, as one does: the path tracer then sees the camera of the frame before.
test('the tabs give the same picture when the path tracer comes before its camera', async (t) => {
  const passes = tabsOf(shaders, scenes[1].file).sort((a, b) => (a.name < b.name ? -1 : 1));
  const { page, errors } = await openSite(passes);
  assert.deepEqual(errors, []);
  await play(page);
  const shader = writeJson(passes, folder);
  for (const { name } of passes.filter((p) => p.type === 'buffer'))
    assertAlike(t, name, pictureOf(await page.evaluate((pass) => window.site.read(pass), name)), render([shader], name));
  await page.context().close();
});

// The test can fail: the page does not forgive what the site does not.
test('what shadertoy.com rejects is rejected, with the tab and its line', async () => {
  const common = { name: 'Common', type: 'common', code: 'float half_of(float x)\n{ return 0.5 * x; }\n', inputs: [] };
  const image = (code) => ({ name: 'Image', type: 'image', code, inputs: [] });
  const entry = 'void mainImage(out vec4 c, in vec2 f)\n';
  const reject = async (passes, place) => {
    const { page, errors } = await openSite(passes);
    assert.ok(errors.length > 0 && errors[0].startsWith(place), `expected ${place}, not ${errors[0]}`);
    await page.context().close();
  };
  await reject([common, image(`${entry}{\n    c = vec4(half_of(1));\n}\n`)], 'Image:3: ');
  await reject([common, image(`#iChannel0 "self"\n${entry}{ c = vec4(1.0); }\n`)], 'Image:1: ');
  await reject([{ ...common, code: '\nfloat now() { return iTime; }\n' }, image(`${entry}{ c = vec4(0.0); }`)], 'Common:2: ');
  await reject([image(`${entry}{ c = vec4(saturate(2.0)); }`)], 'Image:2: ');
});
