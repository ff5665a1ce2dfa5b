// The values of #iUniforms as a hand has set them.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/project/project.h"
#include "host/view/shown_text.h"

namespace shadertwin::view {

// What was set by hand outlives a reload, as long as the shader declares that name with that type. What was
// not follows the shader's own values.
class LiveUniforms {
 public:
  // The uniforms of another project, or of a changed one.
  void declare(const std::vector<CustomUniform>& uniforms);
  // Takes over `values` (as many as declared); those that differ count as set by hand.
  void set(const std::vector<UniformValue>& values);
  // Back to the shader's own values.
  void reset();

  const std::vector<CustomUniform>& declared() const { return declared_; }
  const std::vector<UniformValue>& values() const { return values_; }
  // All values as options, if one was set by hand; else empty.
  std::string edits_as_options() const;

 private:
  std::vector<CustomUniform> declared_;
  std::vector<UniformValue> values_;
  std::map<std::string, std::pair<UniformType, UniformValue>> edited_;
};

}  // namespace shadertwin::view
