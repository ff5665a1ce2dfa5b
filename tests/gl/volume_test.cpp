// Volumes on the GPU.
#include "host/text/load.h"
#include "tests/gl/play.h"
#include "tests/image/volume_file.h"

namespace shadertwin {
namespace {

using Volume = OnEveryDevice;

// What `lookup` gives of a volume of 2x2x2 texels, red 0, 1, 2 ... 7 times 32, seen through `sampler`.
Project volume_shader(const ScratchFolder& folder, const std::string& sampler, const std::string& lookup) {
  std::string texels;
  for (int i = 0; i < 8; ++i) texels += static_cast<char>(32 * i);
  folder.write("media/v.bin", volume_file({2, 2, 2}, 1, 0, texels));
  const auto shader = folder.write(
      "toy.json",
      R"({"Shader": {"renderpass": [{"type": "image", "name": "Image", "outputs": [{"id": 37, "channel": 0}],
          "inputs": [{"id": 1, "channel": 2, "ctype": "volume", "src": "/media/v.bin", "sampler": {)" +
          sampler + R"(}}], "code": "void mainImage(out vec4 c, vec2 p) { c = )" + lookup + R"(; }"}]}})");
  return load_project(shader);
}

TEST_P(Volume, SamplersDoWhatTheirSettingsSay) {
  const std::string nearest = R"("filter": "nearest", "wrap": "repeat")";
  const std::string linear = R"("filter": "linear", "wrap": "clamp")";
  const std::string mipmap = R"("filter": "mipmap", "wrap": "repeat")";
  const std::vector<std::tuple<std::string, std::string, float>> cases = {
      {nearest, "texelFetch(iChannel2, ivec3(1, 0, 1), 0)", 160},
      {nearest, "textureLod(iChannel2, vec3(.25, .75, .25), 0.)", 64},
      {nearest, "textureLod(iChannel2, vec3(1.25, .75, 1.75), 0.)", 192},
      {linear, "textureLod(iChannel2, vec3(.5), 0.)", 112},
      {linear, "textureLod(iChannel2, vec3(.25, .25, 9.), 0.)", 128},
      {mipmap, "textureLod(iChannel2, vec3(.3), 1.)", 112},
      {nearest, "vec4(iChannelResolution[2] / 255., 1.)", 2},
      {nearest, "vec4(iChannelResolution[2].z / 255.)", 2},
      {nearest, "vec4(textureSize(iChannel2, 0), 1) / 255.", 2},
  };
  for (const auto& [sampler, lookup, wanted] : cases) {
    EXPECT_NEAR(pixel(frames(volume_shader(folder, sampler, lookup), 1, small())[0]).x * 255.0F, wanted, 1.0F)
        << sampler << ' ' << lookup;
  }
}

SHADERTWIN_ON_EVERY_DEVICE(Volume);

}  // namespace
}  // namespace shadertwin
