#include "reference/twin/module.h"

#include <dlfcn.h>

#include <boost/context/fiber.hpp>
#include <boost/context/protected_fixedsize_stack.hpp>
#include <utility>

#include "host/base/error.h"

namespace shadertwin::twin {
namespace {

// What every thread has.
constexpr std::size_t small_stack = std::size_t{1} << 20;

}  // namespace

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

// Compilers keep several copies of a value, one for each place where a function is inlined.
std::size_t Module::stack_bytes() const {
  return 4 * description_.value_bytes + small_stack / 4;
}

void Module::render(const Request& request) const {
  if (stack_bytes() <= small_stack) return render_(&request);
  using boost::context::fiber;
  const auto draw = [&](fiber&& caller) {
    render_(&request);
    return std::move(caller);
  };
  // Pages that are never touched cost nothing.
  fiber(std::allocator_arg, boost::context::protected_fixedsize_stack(stack_bytes()), draw).resume();
}

}  // namespace shadertwin::twin
