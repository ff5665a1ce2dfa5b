float node_switch_12(int _in_index, float _in_0, float _in_1, float _in_2) {
  float _out_value;
  switch (_in_index) {
    case 0: { _out_value = _in_0; } break;
    case 1: { _out_value = _in_1; } break;
    default: { _out_value = _in_2; } break;
  }
  return _out_value;
}
float node_compare_7(float _in_a, float _in_b) { if (_in_a < _in_b) { return 1.0; } else { return 0.0; } }
void mainImage(out vec4 _out_fragColor, in vec2 _in_fragCoord) {
  vec2 _out_uv_3 = _in_fragCoord / iResolution.xy;
  float _out_x_4 = _out_uv_3.x * 3.0;
  int _out_index_5 = int(_out_x_4);
  float _out_cmp_7 = node_compare_7(_out_uv_3.y, 0.5);
  float _out_switch_12 = node_switch_12(_out_index_5, _out_uv_3.y, _out_cmp_7, 1.0 - _out_uv_3.y);
  _out_fragColor = vec4(vec3(_out_switch_12), 1.0);
}
