// What shows only when a shader runs: on a twin that is compiled to look for it.
#pragma once

#include <vector>

#include "host/player/fixed_clock.h"
#include "host/project/project.h"
#include "reference/check/finding.h"

namespace shadertwin::check {

struct RunOptions {
  Schedule schedule;
  int frames = 2;
  double timeout = 0;  // seconds for a frame; 0: none
};

// Draws the frames twice, with variables that start as zero and as a pattern. Finds undefined operations
// (kind `undefined`), the lines where NaN and infinities first appear (`nan`, `inf`), loops of more rounds
// than llvmpipe runs (`loop`), and values that were never written and reach a picture (`uninitialised`).
// Throws what twin::make_player() and Player::render() throw.
std::vector<Finding> run_checks(const Project& project, const RunOptions& options);

}  // namespace shadertwin::check
