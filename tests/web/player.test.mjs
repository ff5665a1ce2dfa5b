// The page that `shadertwin export --to html` writes, as people use it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, afterEach, before, test } from 'node:test';

import { openBrowser, openPage } from './browser.mjs';
import { readPass, shadertwin } from './player.mjs';

let browser, folder;
before(async () => {
  browser = await openBrowser();
  folder = mkdtempSync(path.join(tmpdir(), 'player-'));
});
// A page that nobody looks at any more would play on.
afterEach(() => Promise.all(browser.contexts().map((context) => context.close())));
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

// files: name -> text. The page of the folder of tabs, or of the file `entry` in it. `first`: a function that runs in it
// before its own scripts.
async function open(name, files, { hash = '', entry = '', options = [], first = () => {} } = {}) {
  const project = path.join(folder, name);
  mkdirSync(project);
  for (const [file, text] of Object.entries(files)) writeFileSync(path.join(project, file), text);
  const html = path.join(folder, `${name}.html`);
  execFileSync(shadertwin, ['export', path.join(project, entry), '--quiet', '--to', 'html', '-o', html, ...options]);
  const page = await openPage(browser, { width: 320, height: 216 });
  await page.addInitScript(first);
  await page.goto(`file://${html}${hash}`);
  page.messages = await page.evaluate(() => window.shadertwin.ready);
  return page;
}

const head = 'void mainImage(out vec4 c, in vec2 p)\n';
const showBuffer = `${head}{ c = texelFetch(iChannel0, ivec2(p), 0); }\n`;
const bindings = JSON.stringify({ Image: { iChannel0: { buffer: 'Buffer A' } }, 'Buffer A': { iChannel0: { buffer: 'Buffer A' } } });
const withBuffer = (body) => ({
  'image.glsl': showBuffer,
  'buffer_a.glsl': `${head}{\n    vec4 last = texelFetch(iChannel0, ivec2(p), 0);\n    ${body}\n}\n`,
  'shadertoy.json': bindings,
});

async function texel(page, x = 0, y = 0) {
  const { width, rgba } = await readPass(page, 'Buffer A');
  return [...rgba.subarray(4 * (y * width + x), 4 * (y * width + x) + 4)];
}

test('it plays by itself; the first frame is number 0 at time 0, and said to be 1/60 long', async () => {
  const page = await open('plays', withBuffer('c = iFrame == 0 ? vec4(iTime, iTimeDelta, 0.0, 0.0) : vec4(last.xy, iTime, iFrame);'));
  assert.deepEqual(page.messages, []);
  await page.waitForFunction(() => Number(document.getElementById('time').textContent) > 0.2);
  const [first, delta, time, frame] = await texel(page);
  assert.deepEqual([first, delta], [0, Math.fround(1 / 60)]);
  assert.ok(time > 0 && frame > 0);
  assert.match(await page.textContent('#size'), /^320 × 180$/);
  assert.deepEqual(page.problems, []);
});

test('pause stops time and frames, reset starts again from cleared buffers', async () => {
  const page = await open('pause', withBuffer('c = last + vec4(1.0, 0.0, 0.0, 0.0);\n    c.y = float(iFrame);'));
  await page.waitForFunction(() => Number(document.getElementById('time').textContent) > 0.1);
  await page.click('#pause');
  const [count, frame] = await texel(page);
  assert.equal(count, frame + 1);
  await page.waitForTimeout(200);
  assert.equal((await texel(page))[0], count);
  await page.click('#reset');
  await page.evaluate(() => window.shadertwin.step(0));
  assert.deepEqual((await texel(page)).slice(0, 2), [1, 0]);
});

test('it plays the samples of a Sound pass', async () => {
  const recordStart = () => {
    const { start } = AudioBufferSourceNode.prototype;
    AudioBufferSourceNode.prototype.start = function (...when) {
      window.played = this.buffer;
      return start.apply(this, when);
    };
  };
  const page = await open(
    'sound',
    {
      'image.glsl': `${head}{ c = vec4(1.0); }\n`,
      'sound.glsl': 'vec2 mainSound(int s, float t) { return vec2(float(s % 1024) / 1024.0, -0.5 * t); }\n',
    },
    { first: recordStart },
  );
  await page.waitForFunction(() => window.played);
  const samples = await page.evaluate(() => [0, 1].map((side) => [1, 44100, 400000].map((i) => window.played.getChannelData(side)[i])));
  assert.deepEqual(samples[0], [1 / 1024, 68 / 1024, 640 / 1024]);
  assert.ok(Math.abs(samples[1][1] + 0.5) < 1e-6);
  assert.equal(samples[1][2], -1);
  assert.deepEqual(page.problems, []);
});

test('reset clears the mipmaps of a buffer, too', async () => {
  const page = await open(
    'mipmaps',
    {
      'image.glsl': showBuffer,
      'buffer_a.glsl': `${head}{ c = vec4(textureLod(iChannel0, vec2(0.5), 3.0).x, iFrame, 0.0, 0.0); }\n`,
      'buffer_b.glsl': `${head}{ c = vec4(1.0); }\n`,
      'shadertoy.json': JSON.stringify({
        Image: { iChannel0: { buffer: 'Buffer A' } },
        'Buffer A': { iChannel0: { buffer: 'Buffer B', filter: 'mipmap' } },
      }),
    },
    { hash: '#paused' },
  );
  for (const expected of [0, 1]) {
    await page.evaluate((now) => window.shadertwin.step(now), 20 * expected);
    assert.deepEqual((await texel(page)).slice(0, 2), [expected, expected]);
  }
  await page.evaluate(() => window.shadertwin.reset());
  await page.evaluate(() => window.shadertwin.step(40));
  assert.deepEqual((await texel(page)).slice(0, 2), [0, 0]);
});

test('with the quirks of VS Code a resize restarts, and iChannelResolution stays', async () => {
  const page = await open(
    'quirks',
    {
      'main.glsl': `#iChannel0 "buffer.glsl"\n#iChannel1 "self"\n${head}{ c = vec4(iChannelResolution[0].xy, iFrame, textureSize(iChannel0, 0).x); }\n`,
      'buffer.glsl': `${head}{ c = vec4(1.0); }\n`,
    },
    { hash: '#paused', entry: 'main.glsl', options: ['--vscode-quirks'] },
  );
  const values = async () => [...(await readPass(page, 'main')).rgba.subarray(0, 4)];
  for (const now of [0, 20]) await page.evaluate((time) => window.shadertwin.step(time), now);
  assert.deepEqual(await values(), [320, 180, 1, 320]);
  await page.setViewportSize({ width: 400, height: 236 });
  await page.waitForFunction(() => document.querySelector('canvas').width === 400);
  await page.evaluate(() => window.shadertwin.step(40));
  assert.deepEqual(await values(), [320, 180, 0, 400]);
  await page.evaluate(() => window.shadertwin.reset());
  await page.evaluate(() => window.shadertwin.step(60));
  assert.deepEqual(await values(), [400, 200, 0, 400]);
});

test('iDate is local time with months from 0', async () => {
  const page = await open('date', withBuffer('c = iDate;'), { hash: '#paused' });
  await page.evaluate(() => window.shadertwin.step(0));
  const [year, month, day, seconds] = await texel(page);
  const now = new Date();
  const midnight = new Date(now.getFullYear(), now.getMonth(), now.getDate());
  assert.ok(Math.abs(new Date(year, month, day).getTime() + 1000 * seconds - midnight - (now - midnight)) < 60000);
});

test('a window that grows keeps the buffer from the lower left, and counts on', async () => {
  const page = await open('grows', withBuffer('c = iFrame == 0 ? vec4(p, 1.0, 0.0) : vec4(last.xyz, iFrame);'), { hash: '#paused' });
  for (const now of [0, 20]) await page.evaluate((time) => window.shadertwin.step(time), now);
  await page.setViewportSize({ width: 400, height: 236 });
  await page.waitForFunction(() => document.querySelector('canvas').width === 400);
  await page.evaluate(() => window.shadertwin.step(40));
  const [x, y, drawn, frame] = await texel(page, 319, 179);
  assert.deepEqual([x, y, drawn], [319.5, 179.5, 1]);
  assert.ok(frame > 0);
  assert.deepEqual((await texel(page, 399, 199)).slice(0, 3), [0, 0, 0]);
});

test('a resize may go back to the older of the two pictures of a buffer, once', async () => {
  const page = await open('older', withBuffer('c = last + vec4(1.0, 0.0, 0.0, 0.0);'), { hash: '#paused' });
  for (let frame = 0; frame < 3; ++frame) await page.evaluate((now) => window.shadertwin.step(now), 20 * frame);
  assert.equal((await texel(page))[0], 3);
  await page.setViewportSize({ width: 400, height: 236 });
  await page.waitForFunction(() => document.querySelector('canvas').width === 400);
  assert.equal((await texel(page))[0], 3, 'the first picture, which is the older one after three frames, and one frame more');
});

test('a tap on a key between two frames shows in the toggle row only', async () => {
  const page = await open(
    'tap',
    {
      ...withBuffer('c = vec4(texelFetch(iChannel1, ivec2(65, 0), 0).x, texelFetch(iChannel1, ivec2(65, 1), 0).x, texelFetch(iChannel1, ivec2(65, 2), 0).x, 1.0);'),
      'shadertoy.json': JSON.stringify({ Image: { iChannel0: { buffer: 'Buffer A' } }, 'Buffer A': { iChannel0: { buffer: 'Buffer A' }, iChannel1: { keyboard: true } } }),
    },
    { hash: '#paused' },
  );
  await page.keyboard.press('a');
  await page.evaluate(() => window.shadertwin.step(0));
  assert.deepEqual(await texel(page), [0, 0, 1, 1]);
});

test('Control and what is pressed with it are keys', async () => {
  const page = await open(
    'control',
    {
      ...withBuffer('c = vec4(texelFetch(iChannel1, ivec2(17, 0), 0).x, texelFetch(iChannel1, ivec2(66, 0), 0).x, texelFetch(iChannel1, ivec2(66, 1), 0).x, 0.0);'),
      'shadertoy.json': JSON.stringify({ Image: { iChannel0: { buffer: 'Buffer A' } }, 'Buffer A': { iChannel0: { buffer: 'Buffer A' }, iChannel1: { keyboard: true } } }),
    },
    { hash: '#paused' },
  );
  await page.keyboard.down('Control');
  await page.keyboard.down('b');
  await page.evaluate(() => window.shadertwin.step(0));
  assert.deepEqual(await texel(page), [1, 1, 1, 0]);
  await page.keyboard.up('b');
  await page.keyboard.up('Control');
  await page.evaluate(() => window.shadertwin.step(20));
  assert.deepEqual(await texel(page), [0, 0, 0, 0]);
});

test('errors name the user\'s own file and line, also in an include', async () => {
  const page = await open(
    'errors',
    {
      'image.glsl': `#include "shared.glsl"\n${head}{\n    c = vec4(missing(p), 1.0);\n}\n`,
      'shared.glsl': '\n\nfloat half_of(float x) { return 1 * x; }\n',
    },
    { entry: 'image.glsl' },
  );
  assert.match(page.messages[0], /shared\.glsl:3: error: /);
  assert.match(page.messages.at(-2), /image\.glsl:4: error: 'missing'/);
  assert.equal(await page.textContent('#message'), page.messages.join('\n'));
});

test('a slider changes its uniform', async () => {
  const page = await open(
    'slider',
    { 'image.glsl': `#iUniform float level = 0.25 in { 0.0, 1.0 }\n#iChannel0 "self"\n${head}{ c = vec4(level); }\n` },
    { hash: '#paused', entry: 'image.glsl' },
  );
  await page.evaluate(() => window.shadertwin.step(0));
  assert.equal((await readPass(page, 'image')).rgba[0], 0.25);
  await page.fill('#uniforms input', '0.75');
  assert.equal((await readPass(page, 'image')).rgba[0], 0.75);
});
