// Compiled passes.
#pragma once

#include <string>

#include "host/gl/functions.h"
#include "host/project/project.h"

namespace shadertwin::gl {

// A linked program. Its context must be current when it is destroyed.
class Program {
 public:
  // `source`: of the pass, as it is to be compiled. A fragment program over a triangle that covers the
  // target, or over what the pass's own vertex shader makes of six vertices. Throws Error(shader), every
  // message of the driver mapped to the user's files.
  static Program fragment(const Functions& gl, const Project& project, const Pass& pass,
                          const PassSource& source);
  // The same pass as a compute program of 8x8 invocations a group. Throws Error(shader).
  static Program compute(const Functions& gl, const Project& project, const Pass& pass,
                         const PassSource& source);

  ~Program();
  Program(Program&& other) noexcept;
  Program& operator=(Program&& other) noexcept;

  GLuint name() const { return name_; }
  GLint uniform(const std::string& name) const { return gl_->GetUniformLocation(name_, name.c_str()); }

 private:
  explicit Program(const Functions& gl) : gl_(&gl), name_(gl.CreateProgram()) {}

  const Functions* gl_;
  GLuint name_;
};

}  // namespace shadertwin::gl
