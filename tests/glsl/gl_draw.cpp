#include "tests/glsl/gl_draw.h"

#include <stdexcept>

#include "host/text/define_undefined.h"
#include "host/text/render.h"
#include "host/text/resolve_macros.h"

namespace shadertwin::glsl {

namespace {

const char* const vertex_shader = R"(#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); })";

// With everything defined that GLSL leaves undefined, as players have it.
std::string fragment_shader(const std::string& shader) {
  PassSource source;
  source.body = shader;
  source.tail = "void main() { mainImage(shadertoy_out_color, gl_FragCoord.xy); }\n";
  Project project;
  resolve_macros(project, source, ShaderStage::fragment);
  return render(define_undefined(project, source).value());
}

void attach(const gl::Functions& gl, GLuint program, GLenum kind, const std::string& source) {
  const GLuint shader = gl.CreateShader(kind);
  const char* text = source.c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint compiled = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == 0) {
    char log[4096];
    gl.GetShaderInfoLog(shader, sizeof log, nullptr, log);
    throw std::runtime_error(source + "\n" + log);
  }
  gl.AttachShader(program, shader);
  gl.DeleteShader(shader);
}

}  // namespace

GlDraw::GlDraw(const std::string& device) : context_(gl::open_context(device)) {
  context_->make_current();
}

void GlDraw::bind(const Texture& texture, const shadertwin::Sampler& sampler, bool mipmaps) {
  context_->make_current();
  const gl::Functions& gl = context_->functions();
  gl.ActiveTexture(GL_TEXTURE0);
  target_ = gl::texture_target(texture);
  texture_ = gl::upload(gl, texture, mipmaps);
  sampler_ = gl::make_sampler(gl, sampler);
}

Image GlDraw::operator()(const std::string& shader, int width, int height) {
  context_->make_current();
  const gl::Functions& gl = context_->functions();
  const GLuint program = gl.CreateProgram();
  attach(gl, program, GL_VERTEX_SHADER, vertex_shader);
  attach(gl, program, GL_FRAGMENT_SHADER, fragment_shader(shader));
  gl.LinkProgram(program);

  const gl::VertexArrayObject vertices(gl);
  const gl::FramebufferObject framebuffer(gl);
  gl.ActiveTexture(GL_TEXTURE1);
  const gl::TextureObject drawn = gl::make_target(gl, GL_TEXTURE_2D, {width, height}, false);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, drawn.name(), 0);
  gl.Viewport(0, 0, width, height);
  gl.BindVertexArray(vertices.name());
  gl.ActiveTexture(GL_TEXTURE0);
  if (texture_.name() != 0) {
    gl.BindTexture(target_, texture_.name());
    gl.BindSampler(0, sampler_.name());
  }
  gl.UseProgram(program);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  Image image(width, height);
  gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, image.rgba.data());
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.DeleteProgram(program);
  return image;
}

}  // namespace shadertwin::glsl
