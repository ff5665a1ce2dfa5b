// A Shadertoy project as plain data: what to draw, in which order, from which inputs. No OpenGL here.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shadertwin {

// Whose rules hold: shadertoy.com's or those of the VS Code extension "Shader Toy".
enum class Dialect { shadertoy, vscode };

// A cubemap pass is drawn once for each face, with the uniform int `shadertwin_face` from 0 to 5 (+X -X +Y -Y
// +Z -Z), pixel (x, y) into the face's texel (x, y).
enum class PassKind { image, buffer, cubemap, sound };

enum class MinFilter {
  nearest,
  linear,
  nearest_mipmap_nearest,
  nearest_mipmap_linear,
  linear_mipmap_nearest,
  linear_mipmap_linear
};
enum class MagFilter { nearest, linear };
enum class Wrap { repeat, clamp, mirror };

struct Sampler {
  MinFilter min = MinFilter::linear;
  MagFilter mag = MagFilter::linear;
  Wrap wrap = Wrap::repeat;
  bool vflip = true;  // the picture's bottom row is at t = 0

  bool uses_mipmaps() const { return min != MinFilter::nearest && min != MinFilter::linear; }
};

enum class InputKind {
  none,
  texture,  // files[0]
  cubemap,  // files[0..5], +X -X +Y -Y +Z -Z
  volume,   // files[0]
  pass,     // a buffer or the cubemap pass: `pass`
  keyboard,
  music,  // files[0]
  video,  // files[0]
  webcam,
  microphone,
  // A pass of the kind `undrawn` that the project lacks: texels that nobody draws, of the size that the pass
  // would have. shadertoy.com has all of them, drawn or not.
  undrawn
};

// What is bound to one channel of one pass.
struct Input {
  InputKind kind = InputKind::none;
  // Of an empty channel: what is missing there. The shader's sampler has the type for it.
  InputKind missing = InputKind::none;
  Sampler sampler;
  std::vector<std::filesystem::path> files;
  int pass = -1;                        // index into Project::passes when kind is pass
  PassKind undrawn = PassKind::buffer;  // when kind is undrawn
  bool red_only = false;                // a texture of one channel: r is the picture's grey, g = b = 0, a = 1

  // What the channel is, or would be if what is missing were there.
  InputKind wanted() const { return kind == InputKind::none ? missing : kind; }
};

constexpr int max_channels = 10;  // shadertoy.com declares 4 of them, the extension all

// A sound pass is drawn in blocks of sound_block_side * sound_block_side samples, one a pixel, rows from the
// bottom: left in r, right in g, as the shader gives them. A block's first sample has the number
// iSampleOffset and the time iTimeOffset (seconds).
constexpr int sound_block_side = 512;
constexpr int sound_block_samples = sound_block_side * sound_block_side;
constexpr int sound_rate = 44100;  // samples a second, of all sound here

// Where a line of a shader came from. `file` indexes Project::files; -1 is text that the host supplied.
struct SourceLine {
  int file = -1;
  int line = 0;  // from 1
};

// What the text of a pass is made of: only the body is the user's, with the knobs of the command line, Common
// and includes already in it. host/text/render.h puts it all together for a device.
struct PassSource {
  std::string head;  // in front of the body: uniforms, and main() where it comes first
  std::string body;  // one entry of `lines` for every line
  std::string tail;  // behind the body: main() where it comes last
  std::vector<SourceLine> lines;
  std::string helpers;      // functions that rewritten code calls, without a line end
  bool own_output = false;  // the body declares the output
  std::string written;      // the body before its directives and macros were resolved, line for line
  std::string refused;      // lines `file:line: error: text` of what browsers refuse in them
  bool es100 = false;       // written for GLSL ES 1.00
  bool precise = false;     // for GLSL ES 3.20, with `precise` on what is computed
};

// What becomes of that which GLSL leaves undefined: of variables and outputs that nothing wrote, of returns
// that are missing, of indices that are out of bounds.
enum class Undefined {
  zero,  // as in browsers: zero, and indices are clamped
  raw    // whatever the device has there
};

// A uniform that a shader declares and its host does not have.
struct OtherUniform {
  std::string name;
  SourceLine at;
  bool set = false;       // it is another host's, and has the value that it has there
  bool is_block = false;  // a uniform block, which keeps its pass from being drawn
};

// An input of a pass that has no vertex shader: a variable here, refused by browsers where it is used.
struct UnsetInput {
  std::string name;
  SourceLine at;
};

struct Pass {
  std::string name;  // "Image", "Buffer A" ...; for the extension the file's stem
  std::string code;  // the user's own text: the body without defines and Common
  PassKind kind = PassKind::image;
  PassSource source;
  std::array<Input, max_channels> inputs;
  int tab = 0;  // its place among a JSON's passes: there shadertoy.com loads them in that order
  // The pass's own vertex shader (#iVertex): it places the six vertices of two triangles by gl_VertexID,
  // those that turn their backs are not drawn, and its outputs are the fragments' inputs. Nothing: every
  // pixel is drawn.
  std::optional<PassSource> vertex;
  std::vector<OtherUniform> other_uniforms;
  std::vector<UnsetInput> unset_inputs;
  bool has_vr = false;    // it defines mainVR
  bool keyboard = false;  // the extension's iKeyboard is bound: 256x4, rows held, pressed, toggled, released
  bool strict = false;    // #StrictCompatibility: main() is the host's even if the user's text has one
};

enum class UniformType { float1, float2, float3, float4, int1, int2, int3, int4, mat4 };

// An #iUniform of the extension. Values are floats also for integer types (they are exact there).
struct CustomUniform {
  std::string name;
  UniformType type = UniformType::float1;
  bool is_color = false;
  std::array<float, 4> value{};
  bool has_range = false;
  std::array<float, 4> min{};
  std::array<float, 4> max{};
  std::array<float, 4> step{};  // 0: continuous

  bool operator==(const CustomUniform&) const = default;
};

// Name and value of -D NAME=VALUE.
using Defines = std::vector<std::pair<std::string, std::string>>;

// How a project is to be played, whatever shader it is: what LoadOptions asks for, and the Project then has.
struct PlaySettings {
  // Those of the command line: the first lines of every body, of no file, are `#define NAME VALUE`.
  Defines defines = {};
  // As the extension has them: empty channels read (0, 0, 0, 0), and what PingPong says. Only a project of
  // the extension's dialect has it.
  bool vscode_quirks = false;
  bool vr = false;     // the picture is mainVR() for two eyes side by side
  bool muted = false;  // music and the microphone give shadertoy.com's preview signal
  Undefined undefined = Undefined::zero;
  bool precise = false;  // devices compute what the text states, operation by operation
};

struct Project : PlaySettings {
  Dialect dialect = Dialect::shadertoy;
  std::string title;         // from a JSON; else empty
  std::string common;        // the text of the Common tab
  std::vector<Pass> passes;  // in drawing order; the last one is the picture
  std::vector<CustomUniform> uniforms;
  bool first_person_controls = false;  // iViewMatrix follows the keys and the mouse
  bool local = false;                  // SHADER_TOY is defined: the text was written for a local host
  // Every text that the sources came from, as the user would name it: a path; for a JSON its path, a colon
  // and the pass's name.
  std::vector<std::string> files;
  std::vector<std::string> warnings;  // `file:line: warning: text`
  std::vector<SourceLine> versions;   // where the files had a #version, which the passes have not
  std::string json;                   // the document that the project was read from; else empty
};

struct LoadOptions {
  PlaySettings settings = {};
  // Whose rules hold. Not given: a file has those of the extension, a folder those of shadertoy.com.
  std::optional<Dialect> dialect = {};
  // Where the media are that a JSON names: "/media/a/x.jpg" is <media>/media/a/x.jpg or <media>/x.jpg. Empty:
  // the JSON's own folder. Nothing outside of it is opened.
  std::filesystem::path media = {};
  // Uniforms that the caller sets from frame to frame, beside those that the text declares by #iUniform.
  std::vector<CustomUniform> uniforms = {};
};

// Loads a .glsl/.frag file (VS Code dialect) or a folder of Shadertoy tabs: image.glsl and any of
// common.glsl, buffer_a.glsl to buffer_d.glsl, cubemap_a.glsl, sound.glsl, with channels bound by #iChannelN
// or by shadertoy.json in the folder (tabs_settings.h says how). Throws Error(file) for what can't be read,
// Error(shader) for a malformed directive, an include that goes in a circle or a pass without an entry point,
// and Error(usage) for an impossible define. Messages have the form `file:line: error: text`.
// A .json file is a shader as Shadertoy's API (`{"Shader": ...}`), the site (`[...]`) or an export of a
// profile (`{"shaders": [...]}`) gives it; of several the first is taken. Media that are not there are a
// warning and an empty channel. The passes have their own texts, which load_project (host/text/load.h) puts
// into the host's.
Project read_project(const std::filesystem::path& shader, const LoadOptions& options);

// Index of the pass that the user calls `name`: as Pass::name, or without case, spaces and underscores
// ("buffera"). -1 if there is none.
int find_pass(const Project& project, const std::string& name);
// The same for --pass: throws Error(usage) if there is none.
int need_pass(const Project& project, const std::string& name);

// Index of the sound pass, -1 if there is none.
int find_sound(const Project& project);

}  // namespace shadertwin
