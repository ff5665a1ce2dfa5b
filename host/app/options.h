// The options that every subcommand which takes a shader shares.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "host/player/fixed_clock.h"
#include "host/project/project.h"

namespace shadertwin::app {

struct PlayOptions {
  std::string shader;
  std::string on = "auto";
  std::string size = "640x360";
  int frames = 1;
  double fps = 60.0;
  double time = 0.0;
  std::string date;
  std::vector<std::string> mouse;
  std::vector<std::string> keys;
  std::vector<std::string> defines;
  std::string pass;
  std::string media;
  std::string dialect;
  std::string json;
  std::string tile;
  double timeout = 0.0;
  bool quiet = false;
  bool precise = false;
  bool mute = false;
  bool vr = false;
  std::string seed;
  std::string init = "zero";
  bool vscode_quirks = false;
};

// SHADER and the options that change what is loaded.
void add_load_options(CLI::App& command, PlayOptions& options);
// Those and the options of every subcommand that plays a shader.
void add_shader_options(CLI::App& command, PlayOptions& options);
// Those and how many frames, with what mouse and keys. `on` is left out for subcommands that name their
// players otherwise.
void add_play_options(CLI::App& command, PlayOptions& options);
void add_on_option(CLI::App& command, PlayOptions& options);

// A rectangle of pixels from the lower left.
struct TileRegion {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};
// Reads X,Y,WIDTH,HEIGHT. Throws Error(usage).
TileRegion parse_tile(const std::string& text);

// All three throw Error(usage) on a value that makes no sense.
Schedule make_schedule(const PlayOptions& options);
LoadOptions make_load_options(const PlayOptions& options);
// Index of the pass that --pass names, or of the last one.
int chosen_pass(const Project& project, const PlayOptions& options);

// Loads the project and prints its warnings unless --quiet.
Project load(const PlayOptions& options);

}  // namespace shadertwin::app
