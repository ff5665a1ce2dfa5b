// Draws the passes of a project: targets, uniforms, the order of things.

const keyboardUnit = 10;

const uniformSetters = {
  iResolution: 'uniform3fv',
  iTime: 'uniform1f',
  iTimeDelta: 'uniform1f',
  iFrameRate: 'uniform1f',
  iFrame: 'uniform1i',
  iDate: 'uniform4fv',
  iMouse: 'uniform4fv',
  iMouseButton: 'uniform4fv',
  iSampleRate: 'uniform1f',
  iChannelTime: 'uniform1fv',
  iChannelResolution: 'uniform3fv',
  iTimeOffset: 'uniform1f',
  iSampleOffset: 'uniform1i',
};

const customSetters = {
  float: ['uniform1fv', 1],
  vec2: ['uniform2fv', 2],
  vec3: ['uniform3fv', 3],
  vec4: ['uniform4fv', 4],
  int: ['uniform1iv', 1],
  ivec2: ['uniform2iv', 2],
  ivec3: ['uniform3iv', 3],
  ivec4: ['uniform4iv', 4],
};

class Renderer {
  constructor(canvas, project) {
    const gl = canvas.getContext('webgl2', {
      alpha: false,
      antialias: false,
      depth: false,
      powerPreference: 'high-performance',
      preserveDrawingBuffer: true, // where a shader discards, the last picture stays
    });
    if (!gl) throw new Error('This browser has no WebGL2.');
    if (!gl.getExtension('EXT_color_buffer_float')) throw new Error('This device cannot draw into float textures.');
    gl.getExtension('OES_texture_float_linear');
    this.gl = gl;
    this.canvas = canvas;
    this.project = project;
    this.passes = project.passes;
    this.passes.forEach((pass, index) => Object.assign(pass, { index }));
    this.pingPong = new PingPong(this.passes.map((pass) => pass.targets), project.quirks);
    this.drawn = this.passes.filter((pass) => pass.every_frame);
    this.shown = this.passes.at(-1);
    this.sounds = new Sounds();
    this.media = new Map();
    this.blanks = new Map();
    this.undrawn = new Map();
  }

  // Compiles and loads. Gives the compiler's messages; with any, nothing can be drawn.
  async start() {
    const { gl } = this;
    gl.disable(gl.DITHER);
    const messages = await compilePasses(gl, this.project);
    if (messages.length > 0) return messages;
    this.copy = startProgram(gl, copy).program;
    const read = new Set(this.passes.flatMap((pass) => pass.inputs.map((input) => this.passes[input.pass])));
    for (const pass of this.passes) {
      this.findUniforms(pass);
      // The picture needs no float target of its own when no pass reads it.
      if (pass.every_frame && (pass !== this.shown || read.has(pass))) this.prepareTarget(pass);
      for (const input of pass.inputs) await this.loadInput(input);
    }
    if (this.passes.some((pass) => pass.keyboard)) this.needKeyboard();
    // The extension's empty channels are (0, 0, 0, 0), where a browser's are (0, 0, 0, 1).
    if (this.project.quirks)
      for (const kind of [gl.TEXTURE_2D, gl.TEXTURE_CUBE_MAP, gl.TEXTURE_3D]) this.blanks.set(kind, makeBlank(gl, kind, 1, 1));
    return [];
  }

  findUniforms(pass) {
    const { gl } = this;
    gl.useProgram(pass.program);
    pass.uniforms = [];
    const count = gl.getProgramParameter(pass.program, gl.ACTIVE_UNIFORMS);
    for (let i = 0; i < count; ++i) {
      const name = gl.getActiveUniform(pass.program, i).name.replace('[0]', '');
      const location = gl.getUniformLocation(pass.program, name);
      const custom = this.project.uniforms.find((uniform) => uniform.name === name);
      const channel = /^iCh(?:annel(\d)|(\d)\.sampler)$/.exec(name);
      const member = /^iCh(\d)\.(size|time|loaded)$/.exec(name);
      if (channel) gl.uniform1i(location, Number(channel[1] ?? channel[2]));
      else if (member) pass.uniforms.push({ location, channel: Number(member[1]), member: member[2] });
      else if (name === 'iKeyboard') gl.uniform1i(location, keyboardUnit);
      else if (name === 'iViewMatrix') pass.uniforms.push({ location, name, matrix: true });
      else if (name === 'shadertwin_face') pass.face = location;
      else if (custom) pass.uniforms.push({ location, custom, setter: customSetters[custom.type] });
      else if (uniformSetters[name]) pass.uniforms.push({ location, name, setter: uniformSetters[name] });
    }
  }

  prepareTarget(pass) {
    const { gl, passes } = this;
    const cube = pass.faces === 6;
    const readers = passes.flatMap((p) => p.inputs).filter((input) => passes[input.pass] === pass);
    pass.target = {
      kind: targetOf(gl, cube ? 'cube' : 'flat'),
      side: pass.side,
      format: cube ? gl.RGBA16F : gl.RGBA32F,
      mipmaps: readers.some((input) => input.mipmaps),
      size: null,
      surfaces: [],
    };
  }

  needKeyboard() {
    this.keyboard ??= makeTable(this.gl, 256, this.project.site ? 3 : 4);
    this.keyboard.sampler ??= makeSampler(this.gl, { min: 'NEAREST', mag: 'NEAREST', wrap: 'CLAMP_TO_EDGE' });
    return this.keyboard;
  }

  async loadInput(input) {
    const { gl, project } = this;
    input.sampler = makeSampler(gl, input);
    if (input.source === 'keyboard') Object.assign(input, { texels: this.needKeyboard(), sampler: this.keyboard.sampler });
    else if (input.source === 'moving' && (input.audio || !input.missing)) input.texels = await this.startMedium(input);
    else if (input.source === 'undrawn' && !input.missing) input.texels = this.undrawnPass(input);
    else if (input.media.length > 0) input.texels = await uploadPicture(gl, input, project.media);
  }

  // A pass that is not there reads as one that was never drawn.
  undrawnPass({ shape, size: [side] }) {
    const key = `${shape} ${side}`;
    if (!this.undrawn.has(key)) this.undrawn.set(key, { target: targetOf(this.gl, shape), side });
    return this.undrawn.get(key);
  }

  // What moves plays once, whatever number of channels reads it.
  async startMedium(input) {
    const key = [input.kind, input.vflip, ...input.media].join();
    if (!this.media.has(key)) {
      const start = input.audio ? startSound : startVideo;
      this.media.set(key, await start(this.gl, input, this.project, this.sounds));
    }
    const source = this.media.get(key);
    source.mipmaps ||= input.mipmaps;
    return source;
  }

  // New targets keep, on shadertoy.com, the old pixels from the lower left corner up; the first of two counts as
  // the last one from then on.
  resize(width, height) {
    const { gl, canvas } = this;
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    for (const source of this.undrawn.values()) {
      const size = source.side ? [source.side, source.side] : [width, height];
      this.gl.deleteTexture(source.texture);
      Object.assign(source, { texture: makeBlank(this.gl, source.target, ...size), size: [...size, 1] });
    }
    for (const { target, targets, index } of this.passes.filter((pass) => pass.target)) {
      if (target.side && target.size) continue;
      const size = target.side ? [target.side, target.side] : [width, height];
      const old = target.size;
      target.surfaces = Array.from({ length: targets }, (_, i) => this.makeSurface(target, size, old && target.surfaces[i], old));
      target.size = size;
      if (this.project.site) this.pingPong.front[index] = 0;
    }
  }

  makeSurface(target, size, previous, oldSize) {
    const { gl } = this;
    const texture = gl.createTexture();
    gl.bindTexture(target.kind, texture);
    gl.texStorage2D(target.kind, target.mipmaps ? levelsOf(...size) : 1, target.format, ...size);
    const framebuffers = faceTargets(gl, target.kind).map((face) => {
      const framebuffer = gl.createFramebuffer();
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, face, texture, 0);
      return framebuffer;
    });
    if (previous) {
      if (this.project.site) {
        const [w, h] = [0, 1].map((axis) => Math.min(size[axis], oldSize[axis]));
        gl.bindFramebuffer(gl.READ_FRAMEBUFFER, previous.framebuffers[0]);
        gl.blitFramebuffer(0, 0, w, h, 0, 0, w, h, gl.COLOR_BUFFER_BIT, gl.NEAREST);
      }
      previous.framebuffers.forEach((framebuffer) => gl.deleteFramebuffer(framebuffer));
      gl.deleteTexture(previous.texture);
    }
    this.makeMipmaps(target, { texture });
    return { texture, framebuffers };
  }

  makeMipmaps(target, { texture }) {
    const { gl } = this;
    if (!target.mipmaps) return;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(target.kind, texture);
    gl.generateMipmap(target.kind);
  }

  clear() {
    const { gl } = this;
    for (const { target } of this.passes.filter((pass) => pass.target))
      for (const surface of target.surfaces) {
        for (const framebuffer of surface.framebuffers) {
          gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
          gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
        }
        this.makeMipmaps(target, surface);
      }
  }

  // frame: index, time, timeDelta, frameRate, date, mouse, buttons, keys.
  draw(frame) {
    const warmUp = this.pingPong.begin(frame, [this.canvas.width, this.canvas.height]);
    if (frame.index === 0) this.clear();
    this.keyboard?.update(frame.keys, !this.project.site);
    for (const medium of this.media.values()) medium.refresh(frame);
    if (warmUp) {
      for (const pass of this.drawn) this.drawPass(pass, warmUp);
      this.pingPong.endWarmUp();
    }
    for (const pass of this.drawn) this.drawPass(pass, frame);
    if (this.shown.target) this.show();
  }

  // Gives the sizes of what is bound.
  bindInputs(pass) {
    const { gl } = this;
    for (let unit = 0; unit < keyboardUnit; ++unit) {
      gl.activeTexture(gl.TEXTURE0 + unit);
      for (const kind of [gl.TEXTURE_2D, gl.TEXTURE_CUBE_MAP, gl.TEXTURE_3D]) gl.bindTexture(kind, this.blanks.get(kind) ?? null);
      gl.bindSampler(unit, null);
    }
    const sizes = new Float32Array(30);
    for (const input of pass.inputs) {
      const source = this.passes[input.pass];
      gl.activeTexture(gl.TEXTURE0 + input.channel);
      gl.bindSampler(input.channel, input.sampler);
      if (source) gl.bindTexture(source.target.kind, this.surfaceFor(pass, source).texture);
      else if (input.texels) gl.bindTexture(input.texels.target, input.texels.texture);
      sizes.set(source ? [...this.reportedSize(source), 1] : (input.texels?.size ?? input.size), 3 * input.channel);
    }
    if (this.keyboard) {
      gl.activeTexture(gl.TEXTURE0 + keyboardUnit);
      gl.bindTexture(gl.TEXTURE_2D, this.keyboard.texture);
      gl.bindSampler(keyboardUnit, this.keyboard.sampler);
    }
    return sizes;
  }

  surfaceFor(reader, source) {
    return source.target.surfaces[this.pingPong.readBy(reader.index, source.index)];
  }

  reportedSize({ side }) {
    return side ? [side, side] : this.pingPong.reportedSize;
  }

  setUniforms(pass, size, values) {
    const { gl } = this;
    const times = new Float32Array(4);
    for (const input of pass.inputs) if (input.channel < 4) times[input.channel] = input.texels?.time?.() ?? 0;
    const all = {
      ...values,
      iResolution: [...size, 1],
      iSampleRate: this.project.site || pass.inputs.some((i) => i.audio && !i.missing) ? 44100 : 0,
      iChannelTime: times,
    };
    const sizes = values.iChannelResolution;
    for (const { location, name, custom, setter, channel, member, matrix } of pass.uniforms)
      if (matrix) gl.uniformMatrix4fv(location, false, all[name]);
      else if (member === 'size') gl.uniform3fv(location, sizes.subarray(3 * channel, 3 * channel + 3));
      else if (member === 'time') gl.uniform1f(location, times[channel]);
      else if (member === 'loaded') gl.uniform1i(location, pass.inputs.some((i) => i.channel === channel) ? 1 : 0);
      else if (custom) gl[setter[0]](location, custom.value.slice(0, setter[1]));
      else if (name !== 'iChannelResolution') gl[setter](location, all[name]);
      else gl[setter](location, sizes.subarray(0, this.project.site ? 12 : 30));
  }

  drawPass(pass, frame) {
    const { gl, canvas } = this;
    const { target } = pass;
    const size = target?.size ?? [canvas.width, canvas.height];
    gl.useProgram(pass.program);
    this.setUniforms(pass, size, {
      iTime: frame.time,
      iTimeDelta: frame.timeDelta,
      iFrameRate: frame.frameRate,
      iFrame: frame.index,
      iDate: frame.date,
      iMouse: frame.mouse,
      iMouseButton: frame.buttons,
      iViewMatrix: frame.view,
      iChannelResolution: this.bindInputs(pass),
    });
    gl.viewport(0, 0, ...size);
    const back = this.pingPong.back(pass.index);
    const framebuffers = target ? target.surfaces[back].framebuffers : [null];
    for (const [face, framebuffer] of framebuffers.entries()) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      if (pass.face) gl.uniform1i(pass.face, face);
      // The extension clears every target before it draws, which shows where a shader discards.
      if (!this.project.site) gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
      if (pass.vertex) gl.enable(gl.CULL_FACE);
      gl.drawArrays(gl.TRIANGLES, 0, pass.vertex ? 6 : 3);
      gl.disable(gl.CULL_FACE);
    }
    this.pingPong.drawn(pass.index);
    if (target) this.makeMipmaps(target, target.surfaces[back]);
  }

  // What a pass drew last.
  last({ target, index }) {
    return target.surfaces[this.pingPong.front[index]];
  }

  show() {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.useProgram(this.copy);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.last(this.shown).texture);
    gl.bindSampler(0, null);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  // What a pass drew last: width, height and RGBA, the bottom row first. Float32, but for a picture that only the canvas
  // holds: 8 bits, as fractions of 1. The faces of a cubemap stand on top of one another, +X lowest.
  read(pass) {
    const { gl, canvas } = this;
    const { target } = pass;
    const [width, height] = target?.size ?? [canvas.width, canvas.height];
    const framebuffers = target ? this.last(pass).framebuffers : [null];
    const rgba = new Float32Array(4 * width * height * framebuffers.length);
    for (const [face, framebuffer] of framebuffers.entries()) {
      const part = rgba.subarray(4 * width * height * face, 4 * width * height * (face + 1));
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      if (target) {
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, part);
      } else {
        const bytes = new Uint8Array(part.length);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
        part.set(Float32Array.from(bytes, (byte) => byte / 255));
      }
    }
    return { width, height: height * framebuffers.length, rgba };
  }
}
