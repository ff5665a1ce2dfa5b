// The keyboard texture's rows, from what a hand does.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "host/image/image.h"
#include "host/project/host_rules.h"

namespace shadertwin {

// Rows of 256 key codes (the browser's legacy keyCode): 0 held, 1 pressed since the last frame, 2 toggled by
// every press, 3 released since the last frame (the extension only). 0 or 255 each.
class KeyboardState {
 public:
  using Rows = std::array<std::uint8_t, std::size_t{256} * 4>;

  explicit KeyboardState(const HostRules& rules) : keeps_taps_(rules.keeps_taps) {}

  void press(int code);  // repeats of a key that is held are ignored
  void release(int code);
  bool held(int code) const { return rows_[static_cast<std::size_t>(code)] != 0; }
  const Rows& rows() const { return rows_; }
  // Forgets what was pressed and released; to be called when a frame has seen it.
  void end_frame();

 private:
  std::uint8_t& cell(int row, int code) { return rows_[static_cast<std::size_t>(row * 256 + code)]; }

  bool keeps_taps_;
  Rows rows_{};
};

// What a shader reads of the rows: 256 texels wide, HostRules::keyboard_rows high, 8 bits a channel.
Texture keyboard_texture(const KeyboardState::Rows& rows, const HostRules& rules);

// Code of a key by name, without regard to case: a letter or digit, or space, enter, escape, tab, backspace,
// shift, ctrl, alt, left, up, right, down, pageup, pagedown, home, end, insert, delete, f1 to f12, or a
// number from 0 to 255.
std::optional<int> key_code(std::string_view name);

}  // namespace shadertwin
