// `shadertwin render` and `devices` as a user types them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "host/image/image.h"
#include "tests/app/command_line.h"

namespace shadertwin {
namespace {

class Render : public testing::Test {
 protected:
  void SetUp() override {
    folder.write("wave.glsl", R"(
#iChannel0 "self"
void mainImage(out vec4 c, in vec2 p) {
  vec4 old = texelFetch(iChannel0, ivec2(p), 0);
  c = iFrame == 0 ? vec4(p / iResolution.xy, 0, 1) : old * 0.9 + vec4(fract(iTime * 1.7), .01, float(iFrame) * .1, .1);
}
)");
  }
  ScratchFolder folder;
};

TEST_F(Render, SameCommandGivesTheSameBits) {
  ASSERT_EQ(run(folder, "render wave.glsl --size 64x36 --frames 9 -o a.exr").err, "");
  ASSERT_EQ(run(folder, "render wave.glsl --size 64x36 --frames 9 -o b.exr").err, "");
  EXPECT_EQ(read_image(folder / "a.exr").rgba, read_image(folder / "b.exr").rgba);
}

TEST_F(Render, EglAndOsmesaAgree) {
  SHADERTWIN_NEEDS_OSMESA();
  ASSERT_EQ(run(folder, "render wave.glsl --on llvmpipe --size 64x36 --frames 5 -o a.exr").err, "");
  ASSERT_EQ(run(folder, "render wave.glsl --on osmesa --size 64x36 --frames 5 -o b.exr").err, "");
  EXPECT_EQ(read_image(folder / "a.exr").rgba, read_image(folder / "b.exr").rgba);
}

TEST_F(Render, TileDrawsOnlyItsPixelsOnTheTwin) {
  folder.write("plain.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(p, 1, 1); }");
  ASSERT_EQ(run(folder, "render plain.glsl --on cpu --tile 3,2,4,5 --size 16x9 -o a.exr").err, "");
  const Image image = read_image(folder / "a.exr");
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 16; ++x) {
      const bool inside = x >= 3 && x < 7 && y >= 2 && y < 7;
      EXPECT_EQ(image.at(x, y)[0], inside ? static_cast<float>(x) + 0.5F : 0.0F) << x << ", " << y;
    }
}

TEST_F(Render, DefinesWhatTheShaderLeavesUndefinedUnlessAskedNotTo) {
  folder.write(
      "undefined.glsl",
      "float list[3] = float[](1., 2., 3.);\nfloat none(float x) { if (x > 99.) return 1.; }\n"
      "void mainImage(out vec4 c, in vec2 p) { float x; c.xy = vec2(x + list[iFrame + 7], none(p.x)); }");
  for (const std::string& on : with_osmesa({"llvmpipe/fragment", "llvmpipe/compute", "cpu"})) {
    ASSERT_EQ(run(folder, "render undefined.glsl --size 4x4 -o a.exr --quiet --on " + on).err, "");
    const Image image = read_image(folder / "a.exr");
    EXPECT_EQ(std::vector<float>(image.at(2, 1), image.at(2, 1) + 4), (std::vector<float>{3, 0, 0, 0})) << on;
  }
  // Mesa takes the only value that the function returns for all that it could return.
  ASSERT_EQ(run(folder, "render undefined.glsl --size 4x4 -o a.exr --init raw").status, 0);
  EXPECT_EQ(read_image(folder / "a.exr").at(2, 1)[1], 1.0F);
  EXPECT_EQ(run(folder, "render undefined.glsl --size 4x4 -o a.exr --init ones").status, 2);
}

TEST_F(Render, HasTheExtensionsQuirksWhenAsked) {
  folder.write("quirks.glsl",
               "void mainImage(out vec4 c, in vec2 p) { c = vec4(iMouse.w, iTimeDelta, texture(iChannel3, "
               "p).a, 1); }");
  for (const std::string on : {"llvmpipe", "cpu"}) {
    ASSERT_EQ(run(folder, "render quirks.glsl --size 2x2 --vscode-quirks -o a.exr --quiet --on " + on).err,
              "");
    const Image image = read_image(folder / "a.exr");
    EXPECT_EQ(std::vector<float>(image.at(0, 0), image.at(0, 0) + 4), (std::vector<float>{-1, 0, 0, 1}))
        << on;
  }
}

TEST_F(Render, TimeoutEndsAnEndlessLoopOnTheTwin) {
  folder.write("endless.glsl",
               "void mainImage(out vec4 c, in vec2 p) {\n"
               "  float x = 0.;\n  while (x < 1.) x *= .5;\n  c = vec4(x);\n}\n");
  const Outcome outcome = run(folder, "render endless.glsl --on cpu --timeout 0.5 --size 4x4 -o a.exr");
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "a.exr"));
}

TEST_F(Render, SequenceNumbersEveryFrameAndEndsLikeTheSinglePicture) {
  ASSERT_EQ(run(folder, "render wave.glsl --size 16x9 --frames 3 -o frame_%03d.exr").err, "");
  ASSERT_EQ(run(folder, "render wave.glsl --size 16x9 --frames 3 -o last.exr").err, "");
  for (const char* name : {"frame_000.exr", "frame_001.exr", "frame_002.exr"})
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  EXPECT_FALSE(std::filesystem::exists(folder / "frame_003.exr"));
  EXPECT_EQ(read_image(folder / "frame_002.exr").rgba, read_image(folder / "last.exr").rgba);
  EXPECT_NE(read_image(folder / "frame_001.exr").rgba, read_image(folder / "last.exr").rgba);
}

TEST_F(Render, TimeShiftsTheClockAndNothingElse) {
  folder.write("clock.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(iTime, iFrame, 0, 1); }");
  ASSERT_EQ(run(folder, "render clock.glsl --size 2x2 --fps 64 --frames 64 -o whole.exr").err, "");
  ASSERT_EQ(run(folder, "render clock.glsl --size 2x2 --fps 64 --frames 32 --time 0.5 -o half.exr").err, "");
  const Image whole = read_image(folder / "whole.exr");
  const Image half = read_image(folder / "half.exr");
  EXPECT_EQ(whole.rgba[0], 63.0F / 64.0F);
  EXPECT_EQ(half.rgba[0], whole.rgba[0]);
  EXPECT_EQ(whole.rgba[1], 63.0F);
  EXPECT_EQ(half.rgba[1], 31.0F);
}

TEST_F(Render, PngIsWhatACanvasShows) {
  folder.write("hdr.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(2., -1., 128./255., 1.); }");
  ASSERT_EQ(run(folder, "render hdr.glsl --size 3x2 -o a.png").err, "");
  const Image image = read_image(folder / "a.png");
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.rgba[0], 1.0F);
  EXPECT_EQ(image.rgba[1], 0.0F);
  EXPECT_FLOAT_EQ(image.rgba[2], 128.0F / 255.0F);
}

TEST_F(Render, PassShowsABuffer) {
  folder.write("tabs/buffer_a.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(-7.5, 0, 0, .25); }");
  folder.write(
      "tabs/image.glsl",
      "#iChannel0 \"buffer_a.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p); }");
  for (const char* name : {"'Buffer A'", "buffera", "buffer_a"}) {
    ASSERT_EQ(run(folder, std::string("render tabs --size 2x2 -o a.exr --pass ") + name).err, "");
    EXPECT_EQ(read_image(folder / "a.exr").rgba[0], -7.5F);
    EXPECT_EQ(read_image(folder / "a.exr").rgba[3], 0.25F);
  }
  const Outcome wrong = run(folder, "render tabs --size 2x2 -o b.exr --pass nonsense");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("Buffer A, Image"), std::string::npos) << wrong.err;
}

TEST_F(Render, JsonTakesItsPicturesFromTheMediaFolder) {
  Image picture(1, 1);
  picture.rgba = {0.25F, 0.5F, 0.75F, 1.0F};
  folder.write("media/a/.keep", "");
  write_image(picture, folder / "media/a/p.exr");
  folder.write("p.json", R"({"Shader": {"ver": "0.1", "info": {"id": "x", "name": "n"}, "renderpass": [
    {"inputs": [{"id": 1, "src": "/a/p.exr", "ctype": "texture", "channel": 0, "published": 1,
                 "sampler": {"filter": "nearest", "wrap": "clamp", "vflip": "true"}}],
     "outputs": [{"id": 37, "channel": 0}], "name": "Image", "type": "image",
     "code": "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(0), 0); }"}]}})");
  const Outcome outcome = run(folder, "render p.json --media media --size 2x2 -o a.exr");
  ASSERT_EQ(outcome.err, "");
  EXPECT_EQ(read_image(folder / "a.exr").rgba[1], 0.5F);
}

TEST_F(Render, DialectDecidesWhoseAlphaHolds) {
  folder.write("half.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(.5); }");
  ASSERT_EQ(run(folder, "render half.glsl --size 2x2 -o a.exr").err, "");
  EXPECT_EQ(read_image(folder / "a.exr").rgba[3], 0.5F);
  ASSERT_EQ(run(folder, "render half.glsl --dialect shadertoy --size 2x2 -o b.exr").err, "");
  EXPECT_EQ(read_image(folder / "b.exr").rgba[3], 1.0F);
  EXPECT_EQ(run(folder, "render half.glsl --dialect glsl --size 2x2 -o c.exr").status, 2);
}

TEST_F(Render, LaterOptionsWin) {
  ASSERT_EQ(
      run(folder, "render wave.glsl --size 64x36 --frames 9 -o a.png --size 8x4 --frames 2 -o b.png").err,
      "");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
  EXPECT_EQ(read_image(folder / "b.png").width, 8);
}

TEST_F(Render, ReportsTheFirstFrameAndTheOthersApart) {
  folder.write("a.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(1); }");
  ASSERT_EQ(run(folder, "render a.glsl --size 4x3 --frames 5 -o a.exr --json r.json").err, "");
  const auto report = nlohmann::json::parse(contents(folder / "r.json"));
  const double first = report["first_frame_milliseconds"];
  const double other = report["milliseconds_per_frame"];
  EXPECT_GT(first, 0.0);
  EXPECT_GT(other, 0.0);
  EXPECT_NEAR(first + 4.0 * other, 1000.0 * report["seconds"].get<double>(), 1e-6);
}

TEST_F(Render, ReportCountsWhatIsNotANumber) {
  folder.write("nan.glsl",
               "void mainImage(out vec4 c, in vec2 p) {\n"
               "  float z = iTime * 0.;\n"
               "  c = vec4(p.x < 1. ? z / z : 1., p.y < 1. ? 1. / z : 0., -1, 1);\n}\n");
  ASSERT_EQ(run(folder, "render nan.glsl --size 4x3 -o a.exr --json r.json").err, "");
  const auto report = nlohmann::json::parse(contents(folder / "r.json"));
  EXPECT_EQ(report["frames"], 1);
  EXPECT_EQ(report["passes"][0]["nan"], 3);
  EXPECT_EQ(report["passes"][0]["inf"], 4);
  EXPECT_EQ(report["passes"][0]["negative"], 12);
}

TEST_F(Render, MouseKeysAndDefinesReachTheShader) {
  folder.write("all.glsl",
               "#iKeyboard\nvoid mainImage(out vec4 c, in vec2 p) {\n"
               "  c = p.x < 1. ? iMouse : vec4(KNOB, isKeyDown(Key_A), SEED, float(ON));\n}\n");
  ASSERT_EQ(
      run(folder,
          "render all.glsl --size 8x8 --frames 2 -o a.exr --mouse 3,4,down --keys space,a -D KNOB=2.5 -D ON "
          "--seed 9")
          .err,
      "");
  const Image image = read_image(folder / "a.exr");
  EXPECT_EQ(std::vector<float>(image.at(0, 0), image.at(0, 0) + 4), (std::vector<float>{3, 4, 3, -4}));
  EXPECT_EQ(std::vector<float>(image.at(1, 0), image.at(1, 0) + 4), (std::vector<float>{2.5F, 1, 9, 1}));
}

TEST_F(Render, NothingIsPrintedOnAPipe) {
  const Outcome outcome = run(folder, "render wave.glsl --size 64x36 --frames 20 -o a.png");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "");
}

TEST_F(Render, KeepsTheTwinsCppWhereAskedTo) {
  ASSERT_EQ(run(folder, "render wave.glsl --on cpu --size 8x8 -o a.exr", "SHADERTWIN_KEEP_CPP=kept").err, "");
  std::vector<std::filesystem::path> texts;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "kept"))
    if (entry.path().extension() == ".cpp") texts.push_back(entry.path());
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_NE(contents(texts[0]).find("wave.glsl\""), std::string::npos) << contents(texts[0]);
  EXPECT_TRUE(std::filesystem::exists(texts[0].replace_extension(".so")));
}

TEST(Devices, ListsVendorRendererAndVersionUnderTheNamesOfOn) {
  const ScratchFolder folder;
  const Outcome outcome = run(folder, "devices");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(outcome.out.starts_with("egl:0 ")) << outcome.out;
  EXPECT_EQ(outcome.out.find("\nosmesa ") != std::string::npos, has_osmesa()) << outcome.out;
  EXPECT_NE(outcome.out.find("llvmpipe"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace shadertwin
