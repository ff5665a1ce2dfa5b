// Files that are to be removed when the program is interrupted.
#pragma once

#include <filesystem>

namespace shadertwin {

// While it lives, an interrupt removes the file, or the folder once what is in it has been removed. (The
// program's own ends are the owner's business.) Beyond 256 at a time further ones are not looked after.
class Unfinished {
 public:
  explicit Unfinished(const std::filesystem::path& path);
  ~Unfinished();
  Unfinished(Unfinished&& other) noexcept;
  Unfinished& operator=(Unfinished&& other) noexcept;

 private:
  int slot_ = -1;
};

// From now on SIGINT, SIGTERM and SIGHUP remove what is unfinished before they end the program as usual. One
// that is ignored (nohup) stays so.
void remove_unfinished_when_interrupted();

}  // namespace shadertwin
