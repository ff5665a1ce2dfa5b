// The tabs of the path tracer as one pastes them into shadertoy.com, from the files that local tools open.
import { copyFileSync, existsSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';

const letters = 'ABCD';
const faceSets = [
  ['px', 'nx', 'py', 'ny', 'pz', 'nz'],
  ['posx', 'negx', 'posy', 'negy', 'posz', 'negz'],
  ['e', 'w', 'u', 'd', 'n', 's'],
  ['east', 'west', 'up', 'down', 'north', 'south'],
];

// The scene files by their numbers, as select.glsl lists them.
export function scenesOf(folder) {
  const text = readFileSync(path.join(folder, 'scenes/select.glsl'), 'utf8');
  const found = text.matchAll(/#(?:el)?if SCENE == (\d+)\s+#include "([^"]+)"/g);
  return [...found].map(([, number, file]) => ({ number: Number(number), file: path.join(folder, 'scenes', file) }));
}

// What a file says to local tools: its channels, and what it includes before and after common.glsl.
function readFile(file) {
  const code = readFileSync(file, 'utf8');
  const channels = new Map();
  const channel = (n) => channels.get(n) ?? channels.set(n, {}).get(n);
  for (const [, n, setting, value] of code.matchAll(/^#iChannel(\d)(?:::(\w+))? "([^"]+)"/gm))
    channel(Number(n))[setting ?? 'source'] = value;
  const includes = [...code.matchAll(/^#include "([^"]+)"/gm)].map(([, name]) => name);
  return { file, code, channels, includes };
}

function dataUrl(file) {
  const kind = file.endsWith('.png') ? 'png' : 'jpeg';
  return `data:image/${kind};base64,${readFileSync(file).toString('base64')}`;
}

function cubeFiles(pattern) {
  const sets = faceSets.map((names) => names.map((name) => pattern.replace('{}', name)));
  const found = sets.find((files) => files.every((file) => existsSync(file)));
  if (!found) throw new Error(`${pattern} has no six faces`);
  return found;
}

function samplerOf({ MinFilter = 'Linear', MagFilter = 'Linear', WrapMode = 'Repeat', Type }) {
  let filter = MagFilter.toLowerCase();
  if (MinFilter.includes('MipMap')) filter = 'mipmap';
  return { filter, wrap: WrapMode === 'Clamp' ? 'clamp' : 'repeat', vflip: Type !== 'CubeMap' };
}

// The passes for site.js, in the order in which local tools draw them: what is read comes first. (On shadertoy.com it is
// the order in which one made the tabs.) Every text is a file's or several files' one after the other, unmodified.
export function tabsOf(folder, sceneFile) {
  const scene = readFileSync(sceneFile, 'utf8');
  const textOf = (name) => (name.endsWith('select.glsl') ? scene : readFileSync(path.join(folder, name), 'utf8'));
  const seen = new Set();
  const files = new Map();
  const visit = (name) => {
    if (seen.has(name)) return;
    seen.add(name);
    const found = readFile(path.join(folder, name));
    for (const { source } of found.channels.values()) if (source?.endsWith('.glsl')) visit(source);
    files.set(name, found);
  };
  visit('image.glsl');

  const buffers = [...seen].filter((name) => name !== 'image.glsl');
  const tabName = (name) => (name === 'image.glsl' ? 'Image' : `Buffer ${letters[buffers.indexOf(name)]}`);
  const inputOf = (name, [channel, settings]) => {
    const sampler = samplerOf(settings);
    const { source, Type } = settings;
    if (source === 'self') return { channel, type: 'buffer', source: tabName(name), sampler };
    if (source.endsWith('.glsl')) return { channel, type: 'buffer', source: tabName(source), sampler };
    const file = path.join(folder, source);
    const cube = Type === 'CubeMap';
    const files = cube ? cubeFiles(file) : [file];
    return { channel, type: cube ? 'cubemap' : 'texture', files, source: files.map(dataUrl), sampler };
  };

  const includes = files.get('image.glsl').includes;
  const commonEnd = includes.indexOf('common.glsl') + 1;
  const common = includes.slice(0, commonEnd).map(textOf).join('');
  const passes = [...files].map(([name, { code, channels, includes: own }]) => ({
    name: tabName(name),
    file: name,
    type: name === 'image.glsl' ? 'image' : 'buffer',
    code: own.slice(own.indexOf('common.glsl') + 1).map(textOf).join('') + code,
    inputs: [...channels].map((entry) => inputOf(name, entry)),
  }));
  return [{ name: 'Common', type: 'common', code: common, inputs: [] }, ...passes];
}

// The same tabs as the site's API would give them, with the pictures beside: a file that `shadertwin render` takes.
export function writeJson(passes, folder) {
  const outputs = new Map(passes.map(({ name }) => [name, 257 + letters.indexOf(name.at(-1))]));
  outputs.set('Image', 37);
  const inputOf = ({ channel, type, source, files = [], sampler }) => {
    const name = files.length > 0 ? path.basename(files[0]) : '';
    const [stem, extension] = [name.slice(0, name.lastIndexOf('.')), path.extname(name)];
    files.forEach((file, i) => copyFileSync(file, path.join(folder, i === 0 ? name : `${stem}_${i}${extension}`)));
    const settings = { ...sampler, vflip: String(sampler.vflip), srgb: 'false', internal: 'byte' };
    const id = type === 'buffer' ? outputs.get(source) : 1000;
    return { id, src: `/media/a/${name}`, ctype: type, channel, sampler: settings, published: 1 };
  };
  const renderpass = passes.map(({ name, type, code, inputs }) => ({
    inputs: inputs.map(inputOf),
    outputs: type === 'common' ? [] : [{ id: outputs.get(name), channel: 0 }],
    code,
    name,
    description: '',
    type,
  }));
  const file = path.join(folder, 'shader.json');
  writeFileSync(file, JSON.stringify({ Shader: { ver: '0.1', info: { name: 'pasted' }, renderpass } }));
  return file;
}
