#include "host/text/global_initialisers.h"

#include <algorithm>
#include <set>
#include <vector>

#include "host/language/edits.h"
#include "host/language/entry_points.h"
#include "host/language/tokens.h"

namespace shadertwin {

namespace {

class Assigner {
 public:
  explicit Assigner(std::string_view body) : body_(body), tokens_(tokenize(body)) {}

  std::string assigned() {
    int depth = 0;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_[i].is("{") || tokens_[i].is("(")) ++depth;
      if (tokens_[i].is("}") || tokens_[i].is(")")) --depth;
      const bool begins = i == 0 || tokens_[i - 1].is(";") || tokens_[i - 1].is("}");
      if (depth == 0 && begins) i = statement(i);
    }
    if (edits_.empty()) return std::string(body_);
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const std::size_t body = tokens_[i].is("main") ? body_of_function(tokens_, i) : tokens_.size();
      if (body == tokens_.size()) continue;
      edits_.push_back({tokens_[body].end(), 0, assignments_});
      return edited(body_, edits_);
    }
    return std::string(body_);
  }

 private:
  bool is(std::size_t i, std::string_view text) const { return i < tokens_.size() && tokens_[i].is(text); }
  bool is_name(std::size_t i) const {
    return i < tokens_.size() && tokens_[i].kind == Token::Kind::identifier;
  }

  // From its first token; gives its last one if it declares variables, else the first.
  std::size_t statement(std::size_t first) {
    std::size_t i = first;
    const bool is_given = is(i, "uniform") || is(i, "in");
    if (is_given) ++i;
    while (is(i, "highp") || is(i, "mediump") || is(i, "lowp")) ++i;
    if (is(i, "const") || is(i, "struct") || !is_name(i) || !is_name(i + 1) || is(i + 2, "(")) return first;
    for (++i; is_name(i); ++i) {
      const std::size_t name = i++;
      const std::size_t assign = i;
      bool is_constant = true;
      for (int depth = 0; i < tokens_.size(); ++i) {
        if (depth == 0 && (is(i, ",") || is(i, ";"))) break;
        if (is(i, "(") || is(i, "[")) ++depth;
        if (is(i, ")") || is(i, "]")) --depth;
        is_constant &= !variables_.contains(tokens_[i].text) || is(i - 1, ".");
      }
      if (!is_given && is(assign, "=") && !is_constant && i < tokens_.size()) move(name, assign, i);
      variables_.insert(tokens_[name].text);
      if (!is(i, ",")) break;
    }
    return i;
  }

  // The initialiser, tokens `assign` to `end` without that.
  void move(std::size_t name, std::size_t assign, std::size_t end) {
    const std::size_t begin = tokens_[assign].begin;
    const std::string_view text = body_.substr(begin, tokens_[end - 1].end() - begin);
    std::string in_one_line = " " + std::string(tokens_[name].text) + " " + std::string(text) + ";";
    std::replace(in_one_line.begin(), in_one_line.end(), '\n', ' ');
    assignments_ += in_one_line;
    edits_.push_back(
        {begin, text.size(),
         std::string(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), '\n')});
  }

  std::string_view body_;
  std::vector<Token> tokens_;
  std::set<std::string_view> variables_;  // not constant, so far
  std::string assignments_;
  std::vector<Edit> edits_;
};

}  // namespace

std::string assign_globals_in_main(std::string_view body) {
  return Assigner(body).assigned();
}

}  // namespace shadertwin
