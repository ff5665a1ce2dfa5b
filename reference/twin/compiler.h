// Turns the text of a twin into a shared object with the system's C++ compiler, and remembers it.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

namespace shadertwin::twin {

enum class Uninitialised { zero, pattern };

struct CompileOptions {
  bool double_precision = false;
  Uninitialised uninitialised = Uninitialised::zero;
  bool debug = false;                        // -O0 -g, for gdb
  bool packets = false;                      // the source includes packet_invocation.h
  std::vector<std::string> extra_arguments;  // behind all others
};

// A C++ compiler of this machine: $CXX, or the first of c++, g++ and clang++ on the PATH.
class Compiler {
 public:
  // Throws Error(device) if there is no compiler, Error(file) if the headers that twins include are missing.
  Compiler();
  ~Compiler();
  Compiler(const Compiler&) = delete;
  Compiler& operator=(const Compiler&) = delete;

  // The compiler as the user would call it, "g++".
  std::string name() const { return program_.filename().string(); }

  // Where compiled twins are kept: $XDG_CACHE_HOME/shadertwin, else ~/.cache/shadertwin. If that can't be
  // written, a folder of this object's own under the system's temporary folder. The environment variable
  // SHADERTWIN_KEEP_CPP names another folder, in which the C++ of each twin then stays beside it.
  const std::filesystem::path& cache() const { return cache_; }

  // The name of a twin's shared object in the cache. `text` is whatever decides what the twin is.
  std::filesystem::path object_path(const std::string& text, const CompileOptions& options) const;

  // Compiles in advance what all twins with these options include, unless the cache has it: a second's work
  // less for each twin that is compiled afterwards, but several seconds itself.
  void prepare(const CompileOptions& options) const;

  // Compiles `source` to `object`, which appears whole or not at all. Throws Error(shader) that names the
  // kept source if the compiler refuses it, Error(device) if the compiler can't be run.
  void compile(const std::string& source, const std::filesystem::path& object,
               const CompileOptions& options) const;

 private:
  std::vector<std::string> arguments(const CompileOptions& options) const;
  // Where what twins include is kept, compiled in advance: a file to `-include`, with .gch behind its name.
  std::filesystem::path precompiled_header(const CompileOptions& options) const;
  bool is_clang() const;

  std::filesystem::path program_;
  std::filesystem::path include_root_;  // the folder that holds reference/
  std::filesystem::path cache_;
  bool owns_cache_ = false;
  mutable std::mutex header_mutex_;  // one makes the precompiled header
  std::string identity_;             // of compiler, processor and headers
};

}  // namespace shadertwin::twin
