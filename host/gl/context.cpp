#include "host/gl/context.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "host/base/error.h"
#include "host/gl/egl_context.h"
#include "host/gl/osmesa_context.h"

namespace shadertwin::gl {

namespace {

// EGL and OSMesa share Mesa's dispatch table without knowing of each other, so neither can be asked which one
// is current.
thread_local Context* current = nullptr;

// N of "egl:N".
std::optional<int> egl_index(const std::string& name) {
  if (!name.starts_with("egl:")) return std::nullopt;
  int index = -1;
  const char* const end = name.data() + name.size();
  const auto [rest, failure] = std::from_chars(name.data() + 4, end, index);
  return failure == std::errc() && rest == end && index >= 0 ? std::optional(index) : std::nullopt;
}

}  // namespace

Context::~Context() {
  if (current == this) current = nullptr;
}

void Context::make_current() {
  if (current == this) return;
  bind();
  current = this;
}

void Context::release() {
  if (current != this) return;
  unbind();
  current = nullptr;
}

bool Context::has_extension(const std::string& name) const {
  return std::find(extensions_.begin(), extensions_.end(), name) != extensions_.end();
}

void Context::load(const std::function<void*(const char*)>& get_proc_address, std::string name,
                   bool software) {
  functions_ = load_functions(get_proc_address);
  const auto text = [this](GLenum what) {
    const auto* s = functions_.GetString(what);
    return std::string(s == nullptr ? "" : reinterpret_cast<const char*>(s));
  };
  const auto integer = [this](GLenum what) {
    GLint value = 0;
    functions_.GetIntegerv(what, &value);
    return value;
  };
  const int count = integer(GL_NUM_EXTENSIONS);
  for (int i = 0; i < count; ++i)
    extensions_.emplace_back(
        reinterpret_cast<const char*>(functions_.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i))));
  const int version = integer(GL_MAJOR_VERSION) * 10 + integer(GL_MINOR_VERSION);
  info_ = {.name = std::move(name),
           .vendor = text(GL_VENDOR),
           .renderer = text(GL_RENDERER),
           .version = text(GL_VERSION),
           .shading_language = text(GL_SHADING_LANGUAGE_VERSION),
           .software = software,
           .max_size = integer(GL_MAX_TEXTURE_SIZE),
           .compute = version >= 31 && functions_.DispatchCompute != nullptr};
}

bool is_device_name(const std::string& name) {
  return name == "auto" || name == "egl" || name == "llvmpipe" || name == "osmesa" ||
         egl_index(name).has_value();
}

std::unique_ptr<Context> open_context(const std::string& name) {
  if (!is_device_name(name))
    throw Error(ExitStatus::usage,
                name + ": unknown device (auto, egl, egl:N with N from 0, llvmpipe or osmesa)");
  if (name == "osmesa") return open_osmesa();
  if (name == "llvmpipe") return open_software_egl();
  if (name != "auto") return open_egl(egl_index(name));
  if (const char* chosen = std::getenv("SHADERTWIN_DEVICE");
      chosen != nullptr && *chosen != '\0' && std::string_view(chosen) != "auto")
    return open_context(chosen);
  try {
    return open_egl(std::nullopt);
  } catch (const Error& no_egl) {
    try {
      return open_osmesa();
    } catch (const Error& no_osmesa) {
      throw Error(ExitStatus::device, std::string("no way to run OpenGL here: ") + no_egl.what() + "; " +
                                          no_osmesa.what() +
                                          " (on Debian: apt install libegl1 libgl1-mesa-dri)");
    }
  }
}

std::vector<DeviceInfo> list_devices(std::vector<std::string>* problems) {
  std::vector<DeviceInfo> devices;
  const auto attempt = [problems](auto action) {
    try {
      action();
    } catch (const Error& e) {
      if (problems != nullptr) problems->emplace_back(e.what());
    }
  };
  int count = 0;
  attempt([&] { count = count_egl(); });
  for (int i = 0; i < count; ++i) attempt([&] { devices.push_back(open_egl(i)->info()); });
  attempt([&] { devices.push_back(open_osmesa()->info()); });
  return devices;
}

}  // namespace shadertwin::gl
