// `shadertwin debug` as a user types it, with gdb in batch mode.
#include <gtest/gtest.h>

#include "tests/app/command_line.h"

namespace shadertwin {
namespace {

TEST(Debug, StopsInTheGlslOfOnePixelAndPrintsItsStructs) {
  const ScratchFolder folder;
  const Outcome outcome =
      run(folder, "debug '" SHADERTWIN_SOURCE_DIR
                  "/shadertoy/image.glsl' --pass P3D_RT --pixel 40,5 --size 64x36 "
                  "--command 'info source' --command 'tbreak hit_sphere' --command continue --command finish "
                  "--command 'up' --command 'print rec' --command 'info args'");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("P3D_RT.glsl:"), std::string::npos) << outcome.out;  // the first stop
  EXPECT_NE(outcome.out.find("common.glsl:"), std::string::npos) << outcome.out;  // hit_sphere
  EXPECT_NE(outcome.out.find("normal = ("), std::string::npos) << outcome.out;    // a HitRecord's member
}

TEST(Debug, StopsAtTheFrameAndPixelThatWereAskedFor) {
  const ScratchFolder folder;
  folder.write("a.glsl",
               "#iChannel0 \"self\"\nvoid mainImage(out vec4 c, in vec2 p) {\n"
               "  float sum = texelFetch(iChannel0, ivec2(p), 0).x;\n"
               "  c = vec4(sum + 1.0);\n}\n");
  const Outcome outcome =
      run(folder,
          "debug a.glsl --pixel 3,2 --size 8x8 --frames 4 --command next --command next --command "
          "'print sum' --command 'print p' "
          "--command continue");
  EXPECT_NE(outcome.out.find("a.glsl:2"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("$1 = 3\n"), std::string::npos) << outcome.out;  // three frames were added up
  EXPECT_NE(outcome.out.find("$2 = (3.5, 2.5)\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("pixel 3,2 of a in frame 3: 4 4 4 4\n"), std::string::npos) << outcome.out;
}

TEST(Debug, RefusesAPixelOutsideAndAMissingDebugger) {
  const ScratchFolder folder;
  folder.write("a.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(1); }\n");
  EXPECT_EQ(run(folder, "debug a.glsl --pixel 8,0 --size 8x8").status, 2);
  EXPECT_EQ(run(folder, "debug a.glsl --pixel -1,0 --size 8x8").status, 2);
  EXPECT_EQ(run(folder, "debug a.glsl").status, 2);
  EXPECT_EQ(run(folder, "debug gone.glsl --pixel 0,0").status, 4);
  const Outcome without = run(folder, "debug a.glsl --pixel 0,0", "PATH=/nowhere");
  EXPECT_EQ(without.status, 5) << without.err;
  EXPECT_NE(without.err.find("gdb"), std::string::npos) << without.err;
}

}  // namespace
}  // namespace shadertwin
