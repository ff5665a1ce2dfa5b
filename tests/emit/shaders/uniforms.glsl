// Every built-in uniform.
void mainImage(out vec4 color, in vec2 p) {
  int k = int(p.x) % 4;
  color = vec4(iResolution.x, iResolution.y, iResolution.z, iTime);
  if (k == 1) color = vec4(iTimeDelta, float(iFrame), iFrameRate, iSampleRate);
  if (k == 2) color = iDate + iMouse;
  if (k == 3) color = vec4(iChannelResolution[0].xy, iChannelTime[1], gl_FragCoord.z + gl_FragCoord.w);
}
