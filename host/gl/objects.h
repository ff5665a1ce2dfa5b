// OpenGL names that delete themselves. Their context must be current when they are made and destroyed.
#pragma once

#include <utility>

#include "host/gl/functions.h"

namespace shadertwin::gl {

template <auto Generate, auto Delete>
class Object {
 public:
  Object() = default;
  explicit Object(const Functions& gl) : gl_(&gl) { (gl.*Generate)(1, &name_); }
  ~Object() {
    if (name_ != 0) (gl_->*Delete)(1, &name_);
  }
  Object(Object&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(name_, other.name_);
    return *this;
  }
  GLuint name() const { return name_; }

 private:
  const Functions* gl_ = nullptr;
  GLuint name_ = 0;
};

using TextureObject = Object<&Functions::GenTextures, &Functions::DeleteTextures>;
using SamplerObject = Object<&Functions::GenSamplers, &Functions::DeleteSamplers>;
using FramebufferObject = Object<&Functions::GenFramebuffers, &Functions::DeleteFramebuffers>;
using VertexArrayObject = Object<&Functions::GenVertexArrays, &Functions::DeleteVertexArrays>;
using QueryObject = Object<&Functions::GenQueries, &Functions::DeleteQueries>;

}  // namespace shadertwin::gl
