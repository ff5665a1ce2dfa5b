// Whether everything that runs a shader agrees on it: llvmpipe and the three forms of the CPU twin.
#pragma once

#include <string>
#include <vector>

#include "host/project/project.h"

namespace shadertwin {

struct AgreementOptions {
  int width = 20;
  int height = 12;
  int frames = 2;
  bool doubles = true;  // the twin in doubles too
  bool single = true;   // the twin one pixel at a time too, and the one that `check` runs
  bool osmesa = false;
  bool packets = true;  // the twin of eight pixels
  float tolerance = 0;  // relative; 0: the same bits, but zeros may differ in sign
};

// One line for each that does not compile or whose picture differs from the first: "cpu: 12 of 960 values
// differ, first at 3, 4: ...". Empty if all agree.
std::vector<std::string> disagreements(const Project& project, const AgreementOptions& options);

}  // namespace shadertwin
