#include "host/text/knobs.h"

#include <algorithm>
#include <numeric>

#include "host/language/tokens.h"

namespace shadertwin {

namespace {

// What the user's files hold of a pass: the text without the lines of -D.
std::string_view own_text(const Project& project, const PassSource& source) {
  std::string_view text = source.written;
  for (std::size_t i = 0; i < project.defines.size(); ++i)
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text;
}

// Calls visit(text) for every shader of every pass.
template <typename Visit>
void for_each_text(const Project& project, const Visit& visit) {
  for (const Pass& pass : project.passes) {
    visit(own_text(project, pass.source));
    if (pass.vertex.has_value()) visit(own_text(project, *pass.vertex));
  }
}

// Steps of Levenshtein's distance: a letter more, less or another.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t corner = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = corner + (a[i] == b[j] ? 0 : 1);
      corner = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::vector<Knob> find_knobs(const Project& project) {
  std::vector<Knob> knobs;
  for_each_text(project, [&](std::string_view text) {
    const std::vector<Token> tokens = tokenize(text, {.line_ends = true});
    const auto is = [&](std::size_t i, std::string_view word) {
      return i < tokens.size() && tokens[i].text == word;
    };
    for (std::size_t i = 0; i + 6 < tokens.size(); ++i) {
      if (!tokens[i].preprocessor || !is(i, "#") || !is(i + 1, "ifndef")) continue;
      const std::string name(tokens[i + 2].text);
      std::size_t at = i + 3;
      while (at < tokens.size() && tokens[at].kind == Token::Kind::line_end) ++at;
      if (at == i + 3 || !is(at, "#") || !is(at + 1, "define") || !is(at + 2, name)) continue;
      const std::size_t first = at + 3;
      std::size_t end = first;
      while (end < tokens.size() && tokens[end].kind != Token::Kind::line_end) ++end;
      if (first == end) continue;  // a mark, as of a file that is included once
      const bool known =
          std::any_of(knobs.begin(), knobs.end(), [&](const Knob& k) { return k.name == name; });
      if (known) continue;
      const std::size_t begin = tokens[first].begin;
      knobs.push_back({name, std::string(text.substr(begin, tokens[end - 1].end() - begin))});
    }
  });
  return knobs;
}

bool mentions(const Project& project, const std::string& name) {
  bool found = false;
  for_each_text(project, [&](std::string_view text) { found = found || mentions(tokenize(text), name); });
  return found;
}

std::vector<std::string> unmentioned_defines(const Project& project) {
  std::vector<std::string> names;
  for (const auto& [name, value] : project.defines) names.push_back(name);
  if (names.empty()) return names;
  for_each_text(project, [&](std::string_view text) {
    const std::vector<Token> tokens = tokenize(text);
    std::erase_if(names, [&](const std::string& name) { return mentions(tokens, name); });
  });
  return names;
}

bool decides_conditions(const Project& project, const std::string& name) {
  bool found = false;
  for_each_text(project, [&](std::string_view text) {
    bool condition = false;
    for (const Token& token : tokenize(text, {.line_ends = true})) {
      if (token.kind == Token::Kind::line_end) condition = false;
      if (token.preprocessor && (token.is("if") || token.is("elif"))) condition = true;
      found = found || (condition && token.is(name));
    }
  });
  return found;
}

std::string nearest_knob(const Project& project, const std::string& name) {
  std::string nearest;
  std::size_t least = name.size() / 3 + 1;
  for (const Knob& knob : find_knobs(project)) {
    const std::size_t distance = edit_distance(name, knob.name);
    if (distance >= least + (nearest.empty() ? 1 : 0)) continue;
    least = distance;
    nearest = knob.name;
  }
  return nearest;
}

}  // namespace shadertwin
