// The sound pass: 180 seconds, drawn block by block while the picture already plays.

const soundRate = 44100;
const soundSeconds = 180;
const blockSide = 512;

async function makeSound(renderer, pass, date) {
  const { gl } = renderer;
  const blockSamples = blockSide * blockSide;
  const buffer = renderer.sounds.context.createBuffer(2, soundRate * soundSeconds, soundRate);
  const target = { kind: gl.TEXTURE_2D, format: gl.RGBA32F, mipmaps: false };
  const { framebuffers } = renderer.makeSurface(target, [blockSide, blockSide]);
  const texels = new Float32Array(4 * blockSamples);
  for (let start = 0; start < buffer.length; start += blockSamples) {
    gl.useProgram(pass.program);
    renderer.setUniforms(pass, [blockSide, blockSide], {
      iTimeOffset: start / soundRate,
      iSampleOffset: start,
      iDate: [...date.slice(0, 3), Math.floor(date[3])],
      iChannelResolution: renderer.bindInputs(pass),
    });
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffers[0]);
    gl.viewport(0, 0, blockSide, blockSide);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.readPixels(0, 0, blockSide, blockSide, gl.RGBA, gl.FLOAT, texels);
    const count = Math.min(blockSamples, buffer.length - start);
    for (let side = 0; side < 2; ++side) {
      const samples = new Float32Array(count);
      for (let i = 0; i < count; ++i) samples[i] = Math.min(Math.max(texels[4 * i + side], -1), 1);
      buffer.copyToChannel(samples, side, start);
    }
    await new Promise((resolve) => setTimeout(resolve));
  }
  return buffer;
}

// Plays the buffer along with the picture's clock.
class SoundTrack {
  constructor(sounds, buffer) {
    this.sounds = sounds;
    this.buffer = buffer;
  }

  play(time) {
    this.stop();
    if (time >= this.buffer.duration) return;
    this.source = this.sounds.context.createBufferSource();
    this.source.buffer = this.buffer;
    this.source.connect(this.sounds.volume);
    this.source.start(0, time);
  }

  stop() {
    this.source?.stop();
    this.source = null;
  }
}
