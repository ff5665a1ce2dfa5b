// Plays the points of a sweep and measures them.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/app/options.h"
#include "host/compare/flip.h"
#include "host/image/image.h"
#include "host/player/player.h"
#include "host/sweep/measurement.h"
#include "host/sweep/plan.h"

namespace shadertwin::app {

struct SweepOptions : PlayOptions {
  std::vector<sweep::Axis> axes;
  bool one_at_a_time = false;
  int runs = 4;
  unsigned seed = 0;
  // The picture that is right: a file, or how to draw it.
  std::string reference_file;
  std::vector<Define> reference_defines;
  std::optional<int> reference_frames;
  std::optional<DeviceChoice> reference_on;
  // The picture gets better from frame to frame, so that it is measured on its way, after 1, 2, 4 ... frames.
  bool accumulates = false;
  std::vector<double> targets;    // relative MSE
  std::optional<int> max_frames;  // how far to go on while the least target is not reached
  std::string output;             // a CSV
  std::string plot;

  bool has_reference() const {
    return !reference_file.empty() || !reference_defines.empty() || reference_frames.has_value() ||
           reference_on.has_value();
  }
};

// What a point is compared with.
struct Reference {
  std::string key;
  std::vector<Image> shown;  // one, or two with other random numbers, so that their noise can be told
  std::optional<Image> picture = {};  // the last pass, for people's eyes, where it isn't the shown one
};

class SweepPlayer {
 public:
  // Where the shader has the knob SEED, every run has random numbers of its own. `project`: the shader as it
  // is.
  SweepPlayer(const SweepOptions& options, const Project& project);

  // Reads the file, or plays `point`, or takes what an earlier sweep has left beside the output. Throws as a
  // player does.
  Reference reference(const sweep::Point& point);
  // Names all that decides what a point's runs measure.
  std::string key(const sweep::Point& point, const Reference* reference);
  // Plays the point, twice where there are seeds. Throws as a player does.
  std::vector<sweep::Measurement> run(const sweep::Point& point, int number, const Reference* reference);
  // What the devices are that were asked for.
  std::vector<std::string> devices() const;

 private:
  struct Take {
    std::vector<int> frames;           // after which
    std::vector<Image> shown;          // the shown pass was read
    std::optional<Image> last;         // the last pass, after the last of them
    std::vector<double> milliseconds;  // a frame, the last ones
    bool gpu = false;                  // measured them
  };

  PlayOptions options_of(const sweep::Point& point) const;
  struct Opened {
    Project project;
    std::unique_ptr<Player> player;
  };
  // `seed`: what SEED is, if there are seeds.
  Opened open(PlayOptions options, const std::string& seed);
  // Plays with seed after seed, each from frame 0. Goes on beyond `frames` if the target asks for it, seen
  // from `reference`.
  std::vector<Take> play(const PlayOptions& options, const std::vector<unsigned>& seeds, int frames,
                         bool on_its_way, const Reference* reference);
  Take take(Opened& opened, const PlayOptions& options, unsigned seed, int frames, bool on_its_way,
            const Reference* reference);
  // What people see of the reference, worked out once.
  const Flip& seen_reference(const Reference& reference, bool of_last_pass);
  // The key of what these options draw.
  std::string picture_key(const PlayOptions& options, int frames);
  // What a device is, beside its name.
  const std::string& device(const DeviceChoice& on);

  const SweepOptions& options_;
  bool seeded_;
  // The seed is a uniform, so that a shader is compiled once; where it can't be, a macro.
  bool seed_is_uniform_;
  std::map<std::string, std::string> devices_;
  std::map<std::string, Flip> seen_;  // by the reference's key
};

}  // namespace shadertwin::app
