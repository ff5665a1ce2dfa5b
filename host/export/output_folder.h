// A folder that appears under its name only when it is complete.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/base/unfinished.h"

namespace shadertwin {

// Fill it, then commit(). Without commit() the destructor removes what has been written, as an interrupt
// does.
class OutputFolder {
 public:
  // Throws Error(file) if `target` is there already, other than as an empty folder, or can't be made.
  explicit OutputFolder(const std::filesystem::path& target);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  // Both throw Error(file).
  void write(const std::string& name, const std::string& text);
  void copy(const std::filesystem::path& file, const std::string& name);
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  std::vector<Unfinished> unfinished_;
};

// The name of a pass's file, without an extension: "Buffer A" -> "buffer_a".
std::string file_stem(std::string pass);

}  // namespace shadertwin
