#include "reference/check/rules.h"

#include <cstdlib>
#include <iterator>
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

// The findings that `read` throws as an Error(shader).
template <typename Read>
std::vector<Finding> thrown(const Project& project, const Pass& pass, Read read) {
  std::vector<Finding> findings;
  try {
    read();
  } catch (const Error& e) {
    if (e.status() != ExitStatus::shader) throw;
    std::istringstream lines(e.what());
    for (std::string line; std::getline(lines, line);) {
      const bool counts = line.find(": warning: ") == std::string::npos &&
                          line.find("compilation errors.") == std::string::npos;
      if (counts) findings.push_back(read_error(project, pass, line));
    }
  }
  return findings;
}

}  // namespace

std::vector<Finding> syntax_errors(const Project& project, const Pass& pass) {
  return thrown(project, pass, [&] {
    const emit::SyntaxTree tree(project, pass.source, emit::Folding::float32, emit::Errors::all);
  });
}

std::vector<Finding> compile_errors(const Project& project) {
  std::vector<Finding> findings;
  for (const Pass& pass : project.passes) {
    const auto found = thrown(project, pass, [&] {
      const emit::SyntaxTree tree(project, pass.source, emit::Folding::float32, emit::Errors::all);
      const emit::Program program(tree);  // recursion, functions without a body
    });
    findings.insert(findings.end(), found.begin(), found.end());
  }
  return findings;
}

Reading read_rules(const Project& project) {
  Reading reading;
  const auto append = [&](std::vector<Finding> more) {
    std::move(more.begin(), more.end(), std::back_inserter(reading.findings));
  };
  const std::vector<Finding> errors = compile_errors(project);
  reading.can_run = errors.empty();
  append(text_rules(project));
  append(errors);
  append(common_errors(project, errors));
  if (reading.can_run) {
    append(browser_limits(project));
    append(unwritten_outputs(project));
    const std::vector<Finding> endless = endless_loops(project);
    reading.can_run = endless.empty();
    append(endless);
  }
  reading.findings = sorted(std::move(reading.findings));
  return reading;
}

}  // namespace shadertwin::check
