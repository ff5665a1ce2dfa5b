#include "host/app/options.h"

#include <cstdio>

#include "host/app/add_option.h"
#include "host/base/error.h"
#include "host/text/load.h"
#include "host/text/text_warnings.h"

namespace shadertwin::app {

void add_project_options(CLI::App& command, PlayOptions& o) {
  command
      .add_option("SHADER", o.shader,
                  "a .glsl file (other passes by #iChannel), a folder of Shadertoy tabs, or a Shadertoy JSON")
      ->required();
  add_repeated(
      command, "-D,--define", [&o](const std::string& word) { o.defines.push_back(read_define(word)); },
      "NAME[=VALUE]: #define in front of every pass; sets a shader's knob");
  add_value(command, "--seed", o.seed, read_seed, "the same as -D SEED=N: another stream of random numbers")
      ->type_name("UINT");
  command.add_flag(
      "--vr", o.vr,
      "draw mainVR() instead of mainImage(): the left eye's picture beside the right eye's, each 90 "
      "degrees high, the eyes 64 mm apart at the origin, looking along -z");
  command.add_option("--media", o.media, "the folder that holds the pictures a Shadertoy JSON names");
  add_choice<std::optional<Dialect>, Dialect>(
      command, "--dialect", o.dialect, {{"shadertoy", Dialect::shadertoy}, {"vscode", Dialect::vscode}},
      "whose rules hold: shadertoy or vscode (by default a file's are vscode's, a folder's and a "
      "JSON's shadertoy.com's)");
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

void add_init_option(CLI::App& command, PlayOptions& o) {
  add_choice<Undefined, Undefined>(
      command, "--init", o.init, {{"zero", Undefined::zero}, {"raw", Undefined::raw}},
      "zero: what a shader leaves undefined is what browsers make of it: variables and outputs that "
      "nothing wrote and returns that are missing are zero, indices are clamped; raw: it is what the "
      "device has there",
      "zero");
}

void add_precise_option(CLI::App& command, PlayOptions& o) {
  command.add_flag(
      "--precise", o.precise,
      "play the shader as GLSL ES 3.20 with every computation precise: a GPU's compiler then keeps to "
      "the operations that the text states, as the CPU twin does");
}

void add_frame_options(CLI::App& command, PlayOptions& o) {
  const auto set_size = [&o](const std::string& word) {
    const glm::ivec2 size = read_size(word);
    o.schedule.width = size.x;
    o.schedule.height = size.y;
  };
  add_word(command, "--size", set_size, "picture size in pixels, WIDTHxHEIGHT")
      ->default_str(std::to_string(o.schedule.width) + 'x' + std::to_string(o.schedule.height));
  add_value(command, "--fps", o.schedule.fps, read_rate, "frames a second of shader time", "60")
      ->type_name("FLOAT");
  add_value(command, "--time", o.schedule.t0, read_time, "iTime of the first frame, seconds", "0")
      ->type_name("FLOAT");
  add_value(command, "--date", o.schedule.date, Date::parse, "iDate of the first frame, YYYY-MM-DDTHH:MM:SS",
            "2024-01-01T00:00:00");
}

void add_script_options(CLI::App& command, PlayOptions& o) {
  add_value(command, "--frames", o.frames, read_frames, "how many frames to draw", std::to_string(o.frames))
      ->type_name("INT");
  add_repeated(
      command, "--mouse", [&o](const std::string& word) { o.schedule.mouse.push_back(read_mouse(word)); },
      "X,Y[,down][@FRAME]: the mouse was clicked (or, with down, is held) there from that frame on, in "
      "pixels from the lower left; repeat it for a drag");
  add_repeated(
      command, "--keys",
      [&o](const std::string& word) {
        for (const KeyStep& step : read_keys(word)) o.schedule.keys.push_back(step);
      },
      "NAME[@FRAME[-RELEASE]],...: keys (a, 7, space, left, f1, ...) that are held from a frame on, to the "
      "end or until they are let go before frame RELEASE; a@4-4 is a tap between frames 3 and 4");
}

void add_pass_option(CLI::App& command, PlayOptions& o) {
  command.add_option("--pass", o.pass,
                     "the pass to show instead of the last one (\"Buffer A\", buffera, P3D_RT)");
}

void add_on_option(CLI::App& command, PlayOptions& o) {
  add_value(command, "--on", o.on, read_device,
            "auto, egl, egl:N (shadertwin devices lists them), llvmpipe or osmesa, and /fragment or /compute "
            "if wanted; or cpu or cpu/double, the twin",
            o.on.text);
}

void add_timeout_option(CLI::App& command, PlayOptions& o) {
  add_value(command, "--timeout", o.timeout, read_timeout,
            "on the twin, give up on a frame after so many seconds (0: never)", "0")
      ->type_name("FLOAT");
}

void add_tile_option(CLI::App& command, PlayOptions& o) {
  add_value(command, "--tile", o.tile, read_region,
            "X,Y,WIDTH,HEIGHT: on the twin, draw only these pixels of the last pass, from the lower left");
}

void add_json_option(CLI::App& command, PlayOptions& o) {
  command.add_option("--json", o.json, "also write a report to this file");
}

void refuse(const CLI::App& command, std::initializer_list<const char*> names, const std::string& why) {
  for (const char* name : names)
    if (command.count(name) > 0) throw Error(ExitStatus::usage, std::string(name) + ' ' + why);
}

void refuse_for_gl(const PlayOptions& o, const DeviceChoice& on) {
  if (!on.is_twin() && (o.tile.has_value() || o.timeout > 0.0))
    throw Error(ExitStatus::usage, "--tile and --timeout are for --on cpu only, not for " + on.text);
}

void refuse_for_project(const PlayOptions& o, const Project& project) {
  if (o.vscode_quirks && project.dialect != Dialect::vscode)
    throw Error(ExitStatus::usage,
                o.shader + ": --vscode-quirks is for the rules of vscode: --dialect vscode asks for them");
  if (!o.media.empty() && project.json.empty())
    throw Error(ExitStatus::usage, o.shader + ": --media is for a Shadertoy JSON");
}

int chosen_pass(const Project& project, const PlayOptions& o) {
  if (o.pass.empty()) return static_cast<int>(project.passes.size()) - 1;
  return need_pass(project, o.pass);
}

void check_pixel(glm::ivec2 pixel, glm::ivec2 size) {
  if (pixel.x < size.x && pixel.y < size.y) return;
  throw Error(ExitStatus::usage, "--pixel " + std::to_string(pixel.x) + ',' + std::to_string(pixel.y) +
                                     ": expected X,Y inside the " + std::to_string(size.x) + 'x' +
                                     std::to_string(size.y) + " picture");
}

LoadOptions make_load_options(const PlayOptions& o) {
  LoadOptions load_options;
  load_options.media = o.media;
  load_options.muted = o.mute;
  load_options.vscode_quirks = o.vscode_quirks;
  load_options.undefined = o.init;
  load_options.precise = o.precise;
  load_options.vr = o.vr;
  load_options.dialect = o.dialect;
  load_options.defines = o.defines;
  if (o.seed.has_value()) load_options.defines.emplace_back("SEED", std::to_string(*o.seed));
  return load_options;
}

Project load(const PlayOptions& o, Warnings warnings) {
  Project project = load_project(o.shader, make_load_options(o));
  refuse_for_project(o, project);
  if (!o.quiet)
    for (const std::string& warning : warnings == Warnings::all ? all_warnings(project) : project.warnings)
      std::fprintf(stderr, "%s\n", warning.c_str());
  return project;
}

}  // namespace shadertwin::app
