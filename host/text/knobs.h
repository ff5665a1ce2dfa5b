// The knobs of a shader: macros that -D may set.
#pragma once

#include <string>
#include <vector>

#include "host/project/project.h"

namespace shadertwin {

// A macro that the text gives a value unless somebody else has: `#ifndef NAME`, then `#define NAME VALUE`.
struct Knob {
  std::string name;
  std::string value;  // as it is written, without comments
};

// Each once, in the order in which the passes have them.
std::vector<Knob> find_knobs(const Project& project);

// Whether some pass's text, an include or Common has the identifier.
bool mentions(const Project& project, const std::string& name);
// Those of Project::defines that none has.
std::vector<std::string> unmentioned_defines(const Project& project);

// Whether some #if or #elif looks at the macro, which must then be a number.
bool decides_conditions(const Project& project, const std::string& name);

// The knob whose name is most like `name`, if they are alike enough for a slip of the keyboard; else empty.
std::string nearest_knob(const Project& project, const std::string& name);

}  // namespace shadertwin
