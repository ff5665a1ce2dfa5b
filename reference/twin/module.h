// A compiled twin in memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "reference/twin/abi.h"

namespace shadertwin::twin {

class Module {
 public:
  // Throws Error(file) for what is no twin of this version.
  explicit Module(const std::filesystem::path& object);

  const Description& description() const { return description_; }
  // Draws, on a stack that is large enough for the shader's variables.
  void render(const Request& request) const;
  // What one invocation may need.
  std::size_t stack_bytes() const;

 private:
  struct Close {
    void operator()(void* handle) const;
  };
  std::unique_ptr<void, Close> handle_;
  RenderFunction render_ = nullptr;
  Description description_;
};

}  // namespace shadertwin::twin
