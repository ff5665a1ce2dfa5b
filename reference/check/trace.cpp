#include "reference/check/trace.h"

#include <algorithm>

namespace shadertwin::check {
namespace {

// FNV-1a.
std::uint64_t hash_of(const void* bytes, std::size_t size) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (std::size_t i = 0; i < size; ++i)
    hash = (hash ^ static_cast<const unsigned char*>(bytes)[i]) * 0x100000001b3u;
  return hash;
}

bool same_place(const Step& a, const Step& b) {
  return a.at.file == b.at.file && a.at.line == b.at.line && a.from_texture == b.from_texture;
}

}  // namespace

std::size_t Tracer::find(int x, int y) const {
  return static_cast<std::size_t>(
      std::find_if(pixels_.begin(), pixels_.end(), [&](const Pixel& p) { return p.x == x && p.y == y; }) -
      pixels_.begin());
}

void Tracer::value(int x, int y, SourceLine at, const void* bytes, std::size_t size) {
  // A loop that never ends must not fill the memory.
  constexpr std::size_t most_steps = 1u << 22;
  std::vector<Step>& steps = trace_[find(x, y)];
  if (steps.size() == most_steps) return;
  const bool is_statement = bytes == nullptr;
  steps.push_back(
      {at, !is_statement && at.line == 0 && at.file < 0, is_statement ? 0 : hash_of(bytes, size)});
}

Difference first_difference(const std::vector<Step>& a, const std::vector<Step>& b) {
  const std::size_t common = std::min(a.size(), b.size());
  SourceLine last;
  for (std::size_t i = 0; i < common; ++i) {
    if (!same_place(a[i], b[i])) return {last, false};
    if (a[i].hash != b[i].hash) return {a[i].from_texture ? last : a[i].at, a[i].from_texture};
    if (a[i].at.file >= 0) last = a[i].at;
  }
  return {last, false};
}

}  // namespace shadertwin::check
