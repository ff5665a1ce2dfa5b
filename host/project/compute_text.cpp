#include "host/project/compute_text.h"

#include <array>
#include <string_view>

#include "host/project/tokens.h"

namespace shadertwin {

namespace {

constexpr std::string_view version_line = "#version 300 es";
constexpr std::string_view output_line = "layout(location = 0) out vec4 shadertoy_out_color;";

void replace(std::string& text, std::string_view old, const std::string& by) {
  const std::size_t place = text.find(old);
  if (place != std::string::npos) text.replace(place, old.size(), by);
}

bool is_mipmapped(const Input& input) {
  return input.kind != InputKind::none && input.sampler.min != MinFilter::nearest &&
         input.sampler.min != MinFilter::linear;
}

}  // namespace

std::string compute_text(const Project&, const Pass& pass, int local_x, int local_y) {
  std::string text = pass.source.text();
  replace(text, version_line, "#version 310 es");
  replace(text, output_line,
          "layout(local_size_x = " + std::to_string(local_x) + ", local_size_y = " + std::to_string(local_y) +
              ") in; layout(rgba32f, binding = " + std::to_string(compute_target_binding) +
              ") writeonly uniform highp image2D shadertwin_target; uniform ivec2 shadertwin_origin; "
              "vec4 shadertwin_frag_coord; vec4 shadertoy_out_color;");
  text = rename_identifiers(text, [](std::string_view name) -> std::string_view {
    if (name == "gl_FragCoord") return "shadertwin_frag_coord";
    if (name == "main") return "shadertwin_main";
    return name;
  });
  return text +
         "void main() { ivec2 shadertwin_pixel = ivec2(gl_GlobalInvocationID.xy) + shadertwin_origin;\n"
         "if (any(greaterThanEqual(shadertwin_pixel, ivec2(iResolution.xy)))) return;\n"
         "shadertwin_frag_coord = vec4(vec2(shadertwin_pixel) + 0.5, 0.5, 1.0);\n"
         "shadertoy_out_color = vec4(0.0); shadertwin_main();\n"
         "imageStore(shadertwin_target, shadertwin_pixel, shadertoy_out_color); }\n";
}

bool can_run_as_compute(const Pass& pass, std::string* why) {
  const auto no = [&](const std::string& reason) {
    if (why != nullptr) *why = reason;
    return false;
  };
  if (pass.kind != PassKind::image && pass.kind != PassKind::buffer) return no("the pass is not a picture");
  if (pass.vertex.has_value()) return no("it has its own vertex shader");
  if (pass.source.head.find(output_line) == std::string::npos)
    return no("the shader declares its own output");
  const std::vector<Token> tokens = tokenize(pass.source.body);
  static constexpr std::array<std::string_view, 8> fragment_only = {
      "dFdx",           "dFdy",          "fwidth",       "discard",
      "gl_FrontFacing", "gl_PointCoord", "gl_FragDepth", "gl_FragDepthEXT"};
  for (const std::string_view name : fragment_only)
    if (mentions(tokens, name)) return no("the shader uses " + std::string(name));
  bool mipmapped = false;
  for (const Input& input : pass.inputs) mipmapped = mipmapped || is_mipmapped(input);
  if (!mipmapped) return true;
  static constexpr std::array<std::string_view, 7> implicit = {
      "texture",   "textureProj", "textureOffset", "textureProjOffset",
      "texture2D", "textureCube", "texture2DProj"};
  for (const std::string_view name : implicit)
    if (mentions(tokens, name))
      return no("the shader uses " + std::string(name) + " on an input with mipmaps");
  return true;
}

}  // namespace shadertwin
