// From directives about channels to what is bound to them.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "host/project/project.h"
#include "host/project/text_loader.h"

namespace shadertwin {

struct ChannelContext {
  Project& project;
  std::filesystem::path pass_file;  // "self" is this one
  std::filesystem::path root;       // the file or folder that the user named
  int self = -1;                    // the pass's own index
  // The index of the pass whose text is in a file.
  std::function<int(const std::filesystem::path&, const PlacedDirective&)> find_pass;
};

// Fills pass.inputs from the directives of the pass. Later directives win; settings may stand before the
// channel they are about. Throws Error(file) for a missing file and Error(shader) for a cubemap with missing
// faces.
void bind_channels(const ChannelContext& context, const std::vector<PlacedDirective>& directives,
                   std::array<Input, max_channels>& inputs);

// Adds what the other directives of a pass ask for to the project. True if the pass has #iKeyboard.
struct PassFlags {
  bool keyboard = false;
  bool strict = false;
};
PassFlags apply_directives(Project& project, const std::vector<PlacedDirective>& directives);

}  // namespace shadertwin
