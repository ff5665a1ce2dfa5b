vec2 mainSound(int samp, float time) { return vec2(wave(time, 440.0), wave(time, 441.0)); }
