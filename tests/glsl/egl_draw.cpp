#include "tests/glsl/egl_draw.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl32.h>

#include <stdexcept>

namespace shadertwin::glsl {

namespace {

const char* const vertex_shader = R"(#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); })";

void attach(GLuint program, GLenum kind, const std::string& source) {
  const GLuint shader = glCreateShader(kind);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == 0) {
    char log[4096];
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    throw std::runtime_error(source + "\n" + log);
  }
  glAttachShader(program, shader);
  glDeleteShader(shader);
}

}  // namespace

Draw egl_draw() {
  const EGLDisplay display =
      eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  eglInitialize(display, nullptr, nullptr);
  eglBindAPI(EGL_OPENGL_ES_API);
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2, EGL_NONE};
  const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
    throw std::runtime_error("no surfaceless OpenGL ES 3.2 context");
  }
  return [](const std::string& shader, int width, int height) {
    const GLuint program = glCreateProgram();
    attach(program, GL_VERTEX_SHADER, vertex_shader);
    attach(program, GL_FRAGMENT_SHADER,
           "#version 300 es\nprecision highp float;\nprecision highp int;\nout vec4 color;\n" + shader +
               "void main() { mainImage(color, gl_FragCoord.xy); }\n");
    glLinkProgram(program);

    GLuint texture = 0;
    GLuint framebuffer = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, width, height);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glViewport(0, 0, width, height);
    glUseProgram(program);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    Image image(width, height);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, image.rgba.data());
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
    glDeleteProgram(program);
    return image;
  };
}

}  // namespace shadertwin::glsl
