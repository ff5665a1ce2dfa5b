#include "reference/check/rules.h"

#include <cstdlib>
#include <iterator>
#include <list>
#include <sstream>

#include "host/base/error.h"
#include "reference/check/parsed_pass.h"

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

// What the Error(shader) that is being handled says, line by line.
std::vector<Finding> read_errors(const Project& project, const Pass& pass, const Error& error) {
  if (error.status() != ExitStatus::shader) throw;
  std::vector<Finding> findings;
  std::istringstream lines(error.what());
  for (std::string line; std::getline(lines, line);) {
    const bool counts = line.find(": warning: ") == std::string::npos &&
                        line.find("compilation errors.") == std::string::npos;
    if (counts) findings.push_back(read_error(project, pass, line));
  }
  return findings;
}

}  // namespace

ParsedPass::ParsedPass(const Project& its_project, const Pass& its_pass)
    : project(its_project),
      pass(its_pass),
      tree(project, pass.source, Folding::float32, Errors::all),
      program(tree),
      storage(measure_storage(tree)) {}

std::vector<Finding> compile_errors(const Project& project, const Pass& pass) {
  try {
    const ParsedPass parsed(project, pass);
    return {};
  } catch (const Error& error) {
    return read_errors(project, pass, error);
  }
}

Reading read_rules(const Project& project) {
  Reading reading;
  const auto append = [&](std::vector<Finding> more) {
    std::move(more.begin(), more.end(), std::back_inserter(reading.findings));
  };
  append(text_rules(project));
  std::list<ParsedPass> passes;
  std::vector<Finding> errors;
  for (const Pass& pass : project.passes) {
    try {
      passes.emplace_back(project, pass);
    } catch (const Error& error) {
      const std::vector<Finding> found = read_errors(project, pass, error);
      errors.insert(errors.end(), found.begin(), found.end());
    }
  }
  reading.can_run = errors.empty();
  append(errors);
  append(common_errors(project, errors));
  append(macro_rules(project));
  if (reading.can_run) {
    for (const ParsedPass& parsed : passes) {
      reading.can_run &= parsed.storage.large.empty() && !parsed.storage.is_too_large_together();
      append(browser_limits(parsed));
      append(unwritten_outputs(parsed));
      append(evaluation_order(parsed));
      const std::vector<Finding> endless = endless_loops(parsed);
      reading.can_run &= endless.empty();
      append(endless);
    }
  }
  reading.findings = sorted(std::move(reading.findings));
  return reading;
}

}  // namespace shadertwin::check
