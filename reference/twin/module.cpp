#include "reference/twin/module.h"

#include <dlfcn.h>

#include "host/base/error.h"

namespace shadertwin::twin {

void Module::Close::operator()(void* handle) const {
  dlclose(handle);
}

Module::Module(const std::filesystem::path& object) : handle_(dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (!handle_) throw Error(ExitStatus::file, object.string() + ": can't be loaded: " + dlerror());
  const auto describe = reinterpret_cast<DescribeFunction>(dlsym(handle_.get(), describe_name));
  render_ = reinterpret_cast<RenderFunction>(dlsym(handle_.get(), render_name));
  if (describe == nullptr || render_ == nullptr)
    throw Error(ExitStatus::file, object.string() + ": is no twin");
  describe(&description_);
  if (description_.abi != abi_version)
    throw Error(ExitStatus::file, object.string() + ": was compiled by another version");
}

}  // namespace shadertwin::twin
