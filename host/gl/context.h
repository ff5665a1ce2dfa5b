// Headless OpenGL contexts: EGL (any GPU or llvmpipe, no display needed) and OSMesa (software, no EGL
// needed).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/gl/functions.h"

namespace shadertwin::gl {

// What a context says of itself.
struct DeviceInfo {
  std::string name;  // as the command line takes it: "egl:0", "osmesa"
  std::string vendor;
  std::string renderer;
  std::string version;
  std::string shading_language;
  bool software = false;
  int max_size = 0;      // largest width and height of a target
  bool compute = false;  // runs compute shaders that write images
};

class Context {
 public:
  virtual ~Context();
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // Makes this the calling thread's context; costs nothing if it is already. Every use of functions() needs
  // it.
  void make_current();
  // Leaves the calling thread without this context, so that another thread may make it current.
  void release();
  const Functions& functions() const { return functions_; }
  const DeviceInfo& info() const { return info_; }
  bool has_extension(const std::string& name) const;

 protected:
  // To be called by a derived class once its context is current.
  void load(const std::function<void*(const char*)>& get_proc_address, std::string name, bool software);
  virtual void bind() = 0;
  virtual void unbind() = 0;

 private:
  Functions functions_;
  DeviceInfo info_;
  std::vector<std::string> extensions_;
};

// Opens the device that the user calls `name`: "auto", "egl", "egl:N", "llvmpipe" or "osmesa". auto is the
// device that the environment variable SHADERTWIN_DEVICE names; without it, auto and egl prefer hardware, and
// auto falls back to OSMesa. llvmpipe is the EGL device that draws on the processor, also where there is a
// GPU. Throws Error(device) if it can't be had, Error(usage) for an unknown name.
std::unique_ptr<Context> open_context(const std::string& name);
// Whether open_context() knows the name; the device need not be there.
bool is_device_name(const std::string& name);

// What this machine can run on, in the order of the numbers N of "egl:N", OSMesa last. Devices that don't
// open are left out; `problems` (if given) gets one line for each of them.
std::vector<DeviceInfo> list_devices(std::vector<std::string>* problems = nullptr);

}  // namespace shadertwin::gl
