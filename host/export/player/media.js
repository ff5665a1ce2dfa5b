// Inputs that go on by themselves: music, microphone, video, webcam. A browser starts sound only after a click or a key.

class Sounds {
  constructor() {
    this.muted = true;
  }

  get context() {
    if (!this.own) {
      this.own = new AudioContext();
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
  }

  // What fills 512 x 2 bytes: the spectrum, then the wave.
  analysed(source, audible) {
    const analyser = this.context.createAnalyser();
    source.connect(analyser);
    if (audible) analyser.connect(this.volume);
    return (values) => {
      analyser.getByteFrequencyData(values.subarray(0, 512));
      analyser.getByteTimeDomainData(values.subarray(512));
    };
  }
}

async function captured(constraints) {
  return navigator.mediaDevices.getUserMedia(constraints).catch(() => null);
}

async function startSound(gl, input, media, sounds, grey) {
  const table = makeTable(gl, 512, 2);
  const values = new Uint8Array(1024).fill(128, 512);
  table.update(values, grey);
  let element = null;
  let fill = () => {};
  if (input.kind === 'music') {
    element = Object.assign(document.createElement('audio'), { src: media[input.media[0]], loop: true });
    fill = sounds.analysed(sounds.context.createMediaElementSource(element), true);
  } else {
    const stream = await captured({ audio: true });
    if (stream) fill = sounds.analysed(sounds.context.createMediaStreamSource(stream), false);
  }
  const update = () => {
    fill(values);
    table.update(values, grey);
  };
  return { ...table, update, element };
}

async function startVideo(gl, input, media) {
  const element = Object.assign(document.createElement('video'), { loop: true, muted: true, playsInline: true });
  if (input.kind === 'video') element.src = media[input.media[0]];
  else element.srcObject = await captured({ video: true });
  const target = gl.TEXTURE_2D;
  const texture = gl.createTexture();
  const update = () => {
    if (element.readyState < 2) return;
    gl.bindTexture(target, texture);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, input.vflip);
    gl.texImage2D(target, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, element);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    if (input.mipmaps) gl.generateMipmap(target);
    input.size = [element.videoWidth, element.videoHeight, 1];
  };
  return { target, texture, update, element };
}
