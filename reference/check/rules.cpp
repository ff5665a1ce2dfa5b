#include "reference/check/rules.h"

#include <cstdlib>
#include <sstream>

#include "host/base/error.h"
#include "reference/emit/program.h"

namespace shadertwin::check {
namespace {

// `file:line: error: text`, as map_log and the emitter write it; a file's name may hold colons.
Finding read_error(const Project& project, const Pass& pass, const std::string& line) {
  const std::string mark = ": error: ";
  const std::size_t end = line.find(mark);
  if (end == std::string::npos) return make_finding(project, pass, {}, "webgl2", line);
  std::string text = line.substr(end + mark.size());
  while (!text.empty() && text.back() == ' ') text.pop_back();
  // glslang's own words are about a profile.
  if (text.find("extraneous semicolon") != std::string::npos)
    text = "semicolon of its own outside of functions: browsers refuse it";
  const std::size_t colon = line.rfind(':', end - 1);
  const int number = colon < end ? std::atoi(line.c_str() + colon + 1) : 0;
  if (number <= 0) return make_finding(project, pass, {}, "webgl2", text);
  return {line.substr(0, colon), number, "webgl2", text};
}

}  // namespace

std::vector<Finding> compile_errors(const Project& project) {
  std::vector<Finding> findings;
  for (const Pass& pass : project.passes) {
    try {
      const emit::SyntaxTree tree(project, pass.source, emit::Folding::float32, emit::Errors::all);
      const emit::Program program(tree);  // recursion, functions without a body
    } catch (const Error& e) {
      if (e.status() != ExitStatus::shader) throw;
      std::istringstream lines(e.what());
      for (std::string line; std::getline(lines, line);) {
        if (line.find(": warning: ") == std::string::npos)
          findings.push_back(read_error(project, pass, line));
      }
    }
  }
  return findings;
}

}  // namespace shadertwin::check
