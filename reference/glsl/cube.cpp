#include <cmath>

#include "reference/glsl/filtering.h"

namespace shadertwin::glsl::filtering {

namespace {

// Which axis is the longest: of equal ones z before y before x.
int major_axis(const float* v) {
  const float x = std::fabs(v[0]);
  const float y = std::fabs(v[1]);
  const float z = std::fabs(v[2]);
  if (!(z < detail::first_if_greater(x, y))) return 2;
  return x > y ? 0 : 1;
}

// The components of v along a face's s and t, by OpenGL's table of faces.
struct Minor {
  float s;
  float t;
};
Minor minor_axes(const float* v, int axis, bool negative) {
  const float sign = negative ? -1.0F : 1.0F;
  if (axis == 0) return {sign * -v[2], -v[1]};
  if (axis == 1) return {v[0], sign * v[2]};
  return {sign * v[0], -v[1]};
}

// What lies across the four edges of a face: the face there, and the texel's place on it.
struct Neighbour {
  int face;
  int x;
  int y;
};

// Beyond s = 0 (edge 0), s = 1 (1), t = 0 (2) and t = 1 (3); x and y are the texel's, of which the one across
// the edge does not count. `last`: the highest texel.
Neighbour across(int face, int edge, int x, int y, int last) {
  static constexpr int faces[4][6] = {
      {4, 5, 1, 1, 1, 0}, {5, 4, 0, 0, 0, 1}, {2, 2, 5, 4, 2, 2}, {3, 3, 4, 5, 3, 3}};
  const int next = faces[edge][face];
  switch (edge) {
    case 0:
      if (face == 2) return {next, y, 0};
      if (face == 3) return {next, last - y, last};
      return {next, last, y};
    case 1:
      if (face == 2) return {next, last - y, 0};
      if (face == 3) return {next, y, last};
      return {next, 0, y};
    case 2:
      switch (face) {
        case 0:
          return {next, last, last - x};
        case 1:
          return {next, 0, x};
        case 2:
          return {next, last - x, 0};
        case 3:
          return {next, x, last};
        case 4:
          return {next, x, last};
        default:
          return {next, last - x, 0};
      }
    default:
      switch (face) {
        case 0:
          return {next, last, x};
        case 1:
          return {next, 0, last - x};
        case 2:
          return {next, x, 0};
        case 3:
          return {next, last - x, last};
        case 4:
          return {next, x, 0};
        default:
          return {next, last - x, last};
      }
  }
}

// A face's coordinate in texels, counted from the centre of the first.
float texel_position(float coordinate, const TextureLevel& level) {
  return detail::first_if_greater(coordinate, 0.0F) * static_cast<float>(level.width) - 0.5F;
}

}  // namespace

CubePoint cube_point(const float* direction) {
  const int axis = major_axis(direction);
  const bool negative = std::signbit(direction[axis]);
  const Minor minor = minor_axes(direction, axis, negative);
  const float length = std::fabs(direction[axis]);
  const float scale = length > 0.0F ? 0.5F / length : 0.0F;
  return {2 * axis + (negative ? 1 : 0), minor.s * scale + 0.5F, minor.t * scale + 0.5F};
}

float cube_footprint(const TextureView& view, const float* direction, const float* dx, const float* dy) {
  const int axis = major_axis(direction);
  const bool negative = std::signbit(direction[axis]);
  const Minor minor = minor_axes(direction, axis, negative);
  const float inverse = 1.0F / direction[axis];
  const float half = 0.5F * inverse;
  const auto size = static_cast<float>(view.level[0].width);
  const auto squared_step = [&](const float* d) {
    const Minor step = minor_axes(d, axis, negative);
    const float along = d[axis] * inverse;
    float s = size * ((step.s - along * minor.s) * half);
    float t = size * ((step.t - along * minor.t) * half);
    s = s * s;
    t = t * t;
    return s + t;
  };
  const float footprint = detail::first_if_greater(squared_step(dx), squared_step(dy));
  return footprint < detail::infinity ? footprint : 0.0F;
}

bool meets_corner(const TextureLevel& level, const CubePoint& point) {
  const auto beyond = [&](float coordinate) {
    const int first = down(texel_position(coordinate, level));
    return first < 0 || first + 1 >= level.width;
  };
  return beyond(point.s) && beyond(point.t);
}

Color cube_linear(const TextureView& view, const TextureLevel& level, const CubePoint& point, bool weighted) {
  const int last = level.width - 1;
  const float x = texel_position(point.s, level);
  const float y = texel_position(point.t, level);
  const int x0 = down(x);
  const int y0 = down(y);
  const float s = x - std::floor(x);
  const float t = y - std::floor(y);

  // Corners 00, 01, 10, 11: second digit along s.
  Color texel[4];
  int missing = -1;
  for (int i = 0; i < 4; ++i) {
    const int tx = x0 + (i & 1);
    const int ty = y0 + (i >> 1);
    const int edge_x = tx < 0 ? 0 : tx > last ? 1 : -1;
    const int edge_y = ty < 0 ? 2 : ty > last ? 3 : -1;
    Neighbour at{point.face, tx, std::clamp(ty, 0, last)};
    if (edge_x >= 0) {
      at = across(point.face, edge_x, tx, at.y, last);
      if (edge_y >= 0) missing = i;
    } else if (edge_y >= 0) {
      at = across(point.face, edge_y, tx, ty, last);
    }
    texel[i] = color_at(view, level, at.x, at.y, at.face);
  }
  if (missing < 0 && !weighted) return blend(t, blend(s, texel[0], texel[1]), blend(s, texel[2], texel[3]));

  // Only three texels meet in a corner of the cube: the fourth's weight is shared among them.
  float weight[4] = {(1.0F - s) * (1.0F - t), s * (1.0F - t), (1.0F - s) * t, s * t};
  const float share = missing < 0 ? 0.0F : weight[missing] * (1.0F / 3.0F);
  for (int i = 0; i < 4; ++i) weight[i] = i == missing ? 0.0F : weight[i] + share;
  Color color;
  for (std::size_t c = 0; c < 4; ++c) {
    color[c] = weight[0] * texel[0][c];
    for (int i = 1; i < 4; ++i) color[c] = weight[i] * texel[i][c] + color[c];
  }
  return color;
}

}  // namespace shadertwin::glsl::filtering
