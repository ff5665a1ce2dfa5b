#include "host/base/assert.h"

#include <cstdio>
#include <cstdlib>

namespace shadertwin {

void assertion_failed(const char* file, int line, const std::string& text) {
  std::fprintf(stderr, "%s:%d: this should hold: %s\n", file, line, text.c_str());
  std::abort();
}

}  // namespace shadertwin
