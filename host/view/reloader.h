// Loads projects in the background, and again whenever a file they use is saved.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "host/project/project.h"
#include "host/view/file_watch.h"
#include "host/view/stage.h"

namespace shadertwin::view {

struct Loaded {
  Project project;
  std::unique_ptr<Stage> stage;
};

// Throws Error.
using Load = std::function<Loaded(const std::filesystem::path& shader)>;

// Every file that a project is made from.
std::vector<std::filesystem::path> files_of(const std::filesystem::path& shader, const Project& project);

class Reloader {
 public:
  using Clock = std::chrono::steady_clock;

  struct Result {
    std::filesystem::path shader;
    std::optional<Loaded> loaded;  // or else
    std::string problem;           // what the user reads
    Clock::time_point since;       // when the change was noticed
  };

  // Watches the files of `project`, which the window shows already; `read` is when reading them began.
  Reloader(Load load, const std::filesystem::path& shader, const Project& project, FileWatch::Stamp read);
  ~Reloader();
  Reloader(const Reloader&) = delete;
  Reloader& operator=(const Reloader&) = delete;

  // Loads another shader. If that fails, the old one stays.
  void open(const std::filesystem::path& shader);
  // What was loaded since the last call. Window::wake() ends the wait for it.
  std::optional<Result> take();

 private:
  void work();
  void load(const std::filesystem::path& shader, Clock::time_point since);

  Load load_;
  FileWatch watch_;
  int wake_ = -1;  // an eventfd
  std::mutex mutex_;
  bool stop_ = false;
  std::optional<std::filesystem::path> wanted_;
  std::optional<Result> result_;
  std::filesystem::path shader_;
  bool broken_ = false;
  std::thread thread_;
};

}  // namespace shadertwin::view
