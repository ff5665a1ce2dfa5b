// Textures and samplers: pictures, cubemaps, volumes, the keyboard.

function levelsOf(...sizes) {
  return 1 + Math.floor(Math.log2(Math.max(...sizes)));
}

function bytesOf(base64) {
  return Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
}

function makeSampler(gl, { min, mag, wrap }) {
  const sampler = gl.createSampler();
  gl.samplerParameteri(sampler, gl.TEXTURE_MIN_FILTER, gl[min]);
  gl.samplerParameteri(sampler, gl.TEXTURE_MAG_FILTER, gl[mag]);
  for (const axis of ['S', 'T', 'R']) gl.samplerParameteri(sampler, gl[`TEXTURE_WRAP_${axis}`], gl[wrap]);
  return sampler;
}

// Of what a sampler of the shape reads.
function targetOf(gl, shape) {
  return { cube: gl.TEXTURE_CUBE_MAP, volume: gl.TEXTURE_3D }[shape] ?? gl.TEXTURE_2D;
}

function faceTargets(gl, target) {
  return target === gl.TEXTURE_CUBE_MAP ? [0, 1, 2, 3, 4, 5].map((i) => gl.TEXTURE_CUBE_MAP_POSITIVE_X + i) : [target];
}

async function decoded(url) {
  const image = new Image();
  image.src = url;
  await image.decode();
  return image;
}

// A medium is a URL that the browser decodes, or { width, height, depth, format, base64 } with the texels as they are,
// the row at t = 0 first.
async function uploadPicture(gl, input, media) {
  const pictures = await Promise.all(
    input.media.map(async (index) => {
      const medium = media[index];
      return typeof medium === 'string' ? decoded(medium) : { ...medium, texels: bytesOf(medium.base64) };
    }),
  );
  const cube = input.shape === 'cube';
  // A cube that is turned over has its top at the bottom.
  if (cube && input.vflip && !pictures[0].texels) [pictures[2], pictures[3]] = [pictures[3], pictures[2]];
  const target = targetOf(gl, input.shape);
  const [first] = pictures;
  const float = first.format === 'rgba32f';
  const red = input.red && !first.texels;
  const format = float ? gl.RGBA32F : red ? gl.R8 : gl.RGBA8;
  const depth = first.depth ?? 1;
  const texture = gl.createTexture();
  gl.bindTexture(target, texture);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
  const levels = input.mipmaps ? levelsOf(first.width, first.height, depth) : 1;
  if (target === gl.TEXTURE_3D) gl.texStorage3D(target, levels, format, first.width, first.height, depth);
  else gl.texStorage2D(target, levels, format, first.width, first.height);
  for (const [i, face] of faceTargets(gl, target).entries()) {
    const picture = pictures[i];
    const type = float ? gl.FLOAT : gl.UNSIGNED_BYTE;
    const texels = float ? new Float32Array(picture.texels.buffer) : picture.texels;
    const { width, height } = picture;
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, !texels && input.vflip);
    if (target === gl.TEXTURE_3D) gl.texSubImage3D(target, 0, 0, 0, 0, width, height, depth, gl.RGBA, type, texels);
    else if (texels) gl.texSubImage2D(face, 0, 0, 0, width, height, gl.RGBA, type, texels);
    else gl.texSubImage2D(face, 0, 0, 0, red ? gl.RED : gl.RGBA, type, picture);
  }
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
  if (levels > 1) gl.generateMipmap(target);
  return { target, texture };
}

// A small texture whose texels are set anew every frame: the keyboard, a spectrum.
function makeTable(gl, width, height) {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, width, height);
  return {
    target: gl.TEXTURE_2D,
    texture,
    // The site's tables have one channel; the extension's are grey.
    update(values, grey) {
      const texels = new Uint8Array(4 * width * height);
      for (let i = 0; i < width * height; ++i) {
        texels[4 * i] = values[i];
        if (grey) texels[4 * i + 1] = texels[4 * i + 2] = values[i];
        texels[4 * i + 3] = 255;
      }
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, texels);
    },
  };
}

// Texels of nothing.
function makeBlank(gl, target, width, height) {
  const texture = gl.createTexture();
  gl.bindTexture(target, texture);
  if (target === gl.TEXTURE_3D) gl.texStorage3D(target, 1, gl.RGBA8, width, height, 1);
  else gl.texStorage2D(target, 1, gl.RGBA8, width, height);
  return texture;
}
