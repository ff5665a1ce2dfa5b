#include "host/text/resolve_macros.h"

#include <algorithm>

#include "host/base/error.h"
#include "host/language/nesting.h"
#include "host/language/preprocessor.h"
#include "host/language/tokens.h"
#include "host/text/legacy_names.h"

namespace shadertwin {

namespace {

using Macros = std::vector<std::pair<std::string, std::string>>;

// Those that a shader can ask for by #ifdef.
Macros host_macros(const Project& project, Stage stage) {
  Macros macros;
  // Only local hosts have vertex shaders.
  if (project.local || stage == Stage::vertex) macros.emplace_back("SHADER_TOY", "");
  if (project.dialect == Dialect::shadertoy) macros.emplace_back("HW_PERFORMANCE", "1");
  return macros;
}

// Other names, which the extension and three.js, which it draws with, give to what GLSL ES 3.00 has.
Macros other_names(Stage stage) {
  Macros names;
  for (const auto& [name, meaning] : legacy_names) names.emplace_back(name, meaning);
  names.emplace_back("HW_PERFORMANCE", "1");
  if (stage == Stage::vertex) {
    names.emplace_back("attribute", "in");
    names.emplace_back("varying", "out");
  } else {
    names.emplace_back("varying", "in");
    names.emplace_back("gl_FragColor", "shadertoy_out_color");
    names.emplace_back("gl_FragDepthEXT", "gl_FragDepth");
    names.emplace_back("GLSL_FRAGCOLOR", "gl_FragColor");
  }
  return names;
}

// `name:line: error: message`, as a compiler's messages are mapped.
std::string refusals(const Project& project, const PassSource& source, const PlainText& plain) {
  std::string text;
  for (const Diagnostic& error : plain.errors) {
    const auto last = static_cast<int>(source.lines.size()) - 1;
    const SourceLine place =
        last < 0 ? SourceLine{} : source.lines[static_cast<std::size_t>(std::clamp(error.line - 1, 0, last))];
    const std::string at = place.file < 0 ? "-D"
                                          : project.files[static_cast<std::size_t>(place.file)] + ":" +
                                                std::to_string(place.line);
    text += (text.empty() ? "" : "\n") + at + ": error: " + error.message;
  }
  return text;
}

}  // namespace

void resolve_macros(const Project& project, PassSource& source, Stage stage) {
  PreprocessOptions options;
  options.predefined = host_macros(project, stage);
  // Files for a local host may ask for extensions in front of all; on the site there is code before them.
  options.behind_head = project.dialect == Dialect::shadertoy;
  const int lines = std::max(static_cast<int>(source.lines.size()), count_lines(source.body));
  PlainText plain = preprocess(source.body, options);
  if (project.dialect == Dialect::vscode) {
    Macros names = other_names(stage);
    const std::vector<Token> written = tokenize(source.body);
    std::erase_if(names, [&](const auto& name) { return !mentions(written, name.first); });
    if (!names.empty()) {
      // The shader's own meaning of a name wins.
      const std::string code = to_text(plain, lines);
      const std::vector<Token> tokens = tokenize(code);
      for (auto& [name, meaning] : names)
        if (!declares(tokens, name)) options.predefined.emplace_back(std::move(name), std::move(meaning));
      plain = preprocess(source.body, options);
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
