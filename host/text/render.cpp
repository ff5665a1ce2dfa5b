#include "host/text/render.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "host/language/tokens.h"
#include "host/project/kinds.h"

namespace shadertwin {

namespace {

// The precisions that WebGL's implementations compute with, asked for or not.
constexpr std::string_view precision = "precision highp float; precision highp int;";
constexpr std::string_view sampler_precision =
    "precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;";

// What stands in front of the head: version, precisions, helpers, output. A line each, so that the body has
// the same place for all stages.
constexpr int lines_in_front = 5;

std::string output_line(const PassSource& source, ShaderStage stage) {
  if (stage == ShaderStage::vertex || source.own_output) return "";
  if (stage == ShaderStage::fragment) return "layout(location = 0) out vec4 shadertoy_out_color;";
  const std::string size = std::to_string(group_size);
  return "layout(local_size_x = " + size + ", local_size_y = " + size +
         ") in; layout(rgba32f, binding = " + std::to_string(compute_target_binding) +
         ") writeonly uniform highp image2D shadertwin_target; uniform ivec2 shadertwin_origin; "
         "vec4 shadertwin_frag_coord; vec4 shadertoy_out_color;";
}

constexpr std::string_view compute_main =
    "void main() { ivec2 shadertwin_pixel = ivec2(gl_GlobalInvocationID.xy) + shadertwin_origin;\n"
    "if (any(greaterThanEqual(shadertwin_pixel, ivec2(iResolution.xy)))) return;\n"
    "shadertwin_frag_coord = vec4(vec2(shadertwin_pixel) + 0.5, 0.5, 1.0);\n"
    "shadertoy_out_color = vec4(0.0); shadertwin_main();\n"
    "imageStore(shadertwin_target, shadertwin_pixel, shadertoy_out_color); }\n";

std::string in_compute(const std::string& text) {
  return rename_identifiers(text, [](std::string_view name) -> std::string_view {
    if (name == "gl_FragCoord") return "shadertwin_frag_coord";
    if (name == "main") return "shadertwin_main";
    return name;
  });
}

bool is_mipmapped(const Input& input) {
  return input.kind != InputKind::none && input.sampler.min != MinFilter::nearest &&
         input.sampler.min != MinFilter::linear;
}

}  // namespace

std::string render(const PassSource& source, ShaderStage stage) {
  const std::string_view version = source.precise                  ? "#version 320 es\n"
                                   : stage == ShaderStage::compute ? "#version 310 es\n"
                                                                   : "#version 300 es\n";
  std::string text(version);
  text.append(precision) += '\n';
  text.append(sampler_precision) += '\n';
  text.append(source.helpers) += '\n';
  text += output_line(source, stage) + '\n';
  const std::string own = source.head + source.body + source.tail;
  if (stage != ShaderStage::compute) return text + own;
  return text.append(in_compute(own)).append(compute_main);
}

int line_count(std::string_view text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n')) +
         (text.empty() || text.ends_with('\n') ? 0 : 1);
}

int first_body_line(const PassSource& source) {
  return lines_in_front + static_cast<int>(std::count(source.head.begin(), source.head.end(), '\n')) + 1;
}

bool can_run_as_compute(const Pass& pass, std::string* why) {
  const auto no = [&](const std::string& reason) {
    if (why != nullptr) *why = reason;
    return false;
  };
  if (!traits(pass).fills_frame()) return no("the pass is not a picture");
  if (pass.vertex.has_value()) return no("it has its own vertex shader");
  if (pass.source.own_output) return no("the shader declares its own output");
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
