#include "host/project/wrapper.h"

#include "host/base/error.h"
#include "host/project/keyboard_text.h"
#include "host/project/tokens.h"

namespace shadertwin {

namespace {

// The user's own `void main() {` or `void main(void) {`.
bool defines_main(const std::vector<Token>& tokens) {
  for (std::size_t i = 0; i + 3 < tokens.size(); ++i) {
    if (!tokens[i].is("main") || !tokens[i + 1].is("(")) continue;
    std::size_t after = i + 2;
    if (tokens[after].is("void")) ++after;
    if (after + 1 < tokens.size() && tokens[after].is(")") && tokens[after + 1].is("{")) return true;
  }
  return false;
}

bool defines_macro(const std::vector<Token>& tokens, std::string_view name) {
  for (std::size_t i = 2; i < tokens.size(); ++i)
    if (tokens[i].is(name) && tokens[i - 1].is("define") && tokens[i - 2].is("#")) return true;
  return false;
}

// A global `out TYPE NAME;` of the user's, which takes the place of the host's.
bool declares_output(const std::vector<Token>& tokens) {
  int depth = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].preprocessor) continue;
    if (tokens[i].is("{") || tokens[i].is("(")) ++depth;
    if (tokens[i].is("}") || tokens[i].is(")")) --depth;
    if (tokens[i].is("out") && depth == 0) return true;
  }
  return false;
}

std::string_view glsl_name(UniformType type) {
  switch (type) {
    case UniformType::float1:
      return "float";
    case UniformType::float2:
      return "vec2";
    case UniformType::float3:
      return "vec3";
    case UniformType::float4:
      return "vec4";
    case UniformType::int1:
      return "int";
    case UniformType::int2:
      return "ivec2";
    case UniformType::int3:
      return "ivec3";
    case UniformType::int4:
      return "ivec4";
    case UniformType::mat4:
      return "mat4";
  }
  return "float";
}

std::string_view sampler_name(const Project& project, const Input& input) {
  if (input.kind == InputKind::cubemap) return "samplerCube";
  if (input.kind == InputKind::volume) return "sampler3D";
  if (input.kind == InputKind::pass &&
      project.passes[static_cast<std::size_t>(input.pass)].kind == PassKind::cubemap)
    return "samplerCube";
  return "sampler2D";
}

class Head {
 public:
  Head(const std::vector<Token>& tokens) : tokens_(tokens) {}

  void line(std::string_view text) { text_.append(text) += '\n'; }
  // A uniform, unless the user's text declares it as well.
  void uniform(std::string_view type, const std::string& name, int count = 1) {
    if (declares(tokens_, name)) return;
    const std::string size = count > 1 ? "[" + std::to_string(count) + "]" : "";
    line("uniform " + std::string(type) + " " + name + size + ";");
  }
  void macro(const std::string& name, std::string_view value) {
    if (!declares(tokens_, name)) line("#define " + name + " " + std::string(value));
  }
  // What one of the hosts does not have: only for texts that use it.
  bool wanted(std::string_view name) const { return mentions(tokens_, name) && !declares(tokens_, name); }
  std::string take() { return std::move(text_); }

 private:
  const std::vector<Token>& tokens_;
  std::string text_;
};

void add_version(Head& head) {
  head.line("#version 300 es");
  head.line("precision highp float; precision highp int;");
  head.line("precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;");
}

void add_common_uniforms(Head& head) {
  head.uniform("vec3", "iResolution");
  head.uniform("float", "iTime");
  head.uniform("float", "iTimeDelta");
  head.uniform("int", "iFrame");
  head.uniform("vec4", "iDate");
  head.uniform("vec4", "iMouse");
  head.uniform("float", "iSampleRate");
}

void add_channels(Head& head, const Project& project, const Pass& pass, int channels) {
  head.uniform("vec3", "iChannelResolution", channels);
  for (int i = 0; i < channels; ++i)
    head.uniform(sampler_name(project, pass.inputs[static_cast<std::size_t>(i)]),
                 "iChannel" + std::to_string(i));
}

// The names of GLSL ES 1.00 that three.js, which the extension draws with, gives to those of 3.00.
void add_legacy_names(Head& head) {
  static constexpr std::pair<const char*, const char*> names[] = {
      {"varying", "in"},
      {"gl_FragColor", "shadertoy_out_color"},
      {"gl_FragDepthEXT", "gl_FragDepth"},
      {"texture2D", "texture"},
      {"textureCube", "texture"},
      {"texture2DProj", "textureProj"},
      {"texture2DLodEXT", "textureLod"},
      {"texture2DProjLodEXT", "textureProjLod"},
      {"textureCubeLodEXT", "textureLod"},
      {"texture2DGradEXT", "textureGrad"},
      {"texture2DProjGradEXT", "textureProjGrad"},
      {"textureCubeGradEXT", "textureGrad"},
      {"GLSL_FRAGCOLOR", "gl_FragColor"},
      {"iGlobalTime", "iTime"},
      {"iGlobalFrame", "iFrame"},
  };
  for (const auto& [name, meaning] : names) head.macro(name, meaning);
}

void add_vscode(Head& head, const Project& project, const Pass& pass, const WrapOptions& options) {
  add_common_uniforms(head);
  head.uniform("vec4", "iMouseButton");
  head.uniform("mat4", "iViewMatrix");
  add_channels(head, project, pass, max_channels);
  head.uniform("sampler2D", "iKeyboard");
  if (head.wanted("iFrameRate")) head.uniform("float", "iFrameRate");
  if (head.wanted("iChannelTime")) head.uniform("float", "iChannelTime", 4);
  if (head.wanted("HW_PERFORMANCE")) head.line("#define HW_PERFORMANCE 1");
  if (head.wanted("saturate")) head.line("#define saturate(a) clamp(a, 0.0, 1.0)");
  add_legacy_names(head);
  for (const CustomUniform& uniform : project.uniforms) head.uniform(glsl_name(uniform.type), uniform.name);
  if (options.keyboard) head.line(keyboard_text());
}

void add_shadertoy(Head& head, const Project& project, const Pass& pass) {
  head.line("#define HW_PERFORMANCE 1");
  add_common_uniforms(head);
  head.uniform("float", "iFrameRate");
  head.uniform("float", "iChannelTime", 4);
  add_channels(head, project, pass, 4);
  for (const CustomUniform& uniform : project.uniforms) head.uniform(glsl_name(uniform.type), uniform.name);
}

// shadertoy.com shows a picture without alpha; everything else keeps it.
std::string image_main(bool opaque) {
  return std::string(
             "void main() { vec4 shadertoy_color = vec4(0.0); mainImage(shadertoy_color, "
             "gl_FragCoord.xy); ") +
         "shadertoy_out_color = " + (opaque ? "vec4(shadertoy_color.rgb, 1.0)" : "shadertoy_color") + "; }\n";
}

// `mainImage(out vec4` becomes `mainImage(inout vec4`, so that what the wrapper put into the colour is there
// where the shader does not write it. Browsers zero every `out` parameter; drivers leave garbage.
std::string with_inout_entry(const std::string& body, const std::vector<Token>& tokens) {
  std::string result;
  std::size_t copied = 0;
  for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
    if (!tokens[i].is("mainImage") || !tokens[i + 1].is("(") || !tokens[i + 2].is("out")) continue;
    result.append(body, copied, tokens[i + 2].begin - copied).append("in");
    copied = tokens[i + 2].begin;
  }
  return result.append(body, copied);
}

[[noreturn]] void fail_without_entry(const Project& project, const Pass& pass) {
  // The pass's own file is the one that its last line is from.
  const int file = pass.source.lines.empty() ? -1 : pass.source.lines.back().file;
  const std::string name = file < 0 ? pass.name : project.files[static_cast<std::size_t>(file)];
  throw Error(ExitStatus::shader, name + ":1: error: there is no mainImage(out vec4, in vec2) and no main()");
}

}  // namespace

void wrap_pass(const Project& project, Pass& pass, const WrapOptions& options) {
  const std::vector<Token> tokens = tokenize(pass.source.body);
  const bool shadertoy = project.dialect == Dialect::shadertoy;
  const bool has_image = mentions(tokens, "mainImage");
  const bool has_main = defines_main(tokens);
  if (!has_image && !has_main) fail_without_entry(project, pass);

  Head head(tokens);
  add_version(head);
  if (options.local || !shadertoy) head.macro("SHADER_TOY", "");
  if (shadertoy)
    add_shadertoy(head, project, pass);
  else
    add_vscode(head, project, pass, options);
  if (!declares_output(tokens)) head.line("layout(location = 0) out vec4 shadertoy_out_color;");

  pass.source.tail.clear();
  const bool macro_entry = defines_macro(tokens, "mainImage");
  pass.source.body = with_inout_entry(pass.source.body, tokens);  // the tokens end here
  if (has_image && (!has_main || options.strict)) {
    const std::string main = image_main(shadertoy && pass.kind == PassKind::image);
    // A macro called mainImage only works for a main() behind it.
    if (shadertoy && !macro_entry) {
      head.line("void mainImage(inout vec4, in vec2);");
      pass.source.head = head.take() + main;
      return;
    }
    pass.source.tail = main;
  } else if (shadertoy) {
    head.line("#define gl_FragColor shadertoy_out_color");
  }
  pass.source.head = head.take();
}

}  // namespace shadertwin
