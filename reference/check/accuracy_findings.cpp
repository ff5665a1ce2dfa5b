#include <algorithm>
#include <cmath>
#include <cstdio>

#include "reference/check/accuracy.h"
#include "reference/glsl/loss.h"

namespace shadertwin::check {
namespace {

using glsl::Loss;
using twin::PixelPlace;
using twin::PlaceRecord;

template <class... Value>
std::string printed(const char* format, Value... values) {
  std::string text(static_cast<std::size_t>(std::snprintf(nullptr, 0, format, values...)), '\0');
  std::snprintf(text.data(), text.size() + 1, format, values...);
  return text;
}

std::string number(double x) {
  return printed("%.8g", x);
}

std::string pixel(const PixelPlace& at) {
  return printed("pixel %d,%d in frame %d", at.x, at.y, at.frame);
}

// `1000.25 and 1000.24`
std::string operands_of(const PlaceRecord& record) {
  std::string text;
  for (int i = 0; i < record.operand_count; ++i) {
    if (i > 0) text += i + 1 == record.operand_count ? " and " : ", ";
    text += number(record.operands[i].value);
  }
  return text;
}

// What the operation does to its digits.
std::string loss_text(const Operation& o) {
  const int bits = static_cast<int>(std::lround(bits_lost(o.record.own)));
  const std::string lost = bits >= 24 ? "all 24 bits" : printed(bits == 1 ? "%d bit" : "%d bits", bits);
  switch (static_cast<Loss>(o.record.loss)) {
    case Loss::absorption:
      return o.text + " drops most of its smaller term";
    case Loss::rounding:
      return "the roundings before and in " + o.text + " add up";
    case Loss::conditioning:
      return lost + " lost in " + o.text + ", which hangs on the last digits of its argument";
    case Loss::coarse:
      return o.text + printed(" is computed to only %d of 24 bits", 24 - bits);
    case Loss::jump:
      return o.text + " jumps between two numbers that are hardly apart";
    case Loss::underflow:
      return o.text + " is too small for a float";
    case Loss::overflow:
      return o.text + " is too large for a float";
    default:
      return lost + " lost in " + o.text;
  }
}

std::string worst_text(const PlaceRecord& record) {
  return " (at worst, " + pixel(record.lost_at) + ": from " + operands_of(record) + " comes " +
         number(record.result.value) + ", exactly " + number(record.result.exact) + ")";
}

std::string reach_text(const Operation& o, std::size_t drawn) {
  if (o.pixels == 0) return "; does not reach the picture";
  std::string text = printed("; reaches the picture: off by up to %.2g in %zu of %zu pixels, the worst at ",
                             o.error, o.pixels, drawn) +
                     pixel(o.at);
  if (o.not_numbers != 0) text += printed(", and NaN in float or double alone in %zu", o.not_numbers);
  return text;
}

std::string branch_text(const Operation& o) {
  const PlaceRecord& r = o.record;
  const std::string what = r.is_number ? " becomes another integer" : " is decided differently";
  const auto both = [](const twin::ShadowNumber& x) {
    return number(x.value) + (x.value == x.exact ? "" : ", exactly " + number(x.exact));
  };
  std::string text = o.text + what +
                     printed(" in double in %llu %s (first at ", static_cast<unsigned long long>(r.parted),
                             r.parted == 1 ? "pixel" : "pixels") +
                     pixel(r.parted_at) + ": " + both(r.sides[0]);
  if (!r.is_number) text += " against " + both(r.sides[1]);
  if (!o.cause.empty()) text += ", an error that comes from " + o.cause;
  text += ')';
  if (r.moved == 0) return text + "; does not reach the picture";
  const std::string of = r.tried == r.parted ? "them" : printed("%zu that were tried", std::size_t{r.tried});
  return text + printed("; moves the picture: by up to %.2g in %zu of ", r.moved_by, std::size_t{r.moved}) +
         of + ", the most at " + pixel(r.moved_at);
}

}  // namespace

std::vector<AccuracyFinding> accuracy_findings(const Accuracy& accuracy, std::optional<double> least_bits) {
  std::vector<AccuracyFinding> findings;
  const auto is_speck = [&](std::size_t pixels) { return pixels < 2 || 1000 * pixels < accuracy.drawn; };
  for (const Operation& o : accuracy.operations) {
    const double bits = o.record.losses != 0 ? bits_lost(o.record.own) : 0.0;
    const bool is_seen = o.not_numbers != 0 || !is_speck(o.pixels);
    const bool is_wanted = least_bits && (o.pixels != 0 || bits >= *least_bits);
    if (o.record.losses != 0 && (is_seen || is_wanted))
      findings.push_back({{o.file, o.line, name_of(static_cast<Loss>(o.record.loss)),
                           loss_text(o) + worst_text(o.record) + reach_text(o, accuracy.drawn)},
                          o.error_sum,
                          bits,
                          &o});
    // Of all pixels, as of those that were tried.
    const double tried = static_cast<double>(std::max<std::uint64_t>(o.record.tried, 1));
    const double moved = static_cast<double>(o.record.moved * o.record.parted) / tried;
    if (o.record.parted != 0 && (!is_speck(static_cast<std::size_t>(moved)) || least_bits))
      findings.push_back({{o.file, o.line, "branch", branch_text(o)}, o.record.moved_by * moved, 0.0, &o});
  }
  // What a decision costs is the doing of the loss that lets it differ, which is told first.
  for (const AccuracyFinding& branch : findings) {
    if (branch.kind != "branch") continue;
    const auto cause = std::find_if(findings.begin(), findings.end(), [&](const AccuracyFinding& f) {
      return f.kind != "branch" && f.file + ':' + std::to_string(f.line) == branch.operation->cause;
    });
    if (cause != findings.end()) cause->weight += branch.weight;
  }
  std::stable_sort(findings.begin(), findings.end(), [](const AccuracyFinding& a, const AccuracyFinding& b) {
    return std::tie(a.weight, a.bits) > std::tie(b.weight, b.bits);
  });
  return findings;
}

}  // namespace shadertwin::check
