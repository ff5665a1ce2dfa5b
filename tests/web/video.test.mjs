// Videos: Chromium shows of ours what was drawn, and we show of a video what Chromium shows.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';

import { openBrowser, openPage, pictureOf } from './browser.mjs';
import { readExr } from './exr.mjs';
import { shadertwin } from './player.mjs';

// Fields of colours; after half a second in another order, so that a wrong frame shows.
const colours = [[200, 40, 90], [20, 180, 60], [30, 60, 220], [240, 240, 16], [128, 128, 128], [255, 255, 255], [0, 0, 0], [255, 0, 0]];
const fields = `void mainImage(out vec4 c, in vec2 p) {
  vec3 t[8] = vec3[8](${colours.map((c) => `vec3(${c})`).join(', ')});
  c = vec4(t[(int(p.x / 32.) + (iTime < .5 ? 0 : 3)) % 8] / 255., 1);
}\n`;
const size = [256, 64];

let browser, folder;
before(async () => {
  browser = await openBrowser();
  folder = mkdtempSync(path.join(tmpdir(), 'video-'));
  writeFileSync(path.join(folder, 'fields.glsl'), fields);
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

const render = (...args) => execFileSync(shadertwin, ['render', ...args], { cwd: folder });

// The texels that WebGL2 gets of the video at a moment.
async function inBrowser(name, seconds) {
  const page = await openPage(browser, { width: 320, height: 200 });
  const url = `data:video/${name.split('.').pop()};base64,${readFileSync(path.join(folder, name)).toString('base64')}`;
  return pictureOf(
    await page.evaluate(
      async ([source, moment]) => {
        const video = document.createElement('video');
        video.muted = true;
        video.src = source;
        await new Promise((ready, failed) => {
          video.onloadeddata = ready;
          video.onerror = () => failed(new Error(video.error.message));
        });
        video.currentTime = moment;
        await new Promise((ready) => (video.onseeked = ready));
        const { videoWidth: width, videoHeight: height } = video;
        const gl = document.createElement('canvas').getContext('webgl2');
        gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
        gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, true);
        gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, video);
        const texture = gl.getParameter(gl.TEXTURE_BINDING_2D);
        gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
        const bytes = new Uint8Array(4 * width * height);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
        const floats = new Uint8Array(Float32Array.from(bytes).buffer);
        let text = '';
        for (const byte of floats) text += String.fromCharCode(byte);
        return { width, height, base64: btoa(text) };
      },
      [url, seconds],
    ),
  );
}

// The same through a channel, in bytes.
function here(name, seconds) {
  writeFileSync(
    path.join(folder, 'show.glsl'),
    `#iChannel0 "${name}"\nvoid mainImage(out vec4 c, in vec2 p) { c = 255. * texelFetch(iChannel0, ivec2(p), 0); }\n`,
  );
  render('show.glsl', '--size', size.join('x'), '--time', String(seconds), '-o', 'show.exr');
  return readExr(path.join(folder, 'show.exr'));
}

const middle = ({ width, rgba }, field) => {
  const at = 4 * (32 * width + 32 * field + 16);
  return [...rgba.subarray(at, at + 3)].map(Math.round);
};

for (const name of ['fields.webm', 'fields.mp4'])
  test(`${name} has the drawn colours in Chromium, and those of Chromium on a channel here`, async () => {
    render('fields.glsl', '--size', size.join('x'), '--frames', '10', '--fps', '10', '-o', name);
    for (const seconds of [0.25, 0.75]) {
      const browsers = await inBrowser(name, seconds);
      const ours = here(name, seconds);
      for (let field = 0; field < 8; ++field) {
        const drawn = colours[(field + (seconds < 0.5 ? 0 : 3)) % 8];
        const shown = middle(browsers, field);
        // Limited range has 220 levels for 256.
        for (let c = 0; c < 3; ++c)
          assert.ok(Math.abs(shown[c] - drawn[c]) <= 2, `at ${seconds} s field ${field} is ${shown}, not ${drawn}`);
        const sampled = middle(ours, field);
        for (let c = 0; c < 3; ++c)
          assert.ok(Math.abs(sampled[c] - shown[c]) <= 1, `at ${seconds} s field ${field} is ${sampled} here, there ${shown}`);
      }
    }
  });
