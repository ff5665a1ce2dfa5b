#include "tests/shadertoy/probe.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "host/base/error.h"
#include "host/gl/gl_device.h"
#include "host/player/fixed_clock.h"
#include "host/text/load.h"
#include "reference/twin/twin_device.h"
#include "tests/scratch_folder.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

constexpr int input_channel = 9;

// SHADERTWIN_SHADERS names a copy of shadertoy/ and tests/shadertoy/ to test instead: tools/mutants does.
fs::path shader_folder() {
  const char* copy = std::getenv("SHADERTWIN_SHADERS");
  return fs::path(copy ? copy : SHADERTWIN_SOURCE_DIR) / "tests" / "shadertoy";
}

// Table <-> picture, as probe.glsl says. The last row is padded with copies of the last case.
struct Layout {
  std::size_t cases;
  int size;
  int width() const { return static_cast<int>(std::min<std::size_t>(cases, 1024)); }
  int rows() const {
    return static_cast<int>((cases + static_cast<std::size_t>(width()) - 1) /
                            static_cast<std::size_t>(width()));
  }
  int height() const { return rows() * size; }
};

Image to_image(const Table& table) {
  const Layout layout{table.cases(), table.size()};
  Image image(layout.width(), layout.height());
  for (int row = 0; row < layout.rows(); ++row)
    for (int x = 0; x < layout.width(); ++x) {
      const std::size_t i = static_cast<std::size_t>(row) * static_cast<std::size_t>(layout.width()) +
                            static_cast<std::size_t>(x);
      for (int j = 0; j < table.size(); ++j)
        std::memcpy(image.at(x, row * table.size() + j), &table.at(std::min(i, table.cases() - 1), j),
                    sizeof(glm::vec4));
    }
  return image;
}

// A DDS of floats, which is the texels as they are behind a header: a million cases in an EXR take longer to
// pack and unpack than to compute.
void write_texels(const Image& image, const fs::path& file) {
  std::array<std::uint32_t, 32> header{};
  std::memcpy(header.data(), "DDS ", 4);
  header[1] = 124;  // bytes that follow
  header[3] = static_cast<std::uint32_t>(image.height);
  header[4] = static_cast<std::uint32_t>(image.width);
  header[19] = 32;   // bytes of the pixel format
  header[20] = 4;    // it is a code
  header[21] = 116;  // D3DFMT_A32B32G32R32F
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(header.data()), sizeof header);
  out.write(reinterpret_cast<const char*>(image.rgba.data()),
            static_cast<std::streamsize>(image.rgba.size() * sizeof(float)));
  if (!out.flush()) throw Error(ExitStatus::file, file.string() + ": can't be written");
}

Table to_table(const Image& image, std::size_t cases, int size) {
  Table table(cases, size);
  const auto width = static_cast<std::size_t>(image.width);
  for (std::size_t i = 0; i < cases; ++i)
    for (int j = 0; j < size; ++j)
      std::memcpy(&table.at(i, j),
                  image.at(static_cast<int>(i % width), static_cast<int>(i / width) * size + j),
                  sizeof(glm::vec4));
  return table;
}

Table run(const Backend& backend, const Probe& probe, std::size_t cases, const fs::path& inputs) {
  LoadOptions options;
  options.settings.defines = probe.defines;
  options.settings.defines.emplace_back("INPUTS", std::to_string(probe.inputs));
  options.settings.defines.emplace_back("OUTPUTS", std::to_string(probe.outputs));
  Project project = load_project(shader_folder() / probe.file, options);
  Input& input = project.passes.back().inputs[input_channel];
  input.kind = InputKind::texture;
  input.sampler = {MinFilter::nearest, MagFilter::nearest, Wrap::clamp, false};
  input.files = {inputs};
  const Layout layout{cases, probe.outputs};
  Frame frame;
  frame.width = layout.width();
  frame.height = layout.height();
  frame.index = probe.function;
  const auto player = backend.create(project);
  player->render(frame);
  return to_table(player->read(static_cast<int>(project.passes.size()) - 1), cases, probe.outputs);
}

}  // namespace

const std::vector<Backend>& backends() {
  static const std::vector<Backend> all = {
      {"gl", [](const Project& project) { return gl::make_player(gl::open_context("auto"), project); }},
      {"cpu", [](const Project& project) { return twin::make_player(project); }},
      {"cpu_double",
       [](const Project& project) {
         twin::TwinOptions options;
         options.double_precision = true;
         return twin::make_player(project, options);
       }},
  };
  return all;
}

Table run_probe(const Backend& backend, const Probe& probe, const Table& inputs) {
  const ScratchFolder folder;
  write_texels(to_image(inputs), folder / "inputs.dds");
  return run(backend, probe, inputs.cases(), folder / "inputs.dds");
}

Image run_shader(const Backend& backend, const Take& take) {
  LoadOptions options;
  options.settings.defines = take.defines;
  const Project project = load_project(shader_folder() / take.file, options);
  Schedule schedule;
  schedule.width = take.width;
  schedule.height = take.height;
  schedule.t0 = take.time;
  FixedClock clock(schedule, host_rules(project));
  const auto player = backend.create(project);
  for (int i = 0; i < take.frames; ++i) {
    Frame frame = clock.next();
    frame.index += take.first_frame;
    player->render(frame);
  }
  const int last = static_cast<int>(project.passes.size()) - 1;
  return player->read(take.pass.empty() ? last : find_pass(project, take.pass));
}

}  // namespace shadertwin
