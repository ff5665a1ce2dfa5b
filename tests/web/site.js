// A page that plays tabs as shadertoy.com does in WebGL2: what it puts around them, what it binds, the order of drawing.
// Written apart from the program's own players, so that each can find the other's mistakes. Time is the caller's.
'use strict';

window.Site = class Site {
  // passes, in the order of the tabs: { name, type: common | buffer | cubemap | image, code, inputs }.
  // An input: { channel, type: texture | cubemap | buffer | keyboard, source, sampler: { filter, wrap, vflip } };
  // source is a pass's name for a buffer, a URL for a texture, six URLs (+X -X +Y -Y +Z -Z) for a cubemap.
  constructor(canvas, passes) {
    const gl = canvas.getContext('webgl2', {
      alpha: false,
      antialias: false,
      depth: false,
      stencil: false,
      premultipliedAlpha: false,
      preserveDrawingBuffer: true,
    });
    if (!gl || !gl.getExtension('EXT_color_buffer_float')) throw new Error('no WebGL2 with float buffers');
    gl.getExtension('OES_texture_float_linear');
    this.gl = gl;
    this.canvas = canvas;
    this.common = passes.filter((p) => p.type === 'common').map((p) => p.code + '\n').join('');
    this.passes = passes.filter((p) => p.type !== 'common').map((p) => ({ ...p }));
    this.frame = 0;
    this.mouse = { x: 0, y: 0, downX: 0, downY: 0, down: false, fresh: false };
    this.keys = new Uint8Array(256 * 3);
    this.listen();
  }

  listen() {
    const place = (event) => {
      const box = this.canvas.getBoundingClientRect();
      const { width, height } = this.canvas;
      return [
        Math.floor(((event.clientX - box.left) / box.width) * width),
        Math.floor(height - ((event.clientY - box.top) / box.height) * height),
      ];
    };
    const mouse = this.mouse;
    this.canvas.addEventListener('mousedown', (event) => {
      [mouse.x, mouse.y] = [mouse.downX, mouse.downY] = place(event);
      mouse.down = mouse.fresh = true;
    });
    this.canvas.addEventListener('mousemove', (event) => {
      if (mouse.down) [mouse.x, mouse.y] = place(event);
    });
    document.addEventListener('mouseup', () => (mouse.down = false));
    document.addEventListener('keydown', (event) => {
      if (event.repeat || event.keyCode > 255) return;
      this.keys[event.keyCode] = this.keys[256 + event.keyCode] = 255;
      this.keys[512 + event.keyCode] ^= 255;
    });
    document.addEventListener('keyup', (event) => {
      this.keys[event.keyCode] = this.keys[256 + event.keyCode] = 0;
    });
  }

  find(name) {
    return this.passes.find((p) => p.name === name);
  }

  isCube(input) {
    return input.type === 'cubemap' || (input.type === 'buffer' && this.find(input.source).type === 'cubemap');
  }

  // What stands before the user's text. Its first six lines and the uniforms are the site's; main() comes first too.
  header(pass) {
    const lines = [
      '#version 300 es',
      '#ifdef GL_ES',
      'precision highp float;',
      'precision highp int;',
      'precision mediump sampler3D;',
      '#endif',
      '#define HW_PERFORMANCE 1',
      'uniform vec3 iResolution;',
      'uniform float iTime;',
      'uniform float iChannelTime[4];',
      'uniform vec4 iMouse;',
      'uniform vec4 iDate;',
      'uniform float iSampleRate;',
      'uniform vec3 iChannelResolution[4];',
      'uniform int iFrame;',
      'uniform float iTimeDelta;',
      'uniform float iFrameRate;',
    ];
    for (let i = 0; i < 4; ++i) {
      const cube = pass.inputs.some((input) => input.channel === i && this.isCube(input));
      const sampler = cube ? 'samplerCube' : 'sampler2D';
      lines.push(`uniform ${sampler} iChannel${i};`);
      // Chromium 156 loses its context where a structure with a sampler is used behind one that is not.
      if (pass.type === 'image' && new RegExp(`\\biCh${i}\\b`).test(this.common + pass.code))
        lines.push(`uniform struct { ${sampler} sampler; vec3 size; float time; int loaded; } iCh${i};`);
    }
    if (pass.type === 'image')
      lines.push(
        'void mainImage(out vec4 c, in vec2 f);',
        'out vec4 shadertoy_out_color;',
        'void st_assert(bool condition, int value) { if (!condition) shadertoy_out_color.x = float(value); }',
        'void st_assert(bool condition) { st_assert(condition, 0); }',
        'void main(void) { shadertoy_out_color = vec4(1.0, 1.0, 1.0, 1.0); vec4 color = vec4(1e20); ' +
          'mainImage(color, gl_FragCoord.xy); shadertoy_out_color = vec4(color.xyz, 1.0); }',
      );
    else if (pass.type === 'buffer')
      lines.push(
        'void mainImage(out vec4 c, in vec2 f);',
        'out vec4 outColor;',
        'void main(void) { vec4 color = vec4(0.0, 0.0, 0.0, 1.0); mainImage(color, gl_FragCoord.xy); outColor = color; }',
      );
    else
      lines.push(
        'void mainCubemap(out vec4 c, in vec2 f, in vec3 o, in vec3 d);',
        'uniform vec4 unViewport; uniform vec3 unCorners[5];',
        'out vec4 outColor;',
        'void main(void) { vec4 color = vec4(0.0, 0.0, 0.0, 1.0); vec2 uv = (gl_FragCoord.xy - unViewport.xy) / ' +
          'unViewport.zw; vec3 d = normalize(mix(mix(unCorners[0], unCorners[1], uv.x), mix(unCorners[3], ' +
          'unCorners[2], uv.x), uv.y)); mainCubemap(color, gl_FragCoord.xy - unViewport.xy, vec3(0.0), d); ' +
          'outColor = color; }',
      );
    return lines.join('\n') + '\n';
  }

  shader(type, text) {
    const { gl } = this;
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    return shader;
  }

  // Compiles everything. Gives the errors, each as "Tab:line: text", with the line in that tab.
  compile() {
    const { gl } = this;
    const vertex = this.shader(
      gl.VERTEX_SHADER,
      '#version 300 es\nin vec2 pos;\nvoid main() { gl_Position = vec4(pos, 0.0, 1.0); }',
    );
    const errors = [];
    const report = (name, log, before) => {
      const count = errors.length;
      for (const [, line, text] of (log ?? '').matchAll(/ERROR: \d+:(\d+): (.*)/g))
        errors.push(`${name}:${line - before}: ${text}`);
      if (errors.length === count) errors.push(`${name}: ${log}`); // of the whole text
    };
    const lines = (text) => text.split('\n').length - 1;
    if (this.common !== '') {
      const header = `${this.header({ inputs: [] }).split('\n').slice(0, 7).join('\n')}
uniform vec4 iDate; uniform float iSampleRate; out vec4 outColor; void main(void) { outColor = vec4(0.0); }\n`;
      const alone = this.shader(gl.FRAGMENT_SHADER, header + this.common);
      if (!gl.getShaderParameter(alone, gl.COMPILE_STATUS))
        report('Common', gl.getShaderInfoLog(alone), lines(header));
    }
    for (const pass of this.passes) {
      const header = this.header(pass) + this.common;
      const fragment = this.shader(gl.FRAGMENT_SHADER, header + pass.code);
      pass.program = gl.createProgram();
      gl.attachShader(pass.program, vertex);
      gl.attachShader(pass.program, fragment);
      gl.bindAttribLocation(pass.program, 0, 'pos');
      gl.linkProgram(pass.program);
      if (gl.getProgramParameter(pass.program, gl.LINK_STATUS)) continue;
      report(pass.name, gl.getShaderInfoLog(fragment) || gl.getProgramInfoLog(pass.program), lines(header));
    }
    return errors;
  }

  async load() {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 3, -1, -1, 3]), gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
    for (const pass of this.passes) if (pass.type !== 'image') this.makeTarget(pass);
    for (const pass of this.passes)
      for (const input of pass.inputs) {
        if (input.type === 'texture' || input.type === 'cubemap') await this.loadPicture(input);
        else if (input.type === 'keyboard') input.texture = this.keyboard ??= this.makeKeyboard();
        else this.bindPass(input);
      }
  }

  makeTarget(pass) {
    const { gl } = this;
    const cube = pass.type === 'cubemap';
    pass.target = cube ? gl.TEXTURE_CUBE_MAP : gl.TEXTURE_2D;
    pass.size = cube ? [1024, 1024] : [this.canvas.width, this.canvas.height];
    pass.latest = 0;
    pass.textures = [0, 1].map(() => {
      const texture = gl.createTexture();
      gl.bindTexture(pass.target, texture);
      for (let face = 0; face < (cube ? 6 : 1); ++face)
        gl.texImage2D(
          cube ? gl.TEXTURE_CUBE_MAP_POSITIVE_X + face : gl.TEXTURE_2D,
          0,
          cube ? gl.RGBA16F : gl.RGBA32F,
          ...pass.size,
          0,
          gl.RGBA,
          gl.FLOAT,
          null,
        );
      this.setFilter(pass.target, cube ? 'linear' : 'nearest');
      this.setWrap(pass.target, 'clamp');
      return texture;
    });
    pass.framebuffer = gl.createFramebuffer();
  }

  // The wrap mode of a buffer is the buffer's own: the last input to be loaded sets it for all who read it.
  bindPass(input) {
    const source = this.find(input.source);
    source.mipmaps ||= input.sampler.filter === 'mipmap';
    for (const texture of source.textures) {
      this.gl.bindTexture(source.target, texture);
      this.setWrap(source.target, input.sampler.wrap);
    }
  }

  setFilter(target, filter) {
    const { gl } = this;
    const min = { linear: gl.LINEAR, mipmap: gl.LINEAR_MIPMAP_LINEAR }[filter] ?? gl.NEAREST;
    gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, min);
    gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, min === gl.NEAREST ? gl.NEAREST : gl.LINEAR);
  }

  setWrap(target, wrap) {
    const { gl } = this;
    const value = wrap === 'clamp' ? gl.CLAMP_TO_EDGE : gl.REPEAT;
    for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(target, name, value);
  }

  async loadPicture(input) {
    const { gl } = this;
    const cube = input.type === 'cubemap';
    const decode = async (url) => {
      const image = new Image();
      image.src = url;
      await image.decode();
      return image;
    };
    const images = await Promise.all([input.source].flat().map(decode));
    const { filter, wrap, vflip } = input.sampler;
    if (cube && vflip) [images[2], images[3]] = [images[3], images[2]];
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, vflip);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    input.texture = gl.createTexture();
    input.target = cube ? gl.TEXTURE_CUBE_MAP : gl.TEXTURE_2D;
    gl.bindTexture(input.target, input.texture);
    images.forEach((image, face) =>
      gl.texImage2D(
        cube ? gl.TEXTURE_CUBE_MAP_POSITIVE_X + face : gl.TEXTURE_2D,
        0,
        gl.RGBA8,
        gl.RGBA,
        gl.UNSIGNED_BYTE,
        image,
      ),
    );
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    this.setFilter(input.target, filter);
    this.setWrap(input.target, cube ? 'clamp' : wrap);
    if (filter === 'mipmap') gl.generateMipmap(input.target);
    input.size = cube ? [0, 0, 0] : [images[0].width, images[0].height, 1];
  }

  makeKeyboard() {
    const { gl } = this;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    this.setFilter(gl.TEXTURE_2D, 'nearest');
    this.setWrap(gl.TEXTURE_2D, 'clamp');
    return texture;
  }

  // iMouse: xy where it was dragged to, z positive while it is held, w positive in the first frame of a press only.
  mouseValue() {
    const { x, y, downX, downY, down, fresh } = this.mouse;
    return [x, y, down ? downX : -downX, fresh ? downY : -downY];
  }

  step(time, timeDelta, date) {
    const { gl } = this;
    const values = { time, timeDelta, date, mouse: this.mouseValue() };
    if (this.keyboard) {
      gl.bindTexture(gl.TEXTURE_2D, this.keyboard);
      gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.R8, 256, 3, 0, gl.RED, gl.UNSIGNED_BYTE, this.keys);
    }
    if (this.frame === 0)
      for (const pass of this.passes.filter((p) => p.textures))
        for (const texture of pass.textures)
          for (const face of this.faces(pass)) {
            this.attach(pass, texture, face);
            gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
          }
    for (const type of ['buffer', 'cubemap', 'image'])
      for (const pass of this.passes.filter((p) => p.type === type)) this.draw(pass, values);
    this.mouse.fresh = false;
    this.keys.fill(0, 256, 512);
    this.frame += 1;
  }

  faces(pass) {
    const { gl } = this;
    if (pass.type !== 'cubemap') return [gl.TEXTURE_2D];
    return [0, 1, 2, 3, 4, 5].map((face) => gl.TEXTURE_CUBE_MAP_POSITIVE_X + face);
  }

  attach(pass, texture, face) {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, pass.framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, face, texture, 0);
  }

  bindInput(input) {
    const { gl } = this;
    gl.activeTexture(gl.TEXTURE0 + input.channel);
    if (input.type === 'buffer') {
      const source = this.find(input.source);
      gl.bindTexture(source.target, source.textures[source.latest]);
      this.setFilter(source.target, input.sampler.filter);
      return [...source.size, 1];
    }
    gl.bindTexture(input.target ?? gl.TEXTURE_2D, input.texture);
    return input.type === 'keyboard' ? [256, 3, 1] : input.size;
  }

  draw(pass, { time, timeDelta, date, mouse }) {
    const { gl } = this;
    gl.useProgram(pass.program);
    for (let i = 0; i < 4; ++i) {
      gl.activeTexture(gl.TEXTURE0 + i);
      gl.bindTexture(gl.TEXTURE_2D, null);
      gl.bindTexture(gl.TEXTURE_CUBE_MAP, null);
    }
    const sizes = new Float32Array(12);
    for (const input of pass.inputs) sizes.set(this.bindInput(input), 3 * input.channel);
    const at = (name) => gl.getUniformLocation(pass.program, name);
    const size = pass.size ?? [this.canvas.width, this.canvas.height];
    gl.uniform3f(at('iResolution'), ...size, 1);
    gl.uniform1f(at('iTime'), time);
    gl.uniform1f(at('iTimeDelta'), timeDelta);
    gl.uniform1f(at('iFrameRate'), 60);
    gl.uniform1f(at('iSampleRate'), 44100);
    gl.uniform1i(at('iFrame'), this.frame);
    gl.uniform4fv(at('iDate'), date);
    gl.uniform4fv(at('iMouse'), mouse);
    gl.uniform3fv(at('iChannelResolution'), sizes);
    for (let i = 0; i < 4; ++i) {
      gl.uniform1i(at(`iChannel${i}`), i);
      gl.uniform1i(at(`iCh${i}.sampler`), i);
      gl.uniform3fv(at(`iCh${i}.size`), sizes.subarray(3 * i, 3 * i + 3));
      gl.uniform1i(at(`iCh${i}.loaded`), Number(pass.inputs.some((input) => input.channel === i)));
    }
    gl.viewport(0, 0, ...size);
    if (pass.type === 'image') {
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      return;
    }
    const next = 1 - pass.latest;
    this.faces(pass).forEach((face, index) => {
      this.attach(pass, pass.textures[next], face);
      if (pass.type === 'cubemap') {
        gl.uniform4f(at('unViewport'), 0, 0, ...size);
        gl.uniform3fv(at('unCorners'), Site.corners[index]);
      }
      gl.drawArrays(gl.TRIANGLES, 0, 3);
    });
    pass.latest = next;
    if (pass.mipmaps) {
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(pass.target, pass.textures[next]);
      gl.generateMipmap(pass.target);
    }
  }

  // What a pass drew last, float32 RGBA, the bottom row first; the canvas has 8 bits, which become n / 255.
  read(name) {
    const { gl } = this;
    const pass = this.find(name);
    const [width, height] = pass.size ?? [this.canvas.width, this.canvas.height];
    let floats = new Float32Array(4 * width * height);
    if (pass.type === 'image') {
      const bytes = new Uint8Array(floats.length);
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      floats = Float32Array.from(bytes, (byte) => byte / 255);
    } else {
      this.attach(pass, pass.textures[pass.latest], this.faces(pass)[0]);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, floats);
    }
    const bytes = new Uint8Array(floats.buffer);
    let text = '';
    for (let i = 0; i < bytes.length; i += 32768) text += String.fromCharCode(...bytes.subarray(i, i + 32768));
    return { width, height, base64: btoa(text) };
  }
};

// Directions of a cube's corners as seen from its faces: lower left, lower right, upper right, upper left.
window.Site.corners = [
  [1, 1, 1, 1, 1, -1, 1, -1, -1, 1, -1, 1],
  [-1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1],
  [-1, 1, -1, 1, 1, -1, 1, 1, 1, -1, 1, 1],
  [-1, -1, 1, 1, -1, 1, 1, -1, -1, -1, -1, -1],
  [-1, 1, 1, 1, 1, 1, 1, -1, 1, -1, -1, 1],
  [1, 1, -1, -1, 1, -1, -1, -1, -1, 1, -1, -1],
];
