// Music as the browser's own AnalyserNode hears it, volumes as its WebGL2 samples them, against what shadertwin makes.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';

import { openBrowser } from './browser.mjs';
import { readExr } from './exr.mjs';
import { openPlayer, playFrames, readPass, renderPass, shadertwin } from './player.mjs';

const rate = 44100;
const step = 6 * 128; // samples a frame: whole quanta, in which Web Audio works
const frames = 40;

let browser, folder;
before(async () => {
  browser = await openBrowser();
  folder = mkdtempSync(path.join(tmpdir(), 'media-'));
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

// 16-bit stereo: a chirp that fades, a beat of noise, and a pause.
function makeWav(samples) {
  const bytes = Buffer.alloc(44 + 4 * samples);
  bytes.write('RIFF', 0);
  bytes.writeUInt32LE(36 + 4 * samples, 4);
  bytes.write('WAVEfmt ', 8);
  bytes.writeUInt32LE(16, 16);
  bytes.writeUInt16LE(1, 20);
  bytes.writeUInt16LE(2, 22);
  bytes.writeUInt32LE(rate, 24);
  bytes.writeUInt32LE(4 * rate, 28);
  bytes.writeUInt16LE(4, 32);
  bytes.writeUInt16LE(16, 34);
  bytes.write('data', 36);
  bytes.writeUInt32LE(4 * samples, 40);
  let seed = 1;
  for (let i = 0; i < samples; ++i) {
    const t = i / rate;
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    const noise = t % 0.25 < 0.03 ? seed / 2 ** 31 - 1 : 0;
    const chirp = Math.sin(2 * Math.PI * (200 + 8000 * t) * t) * Math.exp(-2 * t);
    const loud = t > 0.35 && t < 0.4 ? 0 : 1;
    bytes.writeInt16LE(Math.round(20000 * loud * (0.7 * chirp + 0.3 * noise)), 44 + 4 * i);
    bytes.writeInt16LE(Math.round(20000 * loud * 0.5 * noise), 46 + 4 * i);
  }
  return bytes;
}

const toy = JSON.stringify({
  Shader: {
    renderpass: [
      {
        name: 'Image',
        type: 'image',
        inputs: [{ id: 1, channel: 0, ctype: 'music', src: '/media/a/music.wav' }],
        outputs: [{ id: 37, channel: 0 }],
        code: 'void mainImage(out vec4 c, vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }',
      },
    ],
  },
});
const file = '#iChannel0 "music.wav"\nvoid mainImage(out vec4 c, vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }\n';

// [spectrum, wave] of each frame, of the file played in a loop: what the page of the shader makes of it.
async function analysedInBrowser(wav, shader, site) {
  const html = path.join(folder, `${path.basename(shader)}.html`);
  execFileSync(shadertwin, ['export', shader, '--quiet', '--to', 'html', '-o', html]);
  const page = await openPlayer(browser, html, [64, 64]);
  assert.deepEqual(page.messages, []);
  const result = await page.evaluate(
    async ({ base64, rate, step, frames, site }) => {
      const context = new OfflineAudioContext(2, step * (frames + 1), rate);
      const source = context.createBufferSource();
      source.buffer = await context.decodeAudioData(Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)).buffer);
      source.loop = true;
      const { analyser, fill } = window.shadertwin.analysed(source, site);
      analyser.connect(context.destination);
      source.start();
      const heard = [];
      for (let i = 0; i < frames; ++i)
        context.suspend((i * step) / rate).then(() => {
          const values = new Uint8Array(1024);
          fill(values);
          heard.push([[...values.subarray(0, 512)], [...values.subarray(512)]]);
          context.resume();
        });
      await context.startRendering();
      return heard;
    },
    { base64: wav.toString('base64'), rate, step, frames, site },
  );
  return result;
}

function analysedHere(shader) {
  execFileSync(shadertwin, [
    'render', shader, '--quiet', '--size', '512x2', '--frames', String(frames),
    '--fps', String(rate / step), '-o', path.join(folder, 'frame_%02d.exr'),
  ]);
  return [...Array(frames).keys()].map((i) => {
    const { rgba } = readExr(path.join(folder, `frame_${String(i).padStart(2, '0')}.exr`));
    const row = (y) => [...Array(512).keys()].map((x) => Math.round(255 * rgba[4 * (512 * y + x)]));
    return [row(0), row(1)];
  });
}

for (const [name, text, site] of [['toy.json', toy, true], ['file.glsl', file, false]])
  test(`music is what the browser's analyser hears, also when it starts again: ${name}`, async () => {
    const wav = makeWav(step * 25 + 301); // it starts again between two frames
    writeFileSync(path.join(folder, 'music.wav'), wav);
    const shader = path.join(folder, name);
    writeFileSync(shader, text);
    const there = await analysedInBrowser(wav, shader, site);
    const here = analysedHere(shader);
    assert.equal(there.length, frames);
    assert.ok(there[20][0].some((level) => level > 150), 'there is something to hear');
    let differing = 0;
    for (let i = 0; i < frames; ++i) {
      assert.deepEqual(here[i][1], there[i][1], `wave of frame ${i}`);
      for (let bin = 0; bin < 512; ++bin) {
        const distance = Math.abs(here[i][0][bin] - there[i][0][bin]);
        assert.ok(distance <= 1, `frame ${i}, bin ${bin}: ${here[i][0][bin]} instead of ${there[i][0][bin]}`);
        differing += distance;
      }
    }
    // The browser's FFT has floats: a level may fall on the other side of a whole number.
    assert.ok(differing <= 0.002 * 512 * frames, `${differing} of ${512 * frames} levels differ by one`);
  });

// The .bin that shadertoy.com serves.
function makeVolume(size, channels) {
  const bytes = Buffer.alloc(20 + size ** 3 * channels);
  bytes.write('BIN\0', 0);
  for (let axis = 0; axis < 3; ++axis) bytes.writeUInt32LE(size, 4 + 4 * axis);
  bytes.writeUInt8(channels, 16);
  for (let i = 20; i < bytes.length; ++i) bytes[i] = Math.imul(i, 2654435761) >>> 24;
  return bytes;
}

test('a volume is sampled as in WebGL2, with every filter and wrap', async () => {
  const toy = path.join(folder, 'volumes');
  mkdirSync(toy);
  writeFileSync(path.join(toy, 'grey.bin'), makeVolume(8, 1));
  writeFileSync(path.join(toy, 'colour.bin'), makeVolume(4, 4));
  writeFileSync(
    path.join(toy, 'shadertoy.json'),
    JSON.stringify({
      'Buffer A': {
        iChannel0: { volume: 'grey.bin', filter: 'mipmap', wrap: 'repeat' },
        iChannel1: { volume: 'colour.bin', filter: 'linear', wrap: 'clamp' },
        iChannel2: { volume: 'colour.bin', filter: 'nearest', wrap: 'repeat' },
      },
      Image: { iChannel0: { buffer: 'Buffer A' } },
    }),
  );
  writeFileSync(path.join(toy, 'image.glsl'), 'void mainImage(out vec4 c, vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }');
  writeFileSync(
    path.join(toy, 'buffer_a.glsl'),
    `void mainImage(out vec4 c, vec2 p) {
      vec3 q = vec3(p / 5. - .7, .3 + p.x * .01);
      if (p.y < 4.) c = textureLod(iChannel0, q, floor(p.x / 4.));
      else if (p.y < 8.) c = textureLod(iChannel1, q, 0.);
      else if (p.y < 12.) c = textureLod(iChannel2, q, 0.);
      else c = vec4(iChannelResolution[0], texelFetch(iChannel0, ivec3(p.x, p.y - 12., 3), 0).g);
    }`,
  );
  const page = path.join(folder, 'volumes.html');
  execFileSync(shadertwin, ['export', toy, '--quiet', '--to', 'html', '-o', page]);
  const script = { size: [16, 16], frames: 1 };
  const player = await openPlayer(browser, page, script.size);
  assert.deepEqual(player.messages, []);
  await playFrames(player, script);
  const there = await readPass(player, 'Buffer A');
  const here = renderPass(toy, 'Buffer A', script, path.join(folder, 'volumes.exr'));
  assert.equal(here.rgba[4 * (16 * 12)], 8);
  for (let i = 0; i < there.rgba.length; ++i) {
    // Renderers weigh neighbours in 8 bits at the least.
    const distance = Math.abs(there.rgba[i] - here.rgba[i]);
    assert.ok(distance <= 3 / 255, `value ${i}: ${here.rgba[i]} instead of ${there.rgba[i]}`);
  }
});
