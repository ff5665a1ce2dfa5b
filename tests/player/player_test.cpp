// The frame script, by what it asks of a device that draws nothing.
#include "host/player/player.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "host/base/error.h"
#include "tests/player/fake_device.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

TEST(Player, DrawsThePassesInTheirOrderAndTakesTurnsWithTheTargetsOfABuffer) {
  Played played(accumulating());  // targets of A: 0 and 1; of the Image: 2
  played.player.render(frame_of(0));
  EXPECT_EQ(played.device.take(),
            (Lines{"begin", "resize 0 to 4x3 keep", "resize 1 to 4x3 keep", "resize 2 to 4x3", "clear 0",
                   "clear 1", "clear 2", "draw A into 1", "draw Image into 2", "end"}));
  EXPECT_EQ(played.device.bound(0, 0), id(0)) << "the frame before";
  EXPECT_EQ(played.device.bound(1, 0), id(1)) << "this frame";
  played.player.render(frame_of(1));
  EXPECT_EQ(played.device.take(), (Lines{"begin", "draw A into 0", "draw Image into 2", "end"}));
  EXPECT_EQ(played.device.bound(0, 0), id(1));
  EXPECT_EQ(played.device.bound(1, 0), id(0));
  EXPECT_EQ(played.player.texture(0), id(0));
  played.player.read(0);
  EXPECT_EQ(played.device.take(), (Lines{"read 0"}));
}

TEST(Player, FrameZeroStartsFromClearTargets) {
  Played played(accumulating());
  played.player.render(frame_of(0));
  played.player.render(frame_of(1));
  played.device.take();
  played.player.render(frame_of(0));
  EXPECT_EQ(played.device.take(),
            (Lines{"begin", "clear 0", "clear 1", "clear 2", "draw A into 1", "draw Image into 2", "end"}));
}

TEST(Player, AResizeKeepsTheBuffersOfTheSiteAndReadsTheirFirstTargetNext) {
  Played played(accumulating());
  played.player.render(frame_of(0));
  EXPECT_EQ(played.player.texture(0), id(1));
  played.device.take();
  played.player.render(frame_of(1, 8, 5));
  EXPECT_EQ(played.device.take(), (Lines{"begin", "resize 0 to 8x5 keep", "resize 1 to 8x5 keep",
                                         "resize 2 to 8x5", "draw A into 1", "draw Image into 2", "end"}));
  EXPECT_EQ(played.device.bound(0, 0), id(0));
}

TEST(Player, AResizeEmptiesTheBuffersOfTheExtension) {
  Played played(accumulating(Dialect::vscode));
  played.player.render(frame_of(0));
  played.device.take();
  played.player.render(frame_of(1, 8, 5));
  EXPECT_EQ(played.device.take(), (Lines{"begin", "resize 0 to 8x5", "resize 1 to 8x5", "resize 2 to 8x5",
                                         "draw A into 0", "draw Image into 2", "end"}));
  EXPECT_EQ(played.device.bound(0, 0), id(1)) << "the turns go on";
}

TEST(Player, OnlyTheExtensionClearsWhatAShaderDiscards) {
  for (const Dialect dialect : {Dialect::shadertoy, Dialect::vscode}) {
    Played played(accumulating(dialect));
    played.player.render(frame_of(0));
    for (const FakeDevice::Draw& draw : played.device.draws)
      EXPECT_EQ(draw.clear, dialect == Dialect::vscode);
  }
}

TEST(Player, WarmsUpBeforeFrameZeroWithTheExtensionsQuirks) {
  Project project = accumulating(Dialect::vscode);
  project.vscode_quirks = true;
  Played played(project);
  played.player.render(frame_of(0));
  ASSERT_EQ(played.device.draws.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const FakeDevice::Draw& draw = played.device.draws[i];
    EXPECT_EQ(draw.pass, i % 2);
    EXPECT_EQ(draw.warm_up, i < 2) << i;
    EXPECT_EQ(draw.uniforms.iTime, i < 2 ? 0.0F : 2.0F);
  }
  EXPECT_EQ(played.device.draws[0].target, played.device.draws[2].target) << "the warm-up takes no turn";
  played.player.render(frame_of(1));
  EXPECT_EQ(played.device.draws.size(), 6U);
}

TEST(Player, TellsEveryPassTheSizeOfWhatItReads) {
  const ScratchFolder folder;
  Image image(5, 7);
  write_image(image, folder / "t.png");
  Project project = accumulating();
  project.passes.insert(project.passes.begin() + 1, named("Cube A", PassKind::cubemap));
  Pass& last = project.passes.back();
  last.inputs[1] = reads(1);
  last.inputs[2] = of_kind(InputKind::texture);
  last.inputs[2].files = {folder / "t.png"};
  last.inputs[3] = of_kind(InputKind::keyboard);
  Played played(project);
  for (const int width : {4, 8}) {
    played.player.render(frame_of(0, width));
    const Uniforms& uniforms = played.device.last_draw(2).uniforms;
    EXPECT_EQ(uniforms.iResolution, glm::vec3(width, 3, 1));
    EXPECT_EQ(uniforms.iChannelResolution[0], glm::vec3(width, 3, 1));
    EXPECT_EQ(uniforms.iChannelResolution[1], glm::vec3(cubemap_pass_size, cubemap_pass_size, 1));
    EXPECT_EQ(uniforms.iChannelResolution[2], glm::vec3(5, 7, 1));
    EXPECT_EQ(uniforms.iChannelResolution[3], glm::vec3(256, 3, 1));
    EXPECT_EQ(uniforms.iChannelResolution[4], glm::vec3(0)) << "empty";
    EXPECT_EQ(played.device.last_draw(1).uniforms.iResolution, glm::vec3(1024, 1024, 1));
  }
}

TEST(Player, LoadsAFileOnceForEveryWayToReadIt) {
  const ScratchFolder folder;
  write_image(Image(5, 7), folder / "t.png");
  Project project = accumulating();
  for (Pass& pass : project.passes) {
    for (std::size_t channel = 1; channel < 4; ++channel) {
      pass.inputs[channel] = of_kind(InputKind::texture);
      pass.inputs[channel].files = {folder / "t.png"};
    }
    pass.inputs[2].sampler.wrap = Wrap::mirror;
    pass.inputs[3].sampler.min = MinFilter::linear_mipmap_linear;
  }
  Played played(project);
  played.player.render(frame_of(0));
  const FakeDevice& device = played.device;
  EXPECT_EQ(device.bound(0, 1), device.bound(1, 1));
  EXPECT_EQ(device.bound(0, 1), device.bound(0, 2));
  EXPECT_NE(device.bound(0, 1), device.bound(0, 3));
  EXPECT_EQ(device.last_draw(0).bound[2].sampler.wrap, Wrap::mirror);
  EXPECT_FALSE(played.device.surface(device.bound(0, 1)).mipmaps);
  EXPECT_TRUE(played.device.surface(device.bound(0, 3)).mipmaps);
}

TEST(Player, GivesTargetsMipmapsWhereAReaderWantsThem) {
  Project project = accumulating();
  project.passes[1].inputs[0] = reads(0, MinFilter::linear_mipmap_linear);
  project.passes.insert(project.passes.begin() + 1, named("Cube A", PassKind::cubemap));
  Played played(project);
  EXPECT_TRUE(played.device.surface(played.player.texture(0)).mipmaps);
  EXPECT_FALSE(played.device.surface(played.player.texture(2)).mipmaps);
  EXPECT_FALSE(played.device.surface(played.player.texture(2)).cube);
  EXPECT_TRUE(played.device.surface(played.player.texture(1)).cube);
}

TEST(Player, EmptyChannelsHaveOneTexelOfTheShapeThatIsMissing) {
  const auto alpha = [](InputKind missing, bool quirks) {
    Project project = accumulating(Dialect::vscode);
    project.vscode_quirks = quirks;
    project.passes[1].inputs[1].missing = missing;
    Played played(project);
    played.player.render(frame_of(0));
    const Texture& texel = played.device.surface(played.device.bound(1, 1)).texels;
    EXPECT_EQ(texel.width * texel.height * texel.depth, 1);
    EXPECT_EQ(texel.faces, missing == InputKind::cubemap ? 6 : 1);
    EXPECT_EQ(texel.is_volume, missing == InputKind::volume);
    EXPECT_EQ(texel.data.size(), std::size_t{4} * static_cast<std::size_t>(texel.faces));
    EXPECT_EQ(texel.data[0], std::byte{0});
    return std::to_integer<int>(texel.data.back());
  };
  EXPECT_EQ(alpha(InputKind::none, false), 255);
  EXPECT_EQ(alpha(InputKind::cubemap, false), 255);
  EXPECT_EQ(alpha(InputKind::volume, false), 255);
  EXPECT_EQ(alpha(InputKind::cubemap, true), 0);
}

TEST(Player, APassThatIsNotThereIsAsLargeAsItWouldBe) {
  Project project = accumulating();
  project.passes[0].inputs[1] = of_kind(InputKind::undrawn);
  project.passes[1].inputs[1] = of_kind(InputKind::undrawn);
  project.passes[1].inputs[2] = of_kind(InputKind::undrawn);
  project.passes[1].inputs[2].undrawn = PassKind::cubemap;
  Played played(project);
  for (const int width : {4, 7}) {
    played.player.render(frame_of(0, width));
    const TextureId buffer = played.device.bound(1, 1);
    const TextureId cube = played.device.bound(1, 2);
    EXPECT_EQ(played.device.bound(0, 1), buffer);
    EXPECT_FALSE(played.device.surface(buffer).cube);
    EXPECT_TRUE(played.device.surface(cube).cube);
    const auto& sizes = played.device.last_draw(1).uniforms.iChannelResolution;
    EXPECT_EQ(sizes[1], glm::vec3(width, 3, 1));
    EXPECT_EQ(sizes[2], glm::vec3(cubemap_pass_size, cubemap_pass_size, 1));
    const Lines log = played.device.take();
    const auto resized = [&](TextureId texture, int w, int h) {
      const std::string line = "resize " + std::to_string(static_cast<std::size_t>(texture)) + " to " +
                               std::to_string(w) + "x" + std::to_string(h);
      return std::any_of(log.begin(), log.end(), [&](const auto& l) { return l == line; });
    };
    EXPECT_TRUE(resized(buffer, width, 3));
    EXPECT_EQ(resized(cube, cubemap_pass_size, cubemap_pass_size), width == 4);
  }
}

TEST(Player, ShowsTheKeyboardOfEveryFrame) {
  for (const Dialect dialect : {Dialect::shadertoy, Dialect::vscode}) {
    const bool site = dialect == Dialect::shadertoy;
    Project project = accumulating(dialect);
    project.passes[1].inputs[1] = of_kind(InputKind::keyboard);
    project.passes[1].keyboard = !site;
    Played played(project);
    for (const std::uint8_t value : {0, 255}) {
      Frame frame = frame_of(1);
      frame.keyboard[65] = value;
      played.player.render(frame);
      const FakeDevice::Draw& draw = played.device.last_draw(1);
      const Texture& texels = played.device.surface(draw.bound[1].texture).texels;
      ASSERT_EQ(texels.data.size(), std::size_t{256} * 4 * (site ? 3 : 4));
      const auto byte = [&](std::size_t i) { return std::to_integer<int>(texels.data[i]); };
      EXPECT_EQ(byte(260), value);
      EXPECT_EQ(byte(261), site ? 0 : value);
      EXPECT_EQ(byte(263), 255);
      EXPECT_EQ(draw.bound[1].sampler.mag, MagFilter::nearest);
      ASSERT_EQ(draw.bound.size(), site ? keyboard_channel : keyboard_channel + 1);
      if (!site) {
        EXPECT_EQ(draw.bound[keyboard_channel].texture, draw.bound[1].texture);
      }
    }
  }
}

TEST(Player, UploadsWhatMovesWhenItChangesAndTellsItsTime) {
  Project project = accumulating();
  project.muted = true;  // music is then the site's preview, 10 seconds in
  project.passes[1].inputs[1] = of_kind(InputKind::music);
  Played played(project);
  played.player.render(frame_of(0));
  const std::string upload = "upload " + FakeDevice::name(played.device.bound(1, 1));
  const Lines first = played.device.take();
  EXPECT_EQ(std::count(first.begin(), first.end(), upload), 1);
  EXPECT_EQ(played.device.last_draw(1).uniforms.iChannelTime[1], 12.0F);
  EXPECT_EQ(played.device.last_draw(1).uniforms.iChannelTime[0], 0.0F);
  played.player.render(frame_of(1));
  const Lines second = played.device.take();
  EXPECT_EQ(std::count(second.begin(), second.end(), upload), 0) << "iTime stands still";
}

TEST(Player, SoundIsDrawnInBlocksOfItsOwnAndLeavesThePicturesAlone) {
  Project project = accumulating();
  project.passes.push_back(named("Sound", PassKind::sound));
  Played played(project);
  played.player.render(frame_of(0));
  const Lines frame = played.device.take();
  EXPECT_EQ(std::count(frame.begin(), frame.end(), "draw A into 1"), 1);
  EXPECT_EQ(played.device.draws.size(), 2U) << "no sound in a frame";
  const std::string target = FakeDevice::name(played.player.texture(2));
  const glm::vec4 date(2024, 1, 2, 3.75);
  played.player.sound_block(0, date);
  EXPECT_EQ(played.device.take(), (Lines{"begin", "resize " + target + " to 512x512",
                                         "draw Sound into " + target, "end", "read " + target}));
  played.player.sound_block(3, date);
  EXPECT_EQ(played.device.take(), (Lines{"begin", "draw Sound into " + target, "end", "read " + target}));
  const FakeDevice::Draw& draw = played.device.last_draw(2);
  EXPECT_EQ(draw.index, 3);
  EXPECT_EQ(draw.uniforms.iSampleOffset, 3 * sound_block_samples);
  EXPECT_EQ(draw.uniforms.iDate, glm::vec4(2024, 1, 2, 3));
  played.player.render(frame_of(1));
  EXPECT_EQ(played.device.take(), (Lines{"begin", "draw A into 0", "draw Image into 2", "end"}));
}

TEST(Player, AskedForASoundThatIsNotThereSaysSo) {
  Played played(accumulating());
  try {
    played.player.sound_block(0, glm::vec4(0));
    FAIL() << "there is no sound";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::usage);
  }
}

TEST(Player, ContinuesFromThePassesOfTheSameName) {
  Played earlier(accumulating());
  earlier.player.render(frame_of(0));
  Project changed = accumulating();
  changed.passes.insert(changed.passes.begin(), named("B", PassKind::buffer));
  changed.passes[1].inputs[0].pass = changed.passes[2].inputs[0].pass = 1;
  Played later(changed);
  Lines copies;
  later.player.continue_from(earlier.player, [&](TextureId from, TextureId to) {
    copies.push_back(FakeDevice::name(from) + " to " + FakeDevice::name(to));
  });
  const auto target = [&](int pass) { return FakeDevice::name(later.player.texture(pass)); };
  EXPECT_EQ(copies.size(), 3U) << "two targets of A, one of the Image";
  EXPECT_EQ(copies[1], "1 to " + target(1)) << "what A drew last is shown next";
  EXPECT_EQ(copies[2], "2 to " + target(2));
  const Lines log = later.device.take();
  EXPECT_EQ(std::count(log.begin(), log.end(), "resize " + target(2) + " to 4x3"), 1);
}

TEST(Player, PassesOnTheWarningsOfItsDevice) {
  const Played played(accumulating());
  EXPECT_EQ(played.player.warnings(), (Lines{"a pass runs as fragments"}));
}

}  // namespace
}  // namespace shadertwin
