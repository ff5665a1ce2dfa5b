#include "host/text/work_around.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/text/operands.h"
#include "host/text/render.h"
#include "host/text/rewritten_lines.h"

namespace shadertwin {
namespace {

bool is_jump(const std::string& text) {
  return text == "break" || text == "continue" || text == "return" || text == "discard";
}

// A loop or a switch.
struct Construct {
  bool is_loop = false;
  int keyword = -1;
  TokenRange body;          // a loop's statement, or a switch's braces
  int last_statement = -1;  // of a loop: where the last statement of its body begins
  int around = -1;          // the construct that it stands in
  bool continues = false;   // a `continue` leaves it that is for it, or for a loop around it
};

struct Continue {
  int token = -1;
  int construct = -1;  // the innermost one around it
};

// The loops and switches of a text, and each `continue` in them.
class Constructs {
 public:
  explicit Constructs(const std::vector<PlainToken>& tokens) : tokens_(tokens) {
    for (int i = 0; i < static_cast<int>(tokens.size()); ++i) {
      if (text(i) != "{") continue;
      i = text(i - 1) == ")" ? statement(i) - 1 : closing_bracket(tokens_, i);
    }
  }

  std::vector<Construct> all;
  std::vector<Continue> continues;

 private:
  const std::string& text(int i) const { return text_at(tokens_, i); }

  // Each of these takes the token that something begins with and gives the one past its end.

  int past_parentheses(int open) const { return closing_bracket(tokens_, open) + 1; }

  int past(int i, std::string_view end) const {
    while (!text(i).empty() && text(i) != end)
      i = text(i) == "(" || text(i) == "[" || text(i) == "{" ? past_parentheses(i) : i + 1;
    return i + 1;
  }

  int statements(int i) {
    last_ = i;
    while (!text(i).empty() && text(i) != "}") {
      const int first = i;
      i = statement(i);
      last_ = first;
    }
    return i + 1;
  }

  int statement(int i) {
    const std::string& word = text(i);
    if (word == "{") return statements(i + 1);
    if (word == "if") {
      i = statement(past_parentheses(i + 1));
      return text(i) == "else" ? statement(i + 1) : i;
    }
    if (word == "for" || word == "while") return construct(i, past_parentheses(i + 1));
    if (word == "do") return past(construct(i, i + 1), ";");
    if (word == "switch") return construct(i, past_parentheses(i + 1));
    if (word == "case" || word == "default") return past(i, ":");
    if (word == "continue" && text(i + 1) == ";") continues.push_back({i, inside_});
    return past(i, ";");
  }

  int construct(int keyword, int body) {
    const auto index = all.size();
    Construct here;
    here.is_loop = text(keyword) != "switch";
    here.keyword = keyword;
    here.around = std::exchange(inside_, static_cast<int>(index));
    all.push_back(here);
    const int end = statement(body);
    all[index].body = {body, std::min(end, static_cast<int>(tokens_.size())) - 1};
    all[index].last_statement = text(body) == "{" ? last_ : body;
    inside_ = here.around;
    return end;
  }

  const std::vector<PlainToken>& tokens_;
  int inside_ = -1;
  int last_ = -1;  // where the last statement of the block that ended last begins
};

class Rewriter {
 public:
  explicit Rewriter(const std::vector<PlainToken>& tokens) : tokens_(tokens), edits_(tokens) {}

  bool meets(Fault fault) const {
    return std::any_of(tokens_.begin(), tokens_.end(), [fault](const PlainToken& token) {
      return token.text == (fault == Fault::half_arithmetic ? "unpackHalf2x16" : "continue");
    });
  }

  // By a function of the shader's own, whose result is highp.
  void widen_halves() {
    for (std::size_t i = 0; i < tokens_.size(); ++i)
      if (tokens_[i].text == "unpackHalf2x16")
        edits_.instead[static_cast<int>(i)] = "shadertwin_unpackHalf2x16";
    helpers += " vec2 shadertwin_unpackHalf2x16(uint bits) { return unpackHalf2x16(bits); }";
  }

  // Whether some `continue` is such that it may get lost.
  bool finds_endangered() {
    for (const Continue& each : constructs_.continues)
      for (int i = each.construct; i >= 0; i = at(i).around) {
        at(i).continues = true;
        if (at(i).is_loop) break;
      }
    return std::any_of(constructs_.all.begin(), constructs_.all.end(),
                       [this](const Construct& c) { return c.continues && (!c.is_loop || jumps_last(c)); });
  }

  // A switch is left by `break`, and the loop goes on behind it. Each `continue` that is left depends on what
  // no compiler knows.
  void keep_continues() {
    for (const Continue& each : constructs_.continues) {
      if (each.construct < 0) continue;
      const Construct& inside = at(each.construct);
      if (inside.is_loop && !jumps_last(inside)) continue;
      edits_.instead[each.token] =
          inside.is_loop ? "{ if (shadertwin_never == 0) continue" : "{ " + flag(inside) + " = true; break";
      after(each.token + 1) += " }";
    }
    for (const Construct& construct : constructs_.all)
      if (construct.continues && !construct.is_loop) pass_on(construct);
    helpers += " uniform int shadertwin_never;";  // nobody sets it: 0
  }

  std::vector<std::string> lines(int count) const { return edits_.lines(count); }

  std::string helpers;

 private:
  Construct& at(int index) { return constructs_.all[static_cast<std::size_t>(index)]; }

  static std::string flag(const Construct& construct) {
    return "shadertwin_continue_" + std::to_string(construct.keyword);
  }

  bool jumps_last(const Construct& loop) const {
    for (int i = loop.last_statement; i <= loop.body.last; ++i)
      if (is_jump(tokens_[static_cast<std::size_t>(i)].text)) return true;
    return false;
  }

  std::string& before(int token) { return edits_.before[static_cast<std::size_t>(token)]; }
  std::string& after(int token) { return edits_.after[static_cast<std::size_t>(token)]; }

  void pass_on(const Construct& construct) {
    before(construct.keyword) = "{ bool " + flag(construct) + " = false; " + before(construct.keyword);
    const bool in_loop = construct.around < 0 || at(construct.around).is_loop;
    after(construct.body.last) += " if (" + flag(construct) +
                                  (in_loop ? " && shadertwin_never == 0) continue; }"
                                           : ") { " + flag(at(construct.around)) + " = true; break; } }");
  }

  const std::vector<PlainToken>& tokens_;
  Constructs constructs_{tokens_};
  RewrittenLines edits_;
};

}  // namespace

PassSource work_around(const PassSource& source, const ShowsFault& shows) {
  const std::vector<PlainToken> tokens = split_tokens(source.body);
  Rewriter rewriter(tokens);
  const bool halves = rewriter.meets(Fault::half_arithmetic) && shows(Fault::half_arithmetic);
  const bool continues =
      rewriter.meets(Fault::lost_continue) && rewriter.finds_endangered() && shows(Fault::lost_continue);
  if (!halves && !continues) return source;
  if (halves) rewriter.widen_halves();
  if (continues) rewriter.keep_continues();
  PassSource result = source;
  result.body.clear();
  for (const std::string& line : rewriter.lines(line_count(source.body))) result.body += line + '\n';
  result.helpers += rewriter.helpers;
  return result;
}

}  // namespace shadertwin
