#include "host/view/recorder.h"

#include <cstdio>
#include <utility>

#include "host/base/error.h"

namespace shadertwin::view {

namespace {

constexpr std::size_t longest_queue = 8;

}  // namespace

Recorder::Recorder(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::error_code failure;
  std::filesystem::create_directories(folder_, failure);
  if (failure) throw Error(ExitStatus::file, folder_.string() + ": " + failure.message());
  thread_ = std::thread([this] { work(); });
}

Recorder::~Recorder() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Recorder::add(Image image) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return queue_.size() < longest_queue || !problem_.empty(); });
  if (!problem_.empty()) throw Error(ExitStatus::file, problem_);
  queue_.push_back(std::move(image));
  ++frames_;
  changed_.notify_all();
}

void Recorder::work() {
  for (int index = 0;; ++index) {
    Image image;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return stop_ || !queue_.empty(); });
      if (queue_.empty()) return;
      image = std::move(queue_.front());
      queue_.pop_front();
    }
    changed_.notify_all();
    try {
      char name[32];
      std::snprintf(name, sizeof name, "frame_%04d.png", index);
      write_image(image, folder_ / name);
    } catch (const std::exception& e) {
      const std::lock_guard lock(mutex_);
      problem_ = e.what();
      queue_.clear();
      changed_.notify_all();
      return;
    }
  }
}

}  // namespace shadertwin::view
