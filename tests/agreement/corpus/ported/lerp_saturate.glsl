// As from HLSL: the names of its functions by macros.
#define float2 vec2
#define float3 vec3
#define float4 vec4
#define lerp mix
#define sat(x) clamp(x, 0.0, 1.0)
#define mul(a, b) ((b) * (a))
#define frac fract
float4 main_ps(float2 uv) {
  float3 cold = float3(0.1, 0.2, 0.5);
  float3 warm = float3(1.0, 0.7, 0.3);
  mat2 turn = mat2(0.6, 0.8, -0.8, 0.6);
  float2 q = mul(uv - 0.5, turn);
  float band = sat(frac(q.x * 4.0) * 3.0 - 1.0);
  return float4(lerp(cold, warm, band) * sat(1.2 - 2.0 * dot(q, q)), 1.0);
}
void mainImage(out float4 fragColor, in float2 fragCoord) { fragColor = main_ps(fragCoord / iResolution.xy); }
