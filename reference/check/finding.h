// What `check` tells about a shader: one line for each thing that is wrong.
#pragma once

#include <string>
#include <vector>

#include "host/project/project.h"

namespace shadertwin::check {

struct Finding {
  std::string file;  // as the user would name it
  int line = 0;      // from 1
  std::string kind;  // webgl2 | portability | undefined | nan | inf | uninitialised | out | loop
  std::string text;

  bool operator==(const Finding&) const = default;
};

// `file:line: kind: text`
std::string to_line(const Finding& finding);

// Without those that are there twice (Common belongs to every pass), by file and line.
std::vector<Finding> sorted(std::vector<Finding> findings);

// A finding at a line of one of the project's files. Lines that the host supplied count as the first line of
// the pass's own file.
Finding make_finding(const Project& project, const Pass& pass, SourceLine at, const std::string& kind,
                     const std::string& text);

}  // namespace shadertwin::check
