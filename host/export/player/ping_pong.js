// Which of its targets a pass draws into, and which one its readers get; host/player/ping_pong.h says what and why.

class PingPong {
  // targets: how many each pass has, 1 or 2.
  constructor(targets, quirks) {
    this.targets = targets;
    this.quirks = quirks;
    this.front = targets.map(() => 0);
    this.size = null;
    this.reportedSize = null;
    this.warmingUp = false;
  }

  // A frame of a size begins. Gives the frame of a warm-up before it, if there is one.
  begin(frame, size) {
    const first = this.size === null;
    const resized = !first && size.some((length, axis) => length !== this.size[axis]);
    const starts = first || (frame.index === 0 && !resized);
    this.size = size;
    if (!this.quirks || starts) this.reportedSize = size;
    this.warmingUp = this.quirks && starts && frame.index === 0;
    return this.warmingUp ? { ...frame, time: 0, timeDelta: 0 } : null;
  }

  endWarmUp() {
    this.warmingUp = false;
  }

  // The target that a pass draws into next.
  back(pass) {
    return this.targets[pass] === 2 ? 1 - this.front[pass] : 0;
  }

  // The target of `source` that is read while `reader` draws.
  readBy(reader, source) {
    if (!this.quirks || reader === source) return this.front[source];
    return source < reader && !this.warmingUp ? this.front[source] : this.back(source);
  }

  drawn(pass) {
    if (!this.warmingUp) this.front[pass] = this.back(pass);
  }
}
