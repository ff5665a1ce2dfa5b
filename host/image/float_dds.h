// DirectDraw surfaces of 32-bit floats, which OpenImageIO does not read: tables that shaders look values up
// in.
#pragma once

#include <filesystem>
#include <optional>

#include "host/image/image.h"

namespace shadertwin {

// The first level of a two-dimensional .dds with one to four floats a texel (DXGI_FORMAT_R32_FLOAT to
// R32G32B32A32_FLOAT, or their Direct3D 9 codes), row 0 the top row. Missing channels are 0, alpha 1. Nothing
// for any other file. Throws Error(file) for one that breaks off or is too large. Format: Microsoft,
// "Programming guide for DDS".
std::optional<Texture> read_float_dds(const std::filesystem::path& file);

}  // namespace shadertwin
