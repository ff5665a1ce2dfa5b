#include "host/project/kinds.h"

#include <gtest/gtest.h>

#include <set>

namespace shadertwin {
namespace {

TEST(PassKinds, AreDrawnSoundFirstAndTheImageLast) {
  EXPECT_LT(traits(PassKind::sound).rank, traits(PassKind::buffer).rank);
  EXPECT_LT(traits(PassKind::buffer).rank, traits(PassKind::cubemap).rank);
  EXPECT_LT(traits(PassKind::cubemap).rank, traits(PassKind::image).rank);
}

TEST(InputKinds, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  std::set<std::string_view> site_names;
  for (const InputKindInfo& kind : input_kinds) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    if (kind.source == InputSource::undrawn) continue;  // it is called as its kind of pass
    EXPECT_TRUE(site_names.insert(kind.site_name).second) << kind.name;
  }
}

TEST(InputKinds, SamplersAreWhatEachHostGivesToANewInput) {
  const Sampler site = info(InputKind::texture).site_sampler;
  EXPECT_EQ(site.min, MinFilter::linear_mipmap_linear);
  EXPECT_EQ(site.wrap, Wrap::repeat);
  EXPECT_TRUE(site.vflip);
  EXPECT_FALSE(info(InputKind::cubemap).site_sampler.vflip);
  EXPECT_EQ(info(InputKind::keyboard).site_sampler.mag, MagFilter::nearest);
  EXPECT_EQ(info(InputKind::pass).site_sampler.wrap, Wrap::clamp);
  EXPECT_EQ(info(InputKind::music).extension_sampler.min, MinFilter::nearest);
  EXPECT_EQ(info(InputKind::texture).extension_sampler.min, MinFilter::linear);
}

}  // namespace
}  // namespace shadertwin
