// Tests that this machine can't run, because something is or isn't there.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace shadertwin {

// Whether the environment's comma list SHADERTWIN_REQUIRE, which CI sets, has `name`.
inline bool is_required(const std::string& name) {
  const char* list = std::getenv("SHADERTWIN_REQUIRE");
  return list != nullptr && (',' + std::string(list) + ',').find(',' + name + ',') != std::string::npos;
}

}  // namespace shadertwin

// Ends the test: skipped, or failed where SHADERTWIN_REQUIRE has `name`.
#define SHADERTWIN_SKIP(name, reason)                                                                   \
  do {                                                                                                  \
    if (shadertwin::is_required(name)) FAIL() << (reason) << ", and SHADERTWIN_REQUIRE has " << (name); \
    GTEST_SKIP() << (reason);                                                                           \
  } while (false)
