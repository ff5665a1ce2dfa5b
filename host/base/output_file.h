// A file that appears under its name only when it is complete.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "host/base/unfinished.h"

namespace shadertwin {

// Write to path(), a temporary name in the target's folder that keeps the target's extension; then commit().
// Without commit() the destructor removes the temporary file, as an interrupt does, and the target stays as
// it was.
class OutputFile {
 public:
  // Throws Error(file) if the target's folder does not exist or can't be written.
  explicit OutputFile(std::filesystem::path target);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::filesystem::path& path() const { return temporary_; }
  // Renames the temporary file to the target. Throws Error(file).
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  std::optional<Unfinished> unfinished_;
  bool committed_ = false;
};

// Writes a file, whole or not at all. Throws Error(file).
void write_file(const std::filesystem::path& file, std::string_view contents);

}  // namespace shadertwin
