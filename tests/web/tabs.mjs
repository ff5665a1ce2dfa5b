// The tabs of the path tracer as one pastes them into shadertoy.com, from the files that local tools open.
import { readFileSync } from 'node:fs';
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

function cubeFaces(pattern) {
  for (const names of faceSets) {
    try {
      return names.map((name) => dataUrl(pattern.replace('{}', name)));
    } catch (error) {
      if (error.code !== 'ENOENT') throw error;
    }
  }
  throw new Error(`${pattern} has no six faces`);
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
    if (Type === 'CubeMap') return { channel, type: 'cubemap', source: cubeFaces(file), sampler };
    return { channel, type: 'texture', source: dataUrl(file), sampler };
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
