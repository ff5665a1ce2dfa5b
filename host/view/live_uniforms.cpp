#include "host/view/live_uniforms.h"

namespace shadertwin::view {

void LiveUniforms::declare(const std::vector<CustomUniform>& uniforms) {
  declared_ = uniforms;
  values_.clear();
  for (const CustomUniform& uniform : declared_) {
    const auto edit = edited_.find(uniform.name);
    const bool kept = edit != edited_.end() && edit->second.first == uniform.type;
    values_.push_back(kept ? edit->second.second : uniform.value);
  }
}

void LiveUniforms::set(const std::vector<UniformValue>& values) {
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (values[i] != values_[i]) edited_[declared_[i].name] = {declared_[i].type, values[i]};
  values_ = values;
}

void LiveUniforms::reset() {
  edited_.clear();
  declare(std::vector<CustomUniform>(declared_));
}

std::string LiveUniforms::edits_as_options() const {
  return edited_.empty() ? "" : uniforms_as_options(declared_, values_);
}

}  // namespace shadertwin::view
