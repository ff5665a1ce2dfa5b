// As a node editor writes it: one temporary a node, nothing folded.
vec2 uv_remap_1(vec2 v_in, vec2 v_scale, vec2 v_offset) { vec2 v_out = v_in * v_scale; v_out = v_out + v_offset; return v_out; }
float checker_2(vec2 v_in) { vec2 tmp_0 = floor(v_in); float tmp_1 = tmp_0.x + tmp_0.y; float tmp_2 = mod(tmp_1, 2.0); return tmp_2; }
vec3 ramp_3(float f_in, vec3 c_a, vec3 c_b) { vec3 tmp_0 = c_b - c_a; vec3 tmp_1 = tmp_0 * f_in; vec3 tmp_2 = c_a + tmp_1; return tmp_2; }
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
  vec2 node_0_uv = fragCoord / iResolution.xy;
  vec2 node_1_out = uv_remap_1(node_0_uv, vec2(8.0, 4.5), vec2(0.25, 0.5));
  float node_2_out = checker_2(node_1_out);
  vec3 node_3_out = ramp_3(node_2_out, vec3(0.1, 0.2, 0.3), vec3(0.9, 0.8, 0.4));
  float node_4_out = node_0_uv.x * node_0_uv.y;
  vec3 node_5_out = node_3_out * node_4_out;
  vec4 node_6_out = vec4(node_5_out, 1.0);
  fragColor = node_6_out;
}
