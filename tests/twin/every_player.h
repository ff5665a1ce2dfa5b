// Plays small projects of shadertoy.com's on every player and precision: OpenGL, as fragments and as compute,
// and the twin, in float and in double.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "host/gl/gl_device.h"
#include "reference/twin/twin_device.h"
#include "tests/scratch_folder.h"
#include "tests/skip.h"

namespace shadertwin {

class OnEveryPlayer : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (GetParam().starts_with("osmesa")) SHADERTWIN_NEEDS_OSMESA();
  }

  static std::unique_ptr<Player> play(const Project& project) {
    const std::string& name = GetParam();
    if (name.starts_with("cpu")) {
      twin::TwinOptions options;
      options.double_precision = name == "cpu/double";
      return twin::make_player(project, options);
    }
    gl::PlayerOptions options;
    options.dispatch = name.ends_with("compute") ? gl::Dispatch::compute : gl::Dispatch::fragment;
    return gl::make_player(gl::open_context(name.substr(0, name.find('/'))), project, options);
  }

  static Frame frame(int index, int width = 4, int height = 3) {
    Frame frame;
    frame.width = width;
    frame.height = height;
    frame.index = index;
    return frame;
  }

  // The picture after each of `count` frames.
  static std::vector<Image> pictures(const Project& project, int count, int width = 4, int height = 3) {
    const auto player = play(project);
    std::vector<Image> result;
    for (int i = 0; i < count; ++i) {
      player->render(frame(i, width, height));
      result.push_back(player->read(static_cast<int>(project.passes.size()) - 1));
    }
    return result;
  }

  static glm::vec4 pixel(const Image& image, int x = 0, int y = 0) {
    const float* p = image.at(x, y);
    return {p[0], p[1], p[2], p[3]};
  }

  // A shader as the API gives it. `passes`: the texts of the renderpass objects.
  std::filesystem::path json(const std::string& name, const std::string& passes) const {
    return folder.write(name,
                        R"({"Shader": {"ver": "0.1", "info": {"id": "x"}, "renderpass": [)" + passes + "]}}");
  }
  static std::string pass(const std::string& type, int id, const std::string& inputs,
                          const std::string& code) {
    return R"({"type": ")" + type + R"(", "name": "", "outputs": [{"id": )" + std::to_string(id) +
           R"(, "channel": 0}], "inputs": [)" + inputs + R"(], "code": ")" + code + "\"}";
  }
  static std::string input(int id, const std::string& type, int channel, const std::string& source = "",
                           const std::string& filter = "nearest", bool vflip = true) {
    return R"({"id": )" + std::to_string(id) + R"(, "ctype": ")" + type + R"(", "channel": )" +
           std::to_string(channel) + R"(, "src": ")" + source + R"(", "sampler": {"filter": ")" + filter +
           R"(", "wrap": "clamp", "vflip": )" + (vflip ? "true" : "false") + "}}";
  }

  ScratchFolder folder;
};

inline std::string player_name(const testing::TestParamInfo<std::string>& player) {
  std::string name = player.param;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

#define SHADERTWIN_ON_EVERY_PLAYER(suite)                                                               \
  INSTANTIATE_TEST_SUITE_P(                                                                             \
      , suite,                                                                                          \
      testing::Values("llvmpipe/fragment", "llvmpipe/compute", "osmesa/fragment", "cpu", "cpu/double"), \
      player_name)

}  // namespace shadertwin
