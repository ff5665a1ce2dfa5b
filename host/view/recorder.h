// Writes every frame as a numbered PNG, in a thread of its own.
#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>

#include "host/image/image.h"

namespace shadertwin::view {

class Recorder {
 public:
  // Makes the folder. Throws Error(file).
  explicit Recorder(std::filesystem::path folder);
  // Waits until all is written.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // Waits while too many pictures wait to be written. Throws Error(file) if an earlier one could not be.
  void add(Image image);
  int frames() const { return frames_; }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  void work();

  std::filesystem::path folder_;
  int frames_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Image> queue_;
  bool stop_ = false;
  std::string problem_;
  std::thread thread_;
};

}  // namespace shadertwin::view
