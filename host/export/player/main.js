// The page: clock, buttons, messages. What stands behind # in the address sets it up: paused, time=SECONDS, size=WxH
// (pixels, whatever the window's), bare (no bar). Scripts drive it through window.shadertwin.

const find = (id) => document.getElementById(id);
const project = JSON.parse(find('project').textContent);
const settings = new URLSearchParams(location.hash.slice(1));
const canvas = document.querySelector('canvas');
const fixedSize = /^(\d+)x(\d+)$/.exec(settings.get('size') ?? '');

function showMessage(text) {
  find('message').textContent = text;
  find('message').hidden = false;
}

function localDate() {
  const now = new Date();
  const seconds = now.getHours() * 3600 + now.getMinutes() * 60 + now.getSeconds() + now.getMilliseconds() / 1000;
  return [now.getFullYear(), now.getMonth(), now.getDate(), seconds];
}

// iTimeDelta where there is nothing to measure. The extension says 0 in its first frame and while it is paused.
function unmeasured(still) {
  return project.quirks && still ? 0 : 1 / 60;
}

class Clock {
  constructor(start) {
    this.start = start;
    this.reset();
  }

  reset() {
    this.time = this.start;
    this.frame = 0;
    this.rate = 60;
    this.counted = 0;
    this.resume();
  }

  // Time goes on from here with the next frame. Until there is a frame before it, its delta is 1/60.
  resume() {
    this.last = null;
    this.since = null;
  }

  // now: milliseconds of any clock. Gives iTimeDelta.
  tick(now) {
    const delta = this.last === null ? unmeasured(this.frame === 0) : (now - this.last) / 1000;
    if (this.last === null) [this.origin, this.base] = [now, this.time];
    this.time = this.base + (now - this.origin) / 1000;
    this.last = now;
    this.since ??= now;
    this.counted += 1;
    if (now - this.since > 500) {
      this.rate = (1000 * this.counted) / (now - this.since);
      this.since = now;
      this.counted = 0;
    }
    return delta;
  }
}

class Player {
  constructor() {
    this.paused = settings.has('paused');
    this.clock = new Clock(Number(settings.get('time') ?? 0));
    this.ready = this.start().catch((error) => {
      showMessage(error.message);
      return [error.message];
    });
  }

  async start() {
    this.renderer = new Renderer(canvas, project);
    this.hands = new Hands(canvas, project);
    canvas.addEventListener('webglcontextlost', () => showMessage('The graphics device was lost. Load the page again.'));
    const messages = await this.renderer.start();
    if (messages.length > 0) {
      showMessage(messages.join('\n'));
      return messages;
    }
    new ResizeObserver(() => this.fit()).observe(canvas.parentElement);
    this.fit();
    this.showState();
    const sound = !project.muted && project.passes.find((pass) => !pass.every_frame);
    const { sounds } = this.renderer;
    find('sound').hidden =
      !sound && (project.muted || !project.passes.some((pass) => pass.inputs.some((i) => !i.missing && (i.kind === 'music' || i.kind === 'video'))));
    document.body.classList.toggle('muted', sounds.muted);
    if (sound) this.startSound(sound);
    requestAnimationFrame((now) => this.loop(now));
    return [];
  }

  async startSound(pass) {
    this.track = new SoundTrack(this.renderer.sounds, await makeSound(this.renderer, pass, localDate()));
    if (!this.paused) this.track.play(this.clock.time);
  }

  fit() {
    const box = canvas.parentElement.getBoundingClientRect();
    const scale = window.devicePixelRatio;
    const size = fixedSize ? [Number(fixedSize[1]), Number(fixedSize[2])] : [box.width * scale, box.height * scale];
    const [width, height] = size.map((length) => Math.max(1, Math.round(length)));
    if (this.size?.[0] === width && this.size[1] === height) return;
    this.size = [width, height];
    this.renderer.resize(width, height);
    find('size').textContent = `${width} × ${height}`;
    if (!project.site) this.clock.frame = 0;
    if (this.paused && this.clock.frame > 0) this.draw(unmeasured(true), localDate());
  }

  draw(timeDelta, date) {
    const { clock } = this;
    this.renderer.draw({
      index: clock.frame,
      time: clock.time,
      timeDelta,
      frameRate: clock.rate,
      date,
      ...this.hands.frame(),
    });
    this.hands.endFrame();
    clock.frame += 1;
    find('time').textContent = clock.time.toFixed(2);
  }

  loop(now) {
    requestAnimationFrame((next) => this.loop(next));
    if (this.paused) return;
    this.hands.fly();
    this.draw(this.clock.tick(now), localDate());
    find('rate').textContent = `${this.clock.rate.toFixed(this.clock.rate < 9.95 ? 1 : 0)} fps`;
  }

  pause(paused = true) {
    this.paused = paused;
    this.clock.resume();
    this.showState();
    if (paused) this.track?.stop();
    else this.track?.play(this.clock.time);
  }

  reset() {
    this.clock.reset();
    this.hands.camera = new FlyCamera();
    for (const { element } of this.renderer.media.values()) if (element) element.currentTime = 0;
    if (!this.paused) this.track?.play(this.clock.time);
  }

  showState() {
    document.body.classList.toggle('paused', this.paused);
    for (const { element } of this.renderer.media.values())
      if (this.paused) element?.pause();
      else element?.play().catch(() => {});
  }

  toggleSound() {
    const { sounds } = this.renderer;
    sounds.mute(!sounds.muted);
    sounds.context.resume();
    document.body.classList.toggle('muted', sounds.muted);
    if (!this.paused) this.track?.play(this.clock.time);
  }
}

const player = new Player();
document.body.classList.toggle('bare', settings.has('bare'));
if (fixedSize) {
  canvas.classList.add('fixed');
  canvas.width = Number(fixedSize[1]);
  canvas.height = Number(fixedSize[2]);
}

find('reset').addEventListener('click', () => player.reset());
find('pause').addEventListener('click', () => player.pause(!player.paused));
find('sound').addEventListener('click', () => player.toggleSound());
find('fullscreen').addEventListener('click', () => document.querySelector('main').requestFullscreen());
addEventListener('keydown', (event) => {
  if (!event.altKey || (event.key !== 'ArrowDown' && event.key !== 'ArrowUp')) return;
  event.preventDefault();
  if (event.key === 'ArrowDown') player.reset();
  else player.pause(!player.paused);
});
showUniforms(project.uniforms, () => player.paused && player.clock.frame > 0 && player.draw(unmeasured(true), localDate()));

window.shadertwin = {
  ready: player.ready, // the compiler's messages, none if all is well
  pause: () => player.pause(true),
  play: () => player.pause(false),
  // The next frame is frame 0, with cleared buffers and nothing touched.
  reset: () => {
    player.reset();
    player.hands.forget();
  },
  // Draws the next frame. `now`: milliseconds of the caller's own clock. To be used while paused.
  step: (now, date = localDate()) => {
    player.hands.fly();
    player.draw(player.clock.tick(now), date);
  },
  // A pass by its name: { width, height, rgba }, the bottom row first.
  read: (name) => player.renderer.read(project.passes.find((pass) => pass.name === name)),
  passes: project.passes.map((pass) => pass.name),
  analysed, // of an audio node and a dialect: how a channel shows it
};
