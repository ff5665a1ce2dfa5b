// The two halves of a shadow: the float has the float twin's bits, the double what the twin in double
// computes.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "host/player/fixed_clock.h"
#include "host/text/load.h"
#include "reference/twin/twin_device.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

class Recorder : public twin::ShadowObserver {
 public:
  bool wants_steps(int, int) override { return false; }
  void step(int, const twin::ShadowNumber*, int, const twin::ShadowNumber&, double) override {}
  Wanted begin(int, int) override { return {}; }
  void noted(int, std::uint32_t, std::span<const twin::PlaceName>, std::span<const twin::PlaceRecord> records,
             std::span<const twin::NumberRecord>) override {
    for (const twin::PlaceRecord& record : records) parted += record.parted;
  }
  void drawn(int, int, glm::ivec2, std::span<const twin::ShadowNumber> of_pass,
             std::span<const float>) override {
    numbers.assign(of_pass.begin(), of_pass.end());
  }

  std::size_t parted = 0;
  std::vector<twin::ShadowNumber> numbers;  // of what was drawn last
};

class Halves : public testing::Test {
 protected:
  // A shader in three frames, on a twin.
  std::unique_ptr<Player> play(const twin::TwinOptions& options) const {
    const Project project = load_project(folder / "shader.glsl");
    auto player = twin::make_player(project, options);
    Schedule schedule;
    schedule.width = 52;
    schedule.height = 16;
    FixedClock clock(schedule, host_rules(project));
    for (int i = 0; i < 3; ++i) player->render(clock.next());
    return player;
  }

  void expect_both(const std::string& text, double relative = 1e-15) {
    folder.write("shader.glsl", text);
    Recorder recorder;
    twin::TwinOptions with_shadows;
    with_shadows.shadows = &recorder;
    const Image shadows = play(with_shadows)->read(0);
    const Image floats = play({})->read(0);
    ASSERT_EQ(shadows.rgba.size(), floats.rgba.size());
    for (std::size_t i = 0; i < floats.rgba.size(); ++i) {
      if (std::isnan(floats.rgba[i]) && std::isnan(shadows.rgba[i])) continue;
      ASSERT_EQ(std::bit_cast<std::uint32_t>(shadows.rgba[i]), std::bit_cast<std::uint32_t>(floats.rgba[i]))
          << "number " << i << ": " << shadows.rgba[i] << " and " << floats.rgba[i] << '\n'
          << text;
    }
    // A picture holds floats, whatever it was computed in.
    EXPECT_EQ(recorder.parted, 0U) << text;
    twin::TwinOptions in_double;
    in_double.double_precision = true;
    const Image doubles = play(in_double)->read(0);
    for (std::size_t i = 0; i < doubles.rgba.size(); ++i) {
      if (std::isnan(doubles.rgba[i]) && std::isnan(recorder.numbers[i].exact)) continue;
      const double wanted = doubles.rgba[i];
      ASSERT_NEAR(static_cast<float>(recorder.numbers[i].exact), wanted,
                  (relative + 0x1p-23) * std::fabs(wanted))
          << "number " << i << '\n'
          << text;
    }
  }

  ScratchFolder folder;
};

const std::string main_begin = "void mainImage(out vec4 c, in vec2 p) {\n  vec2 u = p / iResolution.xy;\n";

TEST_F(Halves, AgreeWithBothTwinsInEveryBuiltin) {
  // One twin for all is compiled once: each column of pixels shows one of them.
  int count = 0;
  std::string choice = "int column = int(p.x) % 26;\n";
  for (const char* expression :
       {"vec4(sin(9.0 * u), cos(40.0 * u))",
        "vec4(tan(u), asin(u))",
        "vec4(acos(u), atan(7.0 * u))",
        "vec4(atan(u.x - 0.3, u.y), sinh(u.x), cosh(u.y), tanh(u.x))",
        "vec4(asinh(u), acosh(1.0 + u))",
        "vec4(atanh(u), exp(u))",
        "vec4(log(u), exp2(5.0 * u))",
        "vec4(log2(u), sqrt(u))",
        "vec4(inversesqrt(u), pow(u, vec2(2.7)))",
        "vec4(pow(u, vec2(2.0)), pow(u, vec2(4.0)))",
        "vec4(abs(u - 0.53), sign(u - 0.53))",
        "vec4(fract(7.3 * u), mod(u, 0.37))",
        "vec4(min(u, u.yx), max(u, u.yx))",
        "vec4(clamp(u, 0.2, 0.7), mix(u, u.yx, 0.3))",
        "vec4(mix(u, u.yx, u), step(0.53, u))",
        "vec4(smoothstep(0.1, 0.8, u), radians(u))",
        "vec4(length(u), distance(u, vec2(0.31)), dot(u, u.yx), degrees(u.x))",
        "vec4(cross(vec3(u, 1.0), vec3(0.3, u)), 1.0)",
        "vec4(normalize(vec3(u, 0.3)), 1.0)",
        "vec4(reflect(vec3(u, 1.0), normalize(vec3(u.yx, 2.0))), 1.0)",
        "vec4(refract(normalize(vec3(u, -1.0)), vec3(0.0, 0.0, 1.0), 0.7), 1.0)",
        "vec4(mat2(u, 0.3, 1.7) * u, u * mat2(0.2, u, 0.9))",
        "vec4(inverse(mat2(1.0 + u, -u)) * u, 0.0, 1.0)",
        "vec4(determinant(mat3(u, 1.0, 2.0, u, u, 3.0)), transpose(mat2(u, u.yx)) * u, 1.0)",
        "vec4(outerProduct(u, vec2(0.3, 0.7))[1], matrixCompMult(mat2(0.3), mat2(u, u))[0])",
        "vec4(unpackHalf2x16(packHalf2x16(0.5 * floor(8.0 * u + 0.3))), 0.0, 1.0)"})
    choice += "if (column == " + std::to_string(count++) + ") c = " + expression + ";\n";
  ASSERT_EQ(count, 26);
  expect_both(main_begin + choice + "}\n", 1e-6);
}

TEST_F(Halves, AgreeWithBothTwinsInTheWholeLanguage) {
  expect_both(R"(
struct Ray { vec3 o; vec3 d; float t[3]; };
const float SCALE = 1.7;
float total = 0.25;
void advance(inout Ray r, out float far, float by) {
  r.o += by * r.d;
  r.t[1] *= by;
  far = r.t[1] - r.o.x;
  total += far;
}
float pick(float x) {
  switch (int(4.0 * x + 0.01)) {
    case 0: return 0.3 * x;
    case 1: x -= 0.1;
    default: break;
  }
  return x * x;
}
)" + main_begin +
              R"(
  Ray ray = Ray(vec3(u, 0.1), normalize(vec3(u.yx, 1.0)), float[3](0.1, u.x, 0.3));
  float far;
  for (int i = 0; i < 5; ++i) {
    advance(ray, far, SCALE + float(i));
    if (far > 400.0) continue;
    ray.d.xz = ray.d.zx * 0.9;
    ray.t[i % 3] -= 0.01;
  }
  float k = 0.0;
  do { k++; ray.o[int(k) % 3] /= 3.1; } while (k < 4.0);
  ivec2 cell = ivec2(10.0 * u);
  c = vec4(ray.o.zy, pick(u.x), u.y > 0.53 ? total : -far);
  c.xy += vec2(cell) * 0.01;
  c *= mat4(0.5);
}
)");
}

TEST_F(Halves, AgreeWithBothTwinsInDerivativesAndTextures) {
  expect_both(R"(#iChannel0 "self"
#iChannel0::MinFilter "Linear"
#iChannel0::MagFilter "Linear"
)" + main_begin + R"(
  vec4 old = texture(iChannel0, u) + 0.5 * texelFetch(iChannel0, ivec2(p) / 2, 0) +
             0.3 * textureLod(iChannel0, u.yx, 0.0);
  float x = sin(5.0 * u.x) * u.y;
  c = 0.4 * old + vec4(dFdx(x), dFdy(x), fwidth(x), x);
}
)",
              1e-5);
}

TEST_F(Halves, LeaveADiscardedPixelAsItIs) {
  expect_both(main_begin + "  if (u.x > 0.53) discard;\n  c = vec4(u, 0.3, 1.0);\n}\n");
}

}  // namespace
}  // namespace shadertwin
