// Mipmaps as glGenerateMipmap makes them on llvmpipe.
#pragma once

#include <cstddef>

#include "reference/glsl/sampler.h"

namespace shadertwin::glsl {

enum class Texel { bytes, floats, halves };  // the last are stored as floats

// Writes the texels of level `to`, whose sizes are set, into `texels`. `from` is the level above; `layers`:
// faces of a cube, or slices of `to`. Denormals are flushed if the thread flushes them.
void shrink(Texel texel, const TextureLevel& from, const TextureLevel& to, std::byte* texels, int layers);

}  // namespace shadertwin::glsl
