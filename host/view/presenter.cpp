#include "host/view/presenter.h"

#include <array>
#include <string>

#include "host/base/error.h"

namespace shadertwin::view {

namespace {

constexpr const char* vertex_text = R"(#version 300 es
void main() {
  gl_Position = vec4(vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0, 0.0, 1.0);
}
)";

// Exponents by their bits: drivers may assume that there is no NaN.
constexpr const char* fragment_text = R"(
uniform ivec2 size;
uniform ivec2 window;
uniform int paint;
out vec4 color;
bvec3 special(vec4 v) {
  bvec3 found = bvec3(false);
  for (int i = 0; i < 4; ++i) {
    uint bits = floatBitsToUint(v[i]);
    if ((bits & 0x7f800000u) != 0x7f800000u) continue;
    if ((bits & 0x007fffffu) != 0u) found.x = true;
    else if ((bits >> 31) == 0u) found.y = true;
    else found.z = true;
  }
  return found;
}
void main() {
  ivec2 n = max(size / window, ivec2(1));
  ivec2 first = ivec2(gl_FragCoord.xy) * size / window;
  vec3 sum = vec3(0.0);
  bvec3 found = bvec3(false);
  for (int y = 0; y < n.y; ++y)
    for (int x = 0; x < n.x; ++x) {
      vec4 texel = fetch_texel(min(first + ivec2(x, y), size - 1));
      sum += clamp(texel.rgb, 0.0, 1.0);
      bvec3 here = special(texel);
      found = bvec3(found.x || here.x, found.y || here.y, found.z || here.z);
    }
  color = vec4(sum / float(n.x * n.y), 1.0);
  if (paint == 0) return;
  if (found.y) color.rgb = vec3(1.0, 1.0, 0.0);
  if (found.z) color.rgb = vec3(0.0, 1.0, 1.0);
  if (found.x) color.rgb = vec3(1.0, 0.0, 1.0);
}
)";

constexpr const char* fetch_flat = R"(
vec4 fetch_texel(ivec2 p) { return texelFetch(picture, p, 0); }
)";

// OpenGL ES 3.0 table 3.21: the axis of every face, and how s and t run on it.
constexpr const char* fetch_cube = R"(
vec4 fetch_texel(ivec2 p) {
  ivec2 face = textureSize(picture, 0);
  ivec2 cell = p / face;
  vec2 st = (vec2(p - cell * face) + 0.5) / vec2(face) * 2.0 - 1.0;
  int index = (1 - cell.y) * 3 + cell.x;
  vec3 d = index == 0 ? vec3(1.0, -st.y, -st.x) : index == 1 ? vec3(-1.0, -st.y, st.x)
         : index == 2 ? vec3(st.x, 1.0, st.y) : index == 3 ? vec3(st.x, -1.0, -st.y)
         : index == 4 ? vec3(st.x, -st.y, 1.0) : vec3(-st.x, -st.y, -1.0);
  return textureLod(picture, d, 0.0);
}
)";

glm::ivec2 shown_size(const ShownTexture& picture) {
  return picture.target == GL_TEXTURE_CUBE_MAP ? picture.size * glm::ivec2(3, 2) : picture.size;
}

}  // namespace

PixelPlace place_in(const ShownTexture& picture, glm::dvec2 point) {
  const glm::ivec2 size = shown_size(picture);
  const glm::ivec2 texel =
      glm::clamp(glm::ivec2(glm::floor(point * glm::dvec2(size))), glm::ivec2(0), size - 1);
  if (picture.target != GL_TEXTURE_CUBE_MAP) return {texel, 0};
  const glm::ivec2 cell = texel / picture.size;
  return {texel - cell * picture.size, (1 - cell.y) * 3 + cell.x};
}

Presenter::Presenter(const gl::Context& context)
    : gl_(context.functions()), vertex_array_(gl_), framebuffer_(gl_) {
  flat_ = compile("sampler2D", fetch_flat);
  cube_ = compile("samplerCube", fetch_cube);
}

Presenter::~Presenter() {
  gl_.DeleteProgram(flat_);
  gl_.DeleteProgram(cube_);
}

GLuint Presenter::compile(const char* sampler, const char* fetch) {
  const std::string text =
      std::string("#version 300 es\nprecision highp float;\nprecision highp int;\nuniform highp ") + sampler +
      " picture;\n" + fetch + fragment_text;
  const GLuint program = gl_.CreateProgram();
  for (const auto& [stage, source] : {std::pair<GLenum, const char*>{GL_VERTEX_SHADER, vertex_text},
                                      std::pair<GLenum, const char*>{GL_FRAGMENT_SHADER, text.c_str()}}) {
    const GLuint shader = gl_.CreateShader(stage);
    gl_.ShaderSource(shader, 1, &source, nullptr);
    gl_.CompileShader(shader);
    gl_.AttachShader(program, shader);
    gl_.DeleteShader(shader);
  }
  gl_.LinkProgram(program);
  GLint ok = GL_FALSE;
  gl_.GetProgramiv(program, GL_LINK_STATUS, &ok);
  if (ok != GL_TRUE)
    throw Error(ExitStatus::device, "this OpenGL can't show pictures: it refuses the window's shader");
  return program;
}

void Presenter::draw(const ShownTexture& picture, glm::ivec2 window, bool paint) {
  const bool cube = picture.target == GL_TEXTURE_CUBE_MAP;
  const GLuint program = cube ? cube_ : flat_;
  const glm::ivec2 size = shown_size(picture);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl_.Viewport(0, 0, window.x, window.y);
  gl_.UseProgram(program);
  gl_.BindVertexArray(vertex_array_.name());
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(picture.target, picture.texture);
  gl_.Uniform2i(gl_.GetUniformLocation(program, "size"), size.x, size.y);
  gl_.Uniform2i(gl_.GetUniformLocation(program, "window"), window.x, window.y);
  gl_.Uniform1i(gl_.GetUniformLocation(program, "paint"), paint ? 1 : 0);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void Presenter::clear(glm::ivec2 window) {
  constexpr std::array<GLfloat, 4> black{};
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl_.Viewport(0, 0, window.x, window.y);
  gl_.ClearBufferfv(GL_COLOR, 0, black.data());
}

glm::vec4 Presenter::pixel(const ShownTexture& picture, const PixelPlace& place) {
  glm::vec4 value(0.0F);
  const GLenum target = picture.target == GL_TEXTURE_CUBE_MAP
                            ? static_cast<GLenum>(GL_TEXTURE_CUBE_MAP_POSITIVE_X + place.face)
                            : picture.target;
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
  gl_.FramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, picture.texture, 0);
  gl_.ReadPixels(place.at.x, place.at.y, 1, 1, GL_RGBA, GL_FLOAT, &value);
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  return value;
}

}  // namespace shadertwin::view
