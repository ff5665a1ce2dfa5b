// A shared library that is opened at run time, so that the program starts on machines that lack it.
#pragma once

#include <dlfcn.h>

#include <string>

#include "host/base/error.h"

namespace shadertwin::gl {

// Never closed: drivers keep threads and exit handlers of their own, and unloading them crashes.
class Library {
 public:
  // Throws Error(device).
  explicit Library(const char* name) : handle_(dlopen(name, RTLD_NOW | RTLD_LOCAL)) {
    if (handle_ == nullptr) throw Error(ExitStatus::device, std::string(name) + " can't be loaded");
  }

  template <typename Function>
  Function get(const char* name) const {
    return reinterpret_cast<Function>(dlsym(handle_, name));
  }

 private:
  void* handle_;
};

}  // namespace shadertwin::gl
