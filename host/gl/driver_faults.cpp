#include "host/gl/driver_faults.h"

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "host/base/error.h"
#include "host/gl/objects.h"
#include "host/gl/program.h"
#include "host/gl/textures.h"

namespace shadertwin::gl {

namespace {

// Where each was seen, and a shader that draws 1 if the driver has it right. `one`: a variable that is 1.
struct Row {
  Fault fault;
  const char* seen;
  const char* shader;
};
constexpr std::array<Row, 2> rows = {{
    {Fault::half_arithmetic, "Mesa 22.3.6, llvmpipe (LLVM 15): unpackHalf2x16() counts as mediump",
     "float x = unpackHalf2x16(packHalf2x16(vec2(12.0, one))).x * 6000.0; c = vec4(x == 72000.0);"},
    {Fault::lost_continue,
     "Mesa 22.3.6, llvmpipe (LLVM 15): NIR joins ifs across a continue before it unrolls",
     "int sum = 0; for (int i = 0; i < 10; i++) "
     "{ switch (i) { case 3: break; default: sum += i; continue; } break; } c = vec4(sum == 3);"},
}};

bool is_right(const Functions& gl, const char* shader) {
  PassSource source;
  source.body = std::string("uniform float iTime; void main() { float one = 1.0 + iTime; vec4 c; ") + shader +
                " shadertoy_out_color = c; }\n";
  source.lines.emplace_back();
  GLint vertices = 0;
  gl.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertices);
  const VertexArrayObject none(gl);
  const TextureObject target = make_target(gl, GL_TEXTURE_2D, {1, 1}, false);
  const FramebufferObject framebuffer(gl);
  gl.BindVertexArray(none.name());
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.name(), 0);
  gl.Viewport(0, 0, 1, 1);
  std::array<float, 4> pixel{};
  try {
    const Program program = Program::fragment(gl, {}, {}, source);
    gl.UseProgram(program.name());
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, pixel.data());
  } catch (const Error&) {
    // A driver that can't compile this has other faults.
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.BindVertexArray(static_cast<GLuint>(vertices));
  return pixel[0] == 1.0F;
}

}  // namespace

bool shows_fault(const Functions& gl, Fault fault) {
  static std::mutex mutex;
  static std::map<std::pair<std::string, Fault>, bool> known;
  std::string driver;
  for (const GLenum what : {GL_RENDERER, GL_VERSION})
    if (const auto* text = gl.GetString(what)) driver += reinterpret_cast<const char*>(text);
  const std::lock_guard lock(mutex);
  const auto [found, is_new] = known.try_emplace({driver, fault});
  if (is_new) {
    const auto* row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.fault == fault; });
    found->second = row != rows.end() && !is_right(gl, row->shader);
  }
  return found->second;
}

}  // namespace shadertwin::gl
