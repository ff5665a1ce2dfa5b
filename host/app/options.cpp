#include "host/app/options.h"

#include <algorithm>
#include <cstdio>

#include "host/base/error.h"
#include "host/text/load.h"
#include "host/text/text_warnings.h"
#include "host/view/shown_text.h"

namespace shadertwin::app {

namespace {

using enum Command;
using enum NoEffect;
using Commands = std::initializer_list<Command>;

constexpr Commands all_commands = {view, render, compare, sweep, check, accuracy, export_, debug};
// `sweep` has some as axes of its own.
constexpr Commands all_with_one_value = {view, render, compare, check, accuracy, export_, debug};
constexpr Commands those_with_one_size = {view, render, compare, check, accuracy, debug};
constexpr Commands those_with_a_clock = {view, render, compare, sweep, check, accuracy, debug};
constexpr Commands those_with_a_script = {render, compare, sweep, check, accuracy, debug};
constexpr Commands those_with_a_pass = {view, render, compare, sweep, accuracy, debug};
constexpr Commands those_with_a_picture = {view, render, compare, debug};

template <typename List, typename T>
bool among(const List& list, T value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

}  // namespace

void add_options(CommandLine app, Command command, PlayOptions& o) {
  PlaySettings& settings = o.load.settings;
  Schedule& schedule = o.schedule;
  const auto declare = [&](Commands commands, std::vector<NoEffect> no_effect, auto add) -> Declared* {
    if (!among(commands, command)) return nullptr;
    o.declared.push_back({add(), std::move(no_effect)});
    return &o.declared.back();
  };
  const auto declare_for_pixels = [&](Commands commands, std::vector<NoEffect> no_effect, auto add) {
    if (Declared* const declared = declare(commands, std::move(no_effect), add))
      declared->changes_pixels = true;
  };

  declare(all_commands, {}, [&] {
    return app
        .add_option(
            "SHADER", o.shader,
            "a .glsl file (other passes by #iChannel), a folder of Shadertoy tabs, or a Shadertoy JSON")
        .required();
  });
  declare_for_pixels(all_with_one_value, {}, [&] {
    return add_repeated(
        app, "-D,--define",
        [&settings](const std::string& word) { settings.defines.push_back(read_define(word)); },
        "NAME[=VALUE]: #define in front of every pass; sets a shader's knob");
  });
  declare_for_pixels(all_with_one_value, {}, [&] {
    const auto add = [&settings](const std::string& word) {
      settings.defines.emplace_back("SEED", std::to_string(read_seed(word)));
    };
    return add_word(app, "--seed", add, "the same as -D SEED=N: another stream of random numbers")
        .type_name("UINT");
  });
  declare_for_pixels(all_commands, {on_sound, on_site_export}, [&] {
    return app.add_flag(
        "--vr", settings.vr,
        "draw mainVR() instead of mainImage(): the left eye's picture beside the right eye's, each 90 "
        "degrees high, the eyes 64 mm apart at the origin, looking along -z");
  });
  declare_for_pixels(all_commands, {on_files}, [&] {
    return add_word(
        app, "--media", [&o](const std::string& word) { o.load.media = word; },
        "the folder that holds the pictures a Shadertoy JSON names");
  });
  declare_for_pixels(all_commands, {}, [&] {
    return add_choice<std::optional<Dialect>, Dialect>(
        app, "--dialect", o.load.dialect, {{"shadertoy", Dialect::shadertoy}, {"vscode", Dialect::vscode}},
        "whose rules hold: shadertoy or vscode (by default a file's are vscode's, a folder's and a "
        "JSON's shadertoy.com's)");
  });
  declare_for_pixels(all_commands, {on_sound, on_site_export, on_cpp_export}, [&] {
    return app.add_flag(
        "--mute", settings.muted,
        "nothing is heard; music and the microphone give the signal that shadertoy.com shows where "
        "sound is muted");
  });
  declare_for_pixels(all_commands, {on_site_rules, on_site_export, on_cpp_export}, [&] {
    return app.add_flag(
        "--vscode-quirks", settings.vscode_quirks,
        "with the rules of vscode: also what only the extension does. iMouse starts at -1 and its w is "
        "positive on the frame after a release, too; the first iTimeDelta is 0; empty channels have "
        "alpha 0; all passes are drawn once before frame 0; a pass reads of a later one that reads itself "
        "what it drew two frames ago; iChannelResolution of passes stays what it was at the start");
  });
  declare(all_commands, {},
          [&] { return app.add_flag("--quiet", o.quiet, "no warnings and no progress bar"); });
  declare_for_pixels({view, render, compare, export_, debug}, {on_site_export}, [&] {
    return add_choice<Undefined, Undefined>(
        app, "--init", settings.undefined, {{"zero", Undefined::zero}, {"raw", Undefined::raw}},
        "zero: what a shader leaves undefined is what browsers make of it: variables and outputs that "
        "nothing wrote and returns that are missing are zero, indices are clamped; raw: it is what the "
        "device has there",
        "zero");
  });
  declare_for_pixels(those_with_a_picture, {on_sound}, [&] {
    return app.add_flag(
        "--precise", settings.precise,
        "play the shader as GLSL ES 3.20 with every computation precise: a GPU's compiler then keeps to "
        "the operations that the text states, as the CPU twin does");
  });

  // Size and time of the frames.
  declare(those_with_one_size, {on_sound}, [&] {
    const auto set = [&schedule](const std::string& word) {
      const glm::ivec2 size = read_size(word);
      schedule.width = size.x;
      schedule.height = size.y;
    };
    return add_word(app, "--size", set, "picture size in pixels, WIDTHxHEIGHT")
        .default_str(std::to_string(schedule.width) + 'x' + std::to_string(schedule.height));
  });
  declare(those_with_a_clock, {on_sound}, [&] {
    return add_value(app, "--fps", schedule.fps, read_rate, "frames a second of shader time", "60")
        .type_name("FLOAT");
  });
  declare(those_with_a_clock, {}, [&] {
    return add_value(app, "--time", schedule.t0, read_time, "iTime of the first frame, seconds", "0")
        .type_name("FLOAT");
  });
  declare(those_with_a_clock, {}, [&] {
    return add_value(app, "--date", schedule.date, Date::parse,
                     "iDate of the first frame, YYYY-MM-DDTHH:MM:SS", "2024-01-01T00:00:00");
  });

  // How many frames, with what mouse and keys.
  declare(those_with_a_script, {on_sound}, [&] {
    return add_value(app, "--frames", o.frames, read_frames, "how many frames to draw",
                     std::to_string(o.frames))
        .type_name("INT");
  });
  declare(those_with_a_script, {on_sound}, [&] {
    return add_repeated(
        app, "--mouse", [&schedule](const std::string& word) { schedule.mouse.push_back(read_mouse(word)); },
        "X,Y[,down][@FRAME]: the mouse was clicked (or, with down, is held) there from that frame on, in "
        "pixels from the lower left; repeat it for a drag");
  });
  declare(those_with_a_script, {on_sound}, [&] {
    const auto add = [&schedule](const std::string& word) {
      for (const KeyStep& step : read_keys(word)) schedule.keys.push_back(step);
    };
    return add_repeated(
        app, "--keys", add,
        "NAME[@FRAME[-RELEASE]],...: keys (a, 7, space, left, f1, ...) that are held from a frame on, to the "
        "end or until they are let go before frame RELEASE; a@4-4 is a tap between frames 3 and 4");
  });

  declare(those_with_a_pass, {on_sound}, [&] {
    return app.add_option("--pass", o.pass,
                          "the pass to show instead of the last one (\"Buffer A\", buffera, P3D_RT)");
  });
  declare({view, render}, {}, [&] {
    return add_value(
        app, "--on", o.on, read_device,
        "auto, egl, egl:N (shadertwin devices lists them), llvmpipe or osmesa, and /fragment or /compute "
        "if wanted; or cpu or cpu/double, the twin",
        o.on.text);
  });
  declare({view, render, compare}, {on_sound, on_opengl}, [&] {
    return add_value(
        app, "--tile", o.tile, read_region,
        "X,Y,WIDTH,HEIGHT: on the twin, draw only these pixels of the last pass, from the lower left");
  });
  declare({view, render, compare, sweep, check, accuracy}, {on_opengl}, [&] {
    return add_value(app, "--timeout", o.timeout, read_timeout,
                     "on the twin, give up on a frame after so many seconds (0: never)", "0")
        .type_name("FLOAT");
  });
  declare({render, compare, sweep, check, accuracy}, {},
          [&] { return app.add_option("--json", o.json, "also write a report to this file"); });
}

void refuse(const PlayOptions& o, NoEffect where, const std::string& why) {
  for (const Declared& declared : o.declared)
    if (declared.option.given() && among(declared.no_effect, where))
      throw Error(ExitStatus::usage, declared.option.name() + ' ' + why);
}

void refuse(CommandLine command, std::initializer_list<const char*> names, const std::string& why) {
  for (const char* name : names)
    if (command.given(name)) throw Error(ExitStatus::usage, std::string(name) + ' ' + why);
}

void refuse_for_player(const PlayOptions& o, const DeviceChoice& on) {
  if (!on.is_twin()) refuse(o, on_opengl, "is for --on cpu only, not for " + on.text);
}

std::string options_text(const PlayOptions& o) {
  std::string text;
  for (const auto& [option, no_effect, changes_pixels] : o.declared) {
    if (!changes_pixels) continue;
    for (const std::string& word : option.words())
      text += (text.empty() ? "" : " ") + option.shortest_name() +
              (option.is_flag() ? "" : ' ' + view::quoted(word));
  }
  return text;
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

void refuse_for_project(const PlayOptions& o, const Project& project) {
  if (project.dialect != Dialect::vscode)
    refuse(o, on_site_rules, "is for the rules of vscode (--dialect vscode), not for " + o.shader);
  if (project.json.empty()) refuse(o, on_files, "is for a Shadertoy JSON, not for " + o.shader);
}

Project load(const PlayOptions& o, Warnings warnings) {
  Project project = load_project(o.shader, o.load);
  refuse_for_project(o, project);
  if (!o.quiet)
    for (const std::string& warning : warnings == Warnings::all ? all_warnings(project) : project.warnings)
      std::fprintf(stderr, "%s\n", warning.c_str());
  return project;
}

}  // namespace shadertwin::app
