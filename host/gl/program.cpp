#include "host/gl/program.h"

#include <utility>

#include "host/base/error.h"
#include "host/text/map_log.h"
#include "host/text/render.h"

namespace shadertwin::gl {

namespace {

// A triangle that covers the target.
constexpr const char* covering_triangle = R"(
void main() {
  gl_Position = vec4(vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0, 0.0, 1.0);
}
)";

std::string trimmed(std::string log) {
  while (!log.empty() && (log.back() == '\n' || log.back() == '\0' || log.back() == ' ')) log.pop_back();
  return log;
}

// Deletes the shader at the end of the scope; GL keeps it as long as a program holds it.
class Shader {
 public:
  Shader(const Functions& gl, GLenum stage, const std::string& text)
      : gl_(gl), name_(gl.CreateShader(stage)) {
    const char* data = text.c_str();
    gl.ShaderSource(name_, 1, &data, nullptr);
    gl.CompileShader(name_);
  }
  ~Shader() { gl_.DeleteShader(name_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;

  GLuint name() const { return name_; }
  bool compiled() const {
    GLint ok = GL_FALSE;
    gl_.GetShaderiv(name_, GL_COMPILE_STATUS, &ok);
    return ok == GL_TRUE;
  }
  std::string log() const {
    GLint length = 0;
    gl_.GetShaderiv(name_, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(length), '\0');
    if (length > 0) gl_.GetShaderInfoLog(name_, length, nullptr, text.data());
    return trimmed(text);
  }

 private:
  const Functions& gl_;
  GLuint name_;
};

void compile(const Shader& shader, const Project& project, const Pass& pass, const PassSource& source) {
  if (shader.compiled()) return;
  const std::string log = shader.log();
  throw Error(ExitStatus::shader, log.empty()
                                      ? pass.name + ": error: the driver refuses the shader without a reason"
                                      : trimmed(map_log(project, source, log)));
}

void link(const Functions& gl, GLuint program, const Pass& pass) {
  gl.LinkProgram(program);
  GLint ok = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &ok);
  if (ok == GL_TRUE) return;
  GLint length = 0;
  gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  if (length > 0) gl.GetProgramInfoLog(program, length, nullptr, log.data());
  throw Error(ExitStatus::shader, pass.name + ": error: the program does not link: " + trimmed(log));
}

}  // namespace

Program Program::fragment(const Functions& gl, const Project& project, const Pass& pass,
                          const PassSource& source) {
  PassSource vertex_source;
  vertex_source.tail = covering_triangle;
  if (pass.vertex.has_value()) vertex_source = *pass.vertex;
  vertex_source.precise = source.precise;  // both stages of a program have to name the same version
  const Shader vertex(gl, GL_VERTEX_SHADER, render(vertex_source, ShaderStage::vertex));
  if (pass.vertex.has_value())
    compile(vertex, project, pass, *pass.vertex);
  else if (!vertex.compiled())
    throw Error(ExitStatus::device, std::string("this OpenGL does not take GLSL ES ") +
                                        (source.precise ? "3.20: " : "3.00: ") + vertex.log());
  const Shader fragment(gl, GL_FRAGMENT_SHADER, render(source));
  compile(fragment, project, pass, source);
  Program program(gl);
  gl.AttachShader(program.name_, vertex.name());
  gl.AttachShader(program.name_, fragment.name());
  link(gl, program.name_, pass);
  return program;
}

Program Program::compute(const Functions& gl, const Project& project, const Pass& pass,
                         const PassSource& source) {
  const Shader shader(gl, GL_COMPUTE_SHADER, render(source, ShaderStage::compute));
  compile(shader, project, pass, source);
  Program program(gl);
  gl.AttachShader(program.name_, shader.name());
  link(gl, program.name_, pass);
  return program;
}

Program::~Program() {
  if (name_ != 0) gl_->DeleteProgram(name_);
}

Program::Program(Program&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}

Program& Program::operator=(Program&& other) noexcept {
  std::swap(gl_, other.gl_);
  std::swap(name_, other.name_);
  return *this;
}

}  // namespace shadertwin::gl
