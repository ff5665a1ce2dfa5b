// Tests that this machine can't run, because something is or isn't there.
#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace shadertwin {

// Whether the environment's comma list SHADERTWIN_REQUIRE, which CI sets, has `name`.
inline bool is_required(const std::string& name) {
  const char* list = std::getenv("SHADERTWIN_REQUIRE");
  return list != nullptr && (',' + std::string(list) + ',').find(',' + name + ',') != std::string::npos;
}

// Whether there is OSMesa, which Mesa has no more from version 25.1 on.
inline bool has_osmesa() {
  static const bool found = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL) != nullptr;
  return found;
}

// The players, and OSMesa if it is there.
inline std::vector<std::string> with_osmesa(std::vector<std::string> players) {
  if (has_osmesa()) players.emplace_back("osmesa");
  return players;
}

}  // namespace shadertwin

// Ends the test: skipped, or failed where SHADERTWIN_REQUIRE has `name`.
#define SHADERTWIN_SKIP(name, reason)                                                                   \
  do {                                                                                                  \
    if (shadertwin::is_required(name)) FAIL() << (reason) << ", and SHADERTWIN_REQUIRE has " << (name); \
    GTEST_SKIP() << (reason);                                                                           \
  } while (false)

#define SHADERTWIN_NEEDS_OSMESA()                                                           \
  do {                                                                                      \
    if (!shadertwin::has_osmesa()) SHADERTWIN_SKIP("osmesa", "there is no libOSMesa.so.8"); \
  } while (false)
