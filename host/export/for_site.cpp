#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include "host/base/error.h"
#include "host/export/export.h"
#include "host/language/tokens.h"
#include "host/project/host_rules.h"
#include "host/project/text_loader.h"
#include "host/project/write_json.h"
#include "host/text/keyboard_text.h"
#include "host/text/legacy_names.h"

namespace shadertwin {

namespace {

// What the extension knows and the site does not. Defined only for shaders that use it.
constexpr std::array<std::pair<const char*, const char*>, 2> extension_uniforms = {{
    {"iMouseButton", "vec4(float(iMouse.z > 0.0), 0.0, 0.0, 0.0)"},
    {"iViewMatrix", "mat4(1.0)"},
}};

constexpr std::array<std::pair<std::string_view, const char*>, 4> key_functions = {
    {{"isKeyDown", "texelFetch(iKeyboard, ivec2(key, 0), 0).x > 0.0"},
     {"isKeyPressed", "texelFetch(iKeyboard, ivec2(key, 1), 0).x > 0.0"},
     {"isKeyToggled", "texelFetch(iKeyboard, ivec2(key, 2), 0).x > 0.0"},
     {"isKeyReleased", "false"}}};  // the site's keyboard does not tell

bool uses(const Project& project, std::string_view name) {
  bool used = false;
  for (const Pass& pass : project.passes) {
    const auto tokens = tokenize(pass.code);
    if (declares(tokens, name)) return false;
    used = used || mentions(tokens, name);
  }
  return used;
}

std::string names(const Project& project) {
  std::string text = "#define SHADER_TOY\n";
  const auto define = [&](const std::string& name, const std::string& parameters,
                          const std::string& meaning) {
    if (uses(project, name)) text += "#define " + name + parameters + ' ' + meaning + '\n';
  };
  for (const auto& [name, meaning] : legacy_names) define(name, "", meaning);
  for (const auto& [name, meaning] : extension_uniforms) define(name, "", meaning);
  define("saturate", "(a)", "clamp(a, 0.0, 1.0)");
  return text;
}

// Binds the keyboard to the last free channel.
void add_keyboard(Pass& pass) {
  const auto tokens = tokenize(pass.code);
  const bool wanted = mentions(tokens, "iKeyboard") ||
                      std::any_of(key_functions.begin(), key_functions.end(),
                                  [&](const auto& function) { return mentions(tokens, function.first); });
  if (!wanted) return;
  const auto last = pass.inputs.rend() - 4;
  const auto free =
      std::find_if(last, pass.inputs.rend(), [](const Input& i) { return i.kind == InputKind::none; });
  if (free == pass.inputs.rend())
    throw Error(ExitStatus::shader, pass.name + ": error: no channel is free for the keyboard");
  free->kind = InputKind::keyboard;
  free->sampler = {MinFilter::nearest, MagFilter::nearest, Wrap::clamp, false};

  std::string text = "#define iKeyboard iChannel" + std::to_string(pass.inputs.rend() - free - 1) + '\n';
  std::istringstream keys(keyboard_text());
  for (std::string line; std::getline(keys, line);) {
    const std::size_t begin = line.find("Key_");
    if (line.starts_with("const") && mentions(tokens, line.substr(begin, line.find(' ', begin) - begin)))
      text += line + '\n';
  }
  for (const auto& [name, test] : key_functions)
    if (mentions(tokens, name)) text += "bool " + std::string(name) + "(int key) { return " + test + "; }\n";
  pass.code = text + pass.code;
}

}  // namespace

Project for_site(const Project& project) {
  for (const Pass& pass : project.passes)
    if (pass.vertex.has_value())
      throw Error(ExitStatus::shader, pass.name + ": error: shadertoy.com has no vertex shaders (#iVertex)");
  std::string prelude = to_text(project.defines);
  const HostRules rules = host_rules(project);
  if (rules.takes_older_names) prelude += names(project);
  if (prelude.empty()) return project;
  Project result = project;
  // The document that it came from lacks the knobs.
  if (rules.takes_older_names)
    result.json.clear();
  else if (!project.json.empty())
    result.json = with_common(project.json, prelude);
  result.common = prelude + project.common;
  if (rules.has_local_inputs)
    for (Pass& pass : result.passes) add_keyboard(pass);
  return result;
}

}  // namespace shadertwin
