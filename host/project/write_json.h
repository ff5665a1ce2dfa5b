// A project as a Shadertoy JSON.
#pragma once

#include <string>

#include "host/project/project.h"

namespace shadertwin {

// The document of Shadertoy's API (`{"Shader": ...}`), which load_project reads. A project that came from a
// JSON gives that very document, with all that is not understood here. Media stand as /media/a/FILENAME; a
// cubemap by its first face, as on the site. An #iUniform becomes a constant with its default value, in
// Common. Throws Error(shader) for what shadertoy.com does not have: over four buffers, channels above 3, an
// image that is read, main() instead of mainImage().
std::string write_json(const Project& project);

// `json`, a document that load_project takes, with `text` in front of its Common, and else as it was.
std::string with_common(const std::string& json, const std::string& text);

}  // namespace shadertwin
