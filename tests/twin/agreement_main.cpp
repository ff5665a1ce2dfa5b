// shadertwin-agreement: looks for shaders on which llvmpipe and the twins differ.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "host/text/load.h"
#include "tests/emit/random_shader.h"
#include "tests/twin/agreement.h"

namespace {

namespace fs = std::filesystem;
using shadertwin::AgreementOptions;

int report(const std::string& name, const fs::path& file, const AgreementOptions& options) {
  std::vector<std::string> lines;
  try {
    lines = shadertwin::disagreements(shadertwin::load_project(file), options);
  } catch (const std::exception& e) {
    lines = {e.what()};
  }
  for (const std::string& line : lines) std::printf("%s: %s\n", name.c_str(), line.c_str());
  std::fflush(stdout);
  return lines.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Plays shaders on llvmpipe and on the CPU twins, and prints where they differ.");
  unsigned first = 1;
  unsigned count = 0;
  std::string keep;
  std::vector<std::string> files;
  AgreementOptions options;
  app.add_option("--first", first, "seed of the first random shader (1)");
  app.add_option("--count", count, "random shaders (0)");
  app.add_option("--keep", keep, "folder to write the random shaders to");
  app.add_option(
      "--size",
      [&](const CLI::results_t& size) {
        return std::sscanf(size[0].c_str(), "%dx%d", &options.width, &options.height) == 2;
      },
      "WxH (20x12)");
  app.add_option("--frames", options.frames, "frames (2)");
  app.add_option("--tolerance", options.tolerance, "relative, or absolute below 1 (0)");
  app.add_flag("--osmesa", options.osmesa, "OSMesa too, if it is there");
  bool packets_only = false;
  app.add_flag("--packets-only", packets_only, "of the twins only the one of eight pixels");
  bool gl_only = false;
  app.add_flag("--gl-only", gl_only, "no twin");
  app.add_option("FILE", files, "shaders");
  CLI11_PARSE(app, argc, argv);
  options.single = options.doubles = !packets_only && !gl_only;
  options.packets = !gl_only;

  int failed = 0;
  for (const std::string& file : files) failed += report(file, file, options);
  const fs::path folder = keep.empty() ? fs::temp_directory_path() : fs::path(keep);
  fs::create_directories(folder);
  for (unsigned seed = first; seed < first + count; ++seed) {
    const fs::path file = folder / ("random_" + std::to_string(seed) + ".glsl");
    std::ofstream(file) << shadertwin::random_shader(seed);
    failed += report("seed " + std::to_string(seed), file, options);
    if (keep.empty()) fs::remove(file);
  }
  std::printf("%d of %zu differ\n", failed, files.size() + count);
  return failed == 0 ? 0 : 1;
}
