#include "reference/emit/masks.h"

#include <algorithm>

namespace shadertwin::emit {

void Masks::open() {
  masks_.push_back(names_.take("active"));
  frames_.push_back({Frame::Kind::function, "", 0, false});
}

std::string Masks::from(std::size_t first) const {
  std::string text;
  for (std::size_t i = masks_.size(); i-- > first;) text += (text.empty() ? "" : ", ") + masks_[i];
  return text;
}

void Masks::leave(std::size_t first, const std::string& also) {
  out_.statement("mask_out__(" + from(first) + (also.empty() ? "" : ", " + also) + ")");
}

const Masks::Frame& Masks::innermost(bool is_break) const {
  return *std::find_if(frames_.rbegin(), frames_.rend(), [&](const Frame& frame) {
    return frame.kind == Frame::Kind::loop || (is_break && frame.kind == Frame::Kind::choice);
  });
}

void Masks::leave_by_break() {
  const Frame& frame = innermost(true);
  if (frame.kind == Frame::Kind::loop && frame.loop_mask.empty()) return out_.statement("break");
  leave(frame.outside, frame.loop_mask);
}

void Masks::leave_by_continue() {
  const Frame& frame = innermost(false);
  // Where all that run leave the body, C++ says so.
  if (masks_.size() == frame.outside) return out_.statement("continue");
  leave(frame.outside);
}

void Masks::continue_if_empty() {
  const Frame& frame = frames_.back();
  if (frame.kind == Frame::Kind::loop && frame.can_continue && masks_.size() > frame.outside)
    out_.statement("if (none__(" + current() + ")) continue");
}

}  // namespace shadertwin::emit
