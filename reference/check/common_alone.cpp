#include <algorithm>

#include "host/project/host_rules.h"
#include "reference/check/rules.h"

namespace shadertwin::check {
namespace {

// What shadertoy.com puts in front of Common where it compiles it by itself: nothing that a pass has, but for
// these two.
constexpr const char* head =
    "uniform vec4 iDate;\n"
    "uniform float iSampleRate;\n";

// The defines of the command line and Common, which every pass begins with.
Pass common_of(const Pass& pass) {
  Pass common;
  common.name = "Common";
  common.source.head = head;
  common.source.own_output = true;
  common.source.tail = "\nvoid main() { }\n";
  const std::size_t count = pass.source.lines.size() - own_lines(pass);
  std::size_t end = 0;
  for (std::size_t line = 0; line < count; ++line)
    end = std::min(pass.source.body.find('\n', end), pass.source.body.size() - 1) + 1;
  common.source.body = pass.source.body.substr(0, end);
  common.source.lines.assign(pass.source.lines.begin(),
                             pass.source.lines.begin() + static_cast<std::ptrdiff_t>(count));
  return common;
}

}  // namespace

std::vector<Finding> common_errors(const Project& project, const std::vector<Finding>& known) {
  if (!host_rules(project).common_stands_alone || project.common.empty()) return {};
  std::vector<Finding> findings;
  for (Finding& finding : syntax_errors(project, common_of(project.passes.back()))) {
    const bool told = std::any_of(known.begin(), known.end(), [&](const Finding& other) {
      return other.file == finding.file && other.line == finding.line;
    });
    if (told) continue;
    finding.text += " (shadertoy.com compiles Common by itself, too)";
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace shadertwin::check
