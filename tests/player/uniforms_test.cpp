#include "host/player/uniforms.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace shadertwin {
namespace {

TEST(Uniforms, FieldsDoNotOverlapAndCoverTheStruct) {
  std::set<std::string> names;
  std::size_t end = 0;
  for (const UniformField& field : uniform_fields()) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name << " twice";
    EXPECT_EQ(field.offset, end) << field.name;
    static constexpr std::array<std::size_t, 9> components = {1, 2, 3, 4, 1, 2, 3, 4, 16};
    end = field.offset +
          4 * components[static_cast<std::size_t>(field.type)] * static_cast<std::size_t>(field.count);
  }
  EXPECT_EQ(end, sizeof(Uniforms));
}

TEST(Uniforms, TakeTheirValuesFromTheFrame) {
  Project project;
  project.passes.resize(1);
  Frame frame;
  frame.index = 7;
  frame.time = 1.5;
  frame.time_delta = 0.25;
  frame.frame_rate = 4.0;
  frame.mouse = {1, 2, 3, 4};
  frame.date = {2024, 1, 29, 0.5};
  ChannelSizes sizes{};
  sizes[2] = {256, 3, 1};
  const Uniforms u = uniforms_for(project, project.passes[0], frame, {64, 36}, sizes);
  EXPECT_EQ(u.iResolution, glm::vec3(64, 36, 1));
  EXPECT_EQ(u.iTime, 1.5F);
  EXPECT_EQ(u.iTimeDelta, 0.25F);
  EXPECT_EQ(u.iFrameRate, 4.0F);
  EXPECT_EQ(u.iFrame, 7);
  EXPECT_EQ(u.iMouse, frame.mouse);
  EXPECT_EQ(u.iDate, frame.date);
  EXPECT_EQ(u.iChannelResolution[2], sizes[2]);
  EXPECT_EQ(u.iViewMatrix, glm::mat4(1.0F));
}

TEST(Uniforms, SampleRateIsZeroInTheExtensionWithoutAudio) {
  Project project;
  project.passes.resize(1);
  const auto rate = [&] { return uniforms_for(project, project.passes[0], {}, {1, 1}, {}).iSampleRate; };
  EXPECT_EQ(rate(), 44100.0F);
  project.dialect = Dialect::vscode;
  EXPECT_EQ(rate(), 0.0F);
  project.passes[0].inputs[1].kind = InputKind::music;
  EXPECT_EQ(rate(), 44100.0F);
}

}  // namespace
}  // namespace shadertwin
