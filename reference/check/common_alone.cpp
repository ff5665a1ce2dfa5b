#include "host/text/common_alone.h"

#include <algorithm>

#include "reference/check/rules.h"

namespace shadertwin::check {

std::vector<Finding> common_errors(const Project& project, const std::vector<Finding>& known) {
  const std::optional<Pass> common = common_alone(project);
  if (!common) return {};
  std::vector<Finding> findings;
  for (Finding& finding : compile_errors(project, *common)) {
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
