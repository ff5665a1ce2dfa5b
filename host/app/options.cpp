#include "host/app/options.h"

#include <charconv>
#include <cmath>
#include <cstdio>

#include "host/base/error.h"
#include "reference/emit/emit_defined.h"
#include "reference/emit/emit_precise.h"

namespace shadertwin::app {

namespace {

constexpr int max_size = 65536;

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find(separator); end != std::string::npos; end = text.find(separator, begin)) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

template <typename Number>
bool read_number(const std::string& text, Number& number) {
  const auto [rest, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  return failure == std::errc() && rest == text.data() + text.size();
}

// "VALUE@FRAME" -> VALUE, FRAME. Without @ the frame is 0.
std::pair<std::string, int> split_frame(const std::string& option, const std::string& text) {
  const std::size_t at = text.rfind('@');
  int frame = 0;
  if (at != std::string::npos && (!read_number(text.substr(at + 1), frame) || frame < 0))
    throw Error(ExitStatus::usage, option + " " + text + ": expected a frame number after @");
  return {text.substr(0, at), frame};
}

MouseStep parse_mouse(const std::string& text) {
  const auto [value, frame] = split_frame("--mouse", text);
  const auto parts = split(value, ',');
  MouseStep step;
  step.frame = frame;
  const bool valid = (parts.size() == 2 || (parts.size() == 3 && parts[2] == "down")) &&
                     read_number(parts[0], step.position.x) && read_number(parts[1], step.position.y) &&
                     std::isfinite(step.position.x) && std::isfinite(step.position.y);
  if (!valid)
    throw Error(ExitStatus::usage, "--mouse " + text + ": expected X,Y or X,Y,down, then @FRAME if not 0");
  step.down = parts.size() == 3;
  return step;
}

// "NAME", "NAME@FRAME" or "NAME@FRAME-RELEASE".
KeyStep parse_key(const std::string& text) {
  const std::size_t at = text.rfind('@');
  const std::size_t dash = at == std::string::npos ? at : text.find('-', at);
  const auto [name, frame] = split_frame("--keys", text.substr(0, dash));
  const auto code = key_code(name);
  if (!code.has_value()) throw Error(ExitStatus::usage, "--keys " + text + ": unknown key");
  KeyStep step{frame, *code};
  if (dash == std::string::npos) return step;
  int release = 0;
  if (!read_number(text.substr(dash + 1), release) || release < frame)
    throw Error(ExitStatus::usage,
                "--keys " + text + ": expected NAME@FRAME-RELEASE, the later frame behind the dash");
  step.release = release;
  return step;
}

void add_repeated(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                  const std::string& help) {
  command.add_option(name, values, help)->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace

void add_load_options(CLI::App& command, PlayOptions& o) {
  command
      .add_option("SHADER", o.shader,
                  "a .glsl file (other passes by #iChannel) or a folder of Shadertoy tabs")
      ->required();
  add_repeated(command, "-D,--define", o.defines,
               "NAME[=VALUE]: #define in front of every pass; sets a shader's knob");
  command.add_flag(
      "--precise", o.precise,
      "play the shader as GLSL ES 3.20 with every computation precise: a GPU's compiler then keeps to "
      "the operations that the text states, as the CPU twin does");
  command
      .add_option(
          "--init", o.init,
          "zero: what a shader leaves undefined is what browsers make of it: variables and outputs that "
          "nothing wrote and returns that are missing are zero, indices are clamped; raw: it is what the "
          "device has there")
      ->check(CLI::IsMember({"zero", "raw"}));
  command.add_flag(
      "--vr", o.vr,
      "draw mainVR() instead of mainImage(): the left eye's picture beside the right eye's, each 90 "
      "degrees high, the eyes 64 mm apart at the origin, looking along -z");
  command.add_option("--seed", o.seed, "the same as -D SEED=N: another stream of random numbers");
  command.add_option("--media", o.media, "the folder that holds the pictures a Shadertoy JSON names");
  command
      .add_option("--dialect", o.dialect,
                  "whose rules hold: shadertoy or vscode (by default a file's are vscode's, a folder's and a "
                  "JSON's shadertoy.com's)")
      ->check(CLI::IsMember({"shadertoy", "vscode"}));
  command.add_flag(
      "--mute", o.mute,
      "nothing is heard; music and the microphone give the signal that shadertoy.com shows where "
      "sound is muted");
  command.add_flag(
      "--vscode-quirks", o.vscode_quirks,
      "with the rules of vscode: also what only the extension does. iMouse starts at -1 and its w is "
      "positive on the frame after a release, too; the first iTimeDelta is 0; empty channels have "
      "alpha 0; all passes are drawn once before frame 0; a pass reads of a later one that reads itself "
      "what it drew two frames ago; iChannelResolution of passes stays what it was at the start");
  command.add_flag("--quiet", o.quiet, "no warnings and no progress bar");
}

void add_shader_options(CLI::App& command, PlayOptions& o) {
  add_load_options(command, o);
  command.add_option("--size", o.size, "picture size in pixels, WIDTHxHEIGHT");
  command.add_option("--fps", o.fps, "frames a second of shader time");
  command.add_option("--time", o.time, "iTime of the first frame, seconds");
  command.add_option("--date", o.date, "iDate of the first frame, YYYY-MM-DDTHH:MM:SS (2024-01-01T00:00:00)");
  command.add_option("--pass", o.pass,
                     "the pass to show instead of the last one (\"Buffer A\", buffera, P3D_RT)");
  command.add_option(
      "--tile", o.tile,
      "X,Y,WIDTH,HEIGHT: with --on cpu, draw only these pixels of the last pass, from the lower left");
  command
      .add_option("--timeout", o.timeout,
                  "with --on cpu, give up on a frame after so many seconds (0: never)")
      ->check(CLI::NonNegativeNumber);
}

void add_play_options(CLI::App& command, PlayOptions& o) {
  add_shader_options(command, o);
  command.add_option("--frames", o.frames, "how many frames to draw");
  add_repeated(
      command, "--mouse", o.mouse,
      "X,Y[,down][@FRAME]: the mouse was clicked (or, with down, is held) there from that frame on, in "
      "pixels from the lower left; repeat it for a drag");
  add_repeated(
      command, "--keys", o.keys,
      "NAME[@FRAME[-RELEASE]],...: keys (a, 7, space, left, f1, ...) that are held from a frame on, to the "
      "end or until they are let go before frame RELEASE; a@4-4 is a tap between frames 3 and 4");
  command.add_option("--json", o.json, "also write a report to this file");
}

void add_on_option(CLI::App& command, PlayOptions& o) {
  command.add_option(
      "--on", o.on,
      "auto, egl, egl:N (shadertwin devices lists them), llvmpipe or osmesa, and /fragment or /compute "
      "if wanted; or cpu or "
      "cpu/double, the twin");
}

TileRegion parse_tile(const std::string& text) {
  const auto parts = split(text, ',');
  TileRegion tile;
  const bool valid = parts.size() == 4 && read_number(parts[0], tile.x) && read_number(parts[1], tile.y) &&
                     read_number(parts[2], tile.width) && read_number(parts[3], tile.height) && tile.x >= 0 &&
                     tile.y >= 0 && tile.width > 0 && tile.height > 0;
  if (!valid) throw Error(ExitStatus::usage, "--tile " + text + ": expected X,Y,WIDTH,HEIGHT in pixels");
  return tile;
}

Schedule make_schedule(const PlayOptions& o) {
  Schedule schedule;
  const auto parts = split(o.size, 'x');
  if (parts.size() != 2 || !read_number(parts[0], schedule.width) ||
      !read_number(parts[1], schedule.height) || schedule.width < 1 || schedule.height < 1 ||
      schedule.width > max_size || schedule.height > max_size)
    throw Error(ExitStatus::usage,
                "--size " + o.size + ": expected WIDTHxHEIGHT, each from 1 to " + std::to_string(max_size));
  if (o.frames < 1)
    throw Error(ExitStatus::usage, "--frames " + std::to_string(o.frames) + ": there must be at least one");
  if (!(o.fps > 0.0) || !std::isfinite(o.fps)) throw Error(ExitStatus::usage, "--fps must be above 0");
  if (!std::isfinite(o.time)) throw Error(ExitStatus::usage, "--time must be a finite number");
  schedule.fps = o.fps;
  schedule.t0 = o.time;
  schedule.vscode_quirks = o.vscode_quirks;
  if (!o.date.empty()) schedule.date = Date::parse(o.date);
  for (const std::string& text : o.mouse) schedule.mouse.push_back(parse_mouse(text));
  for (const std::string& list : o.keys)
    for (const std::string& text : split(list, ',')) schedule.keys.push_back(parse_key(text));
  return schedule;
}

LoadOptions make_load_options(const PlayOptions& o) {
  LoadOptions load_options;
  load_options.media = o.media;
  load_options.muted = o.mute;
  load_options.vscode_quirks = o.vscode_quirks;
  load_options.zero_outputs = o.init == "zero";
  load_options.vr = o.vr;
  if (!o.dialect.empty()) load_options.dialect = o.dialect == "vscode" ? Dialect::vscode : Dialect::shadertoy;
  auto defines = o.defines;
  if (!o.seed.empty()) {
    unsigned seed = 0;
    if (!read_number(o.seed, seed))
      throw Error(ExitStatus::usage, "--seed " + o.seed + ": expected a number from 0");
    defines.push_back("SEED=" + o.seed);
  }
  for (const std::string& text : defines) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const bool valid = !name.empty() &&
                       name.find_first_not_of(
                           "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                           "0123456789_") == std::string::npos &&
                       (name[0] < '0' || name[0] > '9') && text.find('\n') == std::string::npos;
    if (!valid) throw Error(ExitStatus::usage, "-D " + text + ": expected NAME or NAME=VALUE");
    load_options.defines.emplace_back(name, equals == std::string::npos ? "1" : text.substr(equals + 1));
  }
  return load_options;
}

int chosen_pass(const Project& project, const PlayOptions& o) {
  if (o.pass.empty()) return static_cast<int>(project.passes.size()) - 1;
  const int pass = find_pass(project, o.pass);
  if (pass >= 0) return pass;
  std::string names;
  for (const Pass& p : project.passes) names += (names.empty() ? "" : ", ") + p.name;
  throw Error(ExitStatus::usage, "--pass " + o.pass + ": the passes are " + names);
}

Project load(const PlayOptions& o) {
  Project project = load_project(o.shader, make_load_options(o));
  if (!o.quiet)
    for (const std::string& warning : project.warnings) std::fprintf(stderr, "%s\n", warning.c_str());
  if (!o.precise) return project;
  return emit_precise(o.init == "zero" ? emit_defined(project) : project);
}

std::function<Project(const Project&)> rewrite_for_gl(const PlayOptions& o) {
  if (o.init != "zero" || o.precise) return {};
  return emit_defined;
}

}  // namespace shadertwin::app
