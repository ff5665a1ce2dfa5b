// The subcommands. Each function declares one subcommand's options and what it does.
#pragma once

#include <string>
#include <vector>

#include "host/app/command_line.h"

namespace shadertwin::app {

// Callbacks throw Error; main turns that into one line and an exit status.
void add_accuracy(CommandLine app);
void add_check(CommandLine app);
void add_compare(CommandLine app);
// `arguments`: of the whole program, without its name; gdb starts it again with them.
void add_debug(CommandLine app, const std::vector<std::string>& arguments);
void add_devices(CommandLine app);
void add_export(CommandLine app);
void add_render(CommandLine app);
void add_sweep(CommandLine app);
void add_view(CommandLine app);

}  // namespace shadertwin::app
