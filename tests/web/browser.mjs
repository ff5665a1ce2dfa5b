// A headless Chromium that draws WebGL2 on the CPU, and a page whose canvas has the size that a test asks for.
import { chromium } from 'playwright-core';

const flags = [
  '--no-sandbox',
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-default-apps',
  '--disable-extensions',
  // The page around a canvas is not what is tested, and SwiftShader would draw it at the canvas's expense.
  '--disable-gpu-compositing',
  '--disable-gpu-rasterization',
  '--disable-sync',
  '--disable-dev-shm-usage',
  '--force-color-profile=srgb',
  '--force-device-scale-factor=1',
  '--hide-scrollbars',
  '--no-first-run',
];

export async function openBrowser() {
  return chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: flags });
}

// A page that can open nothing but what it is given. Its own errors end up in page.problems.
export async function openPage(browser, size) {
  const context = await browser.newContext({ viewport: size, deviceScaleFactor: 1, offline: true });
  const page = await context.newPage();
  page.problems = [];
  page.on('pageerror', (error) => page.problems.push(String(error)));
  page.setDefaultTimeout(0); // the test runner has its own limit
  return page;
}

// Float32 RGBA as the page sends it (base64 of the bytes, bottom row first) to a picture.
export function pictureOf({ width, height, base64 }) {
  const bytes = Buffer.from(base64, 'base64');
  const copy = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  return { width, height, rgba: new Float32Array(copy) };
}
