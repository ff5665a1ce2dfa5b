#include "host/text/other_uniforms.h"

#include <algorithm>
#include <array>
#include <set>

#include "host/language/edits.h"
#include "host/language/entry_points.h"
#include "host/language/tokens.h"
#include "host/project/host_rules.h"
#include "host/project/kinds.h"
#include "host/text/host_text.h"

namespace shadertwin {

namespace {

struct Meaning {
  std::string_view name;
  std::string_view type;
  std::string_view value;
  std::string_view in_extension = {};  // what it is beside mainImage(); empty: nothing sets it there
};

// The hosts' own pages and sources: mrdoob/glsl-sandbox, patriciogonzalezvivo/glslCanvas and glslViewer,
// doxas/twigl.
constexpr std::array<Meaning, 26> meanings = {{
    {"time", "float", "iTime", "iTime"},
    {"resolution", "vec2", "iResolution.xy", "iResolution.xy"},
    {"resolution", "vec3", "iResolution"},
    {"mouse", "vec2", "iMouse == vec4(0.0) ? vec2(0.5) : iMouse.xy / iResolution.xy",
     "iMouse.xy / iResolution.xy"},
    {"surfaceSize", "vec2", "vec2(iResolution.x / iResolution.y, 1.0)"},
    {"surfacePosition", "vec2", "(gl_FragCoord.xy - 0.5 * iResolution.xy) / iResolution.y"},
    {"frame", "float", "float(iFrame)"},
    {"frame", "int", "iFrame"},
    {"u_time", "float", "iTime"},
    {"u_delta", "float", "iTimeDelta"},
    {"u_date", "vec4", "iDate"},
    {"u_resolution", "vec2", "iResolution.xy"},
    {"u_resolution", "vec3", "iResolution"},
    {"u_mouse", "vec2", "iMouse.xy"},
    {"u_frame", "int", "iFrame"},
    {"u_frame", "float", "float(iFrame)"},
    {"v_texcoord", "vec2", "gl_FragCoord.xy / iResolution.xy"},
    {"v_uv", "vec2", "gl_FragCoord.xy / iResolution.xy"},
    {"vUv", "vec2", "gl_FragCoord.xy / iResolution.xy"},
    {"iGlobalTime", "float", "iTime"},
    {"iGlobalDelta", "float", "iTimeDelta"},
    {"iGlobalFrame", "int", "iFrame"},
    {"iResolution", "vec2", "iResolution.xy"},
    {"iMouse", "vec2", "iMouse.xy"},
    {"iMouse", "vec3", "iMouse.xyz"},
    {"iFrame", "float", "float(iFrame)"},
}};
constexpr std::string_view inputs_of_vertices[] = {"surfacePosition", "v_texcoord", "v_uv", "vUv"};
constexpr std::string_view own_prefix = "shadertwin_own_";

// A host rounds what backbuffer holds to bytes.
constexpr const char* byte_function =
    " vec4 shadertwin_byte(vec4 c) { return floor(clamp(c, 0.0, 1.0) * 255.0 + 0.5) / 255.0; }";

// `uniform TYPE NAME, NAME[SIZE] ...;`, or the same with `in` and what may stand before that.
struct Declaration {
  bool is_input = false;
  std::string_view type;
  std::string_view sizes;  // behind the type
  std::size_t begin = 0;   // in the text
  std::size_t word = 0;    // behind `uniform` or `in`
  std::size_t end = 0;     // behind the semicolon
  struct Name {
    std::string_view text;
    std::string_view whole;  // with the size of an array
    int line = 0;

    bool is_array() const { return text != whole; }
  };
  std::vector<Name> names;

  std::string declared(const Name& name) const {
    return std::string(type) + std::string(sizes) + " " + std::string(name.whole) + "; ";
  }
};

bool is_precision(const Token& token) {
  return token.is("lowp") || token.is("mediump") || token.is("highp");
}

// Where the qualifiers of the input whose `in` is at `i` begin: `flat`, `layout(...)` and so on.
std::size_t begin_of_input(const std::vector<Token>& tokens, std::size_t i) {
  for (; i > 0; --i) {
    const Token& before = tokens[i - 1];
    if (before.is("flat") || before.is("smooth") || before.is("centroid") || before.is("layout")) continue;
    if (!before.is(")")) break;
    std::size_t open = i - 1;
    while (open > 0 && !tokens[open].is("(")) --open;
    if (open == 0 || !tokens[open - 1].is("layout")) break;
    i = open;
  }
  return tokens[i].begin;
}

// Those outside of functions, but for blocks.
std::vector<Declaration> declarations(std::string_view text, const std::vector<Token>& tokens) {
  std::vector<Declaration> found;
  int depth = 0;
  const auto at = [&](std::size_t i) -> const Token& {
    static const Token none;
    return i < tokens.size() ? tokens[i] : none;
  };
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].preprocessor) continue;
    if (tokens[i].is("{") || tokens[i].is("(")) ++depth;
    if (tokens[i].is("}") || tokens[i].is(")")) depth = std::max(depth - 1, 0);
    if (depth != 0 || (!tokens[i].is("uniform") && !tokens[i].is("in"))) continue;
    Declaration declaration;
    declaration.is_input = tokens[i].is("in");
    declaration.begin = declaration.is_input ? begin_of_input(tokens, i) : tokens[i].begin;
    declaration.word = tokens[i].end();
    std::size_t k = i + 1;
    while (is_precision(at(k))) ++k;
    if (at(k).kind != Token::Kind::identifier) continue;
    declaration.type = at(k++).text;
    if (declaration.type == "struct")
      while (k < tokens.size() && !at(k - 1).is("}")) ++k;
    const std::size_t sizes = k;
    while (at(k).is("["))
      while (k < tokens.size() && !at(k++).is("]")) continue;
    if (k > sizes) declaration.sizes = text.substr(at(sizes).begin, at(k - 1).end() - at(sizes).begin);
    if (at(k).kind != Token::Kind::identifier) continue;
    for (;; ++k) {
      const Token& name = at(k);
      if (name.kind != Token::Kind::identifier) break;
      std::size_t end = name.end();
      for (++k; k < tokens.size() && !at(k).is(",") && !at(k).is(";"); ++k) end = at(k).end();
      declaration.names.push_back({name.text, text.substr(name.begin, end - name.begin), name.line});
      if (!at(k).is(",")) break;
    }
    if (!at(k).is(";") || declaration.names.empty()) continue;
    declaration.end = at(k).end();
    found.push_back(std::move(declaration));
  }
  return found;
}

class Adopter {
 public:
  Adopter(const Project& project, std::size_t index, Pass& pass)
      : project_(project), index_(static_cast<int>(index)), pass_(pass) {}

  void adopt() {
    std::string& body = pass_.source.body;
    const std::vector<Token> tokens = tokenize(body);
    // Most shaders declare none.
    if (!mentions(tokens, "uniform") && !mentions(tokens, "in")) return;
    const EntryPoints entry = find_entry_points(tokens);
    only_main_ =
        traits(pass_).fills_frame() && entry.main && !(pass_.strict && entry.has(traits(pass_).entry));
    host_text_ = host_uniforms(project_, pass_);
    const std::vector<Token> host_tokens = tokenize(host_text_);
    host_ = declarations(host_text_, host_tokens);
    const std::vector<Declaration> given = declarations(body, tokens);
    for (const Declaration& each : given) adopt(each, body, tokens);
    if (values_.empty() && edits_.empty()) return;
    set_values(tokens);
    take_bytes(tokens);
    rename_own_variables(given, tokens);
    rename(tokens);
    body = edited(body, edits_);
  }

 private:
  // Whether a player sets a uniform of that name and type.
  bool is_hosts(std::string_view name, std::string_view type, bool exactly = false) const {
    for (const Declaration& each : host_)
      for (const Declaration::Name& known : each.names)
        if (known.text == name) return each.type == type || (type.starts_with("sampler") && !exactly);
    return false;
  }

  const Meaning* meaning_of(std::string_view name, std::string_view type) const {
    const auto found = std::find_if(meanings.begin(), meanings.end(), [&](const Meaning& meaning) {
      return meaning.name == name && meaning.type == type;
    });
    if (found == meanings.end()) return nullptr;
    const bool here = only_main_ || (project_.dialect == Dialect::vscode && !found->in_extension.empty() &&
                                     traits(pass_).in_extension);
    return here ? &*found : nullptr;
  }

  SourceLine line_of(const Declaration::Name& name) const {
    const auto& lines = pass_.source.lines;
    const auto line = static_cast<std::size_t>(name.line - 1);
    return line < lines.size() ? lines[line] : SourceLine{};
  }

  void note(const Declaration::Name& name, bool set) {
    pass_.other_uniforms.push_back({std::string(name.text), line_of(name), set});
  }

  void adopt(const Declaration& declaration, const std::string& body, const std::vector<Token>& tokens) {
    // Without a vertex shader an input is a variable, which nothing sets but for those that have a meaning.
    const bool is_variable = declaration.is_input && !pass_.vertex.has_value();
    const std::string word = is_variable ? "" : declaration.is_input ? "in " : "uniform ";
    std::string text;
    bool changed = false;
    for (const Declaration::Name& name : declaration.names) {
      const std::string variable = variable_for(declaration, name);
      const bool gone = variable.empty() && becomes_channel(declaration, name, tokens);
      changed = changed || gone || !variable.empty();
      text += variable;
      if (variable.empty() && !gone) text += word + declaration.declared(name);
      if (variable.empty() && is_variable)
        pass_.unset_inputs.push_back({std::string(name.text), line_of(name)});
    }
    if (changed)
      replace(body, declaration.begin, declaration.end, text);
    else if (is_variable)
      replace(body, declaration.begin, declaration.word, "");
  }

  void replace(std::string_view body, std::size_t begin, std::size_t end, const std::string& by) {
    const std::string_view old = body.substr(begin, end - begin);
    const auto lines = static_cast<std::size_t>(std::count(old.begin(), old.end(), '\n'));
    edits_.push_back({begin, old.size(), by + std::string(lines, '\n')});
  }

  // The declaration of a variable for what has a meaning here, whose value is noted; else empty.
  std::string variable_for(const Declaration& declaration, const Declaration::Name& name) {
    const bool of_vertices = std::find(std::begin(inputs_of_vertices), std::end(inputs_of_vertices),
                                       name.text) != std::end(inputs_of_vertices);
    const Meaning* meaning = name.is_array() ? nullptr : meaning_of(name.text, declaration.type);
    if (meaning == nullptr || is_hosts(name.text, declaration.type) || declaration.is_input != of_vertices ||
        (of_vertices && pass_.vertex.has_value()))
      return "";
    Declaration::Name variable = name;
    std::string own_name(name.text);
    // A name of the host's with another type.
    if (meaning->value.find(name.text) != std::string::npos && name.text.starts_with('i')) {
      own_name.insert(0, own_prefix);
      renamed_.emplace_back(name.text, own_name);
      variable.whole = own_name;
    }
    values_ +=
        " " + own_name + " = " + std::string(only_main_ ? meaning->value : meaning->in_extension) + ";";
    note(name, true);
    return declaration.declared(variable);
  }

  // Whether a uniform that no player sets goes on as a channel. All of them are noted.
  bool becomes_channel(const Declaration& declaration, const Declaration::Name& name,
                       const std::vector<Token>& tokens) {
    if (declaration.is_input || is_hosts(name.text, declaration.type)) return false;
    const bool sampler = declaration.type == "sampler2D" && !name.is_array();
    const bool set = sampler && only_main_ && name.text == "backbuffer" && bind_backbuffer(tokens);
    note(name, set);
    // WebGL's samplers start at unit 0.
    const bool first = sampler && !set && is_hosts("iChannel0", "sampler2D", true);
    if (first) renamed_.emplace_back(name.text, "iChannel0");
    return set || first;
  }

  // Gives the last picture to a channel that the text does not use.
  bool bind_backbuffer(const std::vector<Token>& tokens) {
    const int channels = host_rules(project_).channels;
    for (int i = channels - 1; i >= 0; --i) {
      Input& input = pass_.inputs[static_cast<std::size_t>(i)];
      const std::string name = "iChannel" + std::to_string(i);
      if (input.wanted() != InputKind::none || mentions(tokens, name)) continue;
      input = {};
      input.kind = InputKind::pass;
      input.pass = index_;
      input.sampler = {MinFilter::nearest, MagFilter::nearest, Wrap::clamp, true};
      renamed_.emplace_back("backbuffer", name);
      bytes_ = true;
      return true;
    }
    return false;
  }

  // Behind the brace of the function that is the shader's entry.
  void set_values(const std::vector<Token>& tokens) {
    if (values_.empty()) return;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      if (!tokens[i].is(only_main_ ? "main" : "mainImage")) continue;
      const std::size_t body = body_of_function(tokens, i);
      if (body == tokens.size()) continue;
      edits_.push_back({tokens[body].end(), 0, values_});
      return;
    }
  }

  // texture(backbuffer, ...) and the like.
  void take_bytes(const std::vector<Token>& tokens) {
    if (!bytes_) return;
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
      const bool lookup = tokens[i].text.starts_with("tex") && !tokens[i].is("textureSize") &&
                          tokens[i + 1].is("(") && tokens[i + 2].is("backbuffer");
      if (!lookup) continue;
      int depth = 0;
      std::size_t close = i + 1;
      for (; close < tokens.size(); ++close) {
        if (tokens[close].is("(")) ++depth;
        if (tokens[close].is(")") && --depth == 0) break;
      }
      if (close == tokens.size()) return;
      edits_.push_back({tokens[i].begin, 0, "shadertwin_byte("});
      edits_.push_back({tokens[close].end(), 0, ")"});
    }
    pass_.source.helpers += byte_function;
  }

  // Variables of the shader's own that bear the names of host's that the values read.
  void rename_own_variables(const std::vector<Declaration>& given, const std::vector<Token>& tokens) {
    std::set<std::string_view> kept;
    for (const Declaration& each : given)
      for (const Declaration::Name& name : each.names) kept.insert(name.text);
    for (const Declaration& each : host_)
      for (const Declaration::Name& name : each.names)
        if (kept.insert(name.text).second && values_.find(name.text) != std::string::npos &&
            declares(tokens, name.text, false))
          renamed_.emplace_back(name.text, std::string(own_prefix) + std::string(name.text));
  }

  void rename(const std::vector<Token>& tokens) {
    for (const Token& token : tokens)
      for (const auto& [name, by] : renamed_)
        if (token.kind == Token::Kind::identifier && token.text == name && !is_edited(token.begin))
          edits_.push_back({token.begin, token.text.size(), by});
  }

  bool is_edited(std::size_t at) const {
    return std::any_of(edits_.begin(), edits_.end(),
                       [&](const Edit& edit) { return at >= edit.begin && at < edit.begin + edit.length; });
  }

  const Project& project_;
  int index_;
  Pass& pass_;
  bool only_main_ = false;  // no host calls a function of the shader's but main()
  bool bytes_ = false;
  std::string host_text_;
  std::vector<Declaration> host_;
  std::string values_;  // assignments
  std::vector<std::pair<std::string_view, std::string>> renamed_;
  std::vector<Edit> edits_;
};

}  // namespace

void adopt_other_uniforms(const Project& project, std::size_t pass_index, Pass& pass) {
  Adopter(project, pass_index, pass).adopt();
}

}  // namespace shadertwin
