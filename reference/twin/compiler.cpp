#include "reference/twin/compiler.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>

#include "host/base/error.h"
#include "host/base/hash.h"
#include "host/base/process.h"
#include "host/base/unfinished.h"

namespace shadertwin::twin {
namespace fs = std::filesystem;
namespace {

constexpr const char* single_header = "reference/twin/invocation.h";
constexpr const char* packet_header = "reference/twin/packet_invocation.h";

std::string read_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

fs::path find_include_root() {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  // An installation holds bin/shadertwin and share/shadertwin/include; a build knows its source tree.
  for (const fs::path& root : {program.parent_path().parent_path() / "share/shadertwin/include",
                               fs::path(SHADERTWIN_INCLUDE_ROOT)}) {
    if (fs::exists(root / single_header, ignored)) return root;
  }
  throw Error(ExitStatus::file,
              "the headers of the CPU twin are missing: no share/shadertwin/include beside " +
                  program.parent_path().string());
}

// The machine code of -march=native is only good for one kind of processor.
std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("flags", 0) == 0 || line.rfind("Features", 0) == 0) return line;
  }
  return {};
}

std::string compiler_identity(const fs::path& program) {
  std::error_code ignored;
  const fs::path file = fs::canonical(program, ignored);
  return file.string() + ' ' + std::to_string(fs::file_size(file, ignored)) + ' ' +
         std::to_string(fs::last_write_time(file, ignored).time_since_epoch().count());
}

std::string headers_identity(const fs::path& include_root) {
  std::vector<fs::path> files;
  for (const char* folder : {"reference/glsl", "reference/twin"}) {
    for (const auto& entry : fs::directory_iterator(include_root / folder)) {
      const fs::path extension = entry.path().extension();
      if (extension == ".h" || extension == ".def") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::string text;
  for (const fs::path& file : files) text += read_file(file);
  return hash_name(text);
}

bool can_write(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  return !failed && access(folder.c_str(), W_OK | X_OK) == 0;
}

// Names the folder in which twins are made anew and their C++ stays.
const char* kept_folder() {
  const char* folder = std::getenv("SHADERTWIN_KEEP_CPP");
  return folder != nullptr && *folder != '\0' ? folder : nullptr;
}

fs::path user_cache() {
  if (const char* folder = kept_folder()) return fs::absolute(folder);
  if (const char* folder = std::getenv("XDG_CACHE_HOME"); folder != nullptr && *folder == '/')
    return fs::path(folder) / "shadertwin";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/')
    return fs::path(home) / ".cache/shadertwin";
  return {};
}

const char* header_of(const CompileOptions& options) {
  return options.packets ? packet_header : single_header;
}

std::string first_error(const std::string& output) {
  std::istringstream in(output);
  for (std::string line; std::getline(in, line);) {
    if (line.find("error: ") != std::string::npos) return line;
  }
  return output.substr(0, output.find('\n'));
}

}  // namespace

Compiler::Compiler() : include_root_(find_include_root()), cache_(user_cache()) {
  const char* chosen = std::getenv("CXX");
  program_ = find_program({chosen != nullptr ? chosen : "", "c++", "g++", "clang++"});
  if (program_.empty())
    throw Error(ExitStatus::device,
                "the CPU twin needs a C++ compiler: install g++ or clang++, or name one in CXX");
  identity_ = compiler_identity(program_) + processor() + headers_identity(include_root_);
  if (cache_.empty() || !can_write(cache_)) {
    std::string pattern = (fs::temp_directory_path() / "shadertwin-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr)
      throw Error(ExitStatus::file, "no folder can be written for compiled twins: " + pattern);
    cache_ = pattern;
    owns_cache_ = true;
  }
}

Compiler::~Compiler() {
  std::error_code ignored;
  if (owns_cache_) fs::remove_all(cache_, ignored);
}

bool Compiler::is_clang() const {
  return fs::canonical(program_).filename().string().find("clang") != std::string::npos;
}

std::vector<std::string> Compiler::arguments(const CompileOptions& options) const {
  // No flag here may change the bits of an IEEE operation.
  std::vector<std::string> list = {"-std=c++20",
                                   "-fPIC",
                                   "-shared",
                                   "-fvisibility=hidden",
                                   "-march=native",
                                   "-ffp-contract=off",
                                   "-fno-math-errno",
                                   "-fno-trapping-math",
                                   "-fwrapv",
                                   "-fno-finite-loops",
                                   "-w",
                                   "-I" + include_root_.string()};
  const bool pattern = options.uninitialised == Uninitialised::pattern;
  if (pattern) list.insert(list.end(), {"-ftrivial-auto-var-init=pattern", "-DSHADERTWIN_PATTERN"});
  // GCC leaves it to the emitter, which starts every variable of the shader's: its flag costs packets 3 % of
  // the path tracer's time, and GCC 12's clears a double of a matrix in a structure that ends with padding.
  if (!pattern && !options.packets && is_clang()) {
    list.emplace_back("-ftrivial-auto-var-init=zero");
    // Behind a flag up to version 15.
    list.emplace_back("-enable-trivial-auto-var-init-zero-knowing-it-will-be-removed-from-clang");
  }
  if (options.double_precision) list.emplace_back("-DSHADERTWIN_DOUBLE");
  if (options.debug)
    list.insert(list.end(), {"-O0", "-g"});
  else  // packets gain from more inlining; one pixel at a time is slower with it
    list.emplace_back(options.packets ? "-O3" : "-O2");
  // Records that a function fills in under a mask are kept in registers, or not made at all, only where its
  // body is at hand. GCC's limits are for scalar code; the last one bounds the time that compiling takes.
  if (options.packets && !options.debug && !is_clang()) {
    for (const char* limit : {"max-inline-insns-single=2000", "large-function-insns=100000",
                              "large-stack-frame-growth=5000", "inline-unit-growth=500"})
      list.insert(list.end(), {"--param", limit});
  }
  list.insert(list.end(), options.extra_arguments.begin(), options.extra_arguments.end());
  return list;
}

fs::path Compiler::object_path(const std::string& text, const CompileOptions& options) const {
  std::string key = identity_ + '\n' + text;
  for (const std::string& argument : arguments(options)) key += '\n' + argument;
  return cache_ / (hash_name(key) + ".so");
}

fs::path Compiler::precompiled_header(const CompileOptions& options) const {
  std::string key = identity_ + header_of(options);
  for (const std::string& argument : arguments(options)) key += '\n' + argument;
  return cache_ / ("headers-" + hash_name(key)) / "twin.h";
}

void Compiler::prepare(const CompileOptions& options) const {
  if (is_clang()) return;
  const std::lock_guard lock(header_mutex_);
  const fs::path stub = precompiled_header(options);
  const fs::path result = stub.string() + ".gch";
  std::error_code failed;
  if (fs::exists(result, failed)) return;
  fs::create_directories(stub.parent_path(), failed);
  std::ofstream(stub) << "#include \"" << header_of(options) << "\"\n";
  const fs::path own = stub.parent_path() / ("twin-" + std::to_string(getpid()) + ".tmp");
  const Unfinished unfinished(own);
  std::vector<std::string> list = arguments(options);
  std::erase(list, "-shared");
  list.insert(list.end(), {"-x", "c++-header", "-o", own.string(), stub.string()});
  if (run_process(program_, list).status == 0) fs::rename(own, result, failed);
}

void Compiler::compile(const std::string& source, const fs::path& object,
                       const CompileOptions& options) const {
  std::error_code failed;
  // What the cache's key names anew, an edited comment or an emitter's next version, often comes to the same
  // C++. A damaged twin is there, and is compiled again.
  const bool reuses = !options.debug && kept_folder() == nullptr;
  const fs::path same_text = object_path(source, options).replace_extension("cpp-so");
  if (reuses && !fs::exists(object, failed)) {
    fs::create_hard_link(same_text, object, failed);
    if (!failed) return;
  }
  // Two processes may compile the same twin: each writes files of its own, and the last rename wins.
  const std::string own = object.stem().string() + '-' + std::to_string(getpid());
  const fs::path text = object.parent_path() / (own + ".cpp");
  const fs::path result = object.parent_path() / (own + ".tmp");
  const std::array unfinished = {Unfinished(text), Unfinished(result)};
  {
    std::ofstream out(text, std::ios::binary);
    out << source;
    if (!out.flush()) throw Error(ExitStatus::file, text.string() + ": can't be written");
  }
  std::vector<std::string> list = arguments(options);
  if (const fs::path headers = precompiled_header(options); fs::exists(headers.string() + ".gch", failed))
    list.insert(list.end(), {"-include", headers.string()});
  list.insert(list.end(), {"-o", result.string(), text.string()});
  ProcessResult run = run_process(program_, list);
  // GCC 12 dies of some shaders where it packs scalars into vectors, which changes no bits.
  if (run.status != 0 && run.output.find("internal compiler error") != std::string::npos) {
    list.emplace_back("-fno-tree-slp-vectorize");
    run = run_process(program_, list);
  }
  if (run.status == -1) {
    fs::remove(text, failed);
    throw Error(ExitStatus::device, program_.string() + ": the C++ compiler can't be run");
  }
  if (run.status != 0) {
    fs::remove(result, failed);
    const fs::path kept = object.parent_path() / (object.stem().string() + ".cpp");
    fs::rename(text, kept, failed);
    throw Error(ExitStatus::shader, kept.string() + ": error: " + program_.string() +
                                        " refuses the shader's C++: " + first_error(run.output));
  }
  fs::rename(result, object, failed);
  if (failed) throw Error(ExitStatus::file, object.string() + ": " + failed.message());
  if (reuses) {
    fs::remove(same_text, failed);
    fs::create_hard_link(object, same_text, failed);
  }
  if (kept_folder() != nullptr)
    fs::rename(text, object.parent_path() / (object.stem().string() + ".cpp"), failed);
  else
    fs::remove(text, failed);
}

}  // namespace shadertwin::twin
