#include "host/view/capture.h"

#include <cstdio>
#include <filesystem>
#include <utility>

namespace shadertwin::view {

std::string Capture::free_name(const std::string& base) const {
  for (int i = 1;; ++i) {
    char number[16];
    std::snprintf(number, sizeof number, "_%04d", i);
    const std::string name = base + number;
    using std::filesystem::exists;
    if (!exists(name) && !exists(name + ".png") && !exists(name + ".exr")) return name;
  }
}

std::string Capture::screenshot(const Image& image) const {
  const std::string name = free_name(base_);
  write_image(image, name + ".png");
  write_image(image, name + ".exr");
  return name;
}

void Capture::start() {
  recorder_.emplace(free_name(base_ + "_recording"));
}

void Capture::add(Image image) {
  recorder_->add(std::move(image));
}

std::string Capture::stop() {
  const std::string text =
      recorder_->folder().string() + ": " + std::to_string(recorder_->frames()) + " frames";
  recorder_.reset();
  return text;
}

}  // namespace shadertwin::view
