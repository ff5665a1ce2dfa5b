#include "host/project/host_rules.h"

#include <gtest/gtest.h>

namespace shadertwin {
namespace {

TEST(HostRules, AreShadertoysUnlessTheProjectIsTheExtensions) {
  const HostRules site = host_rules(Dialect::shadertoy);
  EXPECT_EQ(site.channels, 4);
  EXPECT_EQ(site.keyboard_rows, 3);
  EXPECT_TRUE(site.opaque_image);
  EXPECT_FALSE(site.clears_targets);
  const HostRules extension = host_rules(Dialect::vscode);
  EXPECT_EQ(extension.channels, 10);
  EXPECT_EQ(extension.keyboard_rows, 4);
  EXPECT_FALSE(extension.opaque_image);
  EXPECT_TRUE(extension.clears_targets);
  EXPECT_FALSE(extension.warms_up);
}

TEST(HostRules, QuirksAreTheExtensionsOnly) {
  EXPECT_FALSE(host_rules(Dialect::shadertoy, true).warms_up);
  EXPECT_EQ(host_rules(Dialect::shadertoy, true).first_mouse, 0.0F);
  const HostRules quirks = host_rules(Dialect::vscode, true);
  EXPECT_TRUE(quirks.warms_up);
  EXPECT_EQ(quirks.first_mouse, -1.0F);
  EXPECT_EQ(quirks.idle_time_delta, 0.0);
  EXPECT_EQ(quirks.empty_alpha, 0);
}

}  // namespace
}  // namespace shadertwin
