#include "host/gl/program_uniforms.h"

#include <string>

#include "host/project/kinds.h"

namespace shadertwin::gl {

namespace {

void set_uniform(const Functions& gl, GLint location, UniformType type, int count, const void* value) {
  const auto* f = static_cast<const GLfloat*>(value);
  const auto* i = static_cast<const GLint*>(value);
  switch (type) {
    case UniformType::float1:
      gl.Uniform1fv(location, count, f);
      break;
    case UniformType::float2:
      gl.Uniform2fv(location, count, f);
      break;
    case UniformType::float3:
      gl.Uniform3fv(location, count, f);
      break;
    case UniformType::float4:
      gl.Uniform4fv(location, count, f);
      break;
    case UniformType::int1:
      gl.Uniform1iv(location, count, i);
      break;
    case UniformType::int2:
      gl.Uniform2iv(location, count, i);
      break;
    case UniformType::int3:
      gl.Uniform3iv(location, count, i);
      break;
    case UniformType::int4:
      gl.Uniform4iv(location, count, i);
      break;
    case UniformType::mat4:
      gl.UniformMatrix4fv(location, count, GL_FALSE, f);
      break;
  }
}

}  // namespace

ProgramUniforms::ProgramUniforms(const Functions& gl, const Program& program, const Project& project)
    : gl_(&gl) {
  for (const UniformField& field : uniform_fields())
    if (const GLint location = program.uniform(field.name); location >= 0)
      built_in_.push_back({location, field.type, field.count, field.offset});
  for (std::size_t i = 0; i < project.uniforms.size(); ++i) {
    const CustomUniform& custom = project.uniforms[i];
    if (const GLint location = program.uniform(custom.name); location >= 0)
      custom_.push_back({location, custom.type, i, custom.value});
  }
  gl.UseProgram(program.name());
  for (std::size_t i = 0; i < sampled_.size(); ++i) {
    const GLint location =
        program.uniform(i == keyboard_channel ? "iKeyboard" : "iChannel" + std::to_string(i));
    sampled_[i] = location >= 0;
    if (sampled_[i]) gl.Uniform1i(location, static_cast<GLint>(i));
  }
}

void ProgramUniforms::set(const Uniforms& values, std::span<const std::array<float, 4>> custom) const {
  for (const BuiltIn& slot : built_in_)
    set_uniform(*gl_, slot.location, slot.type, slot.count,
                reinterpret_cast<const char*>(&values) + slot.offset);
  for (const Custom& slot : custom_) {
    const std::array<float, 4>& value = slot.index < custom.size() ? custom[slot.index] : slot.value;
    std::array<GLint, 4> integers{};
    for (std::size_t i = 0; i < 4; ++i) integers[i] = static_cast<GLint>(value[i]);
    set_uniform(*gl_, slot.location, slot.type, 1,
                info(slot.type).is_integer ? static_cast<const void*>(integers.data()) : value.data());
  }
}

}  // namespace shadertwin::gl
