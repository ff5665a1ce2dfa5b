#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "host/app/command.h"
#include "host/base/error.h"
#include "host/base/unfinished.h"

namespace {

using shadertwin::ExitStatus;

int fail(ExitStatus status, const std::string& text) {
  std::fprintf(stderr, "%s%s\n", status == ExitStatus::shader ? "" : "shadertwin: ", text.c_str());
  return static_cast<int>(status);
}

// The first line of a CLI11 message, which may be several.
std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

}  // namespace

int main(int argc, char** argv) {
  shadertwin::remove_unfinished_when_interrupted();
  CLI::App app{
      "Runs Shadertoy shaders off the web, and checks them against a CPU twin compiled from the same GLSL."};
  app.name("shadertwin");
  app.require_subcommand(1);
  app.set_version_flag("--version", SHADERTWIN_VERSION);
  // Later options win, so that scripts can put their own in front of the user's.
  app.option_defaults()->always_capture_default()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.footer(
      "Exit status: 0 done; 1 a comparison or check failed; 2 wrong usage; 3 the shader doesn't compile;\n"
      "4 a file can't be read or written; 5 no way to run here.");
  shadertwin::app::add_view(app);
  shadertwin::app::add_render(app);
  shadertwin::app::add_compare(app);
  shadertwin::app::add_sweep(app);
  shadertwin::app::add_check(app);
  shadertwin::app::add_accuracy(app);
  shadertwin::app::add_export(app);
  shadertwin::app::add_debug(app, {argv + 1, argv + argc});
  shadertwin::app::add_devices(app);
  try {
    app.parse(argc, argv);
    return static_cast<int>(ExitStatus::done);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(e);
    return fail(ExitStatus::usage, first_line(e.what()) + " (shadertwin --help lists what there is)");
  } catch (const shadertwin::Error& e) {
    return fail(e.status(), e.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitStatus::device, "out of memory");
  } catch (const std::exception& e) {
    return fail(ExitStatus::file, e.what());
  }
}
