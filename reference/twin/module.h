// A compiled twin in memory.
#pragma once

#include <filesystem>
#include <memory>

#include "reference/twin/abi.h"

namespace shadertwin::twin {

class Module {
 public:
  // Throws Error(file) for what is no twin of this version.
  explicit Module(const std::filesystem::path& object);

  const Description& description() const { return description_; }
  void render(const Request& request) const { render_(&request); }

 private:
  struct Close {
    void operator()(void* handle) const;
  };
  std::unique_ptr<void, Close> handle_;
  RenderFunction render_ = nullptr;
  Description description_;
};

}  // namespace shadertwin::twin
