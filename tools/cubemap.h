// Cube faces from an equirectangular (latitude and longitude) map.
#pragma once

#include <array>

#include "host/image/image.h"

namespace shadertwin {

using Direction = std::array<double, 3>;

// Order of faces in a cubemap, and the names that files of them go by.
inline constexpr std::array<const char*, 6> face_names = {"px", "nx", "py", "ny", "pz", "nz"};

// The direction that OpenGL looks up at (s, t), each in [0, 1], on `face` (OpenGL 4.6 core, table 8.19). Not
// normalised: the major axis is 1.
Direction face_direction(int face, double s, double t);

// Where a map holds direction `d`, as (u, v) in [0, 1]: v is 1 straight up (+y) and 0 straight down; u grows
// to the right for someone who stands upright in right-handed coordinates, and is 1/2 along +x.
std::array<double, 2> map_position(const Direction& d);

// Renders one face of `size` squared texels from linear colours, by the mean of `samples` squared bilinear
// lookups a texel. Negative values in the map count as 0. Row 0 of the face is the one at t = 1, so that
// write_image puts t = 0 on top, as cube faces are stored.
Image cube_face(const Image& map, int face, int size, int samples);

// Multiplies by 2^stops, then encodes for sRGB (IEC 61966-2-1), clamped to [0, 1]. Alpha becomes 1.
void encode_srgb(Image& image, double stops);

}  // namespace shadertwin
