// The CPU twin against llvmpipe: scene 0, a marcher that lives on sin and exp, and what it takes to begin.
//
//   shadertwin_bench --benchmark_filter='twin|llvmpipe' --benchmark_repetitions=5
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>

#include "host/gl/gl_device.h"
#include "host/player/fixed_clock.h"
#include "host/text/load.h"
#include "reference/twin/twin_device.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

constexpr int width = 320;
constexpr int height = 180;

Project scene_0() {
  return load_project(std::filesystem::path(SHADERTWIN_SOURCE_DIR) / "shadertoy/image.glsl");
}

Project marcher() {
  const ScratchFolder folder;
  return load_project(folder.write("marcher.glsl", R"(
float map(vec3 p) {
  vec3 q = p + 0.2 * sin(3.0 * p.yzx + iTime) + 0.1 * cos(5.0 * p.zxy);
  float bumps = 0.05 * sin(8.0 * p.x) * sin(8.0 * p.y) * sin(8.0 * p.z);
  return length(q) - 1.0 + 0.1 * exp(-2.0 * dot(q, q)) + bumps;
}
void mainImage(out vec4 color, in vec2 p) {
  vec2 uv = (2.0 * p - iResolution.xy) / iResolution.y;
  vec3 o = vec3(0, 0, -3), d = normalize(vec3(uv, 1.5));
  float t = 0.0, glow = 0.0;
  for (int i = 0; i < 80; i++) {
    float step = map(o + t * d) * 0.5;
    glow += exp(-4.0 * abs(step));
    t += max(step, 0.01);
  }
  color = vec4(vec3(glow / 80.0) * (0.5 + 0.5 * sin(t + vec3(0, 2, 4))), 1);
}
)"));
}

void play(benchmark::State& state, Player& player, const Project& project) {
  Schedule schedule;
  schedule.width = width;
  schedule.height = height;
  FixedClock clock(schedule, host_rules(project));
  player.render(clock.next());
  player.finish();
  for (auto _ : state) {
    player.render(clock.next());
    player.finish();
  }
}

void llvmpipe(benchmark::State& state, Project (*load)()) {
  const Project project = load();
  const auto player = gl::make_player(gl::open_context("llvmpipe"), project, {gl::Dispatch::fragment});
  play(state, *player, project);
}

void twin(benchmark::State& state, Project (*load)()) {
  const Project project = load();
  play(state, *twin::make_player(project), project);
}

void twin_of_single_pixels(benchmark::State& state, Project (*load)()) {
  const Project project = load();
  twin::TwinOptions options;
  options.packets = false;
  play(state, *twin::make_player(project, options), project);
}

// Translating and compiling every pass, into a cache that holds nothing, not even the headers.
void twin_cold(benchmark::State& state) {
  const Project project = scene_0();
  for (auto _ : state) {
    state.PauseTiming();
    const ScratchFolder cache;
    setenv("XDG_CACHE_HOME", cache.path().c_str(), 1);
    state.ResumeTiming();
    twin::make_player(project);
  }
  unsetenv("XDG_CACHE_HOME");
}

// The same with the headers there, which all shaders share.
void twin_new_shader(benchmark::State& state) {
  const ScratchFolder cache;
  setenv("XDG_CACHE_HOME", cache.path().c_str(), 1);
  const Project project = scene_0();
  twin::make_player(marcher());
  for (auto _ : state) {
    twin::make_player(project);
    state.PauseTiming();
    for (const auto& entry : std::filesystem::directory_iterator(cache.path() / "shadertwin"))
      if (entry.path().extension() == ".so") std::filesystem::remove(entry.path());
    state.ResumeTiming();
  }
  unsetenv("XDG_CACHE_HOME");
}

void twin_from_cache(benchmark::State& state) {
  const Project project = scene_0();
  twin::make_player(project);
  for (auto _ : state) twin::make_player(project);
}

#define SHADERTWIN_PLAYED(function)             \
  BENCHMARK_CAPTURE(function, scene_0, scene_0) \
      ->Unit(benchmark::kMillisecond)           \
      ->MeasureProcessCPUTime()                 \
      ->UseRealTime();                          \
  BENCHMARK_CAPTURE(function, marcher, marcher) \
      ->Unit(benchmark::kMillisecond)           \
      ->MeasureProcessCPUTime()                 \
      ->UseRealTime()
SHADERTWIN_PLAYED(llvmpipe);
SHADERTWIN_PLAYED(twin);
SHADERTWIN_PLAYED(twin_of_single_pixels);
BENCHMARK(twin_cold)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(twin_new_shader)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(twin_from_cache)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace shadertwin
