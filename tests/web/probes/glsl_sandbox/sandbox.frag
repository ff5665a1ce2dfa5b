#ifdef GL_ES
precision mediump float;
#endif
uniform float time;
uniform vec2 mouse;
uniform vec2 resolution;
uniform sampler2D backbuffer;
varying vec2 surfacePosition;
void main(void) {
  vec4 last = texture2D(backbuffer, gl_FragCoord.xy / resolution);
  gl_FragColor = vec4(mouse.x, floor(time * 2.0) / 4.0, last.b + 0.2 * step(0.0, surfacePosition.y), 1.0);
}
