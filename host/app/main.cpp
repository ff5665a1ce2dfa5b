#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "host/app/command.h"
#include "host/base/error.h"
#include "host/base/unfinished.h"

namespace {

using shadertwin::ExitStatus;

int fail(ExitStatus status, const std::string& text) {
  std::fprintf(stderr, "%s%s\n", status == ExitStatus::shader ? "" : "shadertwin: ", text.c_str());
  return static_cast<int>(status);
}

void declare(shadertwin::app::CommandLine app, const std::vector<std::string>& arguments) {
  shadertwin::app::add_view(app);
  shadertwin::app::add_render(app);
  shadertwin::app::add_compare(app);
  shadertwin::app::add_sweep(app);
  shadertwin::app::add_check(app);
  shadertwin::app::add_accuracy(app);
  shadertwin::app::add_export(app);
  shadertwin::app::add_debug(app, arguments);
  shadertwin::app::add_devices(app);
}

}  // namespace

int main(int argc, char** argv) {
  shadertwin::remove_unfinished_when_interrupted();
  const shadertwin::app::ProgramText text = {.name = "shadertwin",
                                             .description =
                                                 "Runs Shadertoy shaders off the web, and checks them "
                                                 "against a CPU twin compiled from the same GLSL.",
                                             .version = SHADERTWIN_VERSION,
                                             .footer =
                                                 "Exit status: 0 done; 1 a comparison or check failed; 2 "
                                                 "wrong usage; 3 the shader doesn't compile;\n"
                                                 "4 a file can't be read or written; 5 no way to run here."};
  try {
    const int status = shadertwin::app::run_command_line(argc, argv, text, [&](auto app) {
      declare(app, {argv + 1, argv + argc});
    });
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      return fail(ExitStatus::file, "standard output: can't be written");
    return status;
  } catch (const shadertwin::Error& e) {
    return fail(e.status(), e.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitStatus::device, "out of memory");
  } catch (const std::exception& e) {
    return fail(ExitStatus::file, e.what());
  }
}
