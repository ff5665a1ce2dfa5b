// Shaders and projects as passes that the harness's page and shadertwin both play.
//
// A pass: { name, type: common | buffer | cubemap | image, code, inputs }, an input: { channel, type, source, sampler }
// as tests/web/site.js has them.
import { existsSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import path from 'node:path';

const letters = 'ABCD';
const ids = { '4dfGRr': 'Image', '4dXGR8': 'Buffer A', XsXGR8: 'Buffer B', '4sXGR8': 'Buffer C', XdfGR8: 'Buffer D', '4dX3Rr': 'Cubemap A' };
const numbers = { 37: 'Image', 257: 'Buffer A', 258: 'Buffer B', 259: 'Buffer C', 260: 'Buffer D', 41: 'Cubemap A' };
const defaults = { filter: 'linear', wrap: 'clamp', vflip: true };

function nameOfId(id) {
  return ids[id] ?? numbers[id];
}

function mediaFile(folder, source) {
  const below = source.replace(/^\/+/, '');
  return [below, path.basename(below)].map((name) => path.join(folder, name)).find((file) => existsSync(file));
}

function dataUrl(file) {
  return `data:image/${/\.png$/i.test(file) ? 'png' : 'jpeg'};base64,${readFileSync(file).toString('base64')}`;
}

// What the page can't play: the reason, else undefined.
function fromJson(file) {
  const document = JSON.parse(readFileSync(file, 'utf8'));
  const shader = document.Shader ?? document.shaders?.[0] ?? (Array.isArray(document) ? document[0] : document);
  const folder = path.dirname(file);
  const problems = [];
  const passes = shader.renderpass.map((pass, index) => {
    const output = nameOfId(pass.outputs?.[0]?.id);
    const name = { image: 'Image', common: 'Common', cubemap: 'Cubemap A', sound: 'Sound' }[pass.type] ?? output ?? `Buffer ${letters[index]}`;
    const inputs = (pass.inputs ?? []).flatMap((input) => {
      const type = input.ctype ?? input.type;
      const source = input.src ?? input.filepath ?? '';
      const sampler = { ...defaults, ...input.sampler };
      sampler.vflip = String(sampler.vflip) === 'true';
      const buffer = nameOfId(input.id) ?? (/buffer0(\d)/.exec(source) ? `Buffer ${letters[/buffer0(\d)/.exec(source)[1]]}` : undefined);
      if (type === 'buffer' || (type === 'cubemap' && buffer === 'Cubemap A'))
        return [{ channel: input.channel, type: 'buffer', source: buffer, sampler }];
      if (type === 'keyboard') return [{ channel: input.channel, type, sampler }];
      const found = type === 'texture' && mediaFile(folder, source);
      if (found) return [{ channel: input.channel, type, source: dataUrl(found), file: source, sampler }];
      problems.push(`${type} ${source}`);
      return [];
    });
    return { name, type: pass.type, code: pass.code, inputs };
  });
  return { passes: passes.filter((pass) => pass.type !== 'sound'), problems };
}

function fromTabs(folder) {
  const settings = existsSync(path.join(folder, 'shadertoy.json')) ? JSON.parse(readFileSync(path.join(folder, 'shadertoy.json'))) : {};
  const passes = readdirSync(folder)
    .filter((file) => file.endsWith('.glsl'))
    .sort()
    .map((file) => {
      const stem = path.basename(file, '.glsl');
      const [type, letter] = stem.split('_');
      const name = letter ? `${type[0].toUpperCase()}${type.slice(1)} ${letter.toUpperCase()}` : `${type[0].toUpperCase()}${type.slice(1)}`;
      const inputs = Object.entries(settings[name] ?? {}).map(([channel, input]) => ({
        channel: Number(channel.slice(8)),
        type: input.keyboard ? 'keyboard' : 'buffer',
        source: input.buffer,
        sampler: { ...defaults, ...input },
      }));
      return { name, type, code: readFileSync(path.join(folder, file), 'utf8'), inputs };
    });
  // The Image is a shader's first tab.
  return { passes: passes.sort((a, b) => (b.type === 'image') - (a.type === 'image')), problems: [] };
}

// A single shader is the Image tab of shadertoy.com's; its first comment may say what it reads.
export function readProject(file) {
  if (statSync(file).isDirectory()) return fromTabs(file);
  if (file.endsWith('.json')) return fromJson(file);
  return { passes: [{ name: 'Image', type: 'image', code: readFileSync(file, 'utf8'), inputs: [] }], problems: [] };
}

// Files and projects below a folder, or the one that is named.
export function listProjects(place) {
  if (!statSync(place).isDirectory() || existsSync(path.join(place, 'image.glsl'))) return [place];
  return readdirSync(place)
    .sort()
    .flatMap((name) => {
      const file = path.join(place, name);
      if (statSync(file).isDirectory()) return listProjects(file);
      return /\.(glsl|frag)$/.test(name) || (/\.json$/.test(name) && readFileSync(file, 'utf8').includes('renderpass')) ? [file] : [];
    });
}

// A pass that a channel names and the project lacks: one that never draws, and so keeps its zeros.
export function withMissingPasses(passes) {
  const known = new Set(passes.map((pass) => pass.name));
  const missing = new Set(passes.flatMap((pass) => pass.inputs).filter((input) => input.type === 'buffer' && !known.has(input.source)).map((input) => input.source));
  const blank = [...missing].map((name) =>
    name === 'Cubemap A'
      ? { name, type: 'cubemap', code: 'void mainCubemap(out vec4 c, in vec2 p, in vec3 o, in vec3 d) { discard; }', inputs: [] }
      : { name, type: 'buffer', code: 'void mainImage(out vec4 c, in vec2 p) { discard; }', inputs: [] },
  );
  return [...passes, ...blank];
}

// The same as shadertoy.com's API would give it.
export function writeJson(passes, file) {
  const idOf = (name) => Number(Object.entries(numbers).find(([, known]) => known === name)?.[0] ?? 1000);
  const inputOf = ({ channel, type, source, file: medium, sampler }) => ({
    id: type === 'buffer' ? idOf(source) : type === 'keyboard' ? 33 : 1000,
    src: type === 'texture' ? medium : '',
    ctype: type === 'buffer' && source === 'Cubemap A' ? 'cubemap' : type,
    channel,
    sampler: { ...sampler, vflip: String(sampler.vflip) },
  });
  const renderpass = passes.map(({ name, type, code, inputs }) => ({
    name,
    type,
    code,
    description: '',
    inputs: inputs.map(inputOf),
    outputs: type === 'common' ? [] : [{ id: idOf(name), channel: 0 }],
  }));
  writeFileSync(file, JSON.stringify({ Shader: { ver: '0.1', info: { name: 'agreement' }, renderpass } }));
}
