#include "host/gl/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "host/gl/library.h"

namespace shadertwin::gl {

namespace {

// The entry points of libEGL that are used here.
struct Egl {
  Library library{"libEGL.so.1"};
#define SHADERTWIN_EGL(name) decltype(&::name) name = library.get<decltype(&::name)>(#name)
  SHADERTWIN_EGL(eglBindAPI);
  SHADERTWIN_EGL(eglCreateContext);
  SHADERTWIN_EGL(eglDestroyContext);
  SHADERTWIN_EGL(eglGetProcAddress);
  SHADERTWIN_EGL(eglInitialize);
  SHADERTWIN_EGL(eglMakeCurrent);
#undef SHADERTWIN_EGL

  template <typename Function>
  Function extension(const char* name) const {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
  }
};

struct Platform {
  EGLDeviceEXT device = nullptr;  // null: Mesa's surfaceless platform
  bool software = true;
};

std::vector<Platform> platforms(const Egl& egl) {
  std::vector<Platform> found;
  const auto query_devices = egl.extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  const auto query_string = egl.extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  std::array<EGLDeviceEXT, 64> devices{};
  EGLint count = 0;
  if (query_devices != nullptr && query_string != nullptr &&
      query_devices(devices.size(), devices.data(), &count) == EGL_TRUE)
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const char* extensions = query_string(devices[i], EGL_EXTENSIONS);
      const bool software =
          extensions != nullptr &&
          std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos;
      found.push_back({devices[i], software});
    }
  if (found.empty()) found.push_back({});
  return found;
}

class EglContext final : public Context {
 public:
  EglContext(std::shared_ptr<const Egl> egl, const Platform& platform, int index) : egl_(std::move(egl)) {
    const std::string name = "egl:" + std::to_string(index);
    const auto get_display = egl_->extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    if (get_display == nullptr)
      throw Error(ExitStatus::device, name + ": this EGL library has no platform displays");
    display_ = platform.device != nullptr
                   ? get_display(EGL_PLATFORM_DEVICE_EXT, platform.device, nullptr)
                   : get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || egl_->eglInitialize(display_, nullptr, nullptr) != EGL_TRUE)
      throw Error(ExitStatus::device, name + ": EGL can't open the device");
    egl_->eglBindAPI(EGL_OPENGL_ES_API);
    for (const EGLint minor : {2, 1, 0}) {
      const std::array<EGLint, 5> attributes = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION,
                                                minor, EGL_NONE};
      context_ = egl_->eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
      if (context_ != EGL_NO_CONTEXT) break;
    }
    if (context_ == EGL_NO_CONTEXT) throw Error(ExitStatus::device, name + ": no OpenGL ES 3 context");
    make_current();
    load([this](const char* function) { return reinterpret_cast<void*>(egl_->eglGetProcAddress(function)); },
         name, platform.software);
  }

  ~EglContext() override {
    // The display is not terminated: EGL hands the same one to every context of a device.
    egl_->eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl_->eglDestroyContext(display_, context_);
  }

 private:
  void bind() override {
    egl_->eglBindAPI(EGL_OPENGL_ES_API);
    // Another library (OSMesa) may have taken the thread over without EGL's knowledge; EGL then ignores a
    // call that names the context it still believes in.
    egl_->eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (egl_->eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE)
      throw Error(ExitStatus::device, "the EGL context can't be made current");
  }

  void unbind() override { egl_->eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

  std::shared_ptr<const Egl> egl_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

int count_egl() {
  return static_cast<int>(platforms(Egl()).size());
}

std::unique_ptr<Context> open_egl(std::optional<int> index) {
  const auto egl = std::make_shared<const Egl>();
  const auto found = platforms(*egl);
  const int count = static_cast<int>(found.size());
  if (index.has_value()) {
    if (*index >= count)
      throw Error(ExitStatus::device,
                  "egl:" + std::to_string(*index) +
                      ": the EGL devices here are egl:0 to egl:" + std::to_string(count - 1));
    return std::make_unique<EglContext>(egl, found[static_cast<std::size_t>(*index)], *index);
  }
  std::string problem;
  for (const bool software : {false, true})
    for (int i = 0; i < count; ++i) {
      const Platform& platform = found[static_cast<std::size_t>(i)];
      if (platform.software != software) continue;
      try {
        return std::make_unique<EglContext>(egl, platform, i);
      } catch (const Error& e) {
        if (problem.empty()) problem = e.what();
      }
    }
  throw Error(ExitStatus::device, problem);
}

std::unique_ptr<Context> open_software_egl() {
  const auto egl = std::make_shared<const Egl>();
  const auto found = platforms(*egl);
  const auto software =
      std::find_if(found.begin(), found.end(), [](const Platform& p) { return p.software; });
  if (software == found.end())
    throw Error(ExitStatus::device, "llvmpipe: no EGL device here draws on the processor");
  return std::make_unique<EglContext>(egl, *software, static_cast<int>(software - found.begin()));
}

}  // namespace shadertwin::gl
