// What it takes until the first frame of a project in six passes with four textures of the sizes that
// shadertoy.com has, on Mesa's software renderer: `process` + `start` - `compile`.
#include <benchmark/benchmark.h>
#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <nlohmann/json.hpp>

#include "host/gl/gl_device.h"
#include "host/gl/program.h"
#include "host/image/image.h"
#include "host/text/load.h"
#include "tests/bench/device.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

using Json = nlohmann::json;

constexpr std::array<const char*, 4> buffer_ids = {"4dXGR8", "XsXGR8", "4sXGR8", "XdfGR8"};
constexpr std::array<int, 4> sides = {1024, 1024, 512, 512};

std::string texture_name(std::size_t i) {
  return "t" + std::to_string(i) + (i == 3 ? ".png" : ".jpg");
}

Json texture_input(std::size_t i) {
  return {{"id", "t" + std::to_string(i)},
          {"filepath", "/media/a/" + texture_name(i)},
          {"type", "texture"},
          {"channel", 0},
          {"sampler", {{"filter", "mipmap"}, {"wrap", "repeat"}, {"vflip", "true"}}}};
}

Json buffer_input(std::size_t i, int channel) {
  return {{"id", buffer_ids[i]}, {"filepath", ""}, {"type", "buffer"}, {"channel", channel}};
}

Json pass(const std::string& type, const std::string& name, const std::string& id, Json inputs,
          const std::string& code) {
  return {{"type", type},
          {"name", name},
          {"code", code},
          {"inputs", std::move(inputs)},
          {"outputs", Json::array({{{"id", id}, {"channel", 0}}})}};
}

// Four buffers, each of which reads its texture and the buffer before, the cubemap and the image.
class SixPasses {
 public:
  SixPasses() {
    Json passes = Json::array();
    Json all = Json::array();
    for (std::size_t i = 0; i < 4; ++i) {
      write_texture(i);
      passes.push_back(pass("buffer", std::string("Buffer ") + static_cast<char>('A' + i), buffer_ids[i],
                            {texture_input(i), buffer_input((i + 3) % 4, 1)},
                            "void mainImage(out vec4 c, in vec2 p) {\n  vec2 u = p / iResolution.xy;\n"
                            "  c = texture(iChannel0, 3. * u) + .5 * texture(iChannel1, u);\n}\n"));
      all.push_back(buffer_input(i, static_cast<int>(i)));
    }
    passes.push_back(pass("cubemap", "Cube A", "4dX3Rr", {texture_input(0)},
                          "void mainCubemap(out vec4 c, in vec2 p, in vec3 o, in vec3 d) {\n"
                          "  c = texture(iChannel0, p / 1024.) * vec4(d, 1);\n}\n"));
    passes.push_back(pass("image", "Image", "4dfGRr", all,
                          "void mainImage(out vec4 c, in vec2 p) {\n  vec2 u = p / iResolution.xy;\n"
                          "  c = texture(iChannel0, u) + texture(iChannel1, u) + texture(iChannel2, u) + "
                          "texture(iChannel3, u);\n}\n"));
    folder_.write("six.json", Json::array({{{"ver", "0.1"}, {"renderpass", passes}}}).dump());
  }

  Project load() const { return load_project(folder_ / "six.json"); }

 private:
  void write_texture(std::size_t i) const {
    const int side = sides[i];
    Image image(side, side);
    for (std::size_t value = 0; value < image.rgba.size(); ++value)
      image.rgba[value] = value % 4 == 3 ? 1.0F : static_cast<float>(value * 2654435761U % 251U) / 250.0F;
    write_image(image, folder_ / texture_name(i));
  }

  ScratchFolder folder_;
};

void process(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    const std::array<const char*, 3> arguments = {SHADERTWIN_BINARY, "--version", nullptr};
    posix_spawn_file_actions_t quiet;
    posix_spawn_file_actions_init(&quiet);
    posix_spawn_file_actions_addopen(&quiet, 1, "/dev/null", 1, 0);
    pid_t child = 0;
    int status = 0;
    if (posix_spawn(&child, SHADERTWIN_BINARY, &quiet, nullptr, const_cast<char* const*>(arguments.data()),
                    environ) != 0 ||
        waitpid(child, &status, 0) != child || status != 0)
      state.SkipWithError("shadertwin does not run");
    posix_spawn_file_actions_destroy(&quiet);
  }
}

void start(benchmark::State& state, const char* device) {
  if (skips(state, device)) return;
  const SixPasses project;
  for ([[maybe_unused]] auto _ : state) {
    const auto player = gl::make_player(gl::open_context(device), project.load(), {gl::Dispatch::fragment});
    player->finish();
  }
}

void compile(benchmark::State& state, const char* device) {
  if (skips(state, device)) return;
  const Project project = SixPasses().load();
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    const auto context = gl::open_context(device);
    context->make_current();
    state.ResumeTiming();
    for (const Pass& each : project.passes)
      benchmark::DoNotOptimize(
          gl::Program::fragment(context->functions(), project, each, each.source).name());
  }
}

BENCHMARK(process)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(start, llvmpipe, "llvmpipe")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(start, osmesa, "osmesa")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(compile, llvmpipe, "llvmpipe")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(compile, osmesa, "osmesa")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace shadertwin
