// Textures, cubemaps, the keyboard, and every sampler setting.
#include "host/text/load.h"
#include "tests/gl/play.h"

namespace shadertwin {
namespace {

using Inputs = OnEveryDevice;

Image solid(float r, float g, float b, int size = 2) {
  Image image(size, size);
  for (int i = 0; i < size * size; ++i) {
    float* p = &image.rgba[static_cast<std::size_t>(i) * 4];
    p[0] = r;
    p[1] = g;
    p[2] = b;
    p[3] = 1.0F;
  }
  return image;
}

// Two texels beside one another, 0 and 1; red only.
Image step_picture() {
  Image image = solid(0, 0, 0);
  for (int y = 0; y < 2; ++y) image.at(1, y)[0] = 1.0F;
  return image;
}

struct SamplerCase {
  const char* settings;
  const char* lookup;
  float expected;  // red
};

TEST_P(Inputs, SamplersDoWhatTheirSettingsSay) {
  write_image(step_picture(), folder / "step.exr");
  const std::vector<SamplerCase> cases = {
      {"#iChannel0::MagFilter \"Nearest\"\n#iChannel0::MinFilter \"Nearest\"\n", "vec2(.49, .5)", 0.0F},
      {"#iChannel0::MagFilter \"Nearest\"\n#iChannel0::MinFilter \"Nearest\"\n", "vec2(.51, .5)", 1.0F},
      {"#iChannel0::MagFilter \"Linear\"\n", "vec2(.5, .5)", 0.5F},
      {"", "vec2(.5, .5)", 0.5F},
      {"#iChannel0::WrapMode \"Repeat\"\n", "vec2(1.25, .5)", 0.0F},
      {"#iChannel0::WrapMode \"Clamp\"\n", "vec2(1.25, .5)", 1.0F},
      {"#iChannel0::WrapMode \"Mirror\"\n", "vec2(1.25, .5)", 1.0F},
      {"#iChannel0::WrapMode \"Mirror\"\n", "vec2(1.75, .5)", 0.0F},
      {"#iChannel0::WrapMode \"Repeat\"\n", "vec2(-.25, .5)", 1.0F},
      {"#iChannel0::WrapMode \"Clamp\"\n", "vec2(-.25, .5)", 0.0F},
      {"", "vec2(1., .5)", 0.5F},  // Repeat is the default: the seam is half of each
  };
  for (const SamplerCase& c : cases) {
    const auto shader = folder.write(
        "sampler.glsl", std::string("#iChannel0 \"step.exr\"\n") + c.settings +
                            "void mainImage(out vec4 c, in vec2 p) { c = textureLod(iChannel0, " + c.lookup +
                            ", 0.); }\n");
    EXPECT_EQ(pixel(frames(load_project(shader), 1, small())[0]).x, c.expected) << c.settings << c.lookup;
  }
}

TEST_P(Inputs, MipFiltersPickTheirLevels) {
  write_image(step_picture(), folder / "step.exr");
  for (const auto& [filter, lod, expected] : std::vector<std::tuple<std::string, std::string, float>>{
           {"NearestMipMapNearest", "0.", 1.0F},  // the right texel
           {"NearestMipMapNearest", "1.", 0.5F},  // the mean
           {"NearestMipMapLinear", ".5", 0.75F},
           {"LinearMipMapNearest", "1.", 0.5F},
           {"LinearMipMapLinear", ".5", 0.75F}}) {
    const auto shader = folder.write(
        "mip.glsl", "#iChannel0 \"step.exr\"\n#iChannel0::MinFilter \"" + filter +
                        "\"\n#iChannel0::MagFilter \"Nearest\"\n"
                        "void mainImage(out vec4 c, in vec2 p) { c = textureLod(iChannel0, vec2(.75, .75), " +
                        lod + "); }\n");
    EXPECT_NEAR(pixel(frames(load_project(shader), 1, small())[0]).x, expected, 1.0F / 256)
        << filter << ' ' << lod;
  }
}

TEST_P(Inputs, TwoChannelsOnOneBufferKeepTheirOwnFilters) {
  folder.write("a.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(floor(p.x)); }");
  const auto shader = folder.write("main.glsl", R"(
#iChannel0 "a.glsl"
#iChannel0::MagFilter "Nearest"
#iChannel0::MinFilter "Nearest"
#iChannel1 "a.glsl"
#iChannel1::MagFilter "Linear"
void mainImage(out vec4 c, in vec2 p) {
  vec2 uv = vec2(.5, .5);
  c = vec4(textureLod(iChannel0, uv - .01, 0.).x, textureLod(iChannel1, uv, 0.).x, 0, 1);
}
)");
  EXPECT_EQ(pixel(frames(load_project(shader), 1, small(4, 4))[0]), glm::vec4(1, 1.5F, 0, 1));
}

TEST_P(Inputs, PicturesStandUpright) {
  Image image = solid(0, 0, 0);
  image.at(0, 0)[0] = 1.0F;  // lower left red
  image.at(1, 0)[1] = 1.0F;  // lower right green
  image.at(0, 1)[2] = 1.0F;  // upper left blue
  write_image(image, folder / "corners.png");
  const auto shader = folder.write("main.glsl", R"(
#iChannel0 "corners.png"
void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }
)");
  const Image seen = frames(load_project(shader), 1, small(2, 2))[0];
  EXPECT_EQ(seen.rgba, image.rgba);
}

TEST_P(Inputs, EightBitTexelsAreNotDecodedFromSrgb) {
  write_image(solid(128.0F / 255.0F, 0, 0), folder / "grey.png");
  const auto shader = folder.write("main.glsl", R"(
#iChannel0 "grey.png"
void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(0), 0); }
)");
  EXPECT_EQ(pixel(frames(load_project(shader), 1, small())[0]).x, 128.0F / 255.0F);
}

TEST_P(Inputs, UnboundChannelsReadOpaqueBlack) {
  const auto shader = folder.write("main.glsl", R"(
void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel3, p) + vec4(0, vec2(textureSize(iChannel3, 0)), 0); }
)");
  EXPECT_EQ(pixel(frames(load_project(shader), 1, small())[0]), glm::vec4(0, 1, 1, 1));
}

TEST_P(Inputs, CubemapFacesLieWhereOpenGlWantsThem) {
  const std::vector<std::pair<std::string, glm::vec3>> faces = {{"px", {1, 0, 0}}, {"nx", {0, 1, 1}},
                                                                {"py", {0, 1, 0}}, {"ny", {1, 0, 1}},
                                                                {"pz", {0, 0, 1}}, {"nz", {1, 1, 0}}};
  for (const auto& [name, color] : faces)
    write_image(solid(color.r, color.g, color.b), folder / ("sky_" + name + ".png"));
  const auto shader = folder.write("main.glsl", R"(
#iChannel0 "sky_{}.png"
#iChannel0::Type "CubeMap"
void mainImage(out vec4 c, in vec2 p) {
  vec3 axes[6] = vec3[6](vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 1, 0), vec3(0, -1, 0), vec3(0, 0, 1), vec3(0, 0, -1));
  c = textureLod(iChannel0, axes[int(p.x)], 0.);
}
)");
  const Image image = frames(load_project(shader), 1, small(6, 1))[0];
  for (int i = 0; i < 6; ++i)
    EXPECT_EQ(pixel(image, i), glm::vec4(faces[static_cast<std::size_t>(i)].second, 1))
        << faces[static_cast<std::size_t>(i)].first;
}

TEST_P(Inputs, KeyboardRowsReachTheShader) {
  const auto shader = folder.write("main.glsl", R"(
#iKeyboard
void mainImage(out vec4 c, in vec2 p) {
  c = vec4(isKeyDown(Key_A), isKeyPressed(Key_A), isKeyToggled(Key_A), isKeyDown(Key_B));
}
)");
  Schedule schedule = small();
  schedule.keys = {{1, 65}};
  const auto images = frames(load_project(shader), 3, schedule);
  EXPECT_EQ(pixel(images[0]), glm::vec4(0));
  EXPECT_EQ(pixel(images[1]), glm::vec4(1, 1, 1, 0));
  EXPECT_EQ(pixel(images[2]), glm::vec4(1, 0, 1, 0));
}

SHADERTWIN_ON_EVERY_DEVICE(Inputs);

}  // namespace
}  // namespace shadertwin
