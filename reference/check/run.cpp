#include "reference/check/run.h"

#include <cstring>
#include <map>
#include <mutex>
#include <tuple>

#include "host/project/kinds.h"
#include "reference/check/trace.h"
#include "reference/glsl/check.h"
#include "reference/twin/twin_device.h"

namespace shadertwin::check {
namespace {

using glsl::Check;

std::string kind_name(Check kind) {
  switch (kind) {
    case Check::first_nan:
      return "nan";
    case Check::first_infinity:
      return "inf";
    case Check::loop_beyond_cap:
      return "loop";
    default:
      return "undefined";
  }
}

// `(pass Image, 312 pixels, first at 40,12 in frame 0)`; pixels from the lower left, counted in every frame.
std::string where(const Pass& pass, std::size_t pixels, int x, int y, int frame) {
  return " (pass " + pass.name + ", " + std::to_string(pixels) + (pixels == 1 ? " pixel" : " pixels") +
         ", first at " + std::to_string(x) + ',' + std::to_string(y) + " in frame " + std::to_string(frame) +
         ')';
}

// Counts what a checking twin finds.
class Counter : public twin::Observer {
 public:
  void begin(int pass, int frame) override {
    pass_ = pass;
    frame_ = frame;
  }

  void found(int kind, SourceLine at, int x, int y) override {
    const std::scoped_lock lock(mutex_);
    const auto [entry, is_new] = counts_.try_emplace({pass_, at.file, at.line, kind}, Count{frame_, x, y, 0});
    Count& count = entry->second;
    ++count.pixels;
    // Threads draw in any order; the first pixel is the lowest, then the leftmost.
    if (count.frame == frame_ && std::tie(y, x) < std::tie(count.y, count.x)) {
      count.x = x;
      count.y = y;
    }
  }

  bool wants_values(int, int) override { return false; }
  void value(int, int, SourceLine, const void*, std::size_t) override {}

  std::vector<Finding> findings(const Project& project) const {
    std::vector<Finding> findings;
    for (const auto& [key, count] : counts_) {
      const auto [pass_index, file, line, kind] = key;
      const Pass& pass = project.passes[static_cast<std::size_t>(pass_index)];
      findings.push_back(make_finding(project, pass, {file, line}, kind_name(static_cast<Check>(kind)),
                                      glsl::describe(static_cast<Check>(kind)) +
                                          where(pass, count.pixels, count.x, count.y, count.frame)));
    }
    return findings;
  }

 private:
  struct Count {
    int frame = 0;
    int x = 0;
    int y = 0;
    std::size_t pixels = 0;
  };

  std::mutex mutex_;
  int pass_ = 0;
  int frame_ = 0;
  std::map<std::tuple<int, int, int, int>, Count> counts_;  // by pass, file, line, kind
};

// The pixels of a pass that depend on what variables start as.
struct Unsteady {
  int pass = 0;
  int frame = 0;
  std::size_t pixels = 0;
  std::vector<Pixel> samples;  // a few of them, the first one first
};

Unsteady compare_bits(const Image& a, const Image& b, int pass, int frame) {
  Unsteady result{pass, frame, 0, {}};
  std::vector<Pixel> all;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x)
      if (std::memcmp(a.at(x, y), b.at(x, y), 4 * sizeof(float)) != 0) all.push_back({x, y});
  result.pixels = all.size();
  constexpr std::size_t wanted = 8;
  for (std::size_t i = 0; i < wanted && i < all.size(); ++i)
    result.samples.push_back(all[i * all.size() / std::min(wanted, all.size())]);
  return result;
}

std::unique_ptr<Player> open(const Project& project, const RunOptions& options,
                             twin::Uninitialised uninitialised, twin::Observer& observer) {
  twin::TwinOptions twin_options;
  twin_options.uninitialised = uninitialised;
  twin_options.timeout = options.timeout;
  twin_options.observer = &observer;
  return twin::make_player(project, twin_options);
}

// What the chosen pixels compute when variables start in that way.
Trace trace(const Project& project, const RunOptions& options, twin::Uninitialised uninitialised,
            const Unsteady& unsteady) {
  Tracer tracer(unsteady.pass, unsteady.frame, unsteady.samples);
  const auto player = open(project, options, uninitialised, tracer);
  FixedClock clock(options.schedule, host_rules(project));
  for (int i = 0; i <= unsteady.frame; ++i) player->render(clock.next());
  return tracer.take();
}

// Names the lines where a value that was never written is first used.
std::vector<Finding> name_lines(const Project& project, const RunOptions& options, const Unsteady& unsteady) {
  const Trace zero = trace(project, options, twin::Uninitialised::zero, unsteady);
  const Trace pattern = trace(project, options, twin::Uninitialised::pattern, unsteady);
  const Pass& pass = project.passes[static_cast<std::size_t>(unsteady.pass)];
  const Pixel& first = unsteady.samples.front();
  const std::string text = "a value that was never written is used" +
                           where(pass, unsteady.pixels, first.x, first.y, unsteady.frame);
  std::vector<Finding> findings;
  for (std::size_t i = 0; i < unsteady.samples.size(); ++i) {
    const Difference difference = first_difference(zero[i], pattern[i]);
    // A texture that differs is another pass's finding.
    if (difference.from_texture) continue;
    findings.push_back(make_finding(project, pass, difference.at, "uninitialised", text));
  }
  return findings;
}

}  // namespace

std::vector<Finding> run_checks(const Project& project, const RunOptions& options) {
  Counter counter;
  Counter ignored;
  const auto zero = open(project, options, twin::Uninitialised::zero, counter);
  const auto pattern = open(project, options, twin::Uninitialised::pattern, ignored);
  FixedClock clock(options.schedule, host_rules(project));
  std::vector<Unsteady> unsteady;
  for (int i = 0; i < options.frames; ++i) {
    const Frame frame = clock.next();
    zero->render(frame);
    // Later frames only repeat what the first bad one shows.
    if (!unsteady.empty()) continue;
    pattern->render(frame);
    for (std::size_t pass = 0; pass < project.passes.size(); ++pass) {
      if (!traits(project.passes[pass]).every_frame) continue;
      const int index = static_cast<int>(pass);
      const Unsteady found = compare_bits(zero->read(index), pattern->read(index), index, i);
      if (found.pixels != 0) unsteady.push_back(found);
    }
  }
  std::vector<Finding> findings = counter.findings(project);
  for (const Unsteady& found : unsteady) {
    for (Finding& finding : name_lines(project, options, found)) findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace shadertwin::check
