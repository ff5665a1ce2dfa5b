// Shaders in the page that `shadertwin export --to html` writes, frame by frame as `shadertwin render` draws them.
import { execFileSync } from 'node:child_process';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

import { openPage, pictureOf } from './browser.mjs';
import { readExr } from './exr.mjs';

const here = path.dirname(fileURLToPath(import.meta.url));
export const shadertwin = process.env.SHADERTWIN ?? path.resolve(here, '../../build/shadertwin');

const view = { width: 400, height: 300 };

// One page for each browser plays one file after another: a page of its own takes Chromium five times as long as the file.
const pages = new WeakMap();
let opened = 0;

// The page, paused before its first frame, until the next call.
export async function openPlayer(browser, file, size) {
  if (!pages.has(browser)) pages.set(browser, await openPage(browser, view));
  const page = pages.get(browser);
  page.problems = [];
  // With another query it is loaded anew, also where only the size differs.
  await page.goto(`file://${file}?${++opened}#paused&bare&size=${size.join('x')}`);
  page.messages = await page.evaluate(() => window.shadertwin.ready);
  return page;
}

// "X,Y[,down][@FRAME]" as the command line takes it.
function mouseSteps(texts) {
  return texts.map((text) => {
    const [, x, y, down, frame] = /^(-?[\d.]+),(-?[\d.]+)(,down)?(?:@(\d+))?$/.exec(text);
    return { x: Number(x), y: Number(y), down: down !== undefined, frame: Number(frame ?? 0) };
  });
}

// "KEY[@FRAME[-RELEASE]]", likewise.
function keySteps(texts) {
  return texts.map((text) => {
    const [key, frames = '0'] = text.split('@');
    const [frame, release] = frames.split('-').map(Number);
    return { key: key.length === 1 ? key : key[0].toUpperCase() + key.slice(1), frame, release };
  });
}

// script: size, frames, fps, mouse, keys. Frame i is drawn at i / fps seconds, on 1 January 2024. What is still held in the
// end is let go, for the next file.
export async function playFrames(page, { frames, fps = 60, mouse = [], keys = [] }) {
  const box = await page.evaluate(() => {
    const { left, bottom } = document.querySelector('canvas').getBoundingClientRect();
    return { left, bottom };
  });
  let down = false;
  for (let frame = 0; frame < frames; ++frame) {
    for (const step of mouseSteps(mouse).filter((s) => s.frame === frame)) {
      await page.mouse.move(box.left + step.x, box.bottom - step.y);
      if (step.down !== down) await (step.down ? page.mouse.down() : page.mouse.up());
      down = step.down;
    }
    const steps = keySteps(keys);
    for (const { key } of steps.filter((s) => s.release === frame && s.frame < frame)) await page.keyboard.up(key);
    for (const { key, release } of steps.filter((s) => s.frame === frame)) {
      await page.keyboard.down(key);
      if (release === frame) await page.keyboard.up(key);
    }
    await page.evaluate(([now, seconds]) => window.shadertwin.step(now, [2024, 0, 1, seconds]), [
      (1000 * frame) / fps,
      frame / fps,
    ]);
  }
  if (down) await page.mouse.up();
  for (const { key } of keySteps(keys)) await page.keyboard.up(key);
}

export async function readPass(page, name) {
  return pictureOf(
    await page.evaluate((pass) => {
      const { width, height, rgba } = window.shadertwin.read(pass);
      const bytes = new Uint8Array(rgba.buffer);
      let text = '';
      for (let i = 0; i < bytes.length; i += 32768) text += String.fromCharCode(...bytes.subarray(i, i + 32768));
      return { width, height, base64: btoa(text) };
    }, name),
  );
}

// The same frames by the command line; `output` is an .exr that is written.
export function renderPass(shader, pass, { size, frames, fps = 60, mouse = [], keys = [], options = [] }, output) {
  execFileSync(shadertwin, [
    'render', shader, '--quiet', '--on', 'llvmpipe/fragment', '--pass', pass, '--size', size.join('x'),
    '--frames', String(frames), '--fps', String(fps), '-o', output, ...options,
    ...mouse.flatMap((text) => ['--mouse', text]),
    ...keys.flatMap((text) => ['--keys', text]),
  ]);
  return readExr(output);
}
