// tests/check/refused.txt and accepted.txt, put to the browser itself: it refuses each text of the one at the line that
// is marked there, and takes each of the other.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { openBrowser, openPage } from './browser.mjs';

const here = path.dirname(fileURLToPath(import.meta.url));

let browser, page;
before(async () => {
  browser = await openBrowser();
  page = await openPage(browser, { width: 8, height: 8 });
  await page.setContent('<body style="margin:0">');
  await page.addScriptTag({ path: path.join(here, 'site.js') });
});
after(async () => {
  await browser.close();
});

// { text, code, line, type } for each line of a file; `line` is where it is wrong.
function casesOf(file) {
  const cases = [];
  for (const text of readFileSync(path.join(here, '../check', file), 'utf8').split('\n')) {
    const [, place, written] = /^(in|out|all|buffer): (.*?)(?:  => .*)?$/.exec(text) ?? [];
    if (!place) continue;
    let code = written.replaceAll('\\n', '\n');
    if (place === 'in') code = `void mainImage(out vec4 c, in vec2 p) {\n${code}\n}\n`;
    if (place === 'out') code += '\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(p, 0.0, 1.0); }\n';
    const marked = code.split('\n').findIndex((line) => line.endsWith('//!'));
    const line = marked >= 0 ? marked + 1 : place === 'in' ? 2 : 1;
    cases.push({ text, code, line, type: place === 'buffer' ? 'buffer' : 'image' });
  }
  return cases;
}

// What the browser says of a tab, as "Tab:line: text".
function errorsOf({ code, type }) {
  return page.evaluate(
    ([text, kind]) => {
      const canvas = Object.assign(document.createElement('canvas'), { width: 8, height: 8 });
      const site = new window.Site(canvas, [{ name: 'Tab', type: kind, code: text, inputs: [] }]);
      const errors = site.compile();
      site.gl.getExtension('WEBGL_lose_context').loseContext();
      return errors;
    },
    [code, type],
  );
}

test('refuses every text of refused.txt at its line', async () => {
  const cases = casesOf('refused.txt');
  assert.ok(cases.length > 150);
  for (const each of cases) {
    const errors = await errorsOf(each);
    assert.ok(errors.length > 0, `${each.text}: the browser takes it`);
    // Recursion, inputs and outputs are found where there is no line any more.
    const line = /^Tab:(\d+): /.exec(errors[0])?.[1];
    if (line) assert.equal(Number(line), each.line, `${each.text}: ${errors[0]}`);
  }
});

test('takes every text of accepted.txt', async () => {
  const cases = casesOf('accepted.txt');
  assert.ok(cases.length > 40);
  for (const each of cases) assert.deepEqual(await errorsOf(each), [], each.text);
});
