#include "host/gl/osmesa_context.h"

#include <array>
#include <cstdint>

#include "host/gl/library.h"

namespace shadertwin::gl {

namespace {

// What the library's own header says, which Mesa has no more from version 25.1 on.
using OsmesaHandle = struct osmesa_context*;
constexpr int osmesa_format = 0x22;
constexpr int osmesa_profile = 0x33;
constexpr int osmesa_core_profile = 0x34;
constexpr int osmesa_context_major_version = 0x36;
constexpr int osmesa_context_minor_version = 0x37;

class OsmesaContext final : public Context {
 public:
  OsmesaContext()
      : library_("libOSMesa.so.8"),
        create_(library_.get<decltype(create_)>("OSMesaCreateContextAttribs")),
        destroy_(library_.get<decltype(destroy_)>("OSMesaDestroyContext")),
        make_current_(library_.get<decltype(make_current_)>("OSMesaMakeCurrent")),
        get_proc_address_(library_.get<decltype(get_proc_address_)>("OSMesaGetProcAddress")) {
    const std::array attributes = {osmesa_format,
                                   GL_RGBA,
                                   osmesa_profile,
                                   osmesa_core_profile,
                                   osmesa_context_major_version,
                                   4,
                                   osmesa_context_minor_version,
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
  OsmesaHandle (*create_)(const int* attributes, OsmesaHandle share);
  void (*destroy_)(OsmesaHandle context);
  GLboolean (*make_current_)(OsmesaHandle context, void* pixels, GLenum type, GLsizei width, GLsizei height);
  void (*(*get_proc_address_)(const char* name))();
  OsmesaHandle context_ = nullptr;
  std::array<std::uint32_t, 1>
      pixel_{};  // the window that OSMesa asks for; all drawing goes to framebuffer objects
};

}  // namespace

std::unique_ptr<Context> open_osmesa() {
  return std::make_unique<OsmesaContext>();
}

}  // namespace shadertwin::gl
