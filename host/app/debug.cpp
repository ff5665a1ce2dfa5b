#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "host/app/command.h"
#include "host/app/options.h"
#include "host/base/error.h"
#include "reference/twin/twin_device.h"

namespace shadertwin::app {

namespace {

struct DebugOptions : PlayOptions {
  glm::ivec2 pixel{0};
  std::vector<std::string> commands;  // of gdb, for use without a terminal
  bool inside = false;                // this process is the one that gdb runs
};

DeviceChoice read_twin(const std::string& text) {
  if (text != "cpu" && text != "cpu/double") throw Error(ExitStatus::usage, "expected cpu or cpu/double");
  return read_device(text);
}

// What gdb runs: plays up to the pixel, with a stop in front of it.
void play_to_the_pixel(const DebugOptions& options) {
  const Project project = load(options);
  const glm::ivec2 pixel = options.pixel;
  twin::TwinOptions twin_options;
  twin_options.double_precision = options.on.double_precision;
  twin_options.stop_at =
      twin::Breakpoint{chosen_pass(project, options), options.frames - 1, pixel.x, pixel.y};
  const auto player = twin::make_player(project, twin_options);
  FixedClock clock(options.schedule, host_rules(project));
  for (int i = 0; i < options.frames; ++i) player->render(clock.next());
  const Image image = player->read(twin_options.stop_at->pass);
  const float* value = image.at(pixel.x, pixel.y);
  std::printf("pixel %d,%d of %s in frame %d: %.9g %.9g %.9g %.9g\n", pixel.x, pixel.y,
              project.passes[static_cast<std::size_t>(twin_options.stop_at->pass)].name.c_str(),
              options.frames - 1, static_cast<double>(value[0]), static_cast<double>(value[1]),
              static_cast<double>(value[2]), static_cast<double>(value[3]));
}

// Lets gdb show a vector as GLSL has it: (x, y, z).
constexpr const char* vector_printer =
    "python exec(\""
    "def shown(value):\\n"
    "  while value.type.code in (gdb.TYPE_CODE_REF, gdb.TYPE_CODE_RVALUE_REF): value = "
    "value.referenced_value()\\n"
    "  name = value.type.strip_typedefs().name or ''\\n"
    "  if not name.startswith('glm::vec<'): return None\\n"
    "  class Vector:\\n"
    "    def to_string(self): return '(' + ', '.join(str(value[c]) for c in 'xyzw'[:int(name[9])]) + ')'\\n"
    "  return Vector()\\n"
    "gdb.pretty_printers.append(shown)\")";

// Becomes gdb, which runs this program again, with the same arguments and --inside.
[[noreturn]] void become_gdb(const DebugOptions& options, const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {"gdb", "--quiet"};
  const auto command = [&words](const std::string& text) {
    words.emplace_back("-ex");
    words.push_back(text);
  };
  if (!options.commands.empty()) words.emplace_back("--batch");
  command("set breakpoint pending on");
  command("set debuginfod enabled off");
  command("set print thread-events off");
  command("set print inferior-events off");
  command(vector_printer);
  command("break shadertwin_debug_stop");
  command("run");
  command("delete");
  command("tbreak mainImage");
  command("continue");
  for (const std::string& text : options.commands) command(text);
  words.emplace_back("--args");
  words.push_back(std::filesystem::read_symlink("/proc/self/exe").string());
  words.insert(words.end(), arguments.begin(), arguments.end());
  words.emplace_back("--inside");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  execvp("gdb", argv.data());
  throw Error(ExitStatus::device, "gdb can't be started (on Debian: apt install gdb)");
}

}  // namespace

void add_debug(CommandLine app, const std::vector<std::string>& arguments) {
  const CommandLine command =
      app.add_subcommand("debug", "stop gdb in the GLSL at one pixel: its lines, its names, its values");
  const auto options = std::make_shared<DebugOptions>();
  options->on = read_twin("cpu");
  add_options(command, Command::debug, *options);
  add_value(command, "--pixel", options->pixel, read_pixel, "X,Y: the pixel to stop at, from the lower left")
      .required();
  add_value(command, "--on", options->on, read_twin, "cpu, or cpu/double", "cpu");
  command.add_words(
      "--command", [options](const std::string& word) { options->commands.push_back(word); },
      "a gdb command to run after the stop; gdb then ends by itself; may be repeated");
  command.add_flag("--inside", options->inside, "").hidden();
  command.callback([options, arguments] {
    if (options->inside) return play_to_the_pixel(*options);
    // What is wrong with the shader or the options must show before gdb hides it.
    check_pixel(options->pixel, {options->schedule.width, options->schedule.height});
    const Project project = load(*options);
    chosen_pass(project, *options);
    become_gdb(*options, arguments);
  });
}

}  // namespace shadertwin::app
