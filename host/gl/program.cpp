#include "host/gl/program.h"

#include <string_view>
#include <utility>

#include "host/base/error.h"
#include "host/project/compute_text.h"

namespace shadertwin::gl {

namespace {

constexpr const char* vertex_text = R"(
void main() {
  gl_Position = vec4(vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0, 0.0, 1.0);
}
)";

constexpr std::string_view usual_version = "#version 300 es";

// Both stages of a program have to name the same version.
std::string vertex_text_for(const Pass& pass, const std::string& fragment_text) {
  const std::string first_line = fragment_text.substr(0, fragment_text.find('\n'));
  const std::string version(first_line.starts_with("#version") ? first_line : usual_version);
  if (!pass.vertex.has_value()) return version + vertex_text;
  return version + pass.vertex->text().substr(usual_version.size());
}

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

void compile(const Shader& shader, const Project& project, const Pass& pass, const PassSource& source,
             int first_line) {
  if (shader.compiled()) return;
  const std::string log = shader.log();
  throw Error(ExitStatus::shader, log.empty()
                                      ? pass.name + ": error: the driver refuses the shader without a reason"
                                      : trimmed(map_log(project, source, log, first_line)));
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

Program Program::fragment(const Functions& gl, const Project& project, const Pass& pass) {
  const std::string vertex_source = vertex_text_for(pass, pass.source.text());
  const Shader vertex(gl, GL_VERTEX_SHADER, vertex_source);
  if (pass.vertex.has_value())
    compile(vertex, project, pass, *pass.vertex, 1);
  else if (!vertex.compiled())
    throw Error(ExitStatus::device, "this OpenGL does not take `" +
                                        vertex_source.substr(0, vertex_source.find('\n')) +
                                        "` shaders: " + vertex.log());
  const Shader fragment(gl, GL_FRAGMENT_SHADER, pass.source.text());
  compile(fragment, project, pass, pass.source, 1);
  Program program(gl);
  gl.AttachShader(program.name_, vertex.name());
  gl.AttachShader(program.name_, fragment.name());
  link(gl, program.name_, pass);
  return program;
}

Program Program::compute(const Functions& gl, const Project& project, const Pass& pass) {
  const Shader shader(gl, GL_COMPUTE_SHADER, compute_text(project, pass, group_size, group_size));
  compile(shader, project, pass, pass.source, compute_first_line);
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
