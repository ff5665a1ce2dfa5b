#include "tools/cubemap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shadertwin {
namespace {

constexpr double pi = std::numbers::pi;

Direction normalised(const Direction& d) {
  const double length = std::hypot(d[0], d[1], d[2]);
  return {d[0] / length, d[1] / length, d[2] / length};
}

// Where the map's texel (x, y) points, straight from the definition of longitude and latitude.
Direction texel_direction(int x, int y, int width, int height) {
  const double longitude = 2 * pi * ((x + 0.5) / width - 0.5), latitude = pi * ((y + 0.5) / height - 0.5);
  return {std::cos(latitude) * std::cos(longitude), std::sin(latitude),
          std::cos(latitude) * std::sin(longitude)};
}

// A map whose colour says its direction: 0.5 + 0.5 d.
Image direction_map(int width, int height) {
  Image map(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Direction d = texel_direction(x, y, width, height);
      for (int c = 0; c < 3; ++c) map.at(x, y)[c] = static_cast<float>(0.5 + 0.5 * d[c]);
    }
  return map;
}

// A map that is `inside` near an axis and black elsewhere.
Image spot_map(const Direction& axis) {
  Image map(64, 32);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const Direction d = texel_direction(x, y, map.width, map.height);
      if (d[0] * axis[0] + d[1] * axis[1] + d[2] * axis[2] > 0.9) map.at(x, y)[0] = 1;
    }
  return map;
}

// OpenGL 4.6 core, section 8.13 and table 8.19, the other way round from face_direction: the face and (s, t)
// that a direction looks up.
struct Lookup {
  int face;
  double s, t;
};

Lookup look_up(const Direction& d) {
  const double ax = std::abs(d[0]), ay = std::abs(d[1]), az = std::abs(d[2]);
  int face;
  double sc, tc, ma;
  if (ax >= ay && ax >= az) {
    face = d[0] > 0 ? 0 : 1, sc = d[0] > 0 ? -d[2] : d[2], tc = -d[1], ma = ax;
  } else if (ay >= az) {
    face = d[1] > 0 ? 2 : 3, sc = d[0], tc = d[1] > 0 ? d[2] : -d[2], ma = ay;
  } else {
    face = d[2] > 0 ? 4 : 5, sc = d[2] > 0 ? d[0] : -d[0], tc = -d[1], ma = az;
  }
  return {face, (sc / ma + 1) / 2, (tc / ma + 1) / 2};
}

TEST(FaceDirection, IsWhatOpenGlLooksUpThere) {
  for (int face = 0; face < 6; ++face)
    for (const double s : {0.01, 0.3, 0.5, 0.9})
      for (const double t : {0.02, 0.4, 0.5, 0.99}) {
        const Lookup lookup = look_up(face_direction(face, s, t));
        EXPECT_EQ(lookup.face, face);
        EXPECT_NEAR(lookup.s, s, 1e-12);
        EXPECT_NEAR(lookup.t, t, 1e-12);
      }
}

TEST(MapPosition, IsUprightAndTurnsRightInRightHandedCoordinates) {
  EXPECT_NEAR(map_position({0, 1, 0})[1], 1, 1e-12);
  EXPECT_NEAR(map_position({0, -3, 0})[1], 0, 1e-12);
  // Who faces -z has +x at the right hand and +z behind.
  EXPECT_NEAR(map_position({0, 0, -1})[0], 0.25, 1e-12);
  EXPECT_NEAR(map_position({2, 0, 0})[0], 0.5, 1e-12);
  EXPECT_NEAR(map_position({0, 0, 1})[0], 0.75, 1e-12);
}

TEST(CubeFace, EveryTexelHasTheColourOfItsDirection) {
  const Image map = direction_map(256, 128);
  const int size = 32;
  for (int face = 0; face < 6; ++face) {
    const Image picture = cube_face(map, face, size, 4);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        // Row 0 is the last one of the file, at t = 1.
        const Direction d = normalised(face_direction(face, (x + 0.5) / size, 1 - (y + 0.5) / size));
        for (int c = 0; c < 3; ++c)
          ASSERT_NEAR(picture.at(x, y)[c], 0.5 + 0.5 * d[c], 1e-3)
              << face_names[face] << " at " << x << ", " << y << " channel " << c;
      }
  }
}

TEST(CubeFace, ASpotOnAnAxisIsOnThatFaceAlone) {
  const Direction axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int axis = 0; axis < 6; ++axis)
    for (int face = 0; face < 6; ++face) {
      const Image picture = cube_face(spot_map(axes[axis]), face, 8, 1);
      float brightest = 0;
      for (const float* value = picture.rgba.data(); value < &picture.rgba.back(); value += 4)
        brightest = std::max(brightest, *value);
      EXPECT_EQ(brightest > 0.5f, face == axis) << face_names[face] << " for the axis " << face_names[axis];
    }
}

// Texels on both sides of an edge of the cube lie closer together than the diagonal of a texel, so no step
// may be larger than the colours change inside a face over that distance.
TEST(CubeFace, NoSeamShowsBetweenFaces) {
  const int size = 64;
  const Image map = direction_map(512, 256);
  std::array<Image, 6> faces;
  for (int face = 0; face < 6; ++face) faces[face] = cube_face(map, face, size, 2);
  const auto texel = [&](const Direction& d) {
    const Lookup lookup = look_up(d);
    const int x = std::clamp(static_cast<int>(lookup.s * size), 0, size - 1);
    const int y = std::clamp(static_cast<int>((1 - lookup.t) * size), 0, size - 1);
    return std::pair(lookup.face, faces[lookup.face].at(x, y));
  };
  int edges = 0;
  for (int face = 0; face < 6; ++face)
    for (int i = 0; i < size; ++i)
      for (int side = 0; side < 4; ++side) {
        const double along = (i + 0.5) / size, half = 0.5 / size;
        const auto at = [&](double across) {
          const double value = side < 2 ? across : 1 - across;
          return side % 2 == 0 ? face_direction(face, value, along) : face_direction(face, along, value);
        };
        const auto [inner, inside] = texel(at(half));
        const auto [outer, outside] = texel(at(-half));
        ASSERT_EQ(inner, face);
        ASSERT_NE(outer, face);
        ++edges;
        for (int c = 0; c < 3; ++c)
          ASSERT_NEAR(inside[c], outside[c], 1.5 / size) << face << " " << side << " " << i;
      }
  EXPECT_EQ(edges, 6 * 4 * size);
}

TEST(CubeFace, AConstantMapGivesConstantFaces) {
  Image map(16, 8);
  std::fill(map.rgba.begin(), map.rgba.end(), 0.75f);
  for (int face = 0; face < 6; ++face)
    for (const float value : cube_face(map, face, 5, 3).rgba)
      EXPECT_TRUE(value == 1.0f || std::abs(value - 0.75f) < 1e-6f);
}

TEST(CubeFace, NegativeTexelsCountAsBlackBeforeFiltering) {
  Image map(16, 8);
  for (int i = 0; i < 16 * 8; ++i) map.rgba[i * 4] = i % 2 == 0 ? 1.0f : -100.0f;
  for (int face = 0; face < 6; ++face) {
    const Image picture = cube_face(map, face, 4, 8);
    for (int i = 0; i < 16; ++i) EXPECT_GT(picture.rgba[i * 4], 0.05f);
  }
}

TEST(EncodeSrgb, MatchesTheStandardAndClamps) {
  Image image(5, 1);
  const float linear[] = {0, 0.002f, 0.2158605f, 1, 64};
  const double encoded[] = {0, 12.92 * 0.002, 128 / 255.0, 1, 1};
  for (int i = 0; i < 5; ++i) image.rgba[i * 4] = linear[i];
  encode_srgb(image, 0);
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(image.rgba[i * 4], encoded[i], 1e-6);
    EXPECT_EQ(image.rgba[i * 4 + 3], 1);
  }
}

TEST(EncodeSrgb, AStopDoublesTheLight) {
  Image one(1, 1), two(1, 1);
  one.rgba = {0.1f, 0.2f, 0.3f, 1};
  two.rgba = {0.2f, 0.4f, 0.6f, 1};
  encode_srgb(one, 1);
  encode_srgb(two, 0);
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(one.rgba[c], two.rgba[c], 1e-6);
}

}  // namespace
}  // namespace shadertwin
