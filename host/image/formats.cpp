#include "host/image/formats.h"

#include <dlfcn.h>

#include <algorithm>
#include <cctype>

#include "host/base/error.h"

namespace shadertwin {

namespace {

// It lies beside the program, or where `cmake --install` puts it: the program's run path says both.
const Formats& load() {
  int how = RTLD_LAZY | RTLD_LOCAL;
#ifndef __SANITIZE_ADDRESS__
  // Its libraries look for their symbols among themselves first: a third less time.
  how |= RTLD_DEEPBIND;
#endif
  constexpr const char* name = "libshadertwin_pictures.so";
  void* const library = dlopen(name, how);
  const auto get =
      library == nullptr
          ? nullptr
          : reinterpret_cast<decltype(&shadertwin_formats)>(dlsym(library, "shadertwin_formats"));
  if (get == nullptr)
    throw Error(ExitStatus::device, std::string("pictures can't be read or written here: ") + dlerror());
  return *get();
}

}  // namespace

const Formats& formats() {
  static const Formats& loaded = load();
  return loaded;
}

void fail_to_read(const std::filesystem::path& file, std::string reason) {
  while (!reason.empty() && std::isspace(static_cast<unsigned char>(reason.back()))) reason.pop_back();
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  throw Error(ExitStatus::file, file.string() + ": " + reason);
}

}  // namespace shadertwin
