#include "host/text/uniform_blocks.h"

#include <algorithm>

#include "host/language/edits.h"
#include "host/language/entry_points.h"
#include "host/language/tokens.h"
#include "host/project/kinds.h"
#include "host/text/main_text.h"

namespace shadertwin {

namespace {

class Emptier {
 public:
  Emptier(Pass& pass, PassSource& source) : pass_(pass), source_(source), tokens_(tokenize(source.body)) {}

  // Was there any?
  bool run() {
    if (!mentions(tokens_, "uniform")) return false;
    int depth = 0;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_[i].preprocessor) continue;
      if (depth == 0 && is_block(i)) i = empty(i);
      if (at(i).is("{") || at(i).is("(")) ++depth;
      if (at(i).is("}") || at(i).is(")")) depth = std::max(depth - 1, 0);
    }
    if (edits_.empty()) return false;
    source_.body = edited(source_.body, std::move(edits_));
    return true;
  }

 private:
  const Token& at(std::size_t i) const {
    static const Token none;
    return i < tokens_.size() ? tokens_[i] : none;
  }

  // Of what is no block, whatever is wrong with it is for the compiler to tell.
  bool is_block(std::size_t i) const {
    if (!at(i).is("uniform") || at(i + 1).kind != Token::Kind::identifier || at(i + 1).is("struct") ||
        !at(i + 2).is("{"))
      return false;
    const std::size_t close = end_of_members(i);
    return at(close + 1).is(";") || at(close + 1).kind == Token::Kind::identifier;
  }

  std::size_t end_of_members(std::size_t i) const {
    while (i < tokens_.size() && !at(i).is("}")) ++i;
    return i;
  }

  void replace(std::size_t i, const std::string& by) {
    edits_.push_back({at(i).begin, at(i).text.size(), by});
  }

  // Takes `layout(...)` away that begins at `i`, and gives the token behind it.
  std::size_t drop_layout(std::size_t i) {
    std::size_t close = i;
    while (close + 1 < tokens_.size() && !at(close).is(")")) ++close;
    for (std::size_t k = i; k <= close; ++k) replace(k, "");
    return close + 1;
  }

  // The block whose `uniform` is at `i`; gives its semicolon.
  std::size_t empty(std::size_t i) {
    if (i > 0 && at(i - 1).is(")")) {
      std::size_t open = i - 1;
      while (open > 0 && !at(open).is("layout")) --open;
      drop_layout(open);
    }
    const Token& name = at(i + 1);
    const std::size_t close = end_of_members(i);
    const bool has_instance = !at(close + 1).is(";");
    note(name);
    // Members, each with the word `uniform` if it stands for itself.
    for (std::size_t k = i + 3; k < close;) {
      if (at(k).is("layout")) {
        k = drop_layout(k);
        continue;
      }
      if (at(k).is("uniform")) {
        replace(k, "");
        ++k;
        continue;
      }
      if (!has_instance) edits_.push_back({at(k).begin, 0, "uniform "});
      while (k < close && !at(k).is(";")) ++k;
      ++k;
    }
    if (!has_instance) {
      for (const std::size_t k : {i, i + 1, i + 2, close, close + 1}) replace(k, "");
      return close + 1;
    }
    replace(i, "struct");
    edits_.push_back({at(close).end(), 0, "; uniform " + std::string(name.text)});
    std::size_t end = close;
    while (end < tokens_.size() && !at(end).is(";")) ++end;
    return end;
  }

  void note(const Token& name) {
    if (std::ranges::any_of(pass_.other_uniforms, &OtherUniform::is_block)) return;
    const auto& lines = source_.lines;
    const auto line = static_cast<std::size_t>(name.line - 1);
    OtherUniform block{std::string(name.text), line < lines.size() ? lines[line] : SourceLine{}};
    block.is_block = true;
    pass_.other_uniforms.push_back(std::move(block));
  }

  Pass& pass_;
  PassSource& source_;
  std::vector<Token> tokens_;
  std::vector<Edit> edits_;
};

void draw_nothing(PassSource& source) {
  const std::vector<Token> tokens = tokenize(source.body);
  std::vector<Edit> edits;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!is_entry_point(tokens[i].text)) continue;
    const std::size_t body = body_of_function(tokens, i);
    if (body == tokens.size()) continue;
    const bool is_sound = tokens[i].is(traits(PassKind::sound).entry);
    edits.push_back({tokens[body].end(), 0, is_sound ? " return vec2(0.0);" : " discard;"});
  }
  source.body = edited(source.body, std::move(edits));
}

}  // namespace

void empty_uniform_blocks(Pass& pass) {
  bool any = Emptier(pass, pass.source).run();
  if (pass.vertex.has_value()) any = Emptier(pass, *pass.vertex).run() || any;
  if (any) draw_nothing(pass.source);
}

}  // namespace shadertwin
