#include <cstdio>

#include "host/app/command.h"
#include "host/base/error.h"
#include "host/gl/context.h"

namespace shadertwin::app {

void add_devices(CommandLine app) {
  const CommandLine command =
      app.add_subcommand("devices", "what this machine can run on, by the names that --on takes");
  command.callback([] {
    std::vector<std::string> problems;
    const auto devices = gl::list_devices(&problems);
    for (const gl::DeviceInfo& d : devices)
      std::printf("%-8s %s | %s | %s | GLSL %s | targets to %d | %s%s\n", d.name.c_str(), d.vendor.c_str(),
                  d.renderer.c_str(), d.version.c_str(), d.shading_language.c_str(), d.max_size,
                  d.software ? "software" : "hardware", d.compute ? ", compute" : "");
    for (const std::string& problem : problems) std::fprintf(stderr, "%s\n", problem.c_str());
    if (devices.empty()) throw Error(ExitStatus::device, "no OpenGL device opens here");
  });
}

}  // namespace shadertwin::app
