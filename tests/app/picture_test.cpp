// The path tracer's scenes against small committed pictures, judged by several numbers, as OpenImageIO's own
// tests are: a few pixels may differ (another CPU draws other random branches), none may differ grossly, and
// the mean must hold.
//
// After a change that is meant to show: tools/update_pictures, and look at the new files.
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include "tests/app/command_line.h"

namespace shadertwin {
namespace {

constexpr float fail_threshold = 0.04F;  // a pixel that differs by more counts as failed ...
constexpr double fail_percent = 1.0;     // ... and so many of them may
constexpr double hard_fail = 0.5;        // no pixel may differ by more
constexpr double mean_error = 0.004;

class Pictures : public testing::TestWithParam<int> {};

TEST_P(Pictures, SceneLooksAsCommitted) {
  const ScratchFolder folder;
  const std::string name = "scene_" + std::to_string(GetParam()) + ".png";
  const Outcome outcome =
      run(folder, "render '" SHADERTWIN_SOURCE_DIR "/shadertoy/image.glsl' -D SCENE=" +
                      std::to_string(GetParam()) + " --size 160x90 --frames 16 -o " + name);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const OIIO::ImageBuf rendered((folder / name).string());
  const OIIO::ImageBuf committed(SHADERTWIN_SOURCE_DIR "/tests/app/pictures/" + name);
  ASSERT_TRUE(committed.initialized()) << "there is no tests/app/pictures/" << name;
  ASSERT_EQ(rendered.spec().width, committed.spec().width);
  ASSERT_EQ(rendered.spec().height, committed.spec().height);
  const auto difference = OIIO::ImageBufAlgo::compare(rendered, committed, fail_threshold, fail_threshold);
  const double failed =
      100.0 * static_cast<double>(difference.nfail) / static_cast<double>(rendered.spec().image_pixels());
  EXPECT_LE(failed, fail_percent) << "percent of pixels differ by more than " << fail_threshold;
  EXPECT_LE(difference.maxerror, hard_fail) << "at (" << difference.maxx << ", " << difference.maxy << ")";
  EXPECT_LE(difference.meanerror, mean_error);
}

INSTANTIATE_TEST_SUITE_P(Scene, Pictures, testing::Range(0, 5), testing::PrintToStringParamName());

}  // namespace
}  // namespace shadertwin
