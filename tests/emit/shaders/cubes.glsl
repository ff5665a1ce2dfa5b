// A cube's corners and edges, filtered: one pixel there changes how the seven beside it are added up, also
// where it has left the loop.
#iChannel0 "../../../shadertoy/cubemaps/forest_{}.jpg"
#iChannel0::Type "CubeMap"
#iChannel0::MinFilter "LinearMipMapLinear"
#iChannel0::MagFilter "Linear"
uint hash(uint x) {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  return x ^ (x >> 16);
}
float signed_fraction(uint x) { return float(int(hash(x)) >> 8) * (1.0 / 8388608.0); }

// Most of the way to a corner, an edge or the middle of a face, by the lowest bits of n.
vec3 direction(uint n) {
  uint h = hash(n);
  vec3 at = vec3(signed_fraction(3u * n), signed_fraction(3u * n + 1u), signed_fraction(3u * n + 2u));
  vec3 corner = vec3(ivec3((h >> 4) & 2u, (h >> 5) & 2u, (h >> 6) & 2u) - 1);
  if ((n & 3u) < 2u) return corner + at * 0.015;
  if ((n & 3u) == 2u) return vec3(corner.xy + at.xy * 0.015, at.z);
  return at;
}
uvec4 mixed(uvec4 sum, vec4 color) { return (sum ^ floatBitsToUint(color)) * 0x9e3779b1u; }

void mainImage(out vec4 color, in vec2 p) {
  uint pixel = uint(p.x) + 64u * uint(p.y);
  uvec4 sum = uvec4(0u);
  vec3 d = vec3(1.0);
  for (uint i = 0u; i < 48u; i++) {
    uint n = 48u * pixel + i;
    d = direction(n);
    sum = mixed(sum, textureLod(iChannel0, d, 0.0));
    sum = mixed(sum, textureLod(iChannel0, d, 4.0 + 5.0 * d.y * d.z));
    if (hash(n) % 29u == 0u) break;
  }
  sum = mixed(sum, texture(iChannel0, d));
  sum = mixed(sum, textureGrad(iChannel0, d, dFdx(d.zxy) * 0.1, dFdy(d)));
  color = vec4(sum >> 8) * (1.0 / 16777216.0);
}
