// Plays small shaders that a test writes, on each kind of context.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/gl/gl_device.h"
#include "host/player/fixed_clock.h"
#include "tests/scratch_folder.h"
#include "tests/skip.h"

namespace shadertwin {

// Where and how a test's shaders run.
struct TestDevice {
  std::string name;
  gl::Dispatch dispatch = gl::Dispatch::fragment;
};

inline void PrintTo(const TestDevice& device, std::ostream* out) {
  *out << device.name << (device.dispatch == gl::Dispatch::compute ? "/compute" : "/fragment");
}

inline std::string device_name(const testing::TestParamInfo<TestDevice>& info) {
  return info.param.name + (info.param.dispatch == gl::Dispatch::compute ? "Compute" : "Fragment");
}

// Every test of this suite runs on EGL and OSMesa, as fragments and as compute.
class OnEveryDevice : public testing::TestWithParam<TestDevice> {
 protected:
  void SetUp() override {
    if (GetParam().name == "osmesa") SHADERTWIN_NEEDS_OSMESA();
  }

  std::unique_ptr<Player> play(const Project& project) const {
    return gl::make_player(gl::open_context(GetParam().name), project, {GetParam().dispatch});
  }

  // The last pass after each frame of the schedule.
  std::vector<Image> frames(const Project& project, int count, const Schedule& schedule) const {
    const auto player = play(project);
    FixedClock clock(schedule, host_rules(project));
    std::vector<Image> images;
    for (int i = 0; i < count; ++i) {
      player->render(clock.next());
      images.push_back(player->read(static_cast<int>(project.passes.size()) - 1));
    }
    return images;
  }

  static Schedule small(int width = 4, int height = 3) {
    Schedule schedule;
    schedule.width = width;
    schedule.height = height;
    return schedule;
  }

  ScratchFolder folder;
};

#define SHADERTWIN_ON_EVERY_DEVICE(suite)                                                  \
  INSTANTIATE_TEST_SUITE_P(, suite,                                                        \
                           testing::Values(TestDevice{"llvmpipe", gl::Dispatch::fragment}, \
                                           TestDevice{"llvmpipe", gl::Dispatch::compute},  \
                                           TestDevice{"osmesa", gl::Dispatch::fragment},   \
                                           TestDevice{"osmesa", gl::Dispatch::compute}),   \
                           device_name)

inline glm::vec4 pixel(const Image& image, int x = 0, int y = 0) {
  const float* p = image.at(x, y);
  return {p[0], p[1], p[2], p[3]};
}

}  // namespace shadertwin
