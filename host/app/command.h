// The subcommands. Each function declares one subcommand's options and what it does.
#pragma once

#include <CLI/CLI.hpp>

namespace shadertwin::app {

// Callbacks throw Error; main turns that into one line and an exit status.
void add_accuracy(CLI::App& app);
void add_check(CLI::App& app);
void add_compare(CLI::App& app);
// `arguments`: of the whole program, without its name; gdb starts it again with them.
void add_debug(CLI::App& app, const std::vector<std::string>& arguments);
void add_devices(CLI::App& app);
void add_export(CLI::App& app);
void add_render(CLI::App& app);
void add_sweep(CLI::App& app);
void add_view(CLI::App& app);

}  // namespace shadertwin::app
