// Who draws and reads which picture in a frame; host/player/rounds.h says what and why.

class Rounds {
  // pictures: how many each pass has, 1 or 2.
  constructor(pictures, quirks) {
    this.pictures = pictures;
    this.quirks = quirks;
    this.shown = pictures.map(() => 0);
    this.size = null;
    this.reportedSize = null;
    this.rehearsing = false;
  }

  // A frame of pictures of a size begins. Gives the frame of a rehearsal before it, if there is one.
  begin(frame, size) {
    const first = this.size === null;
    const resized = !first && size.some((length, axis) => length !== this.size[axis]);
    const starts = first || (frame.index === 0 && !resized);
    this.size = size;
    if (!this.quirks || starts) this.reportedSize = size;
    this.rehearsing = this.quirks && starts && frame.index === 0;
    return this.rehearsing ? { ...frame, time: 0, timeDelta: 0 } : null;
  }

  endRehearsal() {
    this.rehearsing = false;
  }

  // The picture that a pass draws into next.
  target(pass) {
    return this.pictures[pass] === 2 ? 1 - this.shown[pass] : 0;
  }

  // The picture of `source` that is read while `reader` draws.
  readBy(reader, source) {
    if (!this.quirks || reader === source) return this.shown[source];
    return source < reader && !this.rehearsing ? this.shown[source] : this.target(source);
  }

  drawn(pass) {
    if (!this.rehearsing) this.shown[pass] = this.target(pass);
  }
}
