#include "reference/check/accuracy.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <tuple>

#include "host/compare/compare.h"
#include "host/project/kinds.h"
#include "reference/twin/twin_device.h"

namespace shadertwin::check {
namespace {

using twin::NumberRecord;
using twin::PixelPlace;
using twin::PlaceName;
using twin::PlaceRecord;
using twin::ShadowNumber;

// Of two equal errors the first pixel counts.
bool is_worse(double a, const PixelPlace& at_a, double b, const PixelPlace& at_b) {
  return a > b || (a == b && twin::is_before(at_a, at_b));
}

// Keeps the larger of two errors and its place; the other's if there was none before.
void keep_worse(bool is_first, double& worst, PixelPlace& at, double other, const PixelPlace& other_at) {
  if (!is_first && !is_worse(other, other_at, worst, at)) return;
  worst = other;
  at = other_at;
}

double distance(const ShadowNumber& x) {
  return std::fabs(static_cast<double>(x.value) - x.exact);
}

void add(PlaceRecord& sum, const PlaceRecord& more) {
  if (more.losses != 0) {
    if (sum.losses == 0 || is_worse(more.own, more.lost_at, sum.own, sum.lost_at)) {
      sum.own = more.own;
      sum.loss = more.loss;
      sum.lost_at = more.lost_at;
      sum.operand_count = more.operand_count;
      std::copy(std::begin(more.operands), std::end(more.operands), std::begin(sum.operands));
      sum.result = more.result;
    }
    sum.losses += more.losses;
  }
  if (more.parted != 0) {
    if (sum.parted == 0 || twin::is_before(more.parted_at, sum.parted_at)) {
      sum.parted_at = more.parted_at;
      std::copy(std::begin(more.sides), std::end(more.sides), std::begin(sum.sides));
      sum.is_number = more.is_number;
    }
    keep_worse(sum.parted == 0, sum.moved_by, sum.moved_at, more.moved_by, more.moved_at);
    sum.parted += more.parted;
    sum.tried += more.tried;
    sum.moved += more.moved;
  }
}

void add(NumberRecord& sum, const NumberRecord& more) {
  keep_worse(sum.numbers == 0, sum.error, sum.error_at, more.error, more.error_at);
  sum.numbers += more.numbers;
  sum.not_finite += more.not_finite;
  sum.error_sum += more.error_sum;
}

class Collector : public twin::ShadowObserver {
 public:
  Collector(const Project& project, const AccuracyOptions& options) : project_(project), options_(options) {}

  bool wants_steps(int x, int y) override { return options_.pixel == glm::ivec2(x, y); }

  void step(int place, const ShadowNumber* operands, int count, const ShadowNumber& result,
            double own) override {
    constexpr std::size_t most_steps = 4096;
    if (steps_.size() == most_steps)
      ++result_.untold;
    else
      steps_.push_back({place, {operands, operands + count}, result, own});
  }

  Wanted begin(int pass, int frame) override {
    const bool is_picture = project_.passes[static_cast<std::size_t>(pass)].kind == PassKind::image;
    const bool last = pass == options_.pass && frame == options_.run.frames - 1;
    return {options_.threshold, is_picture, last && options_.pixel.has_value()};
  }

  void noted(int /*pass*/, std::uint32_t first_place, std::span<const PlaceName> places,
             std::span<const PlaceRecord> records, std::span<const NumberRecord> numbers) override {
    if (of_place_.size() < first_place + places.size()) of_place_.resize(first_place + places.size(), -1);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const PlaceName& name = places[i];
      if (name.file < 0) continue;
      if (numbers[i].numbers != 0) add(lines_[{name.file, name.line}], numbers[i]);
      if (*name.text == '\0') continue;
      int& index = of_place_[first_place + i];
      if (index < 0) index = find(name);
      add(result_.operations[static_cast<std::size_t>(index)].record, records[i]);
    }
    for (Step& step : steps_) tell(step, first_place);
    steps_.clear();
  }

  void drawn(int pass, int frame, glm::ivec2 size, std::span<const ShadowNumber> numbers,
             std::span<const float> moved) override {
    if (pass != options_.pass) return;
    const bool is_picture = project_.passes[static_cast<std::size_t>(pass)].kind == PassKind::image;
    const int channels = is_picture ? 3 : 4;  // alpha is not seen
    result_.heatmap = Image(size.x, size.y);
    for (std::size_t i = 0; i < numbers.size() / 4; ++i) {
      const int row = static_cast<int>(i) / size.x;
      judge(numbers.subspan(4 * i, static_cast<std::size_t>(channels)), moved[i], is_picture,
            {frame, static_cast<int>(i) % size.x, row}, &result_.heatmap.rgba[4 * i]);
    }
    if (!options_.pixel || frame != options_.run.frames - 1) return;
    const auto at = static_cast<std::size_t>(options_.pixel->y) * static_cast<std::size_t>(size.x) +
                    static_cast<std::size_t>(options_.pixel->x);
    std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(4 * at), 4, result_.told_pixel.begin());
  }

  Accuracy take() {
    const auto idle = [](const Operation& o) {
      return o.record.losses == 0 && o.record.parted == 0 && o.pixels == 0;
    };
    for (Operation& o : result_.operations) {
      const ShadowNumber* sides = o.record.sides;
      const bool first = distance(sides[0]) >= distance(sides[1]);
      const std::uint32_t origin = sides[first ? 0 : 1].origin;
      const Operation* cause = o.record.parted != 0 && origin != 0 ? operation_at(origin - 1) : nullptr;
      if (cause != nullptr && cause != &o) o.cause = cause->file + ':' + std::to_string(cause->line);
    }
    std::erase_if(result_.operations, idle);
    if (result_.drawn != 0) result_.mean_error = error_sum_ / static_cast<double>(result_.drawn);
    for (const auto& [place, record] : lines_)
      result_.lines.push_back({file(place.first), place.second, record});
    return std::move(result_);
  }

 private:
  struct Step {
    int place = 0;
    std::vector<ShadowNumber> operands;
    ShadowNumber result{};
    double own = 0.0;
  };

  const std::string& file(int index) const { return project_.files[static_cast<std::size_t>(index)]; }

  int find(const PlaceName& name) {
    const auto key = std::tuple(name.file, name.line, std::string(name.text));
    const auto [entry, is_new] = index_.try_emplace(key, static_cast<int>(result_.operations.size()));
    if (is_new)
      result_.operations.push_back({file(name.file), name.line, name.text, {}, {}, 0, 0, 0.0, 0.0, {}});
    return entry->second;
  }

  const Operation* operation_at(std::size_t place) const {
    if (place >= of_place_.size() || of_place_[place] < 0) return nullptr;
    return &result_.operations[static_cast<std::size_t>(of_place_[place])];
  }

  void tell(Step& step, std::uint32_t first_place) {
    const Operation* at = operation_at(first_place + static_cast<std::size_t>(step.place));
    result_.told.push_back({at != nullptr ? at->file : "", at != nullptr ? at->line : 0,
                            at != nullptr ? at->text : "", std::move(step.operands), step.result, step.own});
  }

  // One pixel of the picture.
  void judge(std::span<const ShadowNumber> numbers, double moved, bool is_picture, const PixelPlace& at,
             float* heat) {
    double worst = -1.0;
    const ShadowNumber* of = nullptr;
    bool is_number = true;
    for (const ShadowNumber& number : numbers) {
      const double error = twin::picture_error(is_picture, number.value, number.exact);
      is_number = is_number && std::isnan(number.value) == std::isnan(number.exact);
      if (error > worst) {
        worst = error;
        of = &number;
      }
    }
    const double whole = std::max(worst, moved);
    const glm::vec3 color = is_number ? heat_of(whole) : glm::vec3(1.0F, 0.0F, 1.0F);
    std::copy_n(&color.x, 3, heat);
    heat[3] = 1.0F;
    ++result_.drawn;
    if (!is_number) ++result_.not_numbers;
    error_sum_ += is_number ? whole : 0.0;
    keep_worse(result_.drawn == 1, result_.error, result_.at, whole, at);
    if (whole >= options_.threshold) ++result_.pixels;
    if (worst < options_.threshold) return;
    if (of->origin == 0 || operation_at(of->origin - 1) == nullptr) {
      ++result_.without_origin;
      return;
    }
    auto& operation =
        result_.operations[static_cast<std::size_t>(of_place_[static_cast<std::size_t>(of->origin) - 1])];
    keep_worse(operation.pixels == 0, operation.error, operation.at, worst, at);
    ++operation.pixels;
    if (!is_number) ++operation.not_numbers;
    operation.error_sum += worst;
  }

  static glm::vec3 heat_of(double error) {
    constexpr double least = 0x1p-24;
    return error < least ? glm::vec3(0.0F) : heat(static_cast<float>(1.0 + std::log2(error) / 24.0));
  }

  const Project& project_;
  const AccuracyOptions& options_;
  Accuracy result_;
  double error_sum_ = 0.0;
  std::vector<int> of_place_;  // index into operations, -1: none
  std::map<std::tuple<int, int, std::string>, int> index_;
  std::map<std::pair<int, int>, NumberRecord> lines_;
  std::vector<Step> steps_;
};

}  // namespace

Accuracy measure_accuracy(const Project& project, const AccuracyOptions& options,
                          const std::function<void(int)>& progress) {
  Collector collector(project, options);
  twin::TwinOptions twin_options;
  twin_options.timeout = options.run.timeout;
  twin_options.shadows = &collector;
  const auto player = twin::make_player(project, twin_options);
  FixedClock clock(options.run.schedule, host_rules(project));
  for (int i = 0; i < options.run.frames; ++i) {
    player->render(clock.next());
    if (progress) progress(i + 1);
  }
  return collector.take();
}

double bits_lost(double share) {
  if (!(share > 0.0)) return 0.0;
  return std::clamp(24.0 + std::log2(share), 0.0, 24.0);
}

}  // namespace shadertwin::check
