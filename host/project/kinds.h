// What there is to know of each kind of pass, of input and of uniform, as tables: a new kind is a row here.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "host/project/project.h"

namespace shadertwin {

// Width and height of every face of a cubemap pass (shadertoy.com).
constexpr int cubemap_pass_size = 1024;

// The type of the shader's sampler.
enum class SamplerShape { flat, cube, volume };

struct PassTraits {
  PassKind kind;
  std::string_view name;       // in JSON
  std::string_view title;      // the tab's; of several, they are told apart by a letter behind it
  std::string_view short_tab;  // the start of what a tab's file may be called, too, in lower case
  std::string_view entry;      // the user's function, which the host calls
  bool in_extension;           // the VS Code extension has it, too
  int most;                    // of this kind in a shader of shadertoy.com
  int rank;                    // kinds of lower rank are drawn first
  int faces;                   // of the picture: 6 of a cubemap
  int side;                    // width and height of a face in pixels; 0: the size of the frame
  bool every_frame;            // drawn in every frame, and a picture; else in blocks, for what is heard
  bool is_read;                // by passes on shadertoy.com: HostRules::keeps_previous_pictures holds
  bool keeps_pixels;           // HostRules::keeps_pixels_on_resize holds
  int site_output;             // number of the (first) output of this kind in shadertoy.com's API; 0: none
  std::string_view site_ids;   // of its outputs on the site, of site_id_length and with a space between
  int site_flag;               // bit in `flags` of shadertoy.com's JSON

  // As large as the frame, and flat.
  constexpr bool fills_frame() const { return side == 0; }
  constexpr SamplerShape shape() const { return faces == 6 ? SamplerShape::cube : SamplerShape::flat; }
};

constexpr std::size_t site_id_length = 6;

constexpr std::array<PassTraits, 4> pass_kinds = {{
    {PassKind::image, "image", "Image", "image", "mainImage", true, 1, 3, 1, 0, true, false, false, 37,
     "4dfGRr", 0},
    {PassKind::buffer, "buffer", "Buffer", "buf", "mainImage", true, 4, 1, 1, 0, true, true, true, 257,
     "4dXGR8 XsXGR8 4sXGR8 XdfGR8", 32},
    {PassKind::cubemap, "cubemap", "Cubemap A", "cubemap", "mainCubemap", false, 1, 2, 6, cubemap_pass_size,
     true, true, false, 41, "4dX3Rr", 32},
    {PassKind::sound, "sound", "Sound", "sound", "mainSound", false, 1, 0, 1, sound_block_side, false, false,
     false, 0, "", 8},
}};

constexpr const PassTraits& traits(PassKind kind) {
  return pass_kinds[static_cast<std::size_t>(kind)];
}
inline const PassTraits& traits(const Pass& pass) {
  return traits(pass.kind);
}

// The name of the tab number `index`, from 0, of its kind.
inline std::string tab_name(const PassTraits& kind, int index) {
  std::string name(kind.title);
  if (kind.most > 1) name += {' ', static_cast<char>('A' + index)};
  return name;
}

// Where the texels of an input come from.
enum class InputSource {
  nothing,
  still,   // read or made once: load_texture()
  moving,  // a MovingInput: other ones in every frame
  pass,
  undrawn,  // a pass that the project lacks: zero
  keyboard
};

struct InputKindInfo {
  InputKind kind;
  std::string_view name;       // in shadertoy.json and in exported pages
  std::string_view site_name;  // `ctype` in shadertoy.com's JSON
  InputSource source;
  int files;                    // how many Input::files it has
  std::string_view extensions;  // of such files, in lower case, each with a space behind it
  SamplerShape shape;           // but of a pass: PassTraits::shape()
  bool is_audio;                // spectrum and wave of a sound
  bool has_settings;            // the site lets its users choose filter and wrap
  bool in_extension;            // the VS Code extension has it, too
  int site_flag;                // bit in `flags` of shadertoy.com's JSON
  Sampler site_sampler;         // what the site's editor gives to a new input
  Sampler extension_sampler;    // without #iChannelN::MinFilter and the like
};

namespace input_samplers {

constexpr Sampler plain = {MinFilter::linear, MagFilter::linear, Wrap::repeat, true};
constexpr Sampler plain_unflipped = {MinFilter::linear, MagFilter::linear, Wrap::repeat, false};
constexpr Sampler clamped = {MinFilter::linear, MagFilter::linear, Wrap::clamp, true};
constexpr Sampler nearest = {MinFilter::nearest, MagFilter::nearest, Wrap::clamp, true};
constexpr Sampler nearest_min = {MinFilter::nearest, MagFilter::linear, Wrap::clamp, true};
constexpr Sampler mipmapped = {MinFilter::linear_mipmap_linear, MagFilter::linear, Wrap::repeat, true};
constexpr Sampler mipmapped_cube = {MinFilter::linear_mipmap_linear, MagFilter::linear, Wrap::clamp, false};
constexpr Sampler mipmapped_volume = {MinFilter::linear_mipmap_linear, MagFilter::linear, Wrap::repeat,
                                      false};

}  // namespace input_samplers

constexpr std::array<InputKindInfo, 11> input_kinds = {{
    {InputKind::none, "none", "", InputSource::nothing, 0, "", SamplerShape::flat, false, false, true, 0,
     input_samplers::clamped, input_samplers::plain},
    {InputKind::texture, "texture", "texture", InputSource::still, 1,
     ".png .jpg .jpeg .jpe .bmp .gif .tga .tif .tiff .webp .exr .hdr .dds .psd .ppm .pgm .pbm .pnm .pfm .pic "
     ".jp2 .ico .avif ",
     SamplerShape::flat, false, true, true, 0, input_samplers::mipmapped, input_samplers::plain},
    {InputKind::cubemap, "cubemap", "cubemap", InputSource::still, 6, "", SamplerShape::cube, false, true,
     true, 0, input_samplers::mipmapped_cube, input_samplers::plain_unflipped},
    {InputKind::volume, "volume", "volume", InputSource::still, 1, ".bin ", SamplerShape::volume, false, true,
     false, 0, input_samplers::mipmapped_volume, input_samplers::plain_unflipped},
    {InputKind::pass, "buffer", "buffer", InputSource::pass, 0, "", SamplerShape::flat, false, true, true, 0,
     input_samplers::clamped, input_samplers::plain},
    {InputKind::keyboard, "keyboard", "keyboard", InputSource::keyboard, 0, "", SamplerShape::flat, false,
     false, true, 16, input_samplers::nearest, input_samplers::plain},
    {InputKind::music, "music", "music", InputSource::moving, 1,
     ".mp3 .wav .ogg .oga .flac .m4a .aac .opus .aif .aiff ", SamplerShape::flat, true, false, true, 0,
     input_samplers::clamped, input_samplers::nearest_min},
    {InputKind::video, "video", "video", InputSource::moving, 1,
     ".mp4 .webm .mkv .mov .avi .ogv .m4v .mpg .mpeg ", SamplerShape::flat, false, true, true, 0,
     input_samplers::clamped, input_samplers::plain},
    {InputKind::webcam, "webcam", "webcam", InputSource::moving, 0, "", SamplerShape::flat, false, true, true,
     2, input_samplers::clamped, input_samplers::plain},
    {InputKind::microphone, "microphone", "mic", InputSource::moving, 0, "", SamplerShape::flat, true, false,
     true, 4, input_samplers::clamped, input_samplers::plain},
    {InputKind::undrawn, "missing pass", "", InputSource::undrawn, 0, "", SamplerShape::flat, false, true,
     false, 0, input_samplers::clamped, input_samplers::plain},
}};

constexpr const InputKindInfo& info(InputKind kind) {
  return input_kinds[static_cast<std::size_t>(kind)];
}

// Of the pass that an input reads, drawn or not; null if it reads none.
inline const PassTraits* pass_read(const Project& project, const Input& input) {
  if (input.wanted() == InputKind::undrawn) return &traits(input.undrawn);
  if (input.kind != InputKind::pass) return nullptr;
  return &traits(project.passes[static_cast<std::size_t>(input.pass)]);
}

// Of the sampler for what a channel has, or would have if what is missing were there.
inline SamplerShape shape_of(const Project& project, const Input& input) {
  const PassTraits* const pass = pass_read(project, input);
  return pass != nullptr ? pass->shape() : info(input.wanted()).shape;
}

struct UniformTypeInfo {
  UniformType kind;
  std::string_view name;  // in GLSL
  int components;
  bool is_integer;
};

constexpr std::array<UniformTypeInfo, 9> uniform_types = {{
    {UniformType::float1, "float", 1, false},
    {UniformType::float2, "vec2", 2, false},
    {UniformType::float3, "vec3", 3, false},
    {UniformType::float4, "vec4", 4, false},
    {UniformType::int1, "int", 1, true},
    {UniformType::int2, "ivec2", 2, true},
    {UniformType::int3, "ivec3", 3, true},
    {UniformType::int4, "ivec4", 4, true},
    {UniformType::mat4, "mat4", 16, false},
}};

constexpr const UniformTypeInfo& info(UniformType type) {
  return uniform_types[static_cast<std::size_t>(type)];
}

// Whether every row stands at its kind's number.
constexpr bool in_order(const auto& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (static_cast<std::size_t>(rows[i].kind) != i) return false;
  return true;
}
static_assert(in_order(pass_kinds) && in_order(input_kinds) && in_order(uniform_types));

}  // namespace shadertwin
