// Names of GLSL ES 1.00 and of older players, which the VS Code extension takes.
#iChannel0 "self"
varying vec2 unused;
float level() { return texture2D(iChannel0, gl_FragCoord.xy / iResolution.xy).x + iGlobalTime; }
void main() { gl_FragColor = vec4(saturate(level())); }
