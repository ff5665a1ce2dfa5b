#include "reference/emit/masks.h"

#include <algorithm>

namespace shadertwin::emit {

void Masks::open() {
  masks_.push_back(names_.take("active"));
  scopes_.push_back({Scope::Kind::function, "", 0, false});
}

std::string Masks::from(std::size_t first) const {
  std::string text;
  for (std::size_t i = masks_.size(); i-- > first;) text += (text.empty() ? "" : ", ") + masks_[i];
  return text;
}

void Masks::leave(std::size_t first, const std::string& also) {
  out_.statement("mask_out__(" + from(first) + (also.empty() ? "" : ", " + also) + ")");
}

const Masks::Scope& Masks::innermost(bool is_break) const {
  return *std::find_if(scopes_.rbegin(), scopes_.rend(), [&](const Scope& scope) {
    return scope.kind == Scope::Kind::loop || (is_break && scope.kind == Scope::Kind::choice);
  });
}

void Masks::leave_by_break() {
  const Scope& scope = innermost(true);
  if (scope.kind == Scope::Kind::loop && scope.loop_mask.empty()) return out_.statement("break");
  leave(scope.outside, scope.loop_mask);
}

void Masks::leave_by_continue() {
  const Scope& scope = innermost(false);
  // Where all that run leave the body, C++ says so.
  if (masks_.size() == scope.outside) return out_.statement("continue");
  leave(scope.outside);
}

void Masks::continue_if_empty() {
  const Scope& scope = scopes_.back();
  if (scope.kind == Scope::Kind::loop && scope.can_continue && masks_.size() > scope.outside)
    out_.statement("if (none__(" + current() + ")) continue");
}

}  // namespace shadertwin::emit
