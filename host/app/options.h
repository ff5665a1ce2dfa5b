// The options that subcommands share, as typed values. add_options() says all that there is to know of each:
// name, help, where its value goes, which subcommands honour it, and where it would change nothing and is
// refused.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "host/app/command_line.h"
#include "host/app/values.h"
#include "host/player/fixed_clock.h"
#include "host/project/project.h"

namespace shadertwin::app {

enum class Command { view, render, compare, sweep, check, accuracy, export_, debug };

// Where an option may change nothing.
enum class NoEffect {
  on_sound,        // render writes the Sound pass
  on_opengl,       // the player is not the twin
  on_site_rules,   // the project is not of the extension's dialect
  on_files,        // the shader is no Shadertoy JSON
  on_site_export,  // the export is what shadertoy.com takes
  on_cpp_export,
};

// An option of a subcommand.
struct Declared {
  Option option;
  std::vector<NoEffect> no_effect;
  bool changes_pixels = false;  // options_text() has it
};

struct PlayOptions {
  std::string shader;
  LoadOptions load;
  bool quiet = false;
  Schedule schedule;
  int frames = 1;
  std::string pass;
  DeviceChoice on;
  std::optional<Region> tile;
  double timeout = 0.0;  // seconds; 0: never
  std::string json;
  std::vector<Declared> declared;
};

// Gives a subcommand its options. `options` has to live as long as `app`; what it holds is the default.
void add_options(CommandLine app, Command command, PlayOptions& options);

// Throws Error(usage), "NAME WHY", if an option was given that has no effect there.
void refuse(const PlayOptions& options, NoEffect where, const std::string& why);
// The same for options by name, as they are a subcommand's own.
void refuse(CommandLine command, std::initializer_list<const char*> names, const std::string& why);
// Throws Error(usage) if there is an option that only the twin has and a player of OpenGL that would ignore
// it.
void refuse_for_player(const PlayOptions& options, const DeviceChoice& on);

// Throws Error(usage) if there is an option that has no effect on such a project.
void refuse_for_project(const PlayOptions& options, const Project& project);

// The options that change a pixel, as they were given, to be typed again behind a command that looks into a
// frame; but for those of the frame itself, which view::commands_for_pixel() says.
std::string options_text(const PlayOptions& options);

// Throws Error(usage) if --pixel lies outside of a picture of that size.
void check_pixel(glm::ivec2 pixel, glm::ivec2 size);

// Index of the pass that --pass names, or of the last one. Throws Error(usage) if there is none of that name.
int chosen_pass(const Project& project, const PlayOptions& options);

// Of loading the files, or also of what stands in them, which `check` tells as findings.
enum class Warnings { of_loading, all };

// Loads the project and prints its warnings unless --quiet. Throws Error(usage) for an option that has no
// effect on it.
Project load(const PlayOptions& options, Warnings warnings = Warnings::all);

}  // namespace shadertwin::app
