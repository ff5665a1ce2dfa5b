// Reads the OpenEXR files that shadertwin writes: scan lines, float32, uncompressed or deflated.
import { readFileSync } from 'node:fs';
import { inflateSync } from 'node:zlib';

class Cursor {
  constructor(buffer) {
    this.buffer = buffer;
    this.at = 0;
  }
  int() {
    this.at += 4;
    return this.buffer.readInt32LE(this.at - 4);
  }
  byte() {
    return this.buffer[this.at++];
  }
  string() {
    const end = this.buffer.indexOf(0, this.at);
    const text = this.buffer.toString('latin1', this.at, end);
    this.at = end + 1;
    return text;
  }
}

function readChannels(cursor) {
  const channels = [];
  while (cursor.buffer[cursor.at] !== 0) {
    const name = cursor.string();
    const type = cursor.int();
    if (type !== 2) throw new Error(`channel ${name} is not float32`);
    cursor.at += 12; // pLinear, reserved, sampling
    channels.push(name);
  }
  return channels;
}

// OpenEXR's predictor and the two halves that it takes the bytes apart into.
function undoPredictor(bytes) {
  for (let i = 1; i < bytes.length; ++i) bytes[i] = (bytes[i] + bytes[i - 1] - 128) & 255;
  const result = Buffer.alloc(bytes.length);
  const half = (bytes.length + 1) >> 1;
  for (let i = 0; i < bytes.length; ++i) result[i] = bytes[i & 1 ? half + (i >> 1) : i >> 1];
  return result;
}

// { width, height, rgba }: Float32Array, the bottom row first, as WebGL reads pixels.
export function readExr(file) {
  const cursor = new Cursor(readFileSync(file));
  if (cursor.int() !== 20000630) throw new Error(`${file} is no OpenEXR file`);
  cursor.int();
  let channels, compression, window;
  for (let name = cursor.string(); name !== ''; name = cursor.string()) {
    cursor.string();
    const next = cursor.int() + cursor.at;
    if (name === 'channels') channels = readChannels(cursor);
    if (name === 'compression') compression = cursor.byte();
    if (name === 'dataWindow') window = [cursor.int(), cursor.int(), cursor.int(), cursor.int()];
    cursor.at = next;
  }
  const linesPerBlock = { 0: 1, 2: 1, 3: 16 }[compression];
  if (linesPerBlock === undefined) throw new Error(`${file} is compressed by method ${compression}`);
  const width = window[2] - window[0] + 1;
  const height = window[3] - window[1] + 1;
  const rgba = new Float32Array(4 * width * height).fill(1);
  const blocks = Math.ceil(height / linesPerBlock);
  cursor.at += 8 * blocks;
  for (let block = 0; block < blocks; ++block) {
    const top = cursor.int() - window[1];
    const packed = cursor.buffer.subarray(cursor.at + 4, cursor.at + 4 + cursor.buffer.readInt32LE(cursor.at));
    cursor.at += 4 + packed.length;
    const lines = Math.min(linesPerBlock, height - top);
    const raw = packed.length === 4 * channels.length * width * lines ? packed : undoPredictor(inflateSync(packed));
    let at = 0;
    for (let y = top; y < top + lines; ++y)
      for (const channel of channels)
        for (let x = 0; x < width; ++x, at += 4)
          rgba[4 * ((height - 1 - y) * width + x) + 'RGBA'.indexOf(channel)] = raw.readFloatLE(at);
  }
  return { width, height, rgba };
}
