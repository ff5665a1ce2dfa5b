#include "host/base/output_file.h"

#include <unistd.h>

#include <atomic>
#include <string>
#include <system_error>

#include "host/base/error.h"

namespace shadertwin {

namespace fs = std::filesystem;

OutputFile::OutputFile(fs::path target) : target_(std::move(target)) {
  static std::atomic<unsigned> serial = 0;
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    throw Error(ExitStatus::file, target_.string() + ": the folder " + folder.string() + " does not exist");
  if (fs::is_directory(target_, ignored)) throw Error(ExitStatus::file, target_.string() + ": is a folder");
  if (access(folder.c_str(), W_OK) != 0)
    throw Error(ExitStatus::file, target_.string() + ": the folder " + folder.string() + " can't be written");
  temporary_ = folder / ("." + target_.stem().string() + "." + std::to_string(getpid()) + "-" +
                         std::to_string(serial++) + target_.extension().string());
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!committed_) fs::remove(temporary_, ignored);
}

void OutputFile::commit() {
  std::error_code failure;
  fs::rename(temporary_, target_, failure);
  if (failure) throw Error(ExitStatus::file, target_.string() + ": " + failure.message());
  committed_ = true;
}

}  // namespace shadertwin
