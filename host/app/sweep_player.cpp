#include "host/app/sweep_player.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "host/app/players.h"
#include "host/base/error.h"
#include "host/base/hash.h"
#include "host/base/output_file.h"
#include "host/compare/errors.h"
#include "host/gl/context.h"
#include "host/sweep/steady_times.h"
#include "host/text/knobs.h"
#include "host/text/load.h"

namespace shadertwin::app {

namespace fs = std::filesystem;
using sweep::Axis;
using sweep::Measurement;

namespace {

// A median wants a few; what a fast shader draws on top costs little.
constexpr std::size_t least_timed_frames = 5;
// How long a GPU may draw on, at most, until its times are steady.
constexpr std::chrono::seconds patience{2};

// The macro SEED is this uniform: floats hold whole numbers to 2^24.
constexpr const char* seed_uniform = "iSweepSeed";
constexpr unsigned largest_seed = 1U << 24;

// Of all threads of this process.
double processor_milliseconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

// A file as its path, length and age: enough to see that it was changed.
std::string file_key(const fs::path& file) {
  std::error_code failed;
  const auto size = fs::file_size(file, failed);
  const auto time = fs::last_write_time(file, failed).time_since_epoch().count();
  return file.string() + ' ' + std::to_string(size) + ' ' + std::to_string(time) + '\n';
}

}  // namespace

SweepPlayer::SweepPlayer(const SweepOptions& options, const Project& project)
    : options_(options),
      seeded_(mentions(project, "SEED")),
      seed_is_uniform_(seeded_ && !decides_conditions(project, "SEED")) {}

PlayOptions SweepPlayer::options_of(const sweep::Point& point) const {
  PlayOptions result = options_;
  PlaySettings& settings = result.load.settings;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const Axis& axis = options_.axes[i];
    switch (axis.kind) {
      case Axis::Kind::define:
        if (!point[i].empty()) settings.defines.emplace_back(axis.name, point[i]);
        break;
      case Axis::Kind::on:
        result.on = read_device(point[i]);
        break;
      case Axis::Kind::size: {
        const glm::ivec2 size = read_size(point[i]);
        result.schedule.width = size.x;
        result.schedule.height = size.y;
        break;
      }
      case Axis::Kind::init:
        settings.undefined = point[i] == "raw" ? Undefined::raw : Undefined::zero;
        break;
      case Axis::Kind::precise:
        settings.precise = point[i] == "on";
        break;
    }
  }
  return result;
}

const std::string& SweepPlayer::device(const DeviceChoice& on) {
  std::string& known = devices_[on.text];
  if (known.empty()) known = on.is_twin() ? on.text : gl::open_context(on.device)->info().renderer;
  return known;
}

std::vector<std::string> SweepPlayer::devices() const {
  std::vector<std::string> names;
  for (const auto& [name, device] : devices_) names.push_back(device);
  return names;
}

std::string SweepPlayer::picture_key(const PlayOptions& options, int frames) {
  const Project project = load_project(options.shader, options.load);
  const Schedule& s = options.schedule;
  std::string text =
      options.on.text + ' ' + device(options.on) + ' ' + std::to_string(frames) + ' ' +
      std::to_string(options_.seed) + ' ' + std::to_string(s.width) + 'x' + std::to_string(s.height) + ' ' +
      std::to_string(s.fps) + ' ' + std::to_string(s.t0) + (options.load.settings.precise ? " precise" : "") +
      (options.load.settings.undefined == Undefined::raw ? " raw " : " ") + options.pass + '\n';
  for (const MouseStep& step : s.mouse)
    text += std::to_string(step.frame) + ' ' + std::to_string(step.position.x) + ' ' +
            std::to_string(step.position.y) + (step.down ? " down\n" : "\n");
  for (const KeyStep& step : s.keys)
    text += std::to_string(step.code) + ' ' + std::to_string(step.frame) + ' ' +
            std::to_string(step.release.value_or(-1)) + '\n';
  for (const Pass& pass : project.passes) {
    // An #error leaves its mark in `refused` alone.
    text += pass.name + '\n' + pass.source.head + pass.source.body + pass.source.tail + pass.source.refused;
    for (const Input& input : pass.inputs)
      for (const fs::path& file : input.files) text += file_key(file);
  }
  return hash_name(text);
}

SweepPlayer::Opened SweepPlayer::open(PlayOptions options, const std::string& seed) {
  options.quiet = true;
  if (seeded_) options.load.settings.defines.emplace_back("SEED", seed);
  if (seed_is_uniform_) options.load.uniforms.push_back({.name = seed_uniform, .type = UniformType::int1});
  Opened opened{load_project(options.shader, options.load), nullptr};
  opened.player = open_player(options.on, opened.project, options, nullptr, Timers::gpu);
  return opened;
}

std::vector<SweepPlayer::Take> SweepPlayer::play(const PlayOptions& options,
                                                 const std::vector<unsigned>& seeds, int frames,
                                                 bool on_its_way, const Reference* reference) {
  std::vector<Take> takes;
  std::optional<Opened> opened;
  for (const unsigned seed : seeds) {
    if (!seed_is_uniform_)
      opened = open(options, std::to_string(seed));
    else if (!opened)
      opened = open(options, seed_uniform);
    takes.push_back(take(*opened, options, seed, frames, on_its_way, reference));
  }
  return takes;
}

SweepPlayer::Take SweepPlayer::take(Opened& opened, const PlayOptions& options, unsigned seed, int frames,
                                    bool on_its_way, const Reference* reference) {
  const auto& [project, player] = opened;
  std::vector<std::array<float, 4>> uniforms;
  for (const CustomUniform& uniform : project.uniforms) uniforms.push_back(uniform.value);
  if (seed_is_uniform_) uniforms.back() = {static_cast<float>(seed % largest_seed), 0.0F, 0.0F, 0.0F};
  const int shown = chosen_pass(project, options);
  const int last = static_cast<int>(project.passes.size()) - 1;
  const double target =
      options_.targets.empty() ? 0.0 : *std::min_element(options_.targets.begin(), options_.targets.end());
  FixedClock clock(options.schedule, host_rules(project));
  Take take;
  sweep::SteadyTimes times;
  // The first frame is left out: most of the compiling is in it.
  const auto draw = [&, &player = *player](bool timed) {
    Frame frame = clock.next();
    frame.uniforms = uniforms;
    const double start = processor_milliseconds();
    player.render(frame);
    player.finish();
    if (!timed) return;
    const double processor = processor_milliseconds() - start;
    double gpu = 0.0;
    for (const double pass : player.milliseconds()) gpu += std::max(pass, 0.0);
    take.gpu = gpu > 0.0;
    times.add(take.gpu ? gpu : processor);
  };
  int end = frames;
  for (int i = 1; i <= end; ++i) {
    draw(i > 1);
    const bool power_of_two = (i & (i - 1)) == 0;
    if (i != end && !(on_its_way && power_of_two)) continue;
    take.frames.push_back(i);
    take.shown.push_back(player->read(shown));
    if (i == end && reference != nullptr && options_.max_frames.value_or(0) > end &&
        picture_error(take.shown.back(), reference->shown.front()).relative_mse > target)
      end = std::min(*options_.max_frames, 2 * end);
  }
  if (shown != last) take.last = player->read(last);
  while (times.count() < least_timed_frames) draw(true);
  const auto late = std::chrono::steady_clock::now() + patience;
  while (take.gpu && !times.steady() && std::chrono::steady_clock::now() < late) draw(true);
  take.milliseconds = times.last();
  return take;
}

Reference SweepPlayer::reference(const sweep::Point& point) {
  if (!options_.reference_file.empty())
    return {hash_name(file_key(options_.reference_file)), {read_image(options_.reference_file)}};
  PlayOptions options = options_of(point);
  Defines& defines = options.load.settings.defines;
  for (const Define& define : options_.reference_defines) {
    std::erase_if(defines, [&](const Define& d) { return d.first == define.first; });
    defines.push_back(define);
  }
  if (options_.reference_on.has_value()) options.on = *options_.reference_on;
  const int frames = options_.reference_frames.value_or(options.frames);
  Reference reference{picture_key(options, frames), {}};
  const std::vector<std::string> names = seeded_ ? std::vector<std::string>{"reference-a", "reference-b"}
                                                 : std::vector<std::string>{"reference"};
  const auto kept = [&](const std::string& what) {
    return fs::path(options_.output).replace_extension(what + '-' + reference.key.substr(0, 8) + ".exr");
  };
  const bool keep = !options_.output.empty();
  // The last name is written last.
  if (keep && fs::exists(kept(names.back()))) {
    for (const std::string& name : names) reference.shown.push_back(read_image(kept(name)));
    if (fs::exists(kept("picture"))) reference.picture = read_image(kept("picture"));
    return reference;
  }
  // Far from the seeds of the runs.
  std::vector<unsigned> seeds = {options_.seed};
  if (seeded_) seeds.push_back(options_.seed + 1000000U);
  std::vector<Take> takes = play(options, seeds, frames, false, nullptr);
  reference.picture = std::move(takes.front().last);
  if (keep && reference.picture.has_value()) write_image(*reference.picture, kept("picture"));
  for (std::size_t i = 0; i < takes.size(); ++i) {
    reference.shown.push_back(std::move(takes[i].shown.back()));
    if (keep) write_image(reference.shown.back(), kept(names[i]));
  }
  return reference;
}

const Flip& SweepPlayer::seen_reference(const Reference& reference, bool of_last_pass) {
  const auto found = seen_.find(reference.key);
  if (found != seen_.end()) return found->second;
  return seen_.emplace(reference.key, Flip(of_last_pass ? *reference.picture : reference.shown.front()))
      .first->second;
}

std::string SweepPlayer::key(const sweep::Point& point, const Reference* reference) {
  const PlayOptions options = options_of(point);
  std::string text = picture_key(options, options.frames);
  text += options_.accumulates ? " on its way" : "";
  if (options_.max_frames.has_value()) text += " up to " + std::to_string(*options_.max_frames);
  if (reference != nullptr) text += reference->key;
  return hash_name(text).substr(0, 16);
}

std::vector<Measurement> SweepPlayer::run(const sweep::Point& point, int number, const Reference* reference) {
  const PlayOptions options = options_of(point);
  // The reference has the seed that was asked for.
  const unsigned seed = options_.seed + 1U + 2U * static_cast<unsigned>(number);
  std::vector<unsigned> seeds = {seed};
  if (seeded_) seeds.push_back(seed + 1U);
  const std::vector<Take> takes =
      play(options, seeds, options.frames, options_.accumulates && reference != nullptr, reference);
  if (reference != nullptr) {
    const Image& drawn = takes.front().shown.back();
    const Image& right = reference->shown.front();
    // Only a file can have another size, and it is the reference of all points.
    if (drawn.width != right.width || drawn.height != right.height)
      throw Error(ExitStatus::file, options_.reference_file + ": has " + std::to_string(right.width) + "x" +
                                        std::to_string(right.height) + " pixels, the picture " +
                                        std::to_string(drawn.width) + "x" + std::to_string(drawn.height));
  }
  std::vector<double> times;
  for (const Take& take : takes)
    times.insert(times.end(), take.milliseconds.begin(), take.milliseconds.end());
  std::vector<Measurement> result;
  for (std::size_t stage = 0; stage < std::min(takes.front().frames.size(), takes.back().frames.size());
       ++stage) {
    Measurement m;
    m.run = number;
    m.frames = takes.front().frames[stage];
    m.milliseconds = sweep::median(times);
    m.gpu = takes.front().gpu;
    double mse = 0.0;
    double relative_mse = 0.0;
    std::size_t values = 0;
    for (const Take& take : takes) {
      const Image& drawn = take.shown[stage];
      const PictureError error =
          picture_error(drawn, reference != nullptr ? reference->shown.front() : drawn);
      m.nan += error.nan;
      m.infinite += error.infinite;
      mse += error.mse / static_cast<double>(takes.size());
      relative_mse += error.relative_mse / static_cast<double>(takes.size());
      values += error.values;
    }
    if (reference != nullptr && values > 0) {
      m.mse = mse;
      m.relative_mse = relative_mse;
    }
    if (reference != nullptr && values > 0 && takes.size() == 2) {
      const ErrorParts parts = error_parts(takes[0].shown[stage], takes[1].shown[stage],
                                           reference->shown.front(), reference->shown.back());
      m.relative_bias2 = parts.relative_bias2;
      m.relative_variance = parts.relative_variance;
      // Without the reference's own noise, if it was drawn twice.
      if (reference->shown.size() == 2)
        m.relative_mse = std::max(parts.relative_bias2 + parts.relative_variance, 0.0);
    }
    result.push_back(m);
  }
  if (reference != nullptr) {
    // Of what people see: of a buffer, the last pass; a file says nothing about that one.
    const Take& first = takes.front();
    const Image& picture = first.last.has_value() ? *first.last : first.shown.back();
    if (!first.last.has_value() || reference->picture.has_value())
      result.back().flip = seen_reference(*reference, first.last.has_value()).mean(picture);
  }
  return result;
}

}  // namespace shadertwin::app
