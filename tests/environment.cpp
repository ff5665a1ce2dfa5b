// Linked into every test, for it and for the programs that it starts.
#include <cstdlib>
#include <filesystem>

namespace {

// Tests mean llvmpipe, whose bits are known, also on a machine with a GPU, where "auto" would choose that. A
// SHADERTWIN_DEVICE of the caller's wins: tools/soak is quicker on a GPU.
[[maybe_unused]] const int device = setenv("SHADERTWIN_DEVICE", "llvmpipe", 0);

// Compiled twins, and the headers that they share, are kept in the build, not in the user's cache.
[[maybe_unused]] const int cache = setenv(
    "XDG_CACHE_HOME", (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "cache").c_str(), 1);

}  // namespace
