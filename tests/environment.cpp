// Linked into every test: tests mean llvmpipe, whose bits are known, also on a machine with a GPU, where
// "auto" would choose that. A SHADERTWIN_DEVICE of the caller's wins: tools/soak is quicker on a GPU.
#include <cstdlib>

namespace {

[[maybe_unused]] const int chosen = setenv("SHADERTWIN_DEVICE", "llvmpipe", 0);

}  // namespace
