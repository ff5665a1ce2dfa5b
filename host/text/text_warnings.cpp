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
  for (const Pass& pass : project.passes) {
    for (const OtherUniform& uniform : pass.other_uniforms) {
      if (uniform.set) continue;
      const std::string place = uniform.at.file < 0
                                    ? pass.name
                                    : project.files[static_cast<std::size_t>(uniform.at.file)] + ":" +
                                          std::to_string(uniform.at.line);
      std::string warning = place + ": warning: " + words_for_unset(uniform);
      // Common belongs to every pass.
      if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
        warnings.push_back(std::move(warning));
    }
  }
  if (std::string warning = warning_of_common(project); !warning.empty())
    warnings.push_back(std::move(warning));
  return warnings;
}

}  // namespace shadertwin
