// A folder of small files for one test, removed with it.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "host/base/error.h"
#include "host/project/project.h"
#include "host/text/load.h"

namespace shadertwin {

class TempFolder {
 public:
  TempFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "shadertwin-XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~TempFolder() { std::filesystem::remove_all(path_); }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    const std::filesystem::path file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// What the user reads when `shader` is loaded, with the folder's own path taken out; "" if it loads.
inline std::string load_error(const TempFolder& folder, const std::filesystem::path& shader,
                              ExitStatus status, const LoadOptions& options = {}) {
  try {
    load_project(shader, options);
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), status) << error.what();
    std::string text = error.what();
    const std::string prefix = folder.path().string() + "/";
    for (std::size_t at = 0; (at = text.find(prefix, at)) != std::string::npos;)
      text.erase(at, prefix.size());
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    return text;
  }
  ADD_FAILURE() << "it loads";
  return "";
}

constexpr const char* empty_image = "void mainImage(out vec4 o, in vec2 p) { o = vec4(0.0); }\n";

}  // namespace shadertwin
