// Videos and the webcam on channels.
#include "host/media/video_writer.h"
#include "host/text/load.h"
#include "tests/gl/play.h"
#include "tests/skip.h"

namespace shadertwin {
namespace {

using Video = OnEveryDevice;

constexpr int video_frames = 6;

// Frame i of the video has i / 5 in red below and in green above.
void write_video(const std::filesystem::path& file) {
  const auto writer = media::VideoWriter::create(file, {.width = 16, .height = 32, .fps = 10.0, .crf = 0});
  for (int i = 0; i < video_frames; ++i) {
    Image picture(16, 32);
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 16; ++x) picture.at(x, y)[y < 16 ? 0 : 1] = static_cast<float>(i) / 5.0F;
    writer->add(picture);
  }
  writer->finish();
}

Project video_shader(const ScratchFolder& folder, const std::string& type, const std::string& file,
                     const std::string& vflip) {
  return load_project(
      folder.write("toy.json", R"({"Shader": {"renderpass": [{"type": "image", "name": "Image",
    "outputs": [{"id": 37, "channel": 0}],
    "inputs": [{"id": 1, "channel": 2, "ctype": ")" +
                                   type + R"(", "src": "/media/a/)" + file + R"(",
                "sampler": {"filter": "linear", "wrap": "clamp", "vflip": ")" +
                                   vflip + R"("}}],
    "code": "void mainImage(out vec4 c, vec2 p) { c = p.x < 1. ? texture(iChannel2, p / iResolution.xy) : vec4(iChannelTime[2], iChannelResolution[2].xy, 1); }"}]}})"));
}

TEST_P(Video, IsRepeatedByITime) {
  write_video(folder / "a.webm");
  const Project project = video_shader(folder, "video", "a.webm", "true");
  Schedule schedule = small(2, 2);
  schedule.fps = 10.0;
  const std::vector<Image> images = frames(project, 2 * video_frames, schedule);
  for (int i = 0; i < 2 * video_frames; ++i) {
    const Image& image = images[static_cast<std::size_t>(i)];
    const float shown = static_cast<float>(i % video_frames) / 5.0F;
    EXPECT_NEAR(pixel(image, 0, 0).x, shown, 0.02F) << i;
    EXPECT_NEAR(pixel(image, 0, 0).y, 0.0F, 0.02F) << i;
    EXPECT_NEAR(pixel(image, 0, 1).y, shown, 0.02F) << i;
    EXPECT_NEAR(pixel(image, 1, 0).x, static_cast<float>(i % video_frames) / 10.0F, 1e-5F) << i;
    EXPECT_EQ(pixel(image, 1, 0).y, 16.0F);
    EXPECT_EQ(pixel(image, 1, 0).z, 32.0F);
  }
}

TEST_P(Video, StandsOnItsHeadWithoutVflip) {
  write_video(folder / "a.webm");
  Schedule schedule = small(2, 2);
  schedule.t0 = 0.5;
  const Image image = frames(video_shader(folder, "video", "a.webm", "false"), 1, schedule)[0];
  EXPECT_NEAR(pixel(image, 0, 0).y, 1.0F, 0.02F);
  EXPECT_NEAR(pixel(image, 0, 1).x, 1.0F, 0.02F);
}

TEST_P(Video, IsBlackWithOneWarningWhereTheFileIsMissing) {
  const Project project = video_shader(folder, "video", "none.webm", "true");
  EXPECT_EQ(project.warnings.size(), 1U);
  const Image image = frames(project, 1, small(2, 2))[0];
  EXPECT_EQ(pixel(image, 0, 0), glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(pixel(image, 1, 0), glm::vec4(0, 0, 0, 1));
}

TEST_P(Video, WithoutACameraTheWebcamIsBlackWithOneWarning) {
  if (std::filesystem::exists("/dev/video0")) SHADERTWIN_SKIP("no-camera", "there is a camera");
  const Project project = video_shader(folder, "webcam", "", "true");
  EXPECT_TRUE(project.warnings.empty());
  const auto player = play(project);
  ASSERT_EQ(player->warnings().size(), 1U);
  FixedClock clock(small(2, 2), host_rules(project));
  player->render(clock.next());
  EXPECT_EQ(pixel(player->read(0), 0, 0), glm::vec4(0, 0, 0, 1));
}

SHADERTWIN_ON_EVERY_DEVICE(Video);

}  // namespace
}  // namespace shadertwin
