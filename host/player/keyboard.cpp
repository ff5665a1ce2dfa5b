#include "host/player/keyboard.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string>
#include <utility>

namespace shadertwin {

void KeyboardState::press(int code) {
  if (code < 0 || code > 255 || cell(0, code) != 0) return;
  cell(0, code) = 255;
  cell(1, code) = 255;
  cell(2, code) = static_cast<std::uint8_t>(255 - cell(2, code));
}

void KeyboardState::release(int code) {
  if (code < 0 || code > 255 || cell(0, code) == 0) return;
  cell(0, code) = 0;
  // Without this a tap between two frames shows only in the toggle row.
  if (!keeps_taps_) cell(1, code) = 0;
  cell(3, code) = 255;
}

void KeyboardState::end_frame() {
  const auto row = [this](int i) { return rows_.begin() + 256 * i; };
  std::fill(row(1), row(2), std::uint8_t{0});
  std::fill(row(3), rows_.end(), std::uint8_t{0});
}

Texture keyboard_texture(const KeyboardState::Rows& rows, const HostRules& rules) {
  Texture texture;
  texture.width = 256;
  texture.height = rules.keyboard_rows;
  const std::size_t count = std::size_t{256} * static_cast<std::size_t>(texture.height);
  texture.data.reserve(4 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = static_cast<std::byte>(rows[i]);
    const std::byte other = rules.grey_tables ? value : std::byte{0};
    texture.data.insert(texture.data.end(), {value, other, other, std::byte{255}});
  }
  return texture;
}

std::optional<int> key_code(std::string_view name) {
  std::string key(name);
  std::transform(key.begin(), key.end(), key.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static constexpr std::array<std::pair<std::string_view, int>, 22> names = {
      {{"space", 32},    {"enter", 13},  {"return", 13}, {"escape", 27},  {"esc", 27},      {"tab", 9},
       {"backspace", 8}, {"shift", 16},  {"ctrl", 17},   {"control", 17}, {"alt", 18},      {"left", 37},
       {"up", 38},       {"right", 39},  {"down", 40},   {"pageup", 33},  {"pagedown", 34}, {"end", 35},
       {"home", 36},     {"insert", 45}, {"delete", 46}, {"capslock", 20}}};
  for (const auto& [text, code] : names)
    if (key == text) return code;
  if (key.size() == 1 && std::isalnum(static_cast<unsigned char>(key[0])) != 0)
    return std::toupper(static_cast<unsigned char>(key[0]));
  int number = 0;
  const bool function_key = key.size() > 1 && key[0] == 'f';
  const char* begin = key.data() + (function_key ? 1 : 0);
  const char* end = key.data() + key.size();
  const auto [rest, failure] = std::from_chars(begin, end, number);
  if (failure != std::errc() || rest != end) return std::nullopt;
  if (function_key) return number >= 1 && number <= 12 ? std::optional(111 + number) : std::nullopt;
  return number >= 0 && number <= 255 ? std::optional(number) : std::nullopt;
}

}  // namespace shadertwin
