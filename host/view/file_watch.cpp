#include "host/view/file_watch.h"

#include <sys/inotify.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <utility>

#include "host/base/error.h"

namespace shadertwin::view {

namespace fs = std::filesystem;

namespace {

FileWatch::Stamp stamp_of(const timespec& time) {
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

// By ctime: a file that is moved into another's place keeps its mtime.
bool saved_since(const fs::path& file, FileWatch::Stamp read) {
  struct stat status;
  return stat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode) && stamp_of(status.st_ctim) >= read;
}

bool any_saved_since(const fs::path& folder, FileWatch::Stamp read) {
  std::error_code ignored;
  for (fs::directory_iterator it(folder, ignored), end; !ignored && it != end; it.increment(ignored))
    if (saved_since(it->path(), read)) return true;
  return false;
}

}  // namespace

FileWatch::Stamp FileWatch::now() {
  timespec time;
  clock_gettime(CLOCK_REALTIME_COARSE, &time);  // the one that the kernel stamps files by
  return stamp_of(time);
}

FileWatch::FileWatch() : descriptor_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  if (descriptor_ < 0)
    throw Error(ExitStatus::device, std::string("files can't be watched: ") + std::strerror(errno));
}

FileWatch::~FileWatch() {
  close(descriptor_);
}

void FileWatch::set_files(const std::vector<fs::path>& files, Stamp read) {
  std::map<fs::path, Folder> wanted;
  for (const fs::path& file : files) {
    std::error_code ignored;
    const fs::path absolute = fs::absolute(file, ignored).lexically_normal();
    if (fs::is_directory(absolute, ignored)) {
      wanted[absolute].all = true;
      continue;
    }
    wanted[absolute.parent_path()].names.insert(absolute.filename().string());
    // A link's target changes in its own folder.
    const fs::path real = fs::weakly_canonical(absolute, ignored);
    if (!real.empty()) wanted[real.parent_path()].names.insert(real.filename().string());
  }
  std::map<int, Folder> folders;
  for (auto& [path, folder] : wanted) {
    const int watch = inotify_add_watch(
        descriptor_, path.c_str(), IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_ONLYDIR);
    if (watch < 0) continue;  // the folder is gone; what comes instead is noticed through other files
    const auto old = folders_.find(watch);
    const bool watched_all = old != folders_.end() && old->second.all;
    if (folder.all && !watched_all) missed_ = missed_ || any_saved_since(path, read);
    for (const std::string& name : folder.names)
      if (!watched_all && (old == folders_.end() || !old->second.names.contains(name)))
        missed_ = missed_ || saved_since(path / name, read);
    Folder& known = folders[watch];
    known.all = known.all || folder.all;
    known.names.merge(folder.names);
  }
  for (const auto& [watch, folder] : folders_)
    if (!folders.contains(watch)) inotify_rm_watch(descriptor_, watch);
  folders_ = std::move(folders);
}

bool FileWatch::changed(bool anything) {
  bool found = std::exchange(missed_, false);
  alignas(inotify_event) std::array<char, 16384> buffer;
  for (ssize_t size = 0; (size = read(descriptor_, buffer.data(), buffer.size())) > 0;)
    for (ssize_t at = 0; at < size;) {
      inotify_event event;
      std::memcpy(&event, buffer.data() + at, sizeof event);
      const char* name = buffer.data() + at + sizeof event;
      at += static_cast<ssize_t>(sizeof event + event.len);
      if ((event.mask & IN_Q_OVERFLOW) != 0) found = true;
      const auto folder = folders_.find(event.wd);
      if (folder == folders_.end() || event.len == 0) continue;
      found = found || anything || folder->second.all || folder->second.names.contains(name);
    }
  return found;
}

}  // namespace shadertwin::view
