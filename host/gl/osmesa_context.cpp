#include "host/gl/osmesa_context.h"

#include <GL/osmesa.h>

#include <array>
#include <cstdint>

#include "host/gl/library.h"

namespace shadertwin::gl {

namespace {

class OsmesaContext final : public Context {
 public:
  OsmesaContext()
      : library_("libOSMesa.so.8"),
        create_(library_.get<decltype(&OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs")),
        destroy_(library_.get<decltype(&OSMesaDestroyContext)>("OSMesaDestroyContext")),
        make_current_(library_.get<decltype(&OSMesaMakeCurrent)>("OSMesaMakeCurrent")),
        get_proc_address_(library_.get<decltype(&OSMesaGetProcAddress)>("OSMesaGetProcAddress")) {
    const std::array attributes = {OSMESA_FORMAT,
                                   OSMESA_RGBA,
                                   OSMESA_PROFILE,
                                   OSMESA_CORE_PROFILE,
                                   OSMESA_CONTEXT_MAJOR_VERSION,
                                   4,
                                   OSMESA_CONTEXT_MINOR_VERSION,
                                   5,
                                   0};
    context_ = create_(attributes.data(), nullptr);
    if (context_ == nullptr) throw Error(ExitStatus::device, "OSMesa gives no OpenGL 4.5 context");
    make_current();
    load([this](const char* name) { return reinterpret_cast<void*>(get_proc_address_(name)); }, "osmesa",
         true);
  }
  ~OsmesaContext() override { destroy_(context_); }

 private:
  void bind() override {
    if (make_current_(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) == 0)
      throw Error(ExitStatus::device, "OSMesa's context can't be made current");
  }

  void unbind() override { make_current_(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }

  Library library_;
  decltype(&OSMesaCreateContextAttribs) create_;
  decltype(&OSMesaDestroyContext) destroy_;
  decltype(&OSMesaMakeCurrent) make_current_;
  decltype(&OSMesaGetProcAddress) get_proc_address_;
  OSMesaContext context_ = nullptr;
  std::array<std::uint32_t, 1>
      pixel_{};  // the window that OSMesa asks for; all drawing goes to framebuffer objects
};

}  // namespace

std::unique_ptr<Context> open_osmesa() {
  return std::make_unique<OsmesaContext>();
}

}  // namespace shadertwin::gl
