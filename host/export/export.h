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

// The project as shadertoy.com takes it. What only the VS Code extension or the command line gives is put
// into the text: SHADER_TOY, knobs (-D), older names, key functions on a free channel. Throws Error(shader)
// where there is no channel left for the keyboard, and for a vertex shader.
Project for_site(const Project& project);

// Makes `folder` with a text file for each tab, as it is pasted into shadertoy.com, the pictures and sounds
// that they read, BINDINGS.txt, which says to people what to bind to which channel, and shadertoy.json, which
// says it to load_project: the folder plays here as the project does. `project`: from for_site. The folder
// appears whole or not at all. Throws Error(file) if it is there already, or can't be written; Error(shader)
// for what shadertoy.com does not have.
void write_tabs(const Project& project, const std::filesystem::path& folder);

}  // namespace shadertwin
