// The options that subcommands share, as typed values, in groups: a subcommand adds the groups that it
// honours, so that it refuses what it would ignore.
#pragma once

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "host/app/values.h"
#include "host/player/fixed_clock.h"
#include "host/project/project.h"

namespace shadertwin::app {

struct PlayOptions {
  std::string shader;
  std::vector<Define> defines;
  std::optional<unsigned> seed;
  bool vr = false;
  std::string media;
  std::optional<Dialect> dialect;
  bool mute = false;
  bool vscode_quirks = false;
  bool quiet = false;
  Undefined init = Undefined::zero;
  bool precise = false;
  Schedule schedule;
  int frames = 1;
  std::string pass;
  DeviceChoice on;
  std::optional<Region> tile;
  double timeout = 0.0;  // seconds; 0: never
  std::string json;
};

// SHADER and what changes how it is loaded, for every subcommand; --quiet too.
void add_project_options(CLI::App& command, PlayOptions& options);
void add_init_option(CLI::App& command, PlayOptions& options);
void add_precise_option(CLI::App& command, PlayOptions& options);
// Size and time of the frames.
void add_frame_options(CLI::App& command, PlayOptions& options);
// How many frames, with what mouse and keys.
void add_script_options(CLI::App& command, PlayOptions& options);
void add_pass_option(CLI::App& command, PlayOptions& options);
void add_on_option(CLI::App& command, PlayOptions& options);
void add_timeout_option(CLI::App& command, PlayOptions& options);
void add_tile_option(CLI::App& command, PlayOptions& options);
void add_json_option(CLI::App& command, PlayOptions& options);

// Throws Error(usage), "NAME WHY", if one of the options was given.
void refuse(const CLI::App& command, std::initializer_list<const char*> names, const std::string& why);
// Throws Error(usage) if there is an option that only the twin has and a player of OpenGL that would ignore
// it.
void refuse_for_gl(const PlayOptions& options, const DeviceChoice& on);
// Throws Error(usage) for an option that has no effect on the loaded project.
void refuse_for_project(const PlayOptions& options, const Project& project);

// Throws Error(usage) if --pixel lies outside of a picture of that size.
void check_pixel(glm::ivec2 pixel, glm::ivec2 size);

LoadOptions make_load_options(const PlayOptions& options);
// Index of the pass that --pass names, or of the last one. Throws Error(usage) if there is none of that name.
int chosen_pass(const Project& project, const PlayOptions& options);

// Of loading the files, or also of what stands in them, which `check` tells as findings.
enum class Warnings { of_loading, all };

// Loads the project and prints its warnings unless --quiet.
Project load(const PlayOptions& options, Warnings warnings = Warnings::all);

}  // namespace shadertwin::app
