#include "host/app/values.h"

#include <charconv>
#include <cmath>

#include "host/base/error.h"

namespace shadertwin::app {

namespace {

constexpr int max_size = 65536;

[[noreturn]] void fail(const std::string& why) {
  throw Error(ExitStatus::usage, why);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find(separator); end != std::string::npos; end = text.find(separator, begin)) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

template <typename Number>
bool read_number(const std::string& text, Number& number) {
  const auto [rest, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  return failure == std::errc() && rest == text.data() + text.size();
}

// "VALUE@FRAME" -> VALUE, FRAME. Without @ the frame is 0.
std::pair<std::string, int> split_frame(const std::string& text) {
  const std::size_t at = text.rfind('@');
  int frame = 0;
  if (at != std::string::npos && (!read_number(text.substr(at + 1), frame) || frame < 0))
    fail("expected a frame number after @");
  return {text.substr(0, at), frame};
}

KeyStep read_key(const std::string& text) {
  const std::size_t at = text.rfind('@');
  const std::size_t dash = at == std::string::npos ? at : text.find('-', at);
  const auto [name, frame] = split_frame(text.substr(0, dash));
  const auto code = key_code(name);
  if (!code.has_value()) fail("unknown key " + name);
  KeyStep step{frame, *code};
  if (dash == std::string::npos) return step;
  int release = 0;
  if (!read_number(text.substr(dash + 1), release) || release < frame)
    fail(text + ": expected NAME@FRAME-RELEASE, the later frame behind the dash");
  step.release = release;
  return step;
}

int read_count(const std::string& text, const char* of) {
  int count = 0;
  if (!read_number(text, count) || count < 1)
    fail(std::string("expected a number of ") + of + ", at least one");
  return count;
}

}  // namespace

glm::ivec2 read_size(const std::string& text) {
  const auto parts = split(text, 'x');
  glm::ivec2 size(0);
  if (parts.size() != 2 || !read_number(parts[0], size.x) || !read_number(parts[1], size.y) || size.x < 1 ||
      size.y < 1 || size.x > max_size || size.y > max_size)
    fail("expected WIDTHxHEIGHT, each from 1 to " + std::to_string(max_size));
  return size;
}

glm::ivec2 read_pixel(const std::string& text) {
  const auto parts = split(text, ',');
  glm::ivec2 pixel(-1);
  if (parts.size() != 2 || !read_number(parts[0], pixel.x) || !read_number(parts[1], pixel.y) ||
      pixel.x < 0 || pixel.y < 0)
    fail("expected X,Y, each from 0");
  return pixel;
}

Region read_region(const std::string& text) {
  const auto parts = split(text, ',');
  Region region;
  if (parts.size() != 4 || !read_number(parts[0], region.x) || !read_number(parts[1], region.y) ||
      !read_number(parts[2], region.width) || !read_number(parts[3], region.height) || region.x < 0 ||
      region.y < 0 || region.width < 1 || region.height < 1)
    fail("expected X,Y,WIDTH,HEIGHT in pixels");
  return region;
}

int read_frames(const std::string& text) {
  return read_count(text, "frames");
}

int read_runs(const std::string& text) {
  return read_count(text, "runs");
}

double read_rate(const std::string& text) {
  double rate = 0.0;
  if (!read_number(text, rate) || !(rate > 0.0) || !std::isfinite(rate)) fail("expected a number above 0");
  return rate;
}

double read_share(const std::string& text) {
  double share = -1.0;
  if (!read_number(text, share) || !(share >= 0.0 && share <= 1.0)) fail("expected a number from 0 to 1");
  return share;
}

double read_time(const std::string& text) {
  double seconds = 0.0;
  if (!read_number(text, seconds) || !std::isfinite(seconds)) fail("expected a finite number of seconds");
  return seconds;
}

double read_timeout(const std::string& text) {
  const double seconds = read_time(text);
  if (seconds < 0.0) fail("expected a number of seconds from 0");
  return seconds;
}

unsigned read_seed(const std::string& text) {
  unsigned seed = 0;
  if (!read_number(text, seed)) fail("expected a number from 0");
  return seed;
}

Define read_define(const std::string& text) {
  constexpr const char* letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
  const std::size_t equals = text.find('=');
  const std::string name = text.substr(0, equals);
  if (name.empty() || name.find_first_not_of(letters) != std::string::npos ||
      (name[0] >= '0' && name[0] <= '9') || text.find('\n') != std::string::npos)
    fail("expected NAME or NAME=VALUE");
  return {name, equals == std::string::npos ? "1" : text.substr(equals + 1)};
}

MouseStep read_mouse(const std::string& text) {
  const auto [value, frame] = split_frame(text);
  const auto parts = split(value, ',');
  MouseStep step;
  step.frame = frame;
  const bool valid = (parts.size() == 2 || (parts.size() == 3 && parts[2] == "down")) &&
                     read_number(parts[0], step.position.x) && read_number(parts[1], step.position.y) &&
                     std::isfinite(step.position.x) && std::isfinite(step.position.y);
  if (!valid) fail("expected X,Y or X,Y,down, then @FRAME if not 0");
  step.down = parts.size() == 3;
  return step;
}

std::vector<KeyStep> read_keys(const std::string& text) {
  std::vector<KeyStep> steps;
  for (const std::string& part : split(text, ',')) steps.push_back(read_key(part));
  return steps;
}

DeviceChoice read_device(const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::string how = slash == std::string::npos ? "" : text.substr(slash + 1);
  DeviceChoice choice;
  choice.text = text;
  choice.device = text.substr(0, slash);
  if (!choice.is_twin() && !gl::is_device_name(choice.device))
    fail("unknown player (auto, egl, egl:N, llvmpipe, osmesa, cpu or cpu/double)");
  if (slash == std::string::npos) return choice;
  if (choice.is_twin()) {
    if (how != "double") fail("expected cpu or cpu/double");
    choice.double_precision = true;
  } else {
    if (how != "fragment" && how != "compute") fail("expected /fragment or /compute");
    choice.dispatch = how == "compute" ? gl::Dispatch::compute : gl::Dispatch::fragment;
  }
  return choice;
}

}  // namespace shadertwin::app
