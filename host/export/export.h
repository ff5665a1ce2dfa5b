// A project in the forms in which people pass shaders on.
#pragma once

#include <filesystem>
#include <string>

#include "host/project/project.h"

namespace shadertwin {

// A page that plays the project in any browser with WebGL2, with everything it needs inside: shaders,
// pictures, sounds. Pictures go in as the files are where a browser can decode them, else as texels. The page
// shows compiler messages by the user's own files and lines. `title` is the page's. Throws Error(file) for an
// input that can't be read.
std::string html_player(const Project& project, const std::string& title);

}  // namespace shadertwin
