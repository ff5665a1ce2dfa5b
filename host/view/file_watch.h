// Notices when files are saved, by inotify.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace shadertwin::view {

// Folders are watched, not files: most editors save by putting a new file in the old one's place.
class FileWatch {
 public:
  FileWatch();  // throws Error(device) if the system gives no watch
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  // Time of the clock that stamps files, from the epoch.
  using Stamp = std::chrono::nanoseconds;
  static Stamp now();

  // Watches these files from now on, and no others. They need not be there. A folder among them stands for
  // every file in it. What was saved after `read`, when somebody began to read them, and before it was
  // watched, changed() reports too.
  void set_files(const std::vector<std::filesystem::path>& files, Stamp read = Stamp::max());
  // Becomes readable when something happens that changed() should hear of.
  int descriptor() const { return descriptor_; }
  // Whether changed() has something to say that happened before the watch: descriptor() is silent about it.
  bool missed() const { return missed_; }
  // Whether one of the files was written, replaced or removed since the last call. `anything`: whether any
  // file beside them was.
  bool changed(bool anything = false);

 private:
  struct Folder {
    std::set<std::string> names;
    bool all = false;
  };

  int descriptor_ = -1;
  bool missed_ = false;
  std::map<int, Folder> folders_;  // by watch
};

}  // namespace shadertwin::view
