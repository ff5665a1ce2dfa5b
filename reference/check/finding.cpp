#include "reference/check/finding.h"

#include <algorithm>
#include <string_view>
#include <tuple>

namespace shadertwin::check {

std::string to_line(const Finding& finding) {
  return finding.file + ':' + std::to_string(finding.line) + ": " + finding.kind + ": " + finding.text;
}

std::vector<Finding> sorted(std::vector<Finding> findings) {
  std::stable_sort(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
    return std::tie(a.file, a.line) < std::tie(b.file, b.line);
  });
  std::vector<Finding> result;
  for (Finding& finding : findings) {
    if (std::find(result.begin(), result.end(), finding) == result.end())
      result.push_back(std::move(finding));
  }
  return result;
}

Finding make_finding(const Project& project, const Pass& pass, SourceLine at, const std::string& kind,
                     const std::string& text) {
  if (at.file < 0) {
    // The pass's own file is the one that its last line is from.
    const int file = pass.source.lines.empty() ? -1 : pass.source.lines.back().file;
    at = {file, 1};
  }
  const std::string name = at.file < 0 ? pass.name : project.files[static_cast<std::size_t>(at.file)];
  return {name, at.line, kind, text};
}

}  // namespace shadertwin::check
