#include "host/text/text_warnings.h"

#include <algorithm>

#include "host/text/common_alone.h"

namespace shadertwin {

std::string words_for_unset(const OtherUniform& uniform) {
  return uniform.is_block ? "nothing fills the uniform block '" + uniform.name + "': the pass is not drawn"
                          : "nothing sets the uniform '" + uniform.name + "'";
}

std::vector<std::string> all_warnings(const Project& project) {
  std::vector<std::string> warnings = project.warnings;
  const auto add = [&](const Pass& pass, const SourceLine& at, const std::string& words) {
    const std::string place =
        at.file < 0 ? pass.name
                    : project.files[static_cast<std::size_t>(at.file)] + ":" + std::to_string(at.line);
    std::string warning = place + ": warning: " + words;
    // Common belongs to every pass.
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
      warnings.push_back(std::move(warning));
  };
  for (const Pass& pass : project.passes) {
    for (const OtherUniform& uniform : pass.other_uniforms)
      if (!uniform.set) add(pass, uniform.at, words_for_unset(uniform));
    for (const UnsetInput& input : pass.unset_inputs)
      add(pass, input.at, "no vertex shader sets the input '" + input.name + "'");
  }
  if (std::string warning = warning_of_common(project); !warning.empty())
    warnings.push_back(std::move(warning));
  return warnings;
}

}  // namespace shadertwin
