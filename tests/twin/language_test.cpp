// Every construct of the language: the twin and llvmpipe give the same bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "host/gl/gl_device.h"
#include "host/player/fixed_clock.h"
#include "host/text/load.h"
#include "reference/twin/twin_device.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> shaders() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(SHADERTWIN_SOURCE_DIR) / "tests/emit/shaders"))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// How far the twin may be from llvmpipe, relative to the value. Zero, and so bit for bit, but where filtering
// weights are rounded differently or Mesa reorders sums of products.
float tolerance(const fs::path& shader) {
  const std::string name = shader.stem();
  return name == "implicit_lod" || name == "uv_tricks" || name == "golf" ? 1e-6F : 0.0F;
}

bool same_value(float a, float b, float relative) {
  if (a != a && b != b) return true;  // NaNs have many encodings that no shader can tell apart
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) ||
         std::abs(a - b) <= relative * std::abs(b);
}

void expect_same(const Image& twin, const Image& gl, float relative) {
  ASSERT_EQ(twin.rgba.size(), gl.rgba.size());
  int different = 0;
  for (int y = 0; y < gl.height; ++y) {
    for (int x = 0; x < gl.width; ++x) {
      for (int c = 0; c < 4; ++c) {
        if (same_value(twin.at(x, y)[c], gl.at(x, y)[c], relative) || ++different > 4) continue;
        ADD_FAILURE() << "pixel " << x << ", " << y << " channel " << c << ": twin " << twin.at(x, y)[c]
                      << ", llvmpipe " << gl.at(x, y)[c];
      }
    }
  }
  EXPECT_EQ(different, 0) << "of " << gl.rgba.size() << " values";
}

class Language : public testing::TestWithParam<fs::path> {};

void expect_same_frames(const Project& project, float relative) {
  const auto twin = twin::make_player(project);
  const auto gl =
      gl::make_player(gl::open_context("llvmpipe"), project, {.dispatch = gl::Dispatch::fragment});
  Schedule schedule;
  schedule.width = 17;
  schedule.height = 9;
  FixedClock clock(schedule, host_rules(project));
  for (int i = 0; i < 2; ++i) {
    const Frame frame = clock.next();
    twin->render(frame);
    gl->render(frame);
    const int last = static_cast<int>(project.passes.size()) - 1;
    expect_same(twin->read(last), gl->read(last), relative);
  }
}

TEST_P(Language, TwinAndLlvmpipeGiveTheSameBits) {
  expect_same_frames(load_project(GetParam()), tolerance(GetParam()));
}

// One pixel at a time is what check and debug run.
TEST(Packets, GiveTheBitsOfSinglePixels) {
  for (const char* name : {"divergence", "derivatives", "implicit_lod", "discards"}) {
    SCOPED_TRACE(name);
    const Project project =
        load_project(fs::path(SHADERTWIN_SOURCE_DIR) / "tests/emit/shaders" / (name + std::string(".glsl")));
    twin::TwinOptions single;
    single.packets = false;
    const auto one = twin::make_player(project, single);
    const auto packets = twin::make_player(project);
    Schedule schedule;
    schedule.width = 17;
    schedule.height = 9;
    const Frame frame = FixedClock(schedule, host_rules(project)).next();
    one->render(frame);
    packets->render(frame);
    const int last = static_cast<int>(project.passes.size()) - 1;
    expect_same(packets->read(last), one->read(last), 0.0F);
  }
}

std::string shader_name(const testing::TestParamInfo<fs::path>& info) {
  return info.param.stem().string();
}

INSTANTIATE_TEST_SUITE_P(, Language, testing::ValuesIn(shaders()), shader_name);

// Sums of products in user code are what Mesa reorders otherwise.
TEST(PreciseText, MakesMesaKeepTheOrderOfEveryOperation) {
  const fs::path shader = fs::path(SHADERTWIN_SOURCE_DIR) / "tests/emit/shaders/uv_tricks.glsl";
  expect_same_frames(load_project(shader, {.settings = {.precise = true}}), 0.0F);
}

// Mesa's compiler would take them from the C library, whose bits differ: with llvmpipe's own sin() ... each
// of the sums below is another one.
TEST(PreciseText, LetsTheDeviceComputeWhatItsCompilerKnows) {
  const ScratchFolder folder;
  const fs::path shader = folder.write("shader.glsl", R"(
const float table[3] = float[3](0.37, 0.61, 0.83);
vec4 steep(float x) { return vec4(tan(x), sinh(x), exp(x), pow(x + 1.0, x)); }
vec4 flat_(vec2 x) { return vec4(sin(x), log(x + 1.5)) + vec4(atan(x, x.yx + 0.3), acosh(x + 1.0)); }
void mainImage(out vec4 c, in vec2 p) {
  float a = 1.7, which = floor(p.y / 3.0);
  vec4 sum = vec4(exp(a), exp2(a * 0.7), log2(a), inversesqrt(a));
  for (int i = 0; i < 7; ++i) sum += vec4(cos(float(i) * 1.3), acos(0.1 * float(i)), tanh(float(i)), atan(float(i)));
  for (int i = 0; i < 3; ++i) sum += vec4(asin(table[i]), cosh(table[i]), asinh(table[i]), atanh(table[i]));
  c = (which == 0.0 ? sum : which == 1.0 ? steep(2.3) + steep(0.7) : flat_(vec2(0.3, a))) * p.x;
}
)");
  expect_same_frames(load_project(shader, {.settings = {.precise = true}}), 0.0F);
}

TEST(PreciseText, KeepsTheOrderOfWhatIsPassedToFunctions) {
  const ScratchFolder folder;
  const fs::path shader = folder.write("shader.glsl", R"(
float f(float x) { return x + 1.0; }
vec2 g(in vec2 x, const in float y) { return x * y; }
float sum(float a, float b) { return a * 10.0 + b; }
struct Ray { vec3 origin, direction; };
float along(Ray ray, float far[2]) { return dot(ray.origin, ray.direction) + far[0] * 3.0 + far[1]; }
void mainImage(out vec4 c, in vec2 p) {
  float t = 1.0 + p.x * 0.37 + p.y * 0.11;
  for (int i = 0; i < 9; ++i) {
    t += 0.37;
    c += vec4(f(-0.0001 * t * t * t), g(-0.3 * p * 0.7, t + 0.1 + 0.7), sum(f(t * 0.3 * 0.7), 0.1 + t + 0.2));
    c.x += along(Ray(vec3(t * -0.0001 * t * t), vec3(p * t * 0.7, 0.1)), float[2](-0.3 * t * 0.7, t * 0.3 * t * 0.9));
  }
}
)");
  expect_same_frames(load_project(shader, {.settings = {.precise = true}}), 0.0F);
}

// Whose steps Mesa rearranges elsewhere: one in some thousand has another last bit.
TEST(PreciseText, ComputesArcsInTheOrderOfTheirSteps) {
  const ScratchFolder folder;
  const fs::path shader = folder.write("shader.glsl", R"(
void mainImage(out vec4 c, in vec2 p) {
  uint bits = uint(p.x) + uint(p.y) * 4096u;
  for (int i = 0; i < 400; ++i) {
    bits = bits * 747796405u + 2891336453u;
    vec2 x = vec2(bits >> 16u, (bits ^ bits >> 7u) & 0xffffu) / 32768.0 - 1.0;
    c += vec4(atan(x), atan(x, x.yx));
  }
}
)");
  expect_same_frames(load_project(shader, {.settings = {.precise = true}}), 0.0F);
}

TEST(PreciseText, TakesEveryConstruct) {
  for (const char* name : {"special_calls", "structs", "side_effects", "ternary"}) {
    SCOPED_TRACE(name);
    const fs::path shader =
        fs::path(SHADERTWIN_SOURCE_DIR) / "tests/emit/shaders" / (name + std::string(".glsl"));
    expect_same_frames(load_project(shader, {.settings = {.precise = true}}), 0.0F);
  }
}

}  // namespace
}  // namespace shadertwin
