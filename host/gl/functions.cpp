#include "host/gl/functions.h"

namespace shadertwin::gl {

Functions load_functions(const std::function<void*(const char*)>& get_proc_address) {
  Functions f;
#define SHADERTWIN_GL_LOAD(name, upper) \
  f.name = reinterpret_cast<PFNGL##upper##PROC>(get_proc_address("gl" #name));
  SHADERTWIN_GL_FUNCTIONS(SHADERTWIN_GL_LOAD)
#undef SHADERTWIN_GL_LOAD
  return f;
}

}  // namespace shadertwin::gl
