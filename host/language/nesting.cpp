#include "host/language/nesting.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace shadertwin {

namespace {

bool is_word(const PlainToken& token) {
  const auto first = static_cast<unsigned char>(token.text.front());
  return std::isalnum(first) != 0 || first == '_' || (first == '.' && token.text.size() > 1);
}

// Words that hold the statement behind them.
bool opens_statement(std::string_view word) {
  constexpr std::array<std::string_view, 7> words = {"if", "else", "for", "while", "do", "switch", "return"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

// An open bracket, or the text itself. What is counted bounds how deep the tree is in here.
struct Level {
  bool is_list = false;  // of arguments, whose commas are no operators
  int finished = 0;      // depth of the deepest statement that is over
  int statements = 0;    // `if`, `else` and the like that hold what comes next
  int commas = 0;
  int deepest = 0;    // of the statement's parts that a comma ended
  int operators = 0;  // since then
  int inner = 0;      // depth of the deepest bracket among them

  int depth() const { return std::max(finished, statements + commas + std::max(deepest, operators + inner)); }
  void end_part() {
    deepest = std::max(deepest, operators + inner);
    operators = inner = 0;
  }
};

class NestingCounter {
 public:
  // How deep the tree is at least up to this token, if all operators so far hold each other.
  int add(const PlainToken& token, const PlainToken* next) {
    if (is_word(token))
      add_word(token.text);
    else
      add_mark(token.text, next);
    after_name_ = is_word(token) || token.text == "]" || token.text == ")";
    return outside_ + levels_.back().depth();
  }

 private:
  void add_word(std::string_view word) {
    if (!opens_statement(word)) return;
    ++levels_.back().statements;
  }

  void add_mark(std::string_view mark, const PlainToken* next) {
    Level& level = levels_.back();
    if (mark == "(" || mark == "[" || mark == "{") {
      if (mark != "{" && after_name_) ++level.operators;  // a call or an index
      outside_ += level.statements + level.commas + level.operators + 1;
      levels_.push_back({.is_list = mark == "(" && after_name_});
    } else if (mark == ")" || mark == "]" || mark == "}") {
      close();
      if (mark == "}") end_statement(next);
    } else if (mark == ";") {
      end_statement(next);
    } else if (mark == ",") {
      level.end_part();
      if (!level.is_list) ++level.commas;
    } else {
      ++level.operators;
    }
  }

  void close() {
    const int depth = levels_.back().depth() + 1;
    if (levels_.size() == 1) return;  // one bracket too many is the parser's to tell
    levels_.pop_back();
    Level& level = levels_.back();
    outside_ -= level.statements + level.commas + level.operators + 1;
    level.inner = std::max(level.inner, depth);
  }

  // A block or statement is over, and with it those that hold it, unless an `else` goes on.
  void end_statement(const PlainToken* next) {
    Level& level = levels_.back();
    level.end_part();
    if (next != nullptr && next->text == "else") return;
    level = {.is_list = level.is_list, .finished = level.depth()};
  }

  std::vector<Level> levels_ = {{}};
  int outside_ = 0;  // depth at which the innermost bracket stands
  bool after_name_ = false;
};

// Finds a structure with more levels than deepest_structure.
class StructureLevels {
 public:
  bool add(const PlainToken& token, const PlainToken* next) {
    if (token.text == "struct" && next != nullptr) {
      name_ = next->text;
      level_ = 1;
    } else if (level_ > 0 && token.text == "}") {
      levels_[name_] = level_;
      level_ = 0;
    } else if (level_ > 0 && next != nullptr && is_word(*next)) {
      // The type of a member.
      if (const auto found = levels_.find(token.text); found != levels_.end())
        level_ = std::max(level_, found->second + 1);
    }
    return level_ > deepest_structure;
  }

 private:
  std::map<std::string, int, std::less<>> levels_;
  std::string name_;
  int level_ = 0;  // of the structure whose members are read; 0: of none
};

}  // namespace

std::optional<Diagnostic> nested_too_deeply(const std::vector<PlainToken>& tokens) {
  NestingCounter counter;
  StructureLevels structures;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const PlainToken* next = i + 1 < tokens.size() ? &tokens[i + 1] : nullptr;
    if (counter.add(tokens[i], next) > deepest_nesting)
      return Diagnostic{tokens[i].line, "operators, brackets or statements nested more than " +
                                            std::to_string(deepest_nesting) + " deep"};
    if (structures.add(tokens[i], next))
      return Diagnostic{tokens[i].line,
                        "structures nested more than " + std::to_string(deepest_structure) + " deep"};
  }
  return std::nullopt;
}

}  // namespace shadertwin
