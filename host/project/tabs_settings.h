// shadertoy.json: what a folder of tabs can't say in GLSL, namely what is bound to which channel.
//
//   {
//     "Image":    { "iChannel0": { "buffer": "Buffer A", "filter": "linear", "wrap": "clamp" } },
//     "Buffer A": { "iChannel0": { "buffer": "Buffer A" },
//                   "iChannel1": { "texture": "wood.jpg", "filter": "mipmap", "wrap": "repeat", "vflip": true
//                   }, "iChannel2": { "cubemap": "forest_{}.png" }, "iChannel3": { "keyboard": true } }
//   }
//
// An input has one of buffer (a tab's name, "Cubemap A" included), texture, cubemap (a path with {}, or six
// paths +X -X +Y -Y +Z -Z), volume, music, video (paths inside of the folder), keyboard, webcam, microphone
// (true), and may have filter (nearest, linear, mipmap), wrap (clamp, repeat, mirror) and vflip (true,
// false). Without these it gets what the site's editor gives a new input.
#pragma once

#include <filesystem>

#include "host/project/project.h"

namespace shadertwin {

// Reads `file` and binds what it names, over what directives have bound. Throws Error(file) with the file's
// name.
void apply_tabs_settings(const std::filesystem::path& file, Project& project);

}  // namespace shadertwin
