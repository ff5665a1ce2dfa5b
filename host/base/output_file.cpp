#include "host/base/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>

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
  // A rename would put a file in the place of a device or a pipe.
  if (fs::is_other(target_, ignored))
    throw Error(ExitStatus::file, target_.string() + ": is a device or a pipe, not a file");
  const std::string number = std::to_string(getpid()) + "-" + std::to_string(serial++);
  const std::string stem = target_.stem().string().substr(0, 200);  // names have at most 255 bytes
  temporary_ = folder / ("." + stem + "." + number + target_.extension().string());

  unfinished_.emplace(temporary_);
  // Only making a file shows whether one can be made.
  const int probe = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (probe < 0)
    throw Error(ExitStatus::file, target_.string() + ": can't write in the folder " + folder.string() + ": " +
                                      std::strerror(errno));
  close(probe);
  fs::remove(temporary_, ignored);
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
  unfinished_.reset();
}

void write_file(const fs::path& file, std::string_view contents) {
  OutputFile output(file);
  std::ofstream stream(output.path(), std::ios::binary);
  stream << contents;
  stream.close();
  if (!stream) throw Error(ExitStatus::file, file.string() + ": can't be written");
  output.commit();
}

}  // namespace shadertwin
