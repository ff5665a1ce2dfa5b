// The directives of the VS Code extension "Shader Toy", found in a text and checked, each by itself.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "host/project/project.h"

namespace shadertwin {

struct Directive {
  enum class Kind {
    include,  // text: the path
    channel,  // text: the path
    channel_min,
    channel_mag,
    channel_wrap,
    channel_cubemap,  // ::Type; cubemap says which
    keyboard,
    uniform,
    vertex,  // text: the path
    first_person_controls,
    strict_compatibility,
    version,  // GLSL's own #version line, which the host replaces
  };
  Kind kind = Kind::include;
  std::size_t begin = 0;  // of the # in the text
  std::size_t end = 0;
  int line = 1;
  std::string text;
  int channel = 0;
  MinFilter min = MinFilter::linear;
  MagFilter mag = MagFilter::linear;
  Wrap wrap = Wrap::repeat;
  bool cubemap = false;
  CustomUniform uniform;
};

// All directives of `text`, in order. Conditional compilation is ignored, as the extension does. `file` is
// the name for messages. Throws Error(shader) with file:line for a malformed directive.
std::vector<Directive> parse_directives(std::string_view text, const std::string& file);

}  // namespace shadertwin
