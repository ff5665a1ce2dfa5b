// What a frame costs: a trivial shader through the player against the same OpenGL calls by hand, and scene 0.
//
//   cmake -B build-bench -G Ninja -DSHADERTWIN_BENCHMARKS=ON && ninja -C build-bench shadertwin_bench
//   build-bench/shadertwin_bench --benchmark_repetitions=9 --benchmark_enable_random_interleaving=true
#include <benchmark/benchmark.h>

#include "host/gl/gl_device.h"
#include "host/gl/objects.h"
#include "host/gl/program.h"
#include "host/gl/textures.h"
#include "host/player/fixed_clock.h"
#include "host/text/load.h"
#include "tests/bench/device.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

constexpr glm::ivec2 size(640, 360);

Project trivial_project() {
  const ScratchFolder folder;
  return load_project(folder.write(
      "trivial.glsl",
      "void mainImage(out vec4 c, in vec2 p) { c = vec4(p / iResolution.xy, fract(iTime), 1); }\n"));
}

// The least that draws the same frame: no player.
class BareGl {
 public:
  explicit BareGl(const std::string& device)
      : context_(gl::open_context(device)), gl_(context_->functions()), project_(trivial_project()) {
    program_.emplace(gl::Program::fragment(gl_, project_, project_.passes[0], project_.passes[0].source));
    resolution_ = program_->uniform("iResolution");
    time_ = program_->uniform("iTime");
    vertex_array_ = gl::VertexArrayObject(gl_);
    gl_.BindVertexArray(vertex_array_.name());
    texture_ = gl::make_target(gl_, GL_TEXTURE_2D, size, false);
    framebuffer_ = gl::FramebufferObject(gl_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
  }
  ~BareGl() { context_->make_current(); }

  void draw(int index) {
    context_->make_current();
    const glm::vec3 resolution(size, 1.0F);
    const float time = static_cast<float>(index) / 60.0F;
    gl_.UseProgram(program_->name());
    gl_.Uniform3fv(resolution_, 1, &resolution.x);
    gl_.Uniform1fv(time_, 1, &time);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl_.Viewport(0, 0, size.x, size.y);
    constexpr std::array<GLfloat, 4> zero{};
    gl_.ClearBufferfv(GL_COLOR, 0, zero.data());  // as the extension's rules ask for
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.Flush();
  }
  void finish() { gl_.Finish(); }
  void read(Image& image) { gl_.ReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, image.rgba.data()); }

 private:
  std::unique_ptr<gl::Context> context_;
  const gl::Functions& gl_;
  Project project_;
  std::optional<gl::Program> program_;
  GLint resolution_ = -1;
  GLint time_ = -1;
  gl::VertexArrayObject vertex_array_;
  gl::TextureObject texture_;
  gl::FramebufferObject framebuffer_;
};

void bare_draw(benchmark::State& state, const char* device) {
  if (skips(state, device)) return;
  BareGl bare(device);
  int index = 0;
  for ([[maybe_unused]] auto _ : state) {
    bare.draw(index++);
    bare.finish();
  }
}

void bare_draw_and_read(benchmark::State& state, const char* device) {
  if (skips(state, device)) return;
  BareGl bare(device);
  Image image(size.x, size.y);
  int index = 0;
  for ([[maybe_unused]] auto _ : state) {
    bare.draw(index++);
    bare.read(image);
  }
}

class Playing {
 public:
  Playing(const char* device, const Project& project)
      : player_(gl::make_player(gl::open_context(device), project, {gl::Dispatch::fragment})),
        last_(static_cast<int>(project.passes.size()) - 1),
        clock_({.width = size.x, .height = size.y, .date = {}, .mouse = {}, .keys = {}},
               host_rules(project)) {}

  void draw() { player_->render(clock_.next()); }
  void finish() { player_->finish(); }
  Image read() { return player_->read(last_); }

 private:
  std::unique_ptr<Player> player_;
  int last_;
  FixedClock clock_;
};

void player_draw(benchmark::State& state, const char* device) {
  if (skips(state, device)) return;
  Playing playing(device, trivial_project());
  for ([[maybe_unused]] auto _ : state) {
    playing.draw();
    playing.finish();
  }
}

void player_draw_and_read(benchmark::State& state, const char* device) {
  if (skips(state, device)) return;
  Playing playing(device, trivial_project());
  for ([[maybe_unused]] auto _ : state) {
    playing.draw();
    benchmark::DoNotOptimize(playing.read());
  }
}

void scene_0(benchmark::State& state, const char* device) {
  if (skips(state, device)) return;
  Playing playing(device, load_project(SHADERTWIN_SOURCE_DIR "/shadertoy/image.glsl"));
  for ([[maybe_unused]] auto _ : state) {
    playing.draw();
    playing.finish();
  }
}

#define SHADERTWIN_ON_BOTH(function)                                                               \
  BENCHMARK_CAPTURE(function, llvmpipe, "llvmpipe")->Unit(benchmark::kMillisecond)->UseRealTime(); \
  BENCHMARK_CAPTURE(function, osmesa, "osmesa")->Unit(benchmark::kMillisecond)->UseRealTime()

SHADERTWIN_ON_BOTH(bare_draw);
SHADERTWIN_ON_BOTH(player_draw);
SHADERTWIN_ON_BOTH(bare_draw_and_read);
SHADERTWIN_ON_BOTH(player_draw_and_read);
SHADERTWIN_ON_BOTH(scene_0);

}  // namespace
}  // namespace shadertwin
