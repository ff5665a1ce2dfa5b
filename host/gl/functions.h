// The OpenGL ES functions that the host calls, loaded from one context's own GetProcAddress. Debian's loaders
// (libepoxy, glbinding 2) find functions through the process' GLX or EGL and fail on OSMesa.
#pragma once

#define GL_GLES_PROTOTYPES 0
#include <GLES3/gl32.h>
// The order matters: gl2ext.h needs the types of gl32.h.
#include <GLES2/gl2ext.h>

#include <functional>

namespace shadertwin::gl {

// clang-format off
#define SHADERTWIN_GL_FUNCTIONS(X) \
  X(ActiveTexture, ACTIVETEXTURE) X(AttachShader, ATTACHSHADER) X(BeginQuery, BEGINQUERY) \
  X(BindFramebuffer, BINDFRAMEBUFFER) X(BindImageTexture, BINDIMAGETEXTURE) \
  X(BindSampler, BINDSAMPLER) X(BindTexture, BINDTEXTURE) X(BindVertexArray, BINDVERTEXARRAY) \
  X(BlitFramebuffer, BLITFRAMEBUFFER) X(CheckFramebufferStatus, CHECKFRAMEBUFFERSTATUS) \
  X(ClearBufferfv, CLEARBUFFERFV) X(DeleteSync, DELETESYNC) X(FenceSync, FENCESYNC) X(CompileShader, COMPILESHADER) X(CreateProgram, CREATEPROGRAM) \
  X(CreateShader, CREATESHADER) X(DeleteFramebuffers, DELETEFRAMEBUFFERS) \
  X(DeleteProgram, DELETEPROGRAM) X(DeleteQueries, DELETEQUERIES) X(DeleteSamplers, DELETESAMPLERS) \
  X(DeleteShader, DELETESHADER) X(DeleteTextures, DELETETEXTURES) X(DeleteVertexArrays, DELETEVERTEXARRAYS) \
  X(Disable, DISABLE) X(Enable, ENABLE) X(DispatchCompute, DISPATCHCOMPUTE) X(DrawArrays, DRAWARRAYS) X(EndQuery, ENDQUERY) \
  X(Finish, FINISH) X(Flush, FLUSH) X(FramebufferTexture2D, FRAMEBUFFERTEXTURE2D) \
  X(GenerateMipmap, GENERATEMIPMAP) X(GenFramebuffers, GENFRAMEBUFFERS) X(GenQueries, GENQUERIES) \
  X(GenSamplers, GENSAMPLERS) X(GenTextures, GENTEXTURES) X(GenVertexArrays, GENVERTEXARRAYS) \
  X(GetError, GETERROR) X(GetIntegerv, GETINTEGERV) X(GetProgramInfoLog, GETPROGRAMINFOLOG) \
  X(GetProgramiv, GETPROGRAMIV) X(GetQueryObjectuiv, GETQUERYOBJECTUIV) X(GetQueryObjectui64vEXT, GETQUERYOBJECTUI64VEXT) X(WaitSync, WAITSYNC) \
  X(GetShaderInfoLog, GETSHADERINFOLOG) X(GetShaderiv, GETSHADERIV) X(GetString, GETSTRING) \
  X(GetStringi, GETSTRINGI) X(GetUniformLocation, GETUNIFORMLOCATION) X(LinkProgram, LINKPROGRAM) \
  X(MemoryBarrier, MEMORYBARRIER) X(PixelStorei, PIXELSTOREI) X(ReadPixels, READPIXELS) \
  X(SamplerParameteri, SAMPLERPARAMETERI) X(ShaderSource, SHADERSOURCE) X(TexParameteri, TEXPARAMETERI) \
  X(TexStorage2D, TEXSTORAGE2D) X(TexStorage3D, TEXSTORAGE3D) X(TexSubImage2D, TEXSUBIMAGE2D) \
  X(TexSubImage3D, TEXSUBIMAGE3D) X(Uniform1fv, UNIFORM1FV) X(Uniform1i, UNIFORM1I) \
  X(Uniform1iv, UNIFORM1IV) X(Uniform2fv, UNIFORM2FV) X(Uniform2i, UNIFORM2I) X(Uniform2iv, UNIFORM2IV) \
  X(Uniform3fv, UNIFORM3FV) X(Uniform3iv, UNIFORM3IV) X(Uniform4fv, UNIFORM4FV) X(Uniform4iv, UNIFORM4IV) \
  X(UniformMatrix4fv, UNIFORMMATRIX4FV) X(UseProgram, USEPROGRAM) X(Viewport, VIEWPORT)
// clang-format on

struct Functions {
#define SHADERTWIN_GL_MEMBER(name, upper) PFNGL##upper##PROC name = nullptr;
  SHADERTWIN_GL_FUNCTIONS(SHADERTWIN_GL_MEMBER)
#undef SHADERTWIN_GL_MEMBER
};

// Functions that a context lacks (compute on OpenGL ES 3.0) stay null.
Functions load_functions(const std::function<void*(const char*)>& get_proc_address);

}  // namespace shadertwin::gl
