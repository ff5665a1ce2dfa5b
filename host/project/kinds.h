// What there is to know of each kind of pass, of input and of uniform, as tables: a new kind is a row here.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "host/project/project.h"

namespace shadertwin {

// Width and height of every face of a cubemap pass (shadertoy.com).
constexpr int cubemap_pass_size = 1024;

struct PassTraits {
  PassKind kind;
  std::string_view name;   // in JSON
  std::string_view title;  // the tab's; of several, they are told apart by a letter behind it
  int most;                // of this kind in a shader of shadertoy.com
  int rank;                // kinds of lower rank are drawn first
  int faces;               // of the picture: 6 of a cubemap
  int side;                // width and height of a face in pixels; 0: the size of the frame
  bool every_frame;        // drawn in every frame, and a picture; else in blocks, for what is heard
  bool keeps_previous;     // HostRules::keeps_previous_pictures holds
  bool keeps_pixels;       // HostRules::keeps_pixels_on_resize holds
  int site_output;         // id of the (first) output of this kind in shadertoy.com's JSON; 0: there is none
  int site_flag;           // bit in `flags` of that JSON
};

constexpr std::array<PassTraits, 4> pass_kinds = {{
    {PassKind::image, "image", "Image", 1, 3, 1, 0, true, false, false, 37, 0},
    {PassKind::buffer, "buffer", "Buffer", 4, 1, 1, 0, true, true, true, 257, 32},
    {PassKind::cubemap, "cubemap", "Cubemap A", 1, 2, 6, cubemap_pass_size, true, true, false, 41, 32},
    {PassKind::sound, "sound", "Sound", 1, 0, 1, sound_block_side, false, false, false, 0, 8},
}};

constexpr const PassTraits& traits(PassKind kind) {
  return pass_kinds[static_cast<std::size_t>(kind)];
}
inline const PassTraits& traits(const Pass& pass) {
  return traits(pass.kind);
}
// Of the pass that an input of kind InputKind::pass reads.
inline const PassTraits& traits_of_source(const Project& project, const Input& input) {
  return traits(project.passes[static_cast<std::size_t>(input.pass)]);
}

// Where the texels of an input come from.
enum class InputSource {
  nothing,
  files,   // read once
  moving,  // a MovingInput: other ones in every frame
  pass,
  undrawn,  // a pass that the project lacks: zero
  keyboard
};

// The type of the shader's sampler.
enum class SamplerShape { flat, cube, volume };

struct InputKindInfo {
  InputKind kind;
  std::string_view name;       // in shadertoy.json and in exported pages
  std::string_view site_name;  // `ctype` in shadertoy.com's JSON
  InputSource source;
  int files;                  // how many Input::files it has
  SamplerShape shape;         // of a pass: of one that is a flat picture
  bool is_audio;              // spectrum and wave of a sound
  bool has_settings;          // the site lets its users choose filter and wrap
  bool in_extension;          // the VS Code extension has it, too
  int site_flag;              // bit in `flags` of shadertoy.com's JSON
  Sampler site_sampler;       // what the site's editor gives to a new input
  Sampler extension_sampler;  // without #iChannelN::MinFilter and the like
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

constexpr std::array<InputKindInfo, 12> input_kinds = {{
    {InputKind::none, "none", "", InputSource::nothing, 0, SamplerShape::flat, false, false, true, 0,
     input_samplers::clamped, input_samplers::plain},
    {InputKind::texture, "texture", "texture", InputSource::files, 1, SamplerShape::flat, false, true, true,
     0, input_samplers::mipmapped, input_samplers::plain},
    {InputKind::cubemap, "cubemap", "cubemap", InputSource::files, 6, SamplerShape::cube, false, true, true,
     0, input_samplers::mipmapped_cube, input_samplers::plain_unflipped},
    {InputKind::volume, "volume", "volume", InputSource::files, 1, SamplerShape::volume, false, true, false,
     0, input_samplers::mipmapped_volume, input_samplers::plain_unflipped},
    {InputKind::pass, "buffer", "buffer", InputSource::pass, 0, SamplerShape::flat, false, true, true, 0,
     input_samplers::clamped, input_samplers::plain},
    {InputKind::keyboard, "keyboard", "keyboard", InputSource::keyboard, 0, SamplerShape::flat, false, false,
     true, 16, input_samplers::nearest, input_samplers::plain},
    {InputKind::music, "music", "music", InputSource::moving, 1, SamplerShape::flat, true, false, true, 0,
     input_samplers::clamped, input_samplers::nearest_min},
    {InputKind::video, "video", "video", InputSource::moving, 1, SamplerShape::flat, false, true, true, 0,
     input_samplers::clamped, input_samplers::plain},
    {InputKind::webcam, "webcam", "webcam", InputSource::moving, 0, SamplerShape::flat, false, true, true, 2,
     input_samplers::clamped, input_samplers::plain},
    {InputKind::microphone, "microphone", "mic", InputSource::moving, 0, SamplerShape::flat, true, false,
     true, 4, input_samplers::clamped, input_samplers::plain},
    {InputKind::undrawn_buffer, "missing buffer", "buffer", InputSource::undrawn, 0, SamplerShape::flat,
     false, true, false, 0, input_samplers::clamped, input_samplers::plain},
    {InputKind::undrawn_cubemap, "missing cubemap pass", "cubemap", InputSource::undrawn, 0,
     SamplerShape::cube, false, true, false, 0, input_samplers::mipmapped_cube, input_samplers::plain},
}};

constexpr const InputKindInfo& info(InputKind kind) {
  return input_kinds[static_cast<std::size_t>(kind)];
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
