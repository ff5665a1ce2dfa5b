// The player page's own parts, which the build puts into the program.
#pragma once

#include <string_view>

namespace shadertwin {

extern const std::string_view page_template;  // with {{title}}, {{style}}, {{project}}, {{script}}
extern const std::string_view page_style;
extern const std::string_view page_script;

}  // namespace shadertwin
