#include "host/view/reloader.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <utility>

#include "host/base/error.h"

namespace shadertwin::view {

namespace fs = std::filesystem;

namespace {

// Editors save in several steps, and several files at once: wait until nothing has happened for so long.
constexpr int quiet_milliseconds = 10;

void signal(int descriptor) {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = write(descriptor, &one, sizeof one);
}

}  // namespace

std::vector<fs::path> files_of(const fs::path& shader, const Project& project) {
  std::vector<fs::path> files = {shader};  // a folder stands for all in it: a tab may come
  files.insert(files.end(), project.files.begin(), project.files.end());
  for (const Pass& pass : project.passes)
    for (const Input& input : pass.inputs) files.insert(files.end(), input.files.begin(), input.files.end());
  return files;
}

Reloader::Reloader(Load load, const fs::path& shader, const Project& project, FileWatch::Stamp read)
    : load_(std::move(load)), wake_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)), shader_(shader) {
  watch_.set_files(files_of(shader, project), read);
  thread_ = std::thread([this] { work(); });
}

Reloader::~Reloader() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  signal(wake_);
  thread_.join();
  close(wake_);
}

void Reloader::open(const fs::path& shader) {
  {
    const std::lock_guard lock(mutex_);
    wanted_ = shader;
  }
  signal(wake_);
}

std::optional<Reloader::Result> Reloader::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(result_, std::nullopt);
}

void Reloader::work() {
  std::array<pollfd, 2> sources = {{{watch_.descriptor(), POLLIN, 0}, {wake_, POLLIN, 0}}};
  for (;;) {
    poll(sources.data(), sources.size(), watch_.missed() ? 0 : -1);
    const Clock::time_point since = Clock::now();
    std::optional<fs::path> wanted;
    {
      const std::lock_guard lock(mutex_);
      if (stop_) return;
      wanted = std::exchange(wanted_, std::nullopt);
    }
    std::uint64_t count = 0;
    [[maybe_unused]] const ssize_t drained = read(wake_, &count, sizeof count);
    // What would mend a broken project may be a file that it does not know of yet.
    bool changed = watch_.changed(broken_);
    if (wanted.has_value()) {
      load(*wanted, since);
    } else if (changed) {
      while (poll(sources.data(), 1, quiet_milliseconds) > 0) watch_.changed();
      load(shader_, since);
    }
  }
}

void Reloader::load(const fs::path& shader, Clock::time_point since) {
  {
    // A result that nobody took holds a context of the window, which this load needs.
    const std::lock_guard lock(mutex_);
    result_.reset();
  }
  Result result;
  result.shader = shader;
  result.since = since;
  const FileWatch::Stamp read = FileWatch::now();
  try {
    result.loaded = load_(shader);
    shader_ = shader;
    broken_ = false;
    watch_.set_files(files_of(shader, result.loaded->project), read);
  } catch (const std::exception& e) {
    result.problem = e.what();
    if (shader == shader_) broken_ = true;
  }
  {
    const std::lock_guard lock(mutex_);
    result_ = std::move(result);
  }
  Window::wake();
}

}  // namespace shadertwin::view
