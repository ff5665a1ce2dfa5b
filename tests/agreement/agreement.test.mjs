// The harness tells faults from precision, and a part of its corpus is in order.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { chmodSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { equalise, equaliseProject } from './equalise.mjs';

const here = path.dirname(fileURLToPath(import.meta.url));
const shadertwin = process.env.SHADERTWIN ?? path.resolve(here, '../../build/shadertwin');

let folder;
before(() => (folder = mkdtempSync(path.join(tmpdir(), 'agreement-test-'))));
after(() => rmSync(folder, { recursive: true }));

// What the harness finds. `program`: the shadertwin that it is to judge.
function harness(files, { program = shadertwin, options = [] } = {}) {
  const report = path.join(folder, 'report.json');
  const run = spawnSync(process.execPath, [path.join(here, 'agreement.mjs'), '--json', report, ...options, ...files], {
    env: { ...process.env, SHADERTWIN: program },
    encoding: 'utf8',
  });
  assert.ok(run.status === 0 || run.status === 1, run.stderr);
  return { status: run.status, verdicts: JSON.parse(readFileSync(report)).results.map((result) => result.verdict), text: run.stdout };
}

// A shadertwin that takes one number of the shader for another.
function mistaken(from, to) {
  const program = path.join(folder, 'mistaken');
  writeFileSync(program, `#!/bin/bash\nsed -i 's/${from}/${to}/' "$2"\nexec '${shadertwin}' "$@"\n`);
  chmodSync(program, 0o755);
  return program;
}

function shader(name, statement) {
  const file = path.join(folder, name);
  writeFileSync(file, `void mainImage(out vec4 color, in vec2 p) {\n  vec2 uv = p / iResolution.xy;\n  ${statement}\n}\n`);
  return file;
}

const small = ['--size', '32x18', '--players', 'llvmpipe', '--frames', '1'];

test('a wrong picture is a suspect', () => {
  const file = shader('wrong.glsl', 'color = vec4(uv * 1.125, sin(iTime), 1.0);');
  const right = harness([file], { options: small });
  assert.deepEqual([right.status, right.verdicts], [0, ['same']]);
  const { status, verdicts } = harness([file], { program: mistaken('1.125', '0.875'), options: small });
  assert.deepEqual([status, verdicts], [1, ['suspect']]);
});

test('what one unit in the last place of iTime changes as well is sensitive', () => {
  const file = shader('chaos.glsl', 'color = vec4(fract(iTime * 1.0000 * 3000000.0 + uv), 0.5, 1.0);');
  const { status, verdicts } = harness([file], { program: mistaken('1.0000 ', '1.0000001 '), options: small });
  assert.deepEqual([status, verdicts], [0, ['sensitive']]);
});

test('what only transcendental functions make differ is precision', () => {
  const file = shader('hash.glsl', 'color = vec4(vec3(fract(sin(dot(p, vec2(12.9, 78.2))) * 43758.5)), 1.0);');
  const { status, verdicts } = harness([file], { options: small });
  assert.deepEqual([status, verdicts], [0, ['precision']]);
});

test('the page plays passes that are not there, and iCh1 of a shader that leaves iCh0 alone', () => {
  const file = path.resolve(here, '../emit/shaders/green/missing-passes.json');
  assert.deepEqual(harness([file], { options: [...small, '--frames', '2'] }).verdicts, ['same']);
});

test('a picture that has to be green and is not', () => {
  const file = shader('red.glsl', '// green\n  color = vec4(1.0, 0.0, 0.0, 1.0);');
  assert.deepEqual(harness([file], { options: small }).verdicts, ['suspect']);
});

test('what a player refuses and the browser takes is a suspect, and the reverse says nothing', () => {
  const taken = shader('taken.glsl', 'float half_way = 1.25; color = vec4(half_way);');
  assert.deepEqual(harness([taken], { program: mistaken('half_way = 1.25', 'half_way = 1'), options: small }).verdicts, ['suspect']);
  const refused = shader('refused.glsl', 'float x = 1; color = vec4(x);');
  assert.deepEqual(harness([refused], { options: small }).verdicts, ['refused']);
  assert.equal(harness([refused], { options: [...small, '--none-refused'] }).status, 1);
});

test('equalised texts call plain arithmetic where no constant is asked for', () => {
  const code = '#define S sin(x)\nconst float k = sin(1.0);\nfloat f(float x) { const float c = cos(2.0); return S + pow(x, 2.0); } // sin(x)\n';
  const changed = equalise(code);
  assert.match(changed, /#define S equal_sin\(x\)/);
  assert.match(changed, /const float k = sin\(1\.0\)/);
  assert.match(changed, /const float c = cos\(2\.0\)/);
  assert.match(changed, /equal_pow\(x, 2\.0\)/);
  assert.match(changed, /\/\/ sin\(x\)/);
  assert.match(equalise('void f() { n = a.length() + length(v); }'), /a\.length\(\) \+ equal_length\(v\)/);
  const [pass, common] = equaliseProject([{ name: 'Image', type: 'image', code, inputs: [{ sampler: { filter: 'mipmap' } }] }]);
  assert.equal(pass.inputs[0].sampler.filter, 'nearest');
  assert.equal(common.type, 'common');
});

// The rest is tools/nightly's.
test('a part of the corpus', () => {
  const part = [
    'ported/struct_vertex.glsl', 'macro/self_naming.glsl', 'integer/switch_machine.glsl', 'generated/minified.glsl', 'language/arrays.glsl',
    'hosts/zeros.glsl', 'state/counter_in_a_texel', 'simulation/mip_average', 'art/domain_warp.glsl',
  ].map((name) => path.join(here, 'corpus', name));
  const { status, text } = harness(part, { options: ['--none-refused', '--size', '64x36'] });
  assert.equal(status, 0, text);
});
