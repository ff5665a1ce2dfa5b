// A compiler's messages, which number the lines of what it was given, as messages about the user's own files.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "host/project/project.h"

namespace shadertwin {

// `file:line` of a line of the body, from 0: its last one stands for all behind it. `-D NAME=VALUE` for what
// the command line defines, nothing for other lines that no file has.
std::string place_in_body(const Project& project, const PassSource& source, int line);

// Where a line of a text begins, from 0; the end of the text for all behind its last one.
std::size_t begin_of_line(std::string_view text, std::size_t line);

// Turns a compiler's log about render(source) into lines `file:line: error: text`. Knows the forms of Mesa
// (`0:12(5): error: ...`), NVIDIA (`0(12) : error C0000: ...`), ANGLE and glslang (`ERROR: 0:12: ...`). A
// line about what stands in front of the body is kept as it is; what lies behind the body (a missing brace is
// noticed there) is reported on the user's last line.
std::string map_log(const Project& project, const PassSource& source, const std::string& log);

}  // namespace shadertwin
