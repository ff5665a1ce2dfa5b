// The places of a shader that a twin with shadows tells of, numbered from 1.
#pragma once

#include <string>
#include <vector>

#include "host/text/syntax_tree.h"

namespace shadertwin::emit {

class Places {
 public:
  struct Place {
    SourceLine at;
    std::string text;  // as the shader has it, shortened; empty for an assignment or a return
  };

  explicit Places(const SyntaxTree& tree) : tree_(tree) {}

  // `left OP right`, or a call. 0 for the host's own text.
  int of_operation(const glslang::TIntermTyped& left, const glslang::TIntermTyped& right);
  int of_call(const glslang::TIntermTyped& call);
  int of_line(SourceLine line);

  const std::vector<Place>& all() const { return places_; }

 private:
  struct Range {
    int first = 0;
    int last = -1;
  };
  Range range_of(const TIntermNode& node) const;
  Range called(Range range) const;
  Range whole(Range range) const;
  Range with_factors(Range range) const;
  std::string text_of(Range range) const;
  int add(SourceLine at, const std::string& text);

  const SyntaxTree& tree_;
  std::vector<Place> places_{Place{}};
};

}  // namespace shadertwin::emit
