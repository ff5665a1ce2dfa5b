// Samplers against llvmpipe: every filter, wrap, shape and format, level by level.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/glsl/denormals.h"
#include "reference/glsl/texture_image.h"
#include "tests/glsl/gl_draw.h"

namespace shadertwin::glsl {
namespace {

constexpr int size = 64;

struct Setting {
  Texture::Format format;
  int width;
  int height;
  MinFilter min;
  MagFilter mag;
  shadertwin::Wrap wrap;

  std::string text() const {
    static const char* const filters[] = {"nearest",
                                          "linear",
                                          "nearest mipmap nearest",
                                          "nearest mipmap linear",
                                          "linear mipmap nearest",
                                          "linear mipmap linear"};
    static const char* const wraps[] = {"repeat", "clamp", "mirror"};
    return std::string(format == Texture::Format::rgba8 ? "RGBA8" : "RGBA32F") + " " + std::to_string(width) +
           "x" + std::to_string(height) + ", " + filters[static_cast<int>(min)] + "/" +
           (mag == MagFilter::nearest ? "nearest" : "linear") + ", " + wraps[static_cast<int>(wrap)];
  }
  bool filters_differ() const {
    const bool min_linear = min == MinFilter::linear || min == MinFilter::linear_mipmap_nearest ||
                            min == MinFilter::linear_mipmap_linear;
    return min_linear != (mag == MagFilter::linear);
  }
  bool mipmaps() const { return min != MinFilter::nearest && min != MinFilter::linear; }
};

Texture noise(const Setting& setting, int depth, int faces) {
  Texture texture;
  texture.format = setting.format;
  texture.width = setting.width;
  texture.height = setting.height;
  texture.depth = depth;
  texture.is_volume = depth > 1;
  texture.faces = faces;
  const int texels = setting.width * setting.height * depth * faces;
  texture.data.resize(texture.texel_bytes() * static_cast<std::size_t>(texels));
  for (int i = 0; i < texels; ++i) {
    const vec4 color = input_at({Domain::Kind::range, 0, 3}, static_cast<uint>(i), 0, 99);
    for (int c = 0; c < 4; ++c) {
      const std::size_t at = 4 * static_cast<std::size_t>(i) + static_cast<std::size_t>(c);
      if (setting.format == Texture::Format::rgba8) {
        texture.data[at] = static_cast<std::byte>(floatBitsToUint(color[c]) >> 9);
      } else {
        reinterpret_cast<float*>(texture.data.data())[at] = color[c];
      }
    }
  }
  return texture;
}

// What a case has to work with; a call's level or gradient is the same over each quad, since llvmpipe takes
// the first pixel's for all four.
const char* const arguments = R"(
  uvec2 pixel = uvec2(position);
  vec3 smooth_p = vec3((vec2(ivec2(pixel)) - 37.0) * exp2(float(int(pixel.y) / 16) - 9.0), 0.0);
  smooth_p.x += smooth_p.y * 0.25;
  smooth_p.z = smooth_p.x * 0.5 - smooth_p.y + 0.25;
  vec4 random_p = input_range(draw(pixel, 0u), exp2(-21.0));
  vec4 q = input_range(draw(pixel / 2u, 1u), exp2(-20.0));
)";

struct Pixel {
  vec3 smooth_p;
  vec4 random_p;
  vec4 q;
};

Pixel pixel_at(int x, int y) {
  vec3 p(vec2(x - 37, y - 37) * std::exp2(static_cast<float>(y / 16) - 9.0F), 0.0F);
  p.x += p.y * 0.25F;
  p.z = p.x * 0.5F - p.y + 0.25F;
  const auto at = [](int v) { return static_cast<uint>(v); };
  return {p, input_at({Domain::Kind::range, 0, 2}, at(x), at(y), 0),
          input_at({Domain::Kind::range, 0, 3}, at(x / 2), at(y / 2), 1)};
}

template <class Sampler>
struct SampleCase {
  std::string glsl;
  bool own_level;  // each pixel chooses its level and filter, not each quad
  vec4 (*cpp)(const Sampler& s, const Pixel packet[8], int lane);
};

class SamplersOnLlvmpipe : public testing::Test {
 protected:
  static void SetUpTestSuite() { draw_ = std::make_unique<GlDraw>("llvmpipe"); }
  static void TearDownTestSuite() { draw_.reset(); }

  // Equal bits, but where some pixels of the eight that llvmpipe runs side by side are minified, others
  // magnified, and the two filters differ: there it makes the nearest one out of the linear one, with weights
  // of 0 and 1.
  template <class Sampler>
  static void expect_agreement(const Texture& texture, const Setting& setting, const char* sampler_type,
                               const std::vector<SampleCase<Sampler>>& cases,
                               Sampler (*bind)(const TextureImage*, const shadertwin::Sampler&)) {
    for (const auto& test : cases) {
      const Agreement agreement = compare(texture, setting, sampler_type, test, bind);
      const std::string what = setting.text() + ", " + test.glsl + ": " + agreement.worst;
      EXPECT_EQ(agreement.different, 0) << what;
      EXPECT_LE(agreement.difference, 2e-6) << what;
      EXPECT_LT(agreement.mixed, size * size) << what;
    }
  }

  struct Agreement {
    int mixed = 0;          // pixels in packets that need both filters
    int different = 0;      // other pixels with different bits
    double difference = 0;  // the largest
    std::string worst;
  };

  // The same sampler with one filter for every pixel.
  static shadertwin::Sampler only_minified(shadertwin::Sampler sampler) {
    const bool linear = sampler.min == MinFilter::linear || sampler.min == MinFilter::linear_mipmap_nearest ||
                        sampler.min == MinFilter::linear_mipmap_linear;
    sampler.mag = linear ? MagFilter::linear : MagFilter::nearest;
    return sampler;
  }
  static shadertwin::Sampler only_magnified(shadertwin::Sampler sampler) {
    sampler.min = sampler.mag == MagFilter::linear ? MinFilter::linear : MinFilter::nearest;
    return sampler;
  }

  template <class Sampler>
  static Agreement compare(const Texture& texture, const Setting& setting, const char* sampler_type,
                           const SampleCase<Sampler>& test,
                           Sampler (*bind)(const TextureImage*, const shadertwin::Sampler&)) {
    shadertwin::Sampler how;
    how.min = setting.min;
    how.mag = setting.mag;
    how.wrap = setting.wrap;
    draw_->bind(texture, how, setting.mipmaps());
    const Image drawn = (*draw_)(input_functions() + "uniform " + sampler_type +
                                     " s;\nvoid mainImage(out vec4 r, in vec2 position) {" + arguments +
                                     "  r = " + test.glsl + ";\n}\n",
                                 size, size);
    const FlushDenormals flush;
    const TextureImage image(texture, setting.mipmaps());
    const Sampler sampler = bind(&image, how);
    // Which filter a pixel needs hangs on its level alone, so floats may stand in for bytes, which have ways
    // of their own where both filters are the same.
    Setting floats = setting;
    floats.format = Texture::Format::rgba32f;
    const TextureImage stand_in(noise(floats, texture.depth, texture.faces), setting.mipmaps());
    const Sampler either = bind(&stand_in, how);
    const Sampler minified = bind(&stand_in, only_minified(how));
    const Sampler magnified = bind(&stand_in, only_magnified(how));
    Agreement agreement;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        // llvmpipe runs two squares of four pixels side by side.
        const int left = x & ~3;
        const int bottom = y & ~1;
        Pixel packet[8];
        for (int i = 0; i < 8; ++i)
          packet[i] = pixel_at(left + (i & 1) + 2 * (i >> 2), bottom + ((i >> 1) & 1));
        const auto is_all = [&](const Sampler& other) {
          for (int i = 0; i < 8; ++i)
            if (floatBitsToUint(test.cpp(either, packet, i)) != floatBitsToUint(test.cpp(other, packet, i)))
              return false;
          return true;
        };
        const bool mixed =
            setting.filters_differ() && test.own_level && !is_all(minified) && !is_all(magnified);
        agreement.mixed += mixed ? 1 : 0;
        const vec4 twin = test.cpp(sampler, packet, (x & 1) + 2 * (y & 1) + 4 * ((x >> 1) & 1));
        const vec4 device(drawn.at(x, y)[0], drawn.at(x, y)[1], drawn.at(x, y)[2], drawn.at(x, y)[3]);
        if (floatBitsToUint(device) == floatBitsToUint(twin)) continue;
        if (!mixed) ++agreement.different;
        for (int c = 0; c < 4; ++c) {
          const double difference = std::abs(static_cast<double>(device[c]) - static_cast<double>(twin[c]));
          if (difference <= agreement.difference) continue;
          agreement.difference = difference;
          agreement.worst = "pixel " + std::to_string(x) + ", " + std::to_string(y) + ": device " +
                            std::to_string(device[c]) + ", twin " + std::to_string(twin[c]);
        }
      }
    }
    return agreement;
  }

  static std::unique_ptr<GlDraw> draw_;
};

std::unique_ptr<GlDraw> SamplersOnLlvmpipe::draw_;

// The values of the square that pixel `lane` stands in.
Quad<vec2> flat(const Pixel packet[8], int lane) {
  const Pixel* quad = packet + (lane & 4);
  return {{quad[0].smooth_p.xy(), quad[1].smooth_p.xy(), quad[2].smooth_p.xy(), quad[3].smooth_p.xy()}};
}
Quad<vec3> solid(const Pixel packet[8], int lane) {
  const Pixel* quad = packet + (lane & 4);
  return {{quad[0].smooth_p, quad[1].smooth_p, quad[2].smooth_p, quad[3].smooth_p}};
}

const std::vector<SampleCase<sampler2D>>& flat_cases() {
  static const std::vector<SampleCase<sampler2D>> cases{
      {"texture(s, smooth_p.xy)", false,
       [](const sampler2D& s, const Pixel packet[8], int lane) {
         return texture(s, packet[lane].smooth_p.xy(), implicit_lod(s, flat(packet, lane), lane & 3));
       }},
      {"texture(s, smooth_p.xy, 1.25)", true,
       [](const sampler2D& s, const Pixel packet[8], int lane) {
         return texture(s, packet[lane].smooth_p.xy(), implicit_lod(s, flat(packet, lane), lane & 3), 1.25F);
       }},
      {"textureOffset(s, smooth_p.xy, ivec2(3, -2))", false,
       [](const sampler2D& s, const Pixel packet[8], int lane) {
         return textureOffset(s, packet[lane].smooth_p.xy(), implicit_lod(s, flat(packet, lane), lane & 3),
                              ivec2(3, -2));
       }},
      {"textureLodOffset(s, random_p.xy, q.x, ivec2(-4, 7))", true,
       [](const sampler2D& s, const Pixel packet[8], int lane) {
         return textureLodOffset(s, packet[lane].random_p.xy(), packet[lane].q.x, ivec2(-4, 7));
       }},
      {"textureProjLod(s, vec3(random_p.xy, 3.0 + random_p.z), q.x)", true,
       [](const sampler2D& s, const Pixel packet[8], int lane) {
         const Pixel& p = packet[lane];
         return textureProjLod(s, vec3(p.random_p.xy(), 3.0F + p.random_p.z), p.q.x);
       }},
      {"textureGrad(s, random_p.xy, q.xy * 0.03125, q.zw * 0.03125)", true,
       [](const sampler2D& s, const Pixel packet[8], int lane) {
         const vec4 q = packet[lane].q * 0.03125F;
         return textureGrad(s, packet[lane].random_p.xy(), q.xy(), q.zw());
       }},
  };
  return cases;
}

const std::vector<SampleCase<sampler3D>>& volume_cases() {
  static const std::vector<SampleCase<sampler3D>> cases{
      {"texture(s, smooth_p)", false,
       [](const sampler3D& s, const Pixel packet[8], int lane) {
         return texture(s, packet[lane].smooth_p, implicit_lod(s, solid(packet, lane), lane & 3));
       }},
      {"textureLodOffset(s, random_p.xyz, 0.0, ivec3(1, -3, 2))", true,
       [](const sampler3D& s, const Pixel packet[8], int lane) {
         return textureLodOffset(s, packet[lane].random_p.xyz(), 0.0F, ivec3(1, -3, 2));
       }},
  };
  return cases;
}

// A read by pixel `lane` of a cube that all of the packet read: request(i) and point(i) are pixel i's.
template <class Point, class Request>
vec4 read_cube(const samplerCube& s, int lane, const Point& point, const Request& request) {
  LodRequest own = request(lane);
  for (int i = 0; i < 8; ++i) {
    const auto at = detail::coordinates(point(i));
    own.corners |= s.bound.sampling->corners(*s.bound.view, s.bound.state, at.v, request(i));
  }
  return detail::sampled(s.bound, point(lane), own);
}

const std::vector<SampleCase<samplerCube>>& cube_cases() {
  static const std::vector<SampleCase<samplerCube>> cases{
      {"texture(s, smooth_p)", true,
       [](const samplerCube& s, const Pixel packet[8], int lane) {
         return read_cube(
             s, lane, [&](int i) { return packet[i].smooth_p; },
             [&](int i) { return detail::request(implicit_lod(s, solid(packet, i), i & 3)); });
       }},
      {"texture(s, random_p.xyz)", true,
       [](const samplerCube& s, const Pixel packet[8], int lane) {
         const auto point = [&](int i) { return packet[i].random_p.xyz(); };
         return read_cube(s, lane, point, [&](int i) {
           const int first = i & 4;
           const Quad<vec3> quad{{point(first), point(first + 1), point(first + 2), point(first + 3)}};
           return detail::request(implicit_lod(s, quad, i & 3));
         });
       }},
      {"textureLod(s, random_p.xyz, q.x)", true,
       [](const samplerCube& s, const Pixel packet[8], int lane) {
         return read_cube(
             s, lane, [&](int i) { return packet[i].random_p.xyz(); },
             [&](int i) { return detail::request(packet[i].q.x); });
       }},
      {"textureGrad(s, random_p.xyz, q.xyz * 0.125, q.wzx * 0.125)", true,
       [](const samplerCube& s, const Pixel packet[8], int lane) {
         const auto point = [&](int i) { return packet[i].random_p.xyz(); };
         return read_cube(s, lane, point, [&](int i) {
           const vec4 q = packet[i].q * 0.125F;
           return detail::request(s.bound, point(i), q.xyz(), q.wzx());
         });
       }},
  };
  return cases;
}

const std::vector<SampleCase<sampler2D>>& fetch_cases() {
  static const std::vector<SampleCase<sampler2D>> cases{
      {"texelFetch(s, ivec2(random_p.xy * 8.0), 0)", true,
       [](const sampler2D& s, const Pixel packet[8], int lane) {
         return texelFetch(s, make<ivec2>(packet[lane].random_p.xy() * 8.0F), 0);
       }},
      {"texelFetch(s, ivec2(random_p.xy * 4.0), int(q.x))", true,
       [](const sampler2D& s, const Pixel packet[8], int lane) {
         return texelFetch(s, make<ivec2>(packet[lane].random_p.xy() * 4.0F), make<int>(packet[lane].q.x));
       }},
      {"texelFetchOffset(s, ivec2(random_p.xy * 8.0), 0, ivec2(1, -2))", true,
       [](const sampler2D& s, const Pixel packet[8], int lane) {
         return texelFetchOffset(s, make<ivec2>(packet[lane].random_p.xy() * 8.0F), 0, ivec2(1, -2));
       }},
      {"vec4(textureSize(s, 0), textureSize(s, 1))", true,
       [](const sampler2D& s, const Pixel* /*packet*/, int /*lane*/) {
         return make<vec4>(textureSize(s, 0), textureSize(s, 1));
       }},
  };
  return cases;
}

constexpr auto rgba8 = Texture::Format::rgba8;
constexpr auto rgba32f = Texture::Format::rgba32f;
constexpr auto repeat = shadertwin::Wrap::repeat;
constexpr auto clamp_to_edge = shadertwin::Wrap::clamp;
constexpr auto mirror = shadertwin::Wrap::mirror;

TEST_F(SamplersOnLlvmpipe, FetchesAndSizesHaveItsBits) {
  for (const auto format : {rgba32f, rgba8}) {
    const Setting setting{format, 16, 8, MinFilter::nearest_mipmap_nearest, MagFilter::nearest, repeat};
    expect_agreement(noise(setting, 1, 1), setting, "sampler2D", fetch_cases(), &bind2d);
  }
}

TEST_F(SamplersOnLlvmpipe, NearestAndLinearFilteringAgree) {
  for (const auto format : {rgba32f, rgba8}) {
    for (const auto extent : {ivec2(16, 8), ivec2(13, 7)}) {
      for (const auto wrap : {repeat, clamp_to_edge, mirror}) {
        for (const auto mag : {MagFilter::nearest, MagFilter::linear}) {
          const auto min = mag == MagFilter::nearest ? MinFilter::nearest : MinFilter::linear;
          const Setting setting{format, extent.x, extent.y, min, mag, wrap};
          expect_agreement(noise(setting, 1, 1), setting, "sampler2D", flat_cases(), &bind2d);
        }
      }
    }
  }
}

TEST_F(SamplersOnLlvmpipe, MipmapsAgree) {
  for (const auto format : {rgba32f, rgba8}) {
    for (const auto extent : {ivec2(16, 8), ivec2(13, 7)}) {
      for (const auto min : {MinFilter::nearest_mipmap_nearest, MinFilter::nearest_mipmap_linear,
                             MinFilter::linear_mipmap_nearest, MinFilter::linear_mipmap_linear}) {
        const Setting setting{format, extent.x, extent.y, min, MagFilter::linear, repeat};
        expect_agreement(noise(setting, 1, 1), setting, "sampler2D", flat_cases(), &bind2d);
      }
    }
  }
}

TEST_F(SamplersOnLlvmpipe, VolumesAgree) {
  for (const auto format : {rgba32f, rgba8}) {
    for (const auto extent : {ivec3(8, 4, 4), ivec3(7, 5, 3)}) {
      for (const auto wrap : {repeat, clamp_to_edge}) {
        for (const auto mag : {MagFilter::nearest, MagFilter::linear}) {
          const auto min = mag == MagFilter::nearest ? MinFilter::nearest : MinFilter::linear;
          const Setting setting{format, extent.x, extent.y, min, mag, wrap};
          expect_agreement(noise(setting, extent.z, 1), setting, "sampler3D", volume_cases(), &bind3d);
        }
      }
    }
  }
}

TEST_F(SamplersOnLlvmpipe, MipmapsOfVolumesAgree) {
  for (const auto format : {rgba32f, rgba8}) {
    const Setting setting{format, 8, 4, MinFilter::linear_mipmap_linear, MagFilter::linear, repeat};
    expect_agreement(noise(setting, 4, 1), setting, "sampler3D", volume_cases(), &bind3d);
  }
}

TEST_F(SamplersOnLlvmpipe, CubesAgree) {
  for (const auto format : {rgba32f, rgba8}) {
    for (const auto min : {MinFilter::nearest, MinFilter::linear, MinFilter::linear_mipmap_linear}) {
      const auto mag = min == MinFilter::nearest ? MagFilter::nearest : MagFilter::linear;
      const Setting setting{format, 8, 8, min, mag, clamp_to_edge};
      expect_agreement(noise(setting, 1, 6), setting, "samplerCube", cube_cases(), &bindcube);
    }
  }
}

TEST(UnboundSampler, ReadsOpaqueBlack) {
  EXPECT_EQ(texture(sampler2D{}, vec2(0.5F), Lod{}), vec4(0, 0, 0, 1));
  EXPECT_EQ(texelFetch(sampler3D{}, ivec3(9), 9), vec4(0, 0, 0, 1));
  EXPECT_EQ(textureLod(samplerCube{}, vec3(1), 0.0F), vec4(0, 0, 0, 1));
  EXPECT_EQ(textureSize(sampler2D{}, 0), ivec2(1));
  EXPECT_FALSE(needs_lod(sampler2D{}));
}

TEST(Derivatives, AreDifferencesWithinTheQuad) {
  const Quad<Float> quad{{1, 3, 7, 20}};
  EXPECT_EQ(dFdx(quad, 0), 2);
  EXPECT_EQ(dFdx(quad, 1), 2);
  EXPECT_EQ(dFdx(quad, 3), 13);
  EXPECT_EQ(dFdy(quad, 0), 6);
  EXPECT_EQ(dFdy(quad, 3), 17);
  EXPECT_EQ(fwidth(quad, 2), 19);
}

}  // namespace
}  // namespace shadertwin::glsl
