#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>

#include "host/app/command.h"
#include "host/app/options.h"
#include "host/app/players.h"
#include "host/app/progress.h"
#include "host/app/report.h"
#include "host/base/error.h"
#include "host/base/output_file.h"
#include "host/image/image.h"

namespace shadertwin::app {

namespace {

using Clock = std::chrono::steady_clock;

struct RenderOptions : PlayOptions {
  std::string output;
};

// Where the pictures go: one file for the last frame, or a numbered one for every frame ("frame_%04d.png").
class Output {
 public:
  explicit Output(std::string pattern) : pattern_(std::move(pattern)) {
    if (!can_write(pattern_))
      throw Error(ExitStatus::usage, pattern_ + ": the output must end in .png, .jpg or .exr");
    static const std::regex number("%0?[0-9]?d");
    const auto matches = std::distance(std::sregex_iterator(pattern_.begin(), pattern_.end(), number), {});
    if (matches > 1) throw Error(ExitStatus::usage, pattern_ + ": only one %d can be numbered");
    sequence_ = matches == 1;
    // An output that can't be written must fail before the work, not after it.
    const OutputFile probe(name(0));
  }

  bool sequence() const { return sequence_; }
  std::string name(int frame) const {
    if (!sequence_) return pattern_;
    std::smatch match;
    static const std::regex number("%(0?)([0-9]?)d");
    std::regex_search(pattern_, match, number);
    std::string digits = std::to_string(frame);
    const std::size_t width = match[2].length() == 0 ? 0 : static_cast<std::size_t>(match[2].str()[0] - '0');
    if (digits.size() < width) digits.insert(0, width - digits.size(), match[1].length() == 0 ? ' ' : '0');
    return match.prefix().str() + digits + match.suffix().str();
  }

 private:
  std::string pattern_;
  bool sequence_ = false;
};

// How many frames to draw before waiting for the device: enough that it never idles, so few that the bar
// moves and Ctrl-C works.
class Batch {
 public:
  void drawn(Player& player) {
    if (++pending_ < size_) return;
    player.finish();
    const auto now = Clock::now();
    constexpr auto target = std::chrono::milliseconds(50);
    if (now - start_ < target / 2 && size_ < 64) size_ *= 2;
    if (now - start_ > target && size_ > 1) size_ /= 2;
    start_ = now;
    pending_ = 0;
  }

 private:
  int pending_ = 0;
  int size_ = 1;
  Clock::time_point start_ = Clock::now();
};

nlohmann::json statistics(const Image& image) {
  std::size_t nan = 0;
  std::size_t infinite = 0;
  std::size_t negative = 0;
  double sum = 0.0;
  std::size_t finite = 0;
  float low = INFINITY;
  float high = -INFINITY;
  for (const float value : image.rgba) {
    if (std::isnan(value)) {
      ++nan;
    } else if (std::isinf(value)) {
      ++infinite;
    } else {
      ++finite;
      sum += value;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    if (value < 0.0F) ++negative;
  }
  nlohmann::json j = {{"nan", nan}, {"inf", infinite}, {"negative", negative}};
  if (finite != 0) j.update({{"min", low}, {"max", high}, {"mean", sum / static_cast<double>(finite)}});
  return j;
}

void render(const RenderOptions& options) {
  const Schedule schedule = make_schedule(options);
  const Output output(options.output);
  const Project project = load(options);
  const int shown = chosen_pass(project, options);
  const auto player = open_player(options.on, project, options);

  FixedClock clock(schedule, project.dialect);
  Batch batch;
  const auto start = Clock::now();
  {
    Progress progress("rendering", options.frames, options.quiet);
    for (int i = 0; i < options.frames; ++i) {
      player->render(clock.next());
      if (output.sequence())
        write_image(player->read(shown), output.name(i));
      else
        batch.drawn(*player);
      progress.update(i + 1);
    }
    player->finish();
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (!output.sequence()) write_image(player->read(shown), output.name(0));
  if (!options.json.empty()) {
    nlohmann::json passes = nlohmann::json::array();
    for (std::size_t i = 0; i < project.passes.size(); ++i)
      if (project.passes[i].kind != PassKind::sound) {
        nlohmann::json entry = {{"name", project.passes[i].name}};
        entry.update(statistics(player->read(static_cast<int>(i))));
        passes.push_back(entry);
      }
    write_report(options.json, {{"device", player->description()},
                                {"size", {schedule.width, schedule.height}},
                                {"frames", options.frames},
                                {"seconds", seconds},
                                {"milliseconds_per_frame", 1000.0 * seconds / options.frames},
                                {"passes", passes}});
  }
}

}  // namespace

void add_render(CLI::App& app) {
  CLI::App* command = app.add_subcommand("render", "draw a shader without a window and write the picture");
  const auto options = std::make_shared<RenderOptions>();
  add_play_options(*command, *options);
  add_on_option(*command, *options);
  command
      ->add_option("-o,--output", options->output,
                   "what to write: .png (8 bits, as a browser's canvas shows it), .jpg, .exr (float32 RGBA, "
                   "bit for bit); "
                   "%04d in the name numbers every frame, without it the last frame is written")
      ->required();
  command->callback([options] { render(*options); });
}

}  // namespace shadertwin::app
