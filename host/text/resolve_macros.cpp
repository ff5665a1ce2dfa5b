#include "host/text/resolve_macros.h"

#include <algorithm>
#include <array>

#include "host/base/error.h"
#include "host/language/nesting.h"
#include "host/language/preprocessor.h"
#include "host/language/tokens.h"
#include "host/project/host_rules.h"
#include "host/text/legacy_names.h"
#include "host/text/map_log.h"

namespace shadertwin {

namespace {

using Macros = std::vector<HostMacro>;

// Those that a shader can ask for by #ifdef.
Macros host_macros(const Project& project, ShaderStage stage) {
  Macros macros;
  // Only local hosts have vertex shaders.
  if (project.local || stage == ShaderStage::vertex) macros.push_back({"SHADER_TOY", ""});
  if (host_rules(project).has_performance) macros.push_back({"HW_PERFORMANCE", "1"});
  return macros;
}

// Other names, which the extension and three.js, which it draws with, give to what GLSL ES 3.00 has.
Macros other_names(ShaderStage stage) {
  Macros names = {{"HW_PERFORMANCE", "1"}, {"saturate", "clamp(a, 0.0, 1.0)", {"a"}}};
  for (const auto& [name, meaning] : legacy_names) names.push_back({name, meaning});
  if (stage == ShaderStage::vertex)
    names.insert(names.end(), {{"attribute", "in"}, {"varying", "out"}});
  else
    names.insert(names.end(), {{"varying", "in"},
                               {"gl_FragColor", "shadertoy_out_color"},
                               {"gl_FragDepthEXT", "gl_FragDepth"},
                               {"GLSL_FRAGCOLOR", "gl_FragColor"}});
  return names;
}

// gl_FragData[0] is gl_FragColor.
void name_first_output(std::vector<PlainToken>& tokens) {
  static constexpr std::array<std::string_view, 4> output = {"gl_FragData", "[", "0", "]"};
  const auto is = [](const PlainToken& token, std::string_view text) { return token.text == text; };
  auto at = tokens.begin();
  while ((at = std::search(at, tokens.end(), output.begin(), output.end(), is)) != tokens.end()) {
    at->text = "shadertoy_out_color";
    at = tokens.erase(at + 1, at + output.size());
  }
}

// Of ES 1.00: `invariant varying vec4 v;` and `invariant v;`. It asks that two stages agree, and there is
// one.
void drop_invariance(std::vector<PlainToken>& tokens) {
  const auto is_invariant = [](const PlainToken& token) { return token.text == "invariant"; };
  auto at = tokens.begin();
  while ((at = std::find_if(at, tokens.end(), is_invariant)) != tokens.end()) {
    const auto end =
        std::find_if(at, tokens.end(), [](const PlainToken& token) { return token.text == ";"; });
    const bool is_list = end - at == 2 || (end - at > 2 && (at + 2)->text == ",");
    at = tokens.erase(at, is_list && end != tokens.end() ? end + 1 : at + 1);
  }
}

// `name:line: error: message`, as a compiler's messages are mapped.
std::string refusals(const Project& project, const PassSource& source, const PlainText& plain) {
  std::string text;
  for (const Diagnostic& error : plain.errors)
    text += (text.empty() ? "" : "\n") + place_in_body(project, source, error.line - 1) +
            ": error: " + error.message;
  return text;
}

}  // namespace

void resolve_macros(const Project& project, PassSource& source, ShaderStage stage) {
  PreprocessOptions options;
  options.predefined = host_macros(project, stage);
  // Files for a local host may ask for extensions in front of all; on the site there is code before them.
  options.behind_head = host_rules(project).code_in_front;
  const int lines = std::max(static_cast<int>(source.lines.size()), count_lines(source.body));
  PlainText plain = preprocess(source.body, options);
  if (host_rules(project).takes_older_names) {
    Macros names = other_names(stage);
    const std::vector<Token> written = tokenize(source.body);
    std::erase_if(names, [&](const HostMacro& macro) { return !mentions(written, macro.name); });
    // A main() of its own that writes the output of ES 1.00 was written for that version.
    options.es100 = stage == ShaderStage::fragment && mentions(written, "main") &&
                    (mentions(written, "gl_FragColor") || mentions(written, "gl_FragData"));
    source.es100 = options.es100;
    if (!names.empty() || options.es100) {
      // The shader's own meaning of a name wins.
      if (options.es100) drop_invariance(plain.tokens);
      const std::string code = to_text(plain, lines);
      const std::vector<Token> tokens = tokenize(code);
      for (HostMacro& macro : names)
        if (!declares(tokens, macro.name)) options.predefined.push_back(std::move(macro));
      plain = preprocess(source.body, options);
      if (options.es100) {
        name_first_output(plain.tokens);
        drop_invariance(plain.tokens);
      }
    }
  }
  if (plain.errors.empty())
    if (auto refusal = nested_too_deeply(plain.tokens)) plain.errors.push_back(*std::move(refusal));
  source.refused = refusals(project, source, plain);
  source.written = std::exchange(source.body, to_text(plain, lines));
}

void throw_if_refused(const PassSource& source) {
  if (!source.refused.empty()) throw Error(ExitStatus::shader, source.refused);
}

}  // namespace shadertwin
