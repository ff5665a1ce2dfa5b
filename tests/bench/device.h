// Benchmarks of a device that is not here are skipped.
#pragma once

#include <benchmark/benchmark.h>

#include "host/base/error.h"
#include "host/gl/context.h"

namespace shadertwin {

inline bool skips(benchmark::State& state, const char* device) {
  try {
    gl::open_context(device);
    return false;
  } catch (const Error& error) {
    state.SkipWithError(error.what());
    return true;
  }
}

}  // namespace shadertwin
