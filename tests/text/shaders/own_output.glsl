// A shader that brings its own output and main().
layout(location = 0) out vec4 color;
void main() { color = vec4(gl_FragCoord.xy / iResolution.xy, 0.0, 1.0); }
