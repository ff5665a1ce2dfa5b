// Inputs that go on by themselves: music, microphone, video, webcam. A browser starts sound only after a click or a key.

class Sounds {
  constructor() {
    this.muted = true;
    this.films = []; // elements that sound by themselves
  }

  get context() {
    if (!this.own) {
      this.own = new AudioContext({ sampleRate: soundRate });
      this.volume = this.own.createGain();
      this.volume.connect(this.own.destination);
      this.mute(this.muted);
      for (const event of ['pointerdown', 'keydown']) addEventListener(event, () => this.own.resume());
    }
    return this.own;
  }

  mute(muted) {
    this.muted = muted;
    if (this.own) this.volume.gain.value = muted ? 0 : 1;
    for (const film of this.films) film.muted = muted;
  }
}

// What fills 512 x 2 bytes: the spectrum, then the wave. The extension has half as many bins as columns.
function analysed(source, site) {
  const analyser = new AnalyserNode(source.context, { fftSize: site ? 2048 : 512 });
  source.connect(analyser);
  const bins = new Uint8Array(Math.min(512, analyser.frequencyBinCount));
  const fill = (values) => {
    analyser.getByteFrequencyData(bins);
    for (let i = 0; i < 512; ++i) values[i] = bins[Math.floor((i * bins.length) / 512)];
    analyser.getByteTimeDomainData(values.subarray(512));
  };
  return { analyser, fill };
}

// The signal that shadertoy.com shows where sound is off.
function preview(values, time) {
  const beat = (0.5 + 0.5 * Math.sin(2 * Math.PI * time)) ** 4;
  for (let i = 0; i < 512; ++i) {
    const x = i / 512;
    const level = i < 3 ? beat * (1 - i / 3) : (0.75 + 0.25 * Math.sin(10 * i + 13 * time)) * Math.exp(-3 * x);
    const wave = 0.5 + 0.15 * Math.sin(17 * time + 20 * Math.PI * x) * Math.sin(23 * time + 1.9 * x);
    values[i] = 255 * level;
    values[512 + i] = 255 * wave;
  }
}

async function captured(constraints) {
  return navigator.mediaDevices.getUserMedia(constraints).catch(() => null);
}

// A source that moves has refresh(frame), and time() for iChannelTime. Music that is missing is silent.
async function startSound(gl, input, project, sounds) {
  const table = makeTable(gl, 512, 2);
  const values = new Uint8Array(1024).fill(128, 512);
  let element = null;
  let fill = () => {};
  let time = () => element?.currentTime ?? 0;
  if (project.muted) {
    let now = 0;
    fill = (bytes, frame) => preview(bytes, (now = frame.time));
    time = () => 10 + now;
  } else if (input.kind === 'music' && !input.missing) {
    element = Object.assign(document.createElement('audio'), { src: project.media[input.media[0]], loop: true });
    const heard = analysed(sounds.context.createMediaElementSource(element), project.site);
    heard.analyser.connect(sounds.volume);
    fill = heard.fill;
  } else if (input.kind === 'microphone') {
    const stream = await captured({ audio: true });
    // A stream has its device's rate, which not every browser mixes with another.
    if (stream) fill = analysed(new AudioContext().createMediaStreamSource(stream), project.site).fill;
  }
  const refresh = (frame) => {
    fill(values, frame);
    table.update(values, !project.site);
  };
  refresh({ time: 0 });
  return { ...table, refresh, element, time };
}

async function startVideo(gl, input, project, sounds) {
  const element = Object.assign(document.createElement('video'), { loop: true, muted: true, playsInline: true });
  if (input.kind === 'video') element.src = project.media[input.media[0]];
  else element.srcObject = await captured({ video: true });
  if (input.kind === 'video' && !project.muted) sounds.films.push(element);
  const target = gl.TEXTURE_2D;
  const texture = gl.createTexture();
  const source = { target, texture, element, time: () => (input.kind === 'video' ? element.currentTime : 0) };
  source.refresh = () => {
    if (element.readyState < 2) return;
    gl.bindTexture(target, texture);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, input.vflip);
    gl.texImage2D(target, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, element);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    if (source.mipmaps) gl.generateMipmap(target);
    source.size = [element.videoWidth, element.videoHeight, 1];
  };
  return source;
}
