// Notices when files are saved, by inotify.
#pragma once

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

  // Watches these files from now on, and no others. They need not be there. A folder among them stands for
  // every file in it.
  void set_files(const std::vector<std::filesystem::path>& files);
  // Becomes readable when changed() has something to say.
  int descriptor() const { return descriptor_; }
  // Whether one of the files was written, replaced or removed since the last call. `anything`: whether any
  // file beside them was.
  bool changed(bool anything = false);

 private:
  struct Folder {
    std::set<std::string> names;
    bool all = false;
  };

  int descriptor_ = -1;
  std::map<int, Folder> folders_;  // by watch
};

}  // namespace shadertwin::view
