#!/usr/bin/env node
// agreement.mjs [OPTION...] FILE-OR-FOLDER...: how far shaders look alike on shadertwin's players and in Chromium.
//
//   --players LIST    as --on takes them (llvmpipe,cpu)
//   --no-browser      the players among each other only: the first one is what the others are held to
//   --size WxH        128x72          --frames N   2          --time SECONDS   2
//   --native          without the equalised texts
//   --json FILE       everything as data
//   --none-refused    exit status 1 if the reference refuses one
//   --limit PERCENT   exit status 1 if fewer shaders than that are in order (100)
//
// Every shader is played as it stands (native), then, where a player and the reference differ, equalised: media are read
// by nearest, and transcendental functions are the same plain arithmetic everywhere (equalise.mjs). What differs still is
// played once more with iTime changed by one unit in the last place, on both: a pixel which that changes is sensitive, and
// tells of precision, not of a fault. A shader is
//
//   same        where at most 0.5 % of the pixels differ by more than 4 of 255
//   precision   where that holds when it is equalised, or for a player of doubles where it is no suspect with floats
//   sensitive   where it holds without the sensitive pixels
//   suspect     else, and where one side refuses what the other takes
//   refused     where the reference refuses it: it says nothing of a player
//
// A shader whose text has `// green` has to be green all over, whatever the reference says.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';

import { readExr } from '../web/exr.mjs';
import { equaliseProject } from './equalise.mjs';
import { listProjects, readProject, withMissingPasses, writeJson } from './project.mjs';

const here = path.dirname(fileURLToPath(import.meta.url));
const shadertwin = process.env.SHADERTWIN ?? path.resolve(here, '../../build/shadertwin');
const byte = 4;
const share = 0.005;

const { values: options, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    players: { type: 'string', default: 'llvmpipe,cpu' },
    'no-browser': { type: 'boolean', default: false },
    native: { type: 'boolean', default: false },
    size: { type: 'string', default: '128x72' },
    frames: { type: 'string', default: '2' },
    time: { type: 'string', default: '2' },
    'none-refused': { type: 'boolean', default: false },
    json: { type: 'string' },
    limit: { type: 'string', default: '100' },
  },
});
const players = options.players.split(',');
const [width, height] = options.size.split('x').map(Number);
const frames = Number(options.frames);
const start = Math.fround(Number(options.time));
const folder = mkdtempSync(path.join(tmpdir(), 'agreement-'));

// The next float.
function next(x) {
  const bits = new Int32Array(new Float32Array([x]).buffer);
  return x === 0 ? 2 ** -149 : new Float32Array(Int32Array.of(bits[0] + 1).buffer)[0];
}

// Chromium, through a page that plays tabs as shadertoy.com does.
class Browser {
  static async open() {
    const { openBrowser, openPage, pictureOf } = await import('../web/browser.mjs');
    const self = new Browser();
    self.pictureOf = pictureOf;
    self.browser = await openBrowser();
    self.page = await openPage(self.browser, { width, height });
    await self.page.setContent('<body style="margin:0">');
    await self.page.addScriptTag({ path: path.join(here, '../web/site.js') });
    return self;
  }

  async play(passes, time) {
    const errors = await this.page.evaluate(
      async ([tabs, width, height, frames, time]) => {
        window.site?.gl.getExtension('WEBGL_lose_context')?.loseContext();
        const canvas = Object.assign(document.createElement('canvas'), { width, height });
        document.body.replaceChildren(canvas);
        window.site = new window.Site(canvas, tabs);
        const errors = window.site.compile();
        if (errors.length > 0) return errors;
        await window.site.load();
        for (let i = 0; i < frames; ++i) window.site.step(time + i / 60, 1 / 60, [2024, 0, 1, i / 60]);
        return [];
      },
      [withMissingPasses(passes), width, height, frames, time],
    );
    if (errors.length > 0) return { error: errors[0] };
    return this.pictureOf(await this.page.evaluate(() => window.site.read('Image')));
  }
}

function playHere(player, passes, time, place) {
  const file = path.join(folder, 'shader.json');
  const output = path.join(folder, 'picture.exr');
  writeJson(passes, file);
  try {
    execFileSync(
      shadertwin,
      [
        'render', file, '--quiet', '--on', player, '--size', `${width}x${height}`, '--frames', String(frames), '--time', String(time),
        '--media', place, '-o', output,
      ],
      { stdio: ['ignore', 'ignore', 'pipe'], timeout: 120000 },
    );
  } catch (error) {
    return { error: (error.stderr?.toString() || error.message).split('\n').find((line) => line !== '') };
  }
  return readExr(output);
}

// Bytes, as a canvas shows them.
function shown(picture) {
  return Uint8Array.from(picture.rgba, (x) => (x > 0 ? Math.round(255 * Math.min(x, 1)) : 0));
}

// One flag for every pixel: whether it differs by more than `limit` of 255 in r, g or b.
function apart(a, b, limit) {
  const [x, y] = [shown(a), shown(b)];
  return Array.from({ length: width * height }, (_, i) => [0, 1, 2].some((c) => Math.abs(x[4 * i + c] - y[4 * i + c]) > limit));
}
const count = (flags) => flags.filter(Boolean).length;
const alike = (flags) => count(flags) <= share * flags.length;

function isGreen(picture) {
  const bytes = shown(picture);
  return bytes.every((value, i) => value === [0, 255, 0, 255][i % 4]);
}

class Judge {
  constructor(file, reference) {
    this.place = path.dirname(file);
    this.reference = reference;
    const { passes, problems } = readProject(file);
    this.passes = passes;
    this.problems = problems;
    this.green = passes.some((pass) => /\/\/ green\b/.test(pass.code));
    this.kept = new Map();
  }

  // Each is played once: equal = the equalised texts, time = that or the next float.
  async play(player, equal, time) {
    const key = `${player} ${equal} ${time}`;
    if (!this.kept.has(key)) {
      const passes = equal ? (this.equalised ??= equaliseProject(this.passes)) : this.passes;
      this.kept.set(key, player === 'browser' ? await this.reference.play(passes, time) : playHere(player, passes, time, this.place));
    }
    return this.kept.get(key);
  }

  async judge(player) {
    const other = this.reference ? 'browser' : players[0];
    const [a, b] = [await this.play(other, false, start), await this.play(player, false, start)];
    if (a.error) return { verdict: 'refused', reason: a.error };
    if (b.error) return { verdict: 'suspect', reason: b.error };
    if (this.green) {
      const bad = [[other, a], [player, b]].filter(([, picture]) => !isGreen(picture)).map(([name]) => name);
      return bad.length === 0 ? { verdict: 'same', bytes: true } : { verdict: 'suspect', reason: `not green on ${bad.join(' and ')}` };
    }
    const flags = apart(a, b, byte);
    const bytes = count(apart(a, b, 0)) === 0;
    if (alike(flags)) return { verdict: 'same', bytes };
    const percent = (100 * count(flags)) / flags.length;
    const differs = `${percent.toFixed(1)} % of the pixels differ`;
    if (!options.native) {
      const [c, d] = [await this.play(other, true, start), await this.play(player, true, start)];
      if (!c.error && !d.error) {
        const equal = apart(c, d, byte);
        if (alike(equal)) return { verdict: 'precision', reason: differs };
        if (await this.explained(player, other, true, equal)) return { verdict: 'sensitive', reason: differs };
      }
    }
    if (await this.explained(player, other, false, flags)) return { verdict: 'sensitive', reason: differs };
    // Doubles are not rounded as floats are, whatever the text.
    const float = player.replace(/\/double$/, '');
    if (float !== player && !['suspect', 'refused'].includes((await this.judge(float)).verdict))
      return { verdict: 'precision', reason: differs };
    return { verdict: 'suspect', reason: differs };
  }

  // Whether what differs are pixels that one unit in the last place of iTime changes on either side.
  async explained(player, other, equal, flags) {
    const sensitive = new Array(flags.length).fill(false);
    for (const name of [other, player]) {
      const [now, later] = [await this.play(name, equal, start), await this.play(name, equal, next(start))];
      if (now.error || later.error) return false;
      apart(now, later, 0).forEach((changed, i) => (sensitive[i] ||= changed));
    }
    return alike(flags.map((differs, i) => differs && !sensitive[i]));
  }
}

async function main() {
  const files = positionals.flatMap((place) => listProjects(place));
  if (files.length === 0) throw new Error('there are no shaders');
  const reference = options['no-browser'] ? undefined : await Browser.open();
  const judged = options['no-browser'] ? players.slice(1) : players;
  const results = [];
  for (const file of files) {
    const judge = new Judge(file, reference);
    for (const player of judged) {
      const result = { file, player, ...(await judge.judge(player)) };
      if (judge.problems.length > 0 && result.verdict === 'suspect') Object.assign(result, { verdict: 'refused', reason: `media: ${judge.problems[0]}` });
      results.push(result);
      if (result.verdict !== 'same') console.log(`${file}: ${player}: ${result.verdict}: ${result.reason}`);
    }
  }
  await reference?.browser.close();
  let good = true;
  for (const player of judged) {
    const own = results.filter((result) => result.player === player && result.verdict !== 'refused');
    const of = (verdict) => own.filter((result) => result.verdict === verdict).length;
    const rate = (n) => `${((100 * n) / Math.max(own.length, 1)).toFixed(1)} %`;
    const bytes = own.filter((result) => result.bytes).length;
    console.log(
      `${player}: ${own.length} shaders: ${rate(of('same'))} same (${rate(bytes)} in every byte), ${rate(of('precision'))} precision, ` +
        `${rate(of('sensitive'))} sensitive, ${of('suspect')} suspect`,
    );
    const refused = results.filter((result) => result.player === player && result.verdict === 'refused').length;
    if (options['none-refused'] && refused > 0) good = false;
    good &&= 100 * (own.length - of('suspect')) >= Number(options.limit) * own.length;
  }
  if (options.json) writeFileSync(options.json, JSON.stringify({ options, results }, null, 2));
  return good ? 0 : 1;
}

let status = 2;
try {
  status = await main();
} finally {
  rmSync(folder, { recursive: true, force: true });
}
process.exit(status);
