// tests/language/preprocessor_cases.txt, put to the browser itself: it draws green what is called green there, and refuses
// what is called refused, at the line that is named. It draws green, too, what our preprocessor makes of the green ones.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { openBrowser, openPage } from './browser.mjs';

const here = path.dirname(fileURLToPath(import.meta.url));

// What stands before a case that is not whole. `#line 1` makes the browser count the case's own lines.
const head = `#version 300 es
precision highp float;
precision highp int;
out vec4 shadertwin_color;
bool ok();
void main() { shadertwin_color = ok() ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0); }
#line 1
`;

// { name, expected, line, text } for each case of the file, whose first lines say how it is written.
function readCases() {
  const file = readFileSync(path.join(here, '../language/preprocessor_cases.txt'), 'utf8');
  return file.split(/^--- /m).slice(1).map((written) => {
    const title = written.slice(0, written.indexOf('\n'));
    const [, name, expected, line, whole] = /^(.*): (green|refused|invalid)(?: (\d+))?( whole)?$/.exec(title) ?? [];
    assert.ok(name, `--- ${title}`);
    const text = written
      .slice(title.length + 1)
      .replace(/\u27E6(.*?)\*(\d+)\u27E7/gs, (_, repeated, count) => repeated.repeat(count))
      .replaceAll('\u240D', '\r')
      .replaceAll('\u240B', '\v')
      .replaceAll('\u240C', '\f')
      .replace(/\u2404[^]*/, '');
    return { name, expected, line: Number(line ?? 0), text: (whole ? '' : head) + text };
  });
}

// { name, text } for each green case as our preprocessor writes it, with its line numbers and without #version.
function readPlain() {
  const file = readFileSync(path.join(here, '../language/preprocessor_cases.plain.txt'), 'utf8');
  return file.split(/^--- /m).slice(1).map((written) => {
    const title = written.slice(0, written.indexOf('\n'));
    const whole = title.endsWith(': whole');
    return { name: title, text: (whole ? '#version 300 es' : head) + written.slice(title.length + (whole ? 0 : 1)) };
  });
}

// In the page: what becomes of each text, { log } if it is refused, else { pixel }.
function drawAll(texts) {
  const canvas = Object.assign(document.createElement('canvas'), { width: 1, height: 1 });
  const gl = canvas.getContext('webgl2');
  const compile = (type, text) => {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    return shader;
  };
  const vertex = compile(
    gl.VERTEX_SHADER,
    '#version 300 es\nvoid main() { gl_Position = vec4(0.0, 0.0, 0.0, 1.0); gl_PointSize = 4.0; }',
  );
  return texts.map((text) => {
    const fragment = compile(gl.FRAGMENT_SHADER, text);
    if (!gl.getShaderParameter(fragment, gl.COMPILE_STATUS)) return { log: gl.getShaderInfoLog(fragment) };
    const program = gl.createProgram();
    gl.attachShader(program, vertex);
    gl.attachShader(program, fragment);
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return { log: gl.getProgramInfoLog(program) };
    gl.useProgram(program);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.drawArrays(gl.POINTS, 0, 1);
    const pixel = new Uint8Array(4);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    gl.deleteProgram(program);
    gl.deleteShader(fragment);
    return { pixel: Array.from(pixel) };
  });
}

let browser, page;
before(async () => {
  browser = await openBrowser();
  page = await openPage(browser, { width: 8, height: 8 });
});
after(async () => {
  await browser.close();
});

test('the browser judges every preprocessor case as it is written down', async () => {
  const cases = readCases();
  assert.ok(cases.length > 500);
  const results = await page.evaluate(
    drawAll,
    cases.map((each) => each.text),
  );
  const wrong = [];
  cases.forEach(({ name, expected, line }, i) => {
    const { log, pixel } = results[i];
    if (expected === 'green' && pixel?.join() !== '0,255,0,255') wrong.push(`${name}: ${log ?? pixel}`);
    if (expected !== 'green' && log === undefined) wrong.push(`${name}: is taken, and draws ${pixel}`);
    const found = Number(/ERROR: \d+:(\d+):/.exec(log ?? '')?.[1] ?? 0);
    if (line !== 0 && log !== undefined && found !== line) wrong.push(`${name}: ${log}`);
  });
  assert.deepEqual(wrong, []);
});

test('the browser draws green what our preprocessor makes of the green cases', async () => {
  const plain = readPlain();
  assert.ok(plain.length > 200);
  const results = await page.evaluate(
    drawAll,
    plain.map((each) => each.text),
  );
  const wrong = plain.filter((_, i) => results[i].pixel?.join() !== '0,255,0,255');
  assert.deepEqual(wrong, []);
});
