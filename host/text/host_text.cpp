#include "host/text/host_text.h"

#include <optional>

#include "host/base/error.h"
#include "host/language/entry_points.h"
#include "host/language/tokens.h"
#include "host/project/host_rules.h"
#include "host/project/kinds.h"
#include "host/text/keyboard_text.h"
#include "host/text/main_text.h"
#include "host/text/map_log.h"
#include "host/text/resolve_macros.h"

namespace shadertwin {

namespace {

std::string_view sampler_name(const Project& project, const Input& input) {
  switch (shape_of(project, input)) {
    case SamplerShape::cube:
      return "samplerCube";
    case SamplerShape::volume:
      return "sampler3D";
    case SamplerShape::flat:
      break;
  }
  return "sampler2D";
}

class Head {
 public:
  Head(const std::vector<Token>& tokens) : tokens_(tokens) {}

  void line(std::string_view line) { text_.append(line) += '\n'; }
  void text(std::string_view lines) { text_ += lines; }
  // A uniform, unless the user's text declares it as well.
  void uniform(const std::string_view type, const std::string& name, int count = 1) {
    if (declares(tokens_, name, false)) return;
    const std::string size = count > 1 ? "[" + std::to_string(count) + "]" : "";
    line("uniform " + std::string(type) + " " + name + size + ";");
  }
  // What one of the hosts does not have: only for texts that use it.
  bool wanted(std::string_view name) const { return mentions(tokens_, name) && !declares(tokens_, name); }
  std::string take() { return std::move(text_); }

 private:
  const std::vector<Token>& tokens_;
  std::string text_;
};

void add_channels(Head& head, const Project& project, const Pass& pass, int channels) {
  head.uniform("vec3", "iChannelResolution", channels);
  for (int i = 0; i < channels; ++i)
    head.uniform(sampler_name(project, pass.inputs[static_cast<std::size_t>(i)]),
                 "iChannel" + std::to_string(i));
}

void add_uniforms(Head& head, const HostRules& rules, const Project& project, const Pass& pass) {
  if (!traits(pass).every_frame) {
    head.uniform("float", "iTimeOffset");
    head.uniform("int", "iSampleOffset");
    head.uniform("vec4", "iDate");
    head.uniform("float", "iSampleRate");
  } else {
    head.uniform("vec3", "iResolution");
    head.uniform("float", "iTime");
    head.uniform("float", "iTimeDelta");
    head.uniform("int", "iFrame");
    head.uniform("vec4", "iDate");
    head.uniform("vec4", "iMouse");
    head.uniform("float", "iSampleRate");
    const auto wanted = [&](std::string_view name) { return !rules.has_local_inputs || head.wanted(name); };
    if (wanted("iFrameRate")) head.uniform("float", "iFrameRate");
    if (wanted("iChannelTime")) head.uniform("float", "iChannelTime", 4);
  }
  if (rules.has_local_inputs) {
    head.uniform("vec4", "iMouseButton");
    head.uniform("mat4", "iViewMatrix");
  }
  add_channels(head, project, pass, rules.channels);
  if (rules.has_local_inputs) {
    head.uniform("sampler2D", "iKeyboard");
    if (pass.keyboard) head.text(keyboard_text());
  }
  for (std::size_t i = 0; i < 4; ++i)
    if (const std::string loaded = "shadertwin_loaded_" + std::to_string(i); head.wanted(loaded))
      head.line("const int " + loaded + (pass.inputs[i].kind == InputKind::none ? " = 0;" : " = 1;"));
  for (const CustomUniform& uniform : project.uniforms) head.uniform(info(uniform.type).name, uniform.name);
}

// `file:1: error: message` about the file that the text is from.
[[noreturn]] void fail_in(const Project& project, const Pass& pass, const PassSource& source,
                          const std::string& message) {
  throw_if_refused(source);  // what is missing may be missing for that
  // An own file is the one that the last line is from.
  const int file = source.lines.empty() ? -1 : source.lines.back().file;
  const std::string name = file < 0 ? pass.name : project.files[static_cast<std::size_t>(file)];
  throw Error(ExitStatus::shader, name + ":1: error: " + message);
}

// main(), as the host writes it around the function that it calls; none if it is the user's own.
std::optional<MainText> choose_main(const Project& project, const Pass& pass, const EntryPoints& entry,
                                    bool asserts) {
  const bool image = pass.kind == PassKind::image;
  const std::string_view wanted = project.vr && image ? "mainVR" : traits(pass).entry;
  const bool takes_own = wanted == "mainImage";
  if (takes_own && entry.main && !(pass.strict && entry.has(wanted))) return std::nullopt;
  if (!entry.has(wanted))
    fail_in(project, pass, pass.source,
            "there is no " + signature(wanted) + (takes_own ? " and no main()" : ""));
  return main_text(wanted, {.opaque = host_rules(project).opaque_image && image,
                            .asserts = asserts,
                            .image_is_inout = entry.image_is_inout,
                            .sound_of_time = entry.sound_of_time});
}

bool is_vertex_shader(const std::vector<Token>& tokens) {
  return mentions(tokens, "gl_Position") && !mentions(tokens, "gl_FragCoord") &&
         !mentions(tokens, "gl_FragColor") && !mentions(tokens, "shadertoy_out_color");
}

// A vertex shader sees the uniforms of its pass.
void wrap_vertex(const Project& project, const Pass& pass, PassSource& source) {
  const std::vector<Token> tokens = tokenize(source.body);
  if (!find_entry_points(tokens).main) fail_in(project, pass, source, "a vertex shader needs a main()");
  Head head(tokens);
  add_uniforms(head, host_rules(project), project, pass);
  source.head = head.take();
}

}  // namespace

std::string host_uniforms(const Project& project, const Pass& pass) {
  const std::vector<Token> none;
  Head head(none);
  for (const Dialect dialect : {Dialect::shadertoy, Dialect::vscode})
    add_uniforms(head, host_rules(dialect), project, pass);
  return head.take();
}

void write_host_text(const Project& project, Pass& pass) {
  const std::vector<Token> tokens = tokenize(pass.source.body);
  const EntryPoints entry = find_entry_points(tokens);
  if (!entry.has("mainImage") && entry.main && is_vertex_shader(tokens))
    fail_in(project, pass, pass.source,
            "this is a vertex shader: a shader that is drawn names it by #iVertex");
  const HostRules rules = host_rules(project);
  const bool asserts = rules.has_asserts && pass.kind == PassKind::image && mentions(tokens, "st_assert");
  pass.has_vr = entry.has("mainVR");
  const std::optional<MainText> main = choose_main(project, pass, entry, asserts);

  Head head(tokens);
  add_uniforms(head, rules, project, pass);
  pass.source.own_output = entry.output_line > 0;
  if (main && pass.source.own_output) {
    throw_if_refused(pass.source);
    throw Error(ExitStatus::shader,
                place_in_body(project, pass.source, entry.output_line - 1) +
                    ": error: an output of the shader's own, beside the one that its host "
                    "writes: browsers refuse it");
  }
  if (asserts) head.text(assert_text());

  pass.source.tail.clear();
  if (main && rules.main_in_front)
    head.text(main->prototype + main->main);
  else if (main && !traits(pass).in_extension)
    pass.source.tail = main->prototype + main->main;
  else if (main)
    pass.source.tail = main->main;
  pass.source.head = head.take();
  if (!main && !rules.takes_older_names)
    pass.source.body = rename_identifiers(pass.source.body, [](std::string_view name) -> std::string_view {
      return name == "gl_FragColor" ? "shadertoy_out_color" : name;
    });
  if (pass.vertex.has_value()) wrap_vertex(project, pass, *pass.vertex);
}

}  // namespace shadertwin
