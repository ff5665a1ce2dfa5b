// What one host has and the other has not, as a user types it: first person controls, vertex shaders, mainVR.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>

#include "host/image/image.h"
#include "tests/app/command_line.h"

namespace shadertwin {
namespace {

glm::vec4 pixel(const Image& image, int x, int y) {
  const float* p = image.at(x, y);
  return {p[0], p[1], p[2], p[3]};
}

TEST(FirstPerson, KeysAndADragFlyTheSameWayEveryTime) {
  const ScratchFolder folder;
  folder.write("fly.glsl",
               "#iFirstPersonControls\nvoid mainImage(out vec4 c, in vec2 p) {\n"
               "  c = p.x < 1. ? iViewMatrix[3] : iViewMatrix[2];\n}\n");
  const std::string command =
      "render fly.glsl --size 2x2 --frames 11 --keys w --mouse 1,1,down@5 --mouse 2,1,down@6 -o ";
  ASSERT_EQ(run(folder, command + "a.exr").err, "");
  ASSERT_EQ(run(folder, command + "b.exr --on cpu").err, "");
  const Image image = read_image(folder / "a.exr");
  EXPECT_EQ(image.rgba, read_image(folder / "b.exr").rgba);
  EXPECT_NEAR(pixel(image, 0, 0).z, 1.1F, 0.01F)
      << "eleven steps of a tenth along z, turning from the seventh on";
  EXPECT_GT(pixel(image, 0, 0).x, 0.02F);
  EXPECT_NEAR(pixel(image, 1, 0).x, std::sin(5 * 0.02618F), 1e-4F);
}

TEST(OtherHosts, AreToldOfAndWarnedOf) {
  const ScratchFolder folder;
  folder.write("s.frag",
               "uniform float time;\nuniform float speed;\nuniform vec2 mouse;\n"
               "void main() { gl_FragColor = vec4(time, mouse, 1.0 + speed); }\n");
  const std::string script = " s.frag --size 8x4 --time 1.5 --mouse 2,1,down --frames 2";
  const Outcome outcome = run(folder, "render" + script + " -o a.exr");
  EXPECT_EQ(outcome.err, "s.frag:2: warning: nothing sets the uniform 'speed'\n");
  const glm::vec4 drawn = pixel(read_image(folder / "a.exr"), 3, 2);
  EXPECT_EQ(drawn.y, 0.25F);
  EXPECT_EQ(drawn.z, 0.25F);
  EXPECT_EQ(run(folder, "render" + script + " -o a.exr --quiet").err, "");
  const Outcome compared = run(folder, "compare" + script + " --on llvmpipe --on cpu --max-ulp 0");
  EXPECT_EQ(compared.status, 0) << compared.out << compared.err;
  EXPECT_EQ(compared.error_lines(), 1) << compared.err;
  EXPECT_EQ(run(folder, "export s.frag --to html -o s.html").err, outcome.err);
}

TEST(VertexShader, TwinSaysInOneLineThatItCanNot) {
  const ScratchFolder folder;
  folder.write("v.glsl", "void main() { gl_Position = vec4(0, 0, 0, 1); }\n");
  folder.write("x.glsl", "#iVertex \"v.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(1); }\n");
  const Outcome outcome = run(folder, "render x.glsl --size 2x2 --on cpu -o a.exr");
  EXPECT_EQ(outcome.status, 5);
  EXPECT_EQ(outcome.err, "shadertwin: x: error: the twin draws no triangles of a vertex shader (#iVertex)\n");
  const Outcome tabs = run(folder, "export x.glsl --to tabs -o tabs");
  EXPECT_EQ(tabs.status, 3);
  EXPECT_EQ(tabs.err, "x: error: shadertoy.com has no vertex shaders (#iVertex)\n");
}

TEST(CubemapPass, KeepsHalfFloatsTheSameOnOpenGlAndTheTwin) {
  const ScratchFolder folder;
  folder.write("tabs/cubemap_a.glsl",
               "void mainCubemap(out vec4 c, in vec2 p, in vec3 o, in vec3 d) { c = vec4(1. / 3., 65519., "
               "1e-9, d.x); }\n");
  folder.write(
      "tabs/image.glsl",
      "#iChannel0 \"cubemap_a.glsl\"\n#iChannel0::MinFilter \"Nearest\"\n#iChannel0::MagFilter \"Nearest\"\n"
      "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, vec3(1, p.x / 9., 0)); }\n");
  const Outcome outcome =
      run(folder, "compare tabs --on llvmpipe --on cpu --size 4x2 --max-ulp 0 --min-equal 100");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  ASSERT_EQ(run(folder, "render tabs --size 1x1 -o a.exr").err, "");
  const glm::vec4 kept = pixel(read_image(folder / "a.exr"), 0, 0);
  EXPECT_EQ(kept, glm::vec4(0.333251953125F, 65504.0F, 0.0F, 1.0F));
}

TEST(CubemapPass, KeepsHalfFloatsInItsMipmapsToo) {
  const ScratchFolder folder;
  folder.write("tabs/cubemap_a.glsl",
               "void mainCubemap(out vec4 c, in vec2 p, in vec3 o, in vec3 d) { c = vec4(sin(d * 9.0), 1e-6 "
               "* p.x); }\n");
  folder.write(
      "tabs/image.glsl",
      "#iChannel0 \"cubemap_a.glsl\"\n#iChannel0::MinFilter \"LinearMipMapLinear\"\n"
      "void mainImage(out vec4 c, in vec2 p) { c = textureLod(iChannel0, vec3(p - 4., 3.), p.x); }\n");
  const Outcome outcome =
      run(folder, "compare tabs --on llvmpipe --on cpu --size 9x5 --precise --min-equal 100");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

TEST(VertexShader, CheckReadsTheTextAndSaysThatItDoesNotRun) {
  const ScratchFolder folder;
  folder.write("v.glsl", "varying vec2 at;\nvoid main() { at = vec2(0); gl_Position = vec4(0, 0, 0, 1); }\n");
  folder.write("x.glsl",
               "#iVertex \"v.glsl\"\nvarying vec2 at;\n"
               "void mainImage(out vec4 c, in vec2 p) { c = vec4(at, saturate(1.), 1); }\n");
  const Outcome outcome = run(folder, "check x.glsl");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.out.find("x.glsl:3: portability: "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("x.glsl: warning: only read, not run"), std::string::npos) << outcome.err;
}

class Vr : public testing::Test {
 protected:
  void SetUp() override {
    folder.write("vr.glsl",
                 "void mainImage(out vec4 c, in vec2 p) { c = vec4(9); }\n"
                 "void mainVR(out vec4 c, in vec2 p, in vec3 o, in vec3 d) {\n"
                 "  c = p.y < 1. ? vec4(p, o.x, iResolution.x) : vec4(d, 1);\n}\n");
  }
  ScratchFolder folder;
};

TEST_F(Vr, EyesStandSideBySideEachWithItsOwnPixelsAndPlace) {
  ASSERT_EQ(run(folder, "render vr.glsl --vr --size 8x4 -o a.exr").err, "");
  const Image image = read_image(folder / "a.exr");
  for (int x = 0; x < 8; ++x)
    EXPECT_EQ(pixel(image, x, 0),
              glm::vec4(static_cast<float>(x % 4) + 0.5F, 0.5F, x < 4 ? -0.032F : 0.032F, 8));
  // Rays of a square view 90 degrees high, the same in both eyes.
  const glm::vec3 corner = glm::normalize(glm::vec3(0.75F, 0.75F, -1.0F));
  for (const int x : {3, 7})
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(pixel(image, x, 3)[i], corner[i], 1e-6F);
  ASSERT_EQ(run(folder, "render vr.glsl --size 8x4 -o flat.exr").err, "");
  EXPECT_EQ(pixel(read_image(folder / "flat.exr"), 0, 0), glm::vec4(9));
}

TEST_F(Vr, TwinDrawsTheSameBits) {
  const Outcome outcome =
      run(folder, "compare vr.glsl --vr --on llvmpipe --on cpu --size 8x4 --max-ulp 0 --min-equal 100");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

TEST_F(Vr, ShaderWithoutMainVrIsOneLine) {
  folder.write("flat.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(0); }\n");
  const Outcome outcome = run(folder, "render flat.glsl --vr --size 2x2 -o a.exr");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_EQ(outcome.err, "flat.glsl:1: error: there is no mainVR(out vec4, in vec2, in vec3, in vec3)\n");
}

}  // namespace
}  // namespace shadertwin
