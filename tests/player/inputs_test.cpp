#include "host/player/inputs.h"

#include <gtest/gtest.h>

#include <cstring>

#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

Project two_buffers_and_a_picture(Dialect dialect) {
  Project project;
  project.dialect = dialect;
  project.passes.resize(3);
  project.passes[0].kind = PassKind::buffer;
  project.passes[1].kind = PassKind::buffer;
  return project;
}

Input of_pass(int pass) {
  Input input;
  input.kind = InputKind::pass;
  input.pass = pass;
  return input;
}

TEST(PassesWithHistory, AreThoseThatReadThemselvesOrAreReadEarlier) {
  Project project = two_buffers_and_a_picture(Dialect::vscode);
  project.passes[2].inputs[0] = of_pass(0);
  EXPECT_EQ(passes_with_history(project), (std::vector<bool>{false, false, false}));
  project.passes[0].inputs[0] = of_pass(1);
  EXPECT_EQ(passes_with_history(project), (std::vector<bool>{false, true, false}));
  project.passes[2].inputs[1] = of_pass(2);
  EXPECT_EQ(passes_with_history(project), (std::vector<bool>{false, true, true}));
}

TEST(PassesWithHistory, AreAllBuffersOnTheSite) {
  EXPECT_EQ(passes_with_history(two_buffers_and_a_picture(Dialect::shadertoy)),
            (std::vector<bool>{true, true, false}));
}

TEST(SharedSamplers, ABufferWrapsAsItsLastInputAndIsFilteredAsAPassesLastChannel) {
  Project project;
  project.dialect = Dialect::shadertoy;
  project.passes.resize(3);
  const auto read = [&](int pass, std::size_t channel, MagFilter mag, Wrap wrap) {
    Input& input = project.passes[static_cast<std::size_t>(pass)].inputs[channel];
    input.kind = InputKind::pass;
    input.pass = 0;
    input.sampler = {mag == MagFilter::linear ? MinFilter::linear : MinFilter::nearest, mag, wrap, true};
  };
  read(1, 0, MagFilter::linear, Wrap::repeat);
  read(2, 1, MagFilter::linear, Wrap::repeat);
  read(2, 3, MagFilter::nearest, Wrap::clamp);
  project.passes[0].kind = project.passes[1].kind = PassKind::buffer;

  project.passes[2].tab = 1;
  const Project site = with_shared_samplers(project);
  EXPECT_EQ(site.passes[1].inputs[0].sampler.mag, MagFilter::linear);
  EXPECT_EQ(site.passes[2].inputs[1].sampler.mag, MagFilter::nearest);
  EXPECT_EQ(site.passes[2].inputs[1].sampler.min, MinFilter::nearest);
  EXPECT_EQ(site.passes[2].inputs[3].sampler.mag, MagFilter::nearest);
  EXPECT_EQ(site.passes[1].inputs[0].sampler.wrap, Wrap::clamp);
  EXPECT_EQ(site.passes[2].inputs[1].sampler.wrap, Wrap::clamp);

  project.passes[2].tab = 0;  // the Image, which is drawn last, is the first tab
  EXPECT_EQ(with_shared_samplers(project).passes[2].inputs[1].sampler.wrap, Wrap::repeat);

  project.dialect = Dialect::vscode;
  const Project extension = with_shared_samplers(project);
  EXPECT_EQ(extension.passes[1].inputs[0].sampler.wrap, Wrap::repeat);
  EXPECT_EQ(extension.passes[2].inputs[1].sampler.mag, MagFilter::linear);
}

TEST(LoadTexture, OfOneChannelKeepsRedAlone) {
  const ScratchFolder folder;
  Image picture(1, 1);
  picture.rgba = {0.2F, 0.4F, 0.6F, 0.8F};
  Input input;
  input.kind = InputKind::texture;
  input.red_only = true;
  input.files = {folder / "grey.png"};
  write_image(picture, input.files[0]);
  EXPECT_EQ(load_texture(input).data,
            (std::vector<std::byte>{std::byte{51}, std::byte{0}, std::byte{0}, std::byte{255}}));
  input.files = {folder / "grey.exr"};
  write_image(picture, input.files[0]);
  std::array<float, 4> texel{};
  std::memcpy(texel.data(), load_texture(input).data.data(), sizeof texel);
  EXPECT_EQ(texel, (std::array<float, 4>{0.2F, 0, 0, 1}));
}

TEST(ChannelSize, IsWhatEachDialectReports) {
  const Project site = two_buffers_and_a_picture(Dialect::shadertoy);
  const Project extension = two_buffers_and_a_picture(Dialect::vscode);
  Texture picture;
  picture.width = 40;
  picture.height = 30;
  Input input;
  EXPECT_EQ(channel_size(site, input, nullptr, {64, 36}), glm::vec3(0, 0, 0));
  EXPECT_EQ(channel_size(site, of_pass(0), nullptr, {64, 36}), glm::vec3(64, 36, 1));
  input.kind = InputKind::texture;
  EXPECT_EQ(channel_size(site, input, &picture, {64, 36}), glm::vec3(40, 30, 1));
  input.kind = InputKind::keyboard;
  EXPECT_EQ(channel_size(site, input, nullptr, {64, 36}), glm::vec3(256, 3, 1));
  input.kind = InputKind::cubemap;
  EXPECT_EQ(channel_size(site, input, &picture, {64, 36}), glm::vec3(0, 0, 0));
  EXPECT_EQ(channel_size(extension, input, &picture, {64, 36}), glm::vec3(0, 0, 1));
}

}  // namespace
}  // namespace shadertwin
