// Writes C++ line by line and keeps its indentation.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/project/project.h"

namespace shadertwin::emit {

// A line of C++, and the user's line that it stands for (file -1: none).
struct CppLine {
  int depth = 0;
  std::string text;
  SourceLine source;
  bool is_statement = false;  // ends with a semicolon, which `text` leaves out
  // Of a declaration with a value, `int i = 0`: its two halves.
  std::string type = {};
  std::string declarator = {};

  std::string written() const { return is_statement ? text + ';' : text; }
};

class CppWriter {
 public:
  // The user's line that the next lines stand for.
  void at(const SourceLine& source) { source_ = source; }
  const SourceLine& source() const { return source_; }

  void line(const std::string& text) { lines_.push_back({depth_, text, source_}); }
  void statement(const std::string& text) { lines_.push_back({depth_, text, source_, true}); }
  void declare(const std::string& type, const std::string& name, const std::string& value) {
    const std::string declarator = name + " = " + value;
    lines_.push_back({depth_, type + ' ' + declarator, source_, true, type, declarator});
  }

  // A block: `head {`, then `} head {` for each further part, and `}` or what stands there instead.
  void begin(const std::string& head = {}) {
    line(head.empty() ? "{" : head + " {");
    ++depth_;
  }
  void next(const std::string& head) {
    end("} " + head + " {");
    ++depth_;
  }
  void end(const std::string& tail = "}") {
    --depth_;
    line(tail);
  }

  // What `write` writes, kept for add() instead of written here.
  template <class Write>
  std::vector<CppLine> capture(const Write& write) {
    std::vector<CppLine> outer = std::exchange(lines_, {});
    const int depth = std::exchange(depth_, 0);
    write();
    depth_ = depth;
    return std::exchange(lines_, std::move(outer));
  }
  void add(const std::vector<CppLine>& captured) {
    for (CppLine line : captured) {
      line.depth += depth_;
      lines_.push_back(std::move(line));
    }
  }

  std::vector<CppLine> take() { return std::exchange(lines_, {}); }

 private:
  std::vector<CppLine> lines_;
  int depth_ = 0;
  SourceLine source_;
};

// `int i = 0;` and `int j = 1;` as one statement for a loop's header, `int i = 0, j = 1`; empty for no lines,
// none if C++ can't say it so.
std::optional<std::string> joined(const std::vector<CppLine>& lines);

}  // namespace shadertwin::emit
