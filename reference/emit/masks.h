// Divergent control flow in functions over packets: the one owner of masks, `break`, `continue` and `return`.
#pragma once

#include <string>
#include <vector>

#include "reference/emit/expression.h"
#include "reference/emit/function_scope.h"

namespace shadertwin::emit {

// A mask holds the pixels that run. Where control diverges, each side runs under a mask of its own, and is
// skipped when that is empty:
//
//   if (Bool active_2 = active && (x < 0.0f); any__(active_2)) {
//     set__(active_2, color, vec3(1.0f, 0.0f, 0.0f));
//   }
//
// Pixels that jump leave all masks up to where they go.
class Masks {
 public:
  explicit Masks(FunctionScope& scope) : out_(scope.out), names_(scope.names) {}

  // The function begins: names the mask of the pixels that it is called for.
  void open();
  const std::string& of_function() const { return masks_.front(); }
  // Of the pixels that run here.
  const std::string& current() const { return masks_.back(); }
  bool is_narrowed() const { return masks_.size() > 1; }
  // From the innermost mask to that of the function, `active_3, active_2, active`.
  std::string all() const { return from(0); }

  // Writes what the pixels run for which `condition` holds.
  template <class Body>
  void where(const Expression& condition, const Body& body);
  // The same for those of `mask`, a group of a switch: `break` leaves it.
  template <class Body>
  void group(const std::string& mask, const Body& body);
  // Writes a loop that pixels leave one by one: `body` gets the name of the mask of those that have not.
  template <class Body>
  void loop(const Body& body);
  // Writes a loop's body. `loop_mask`: of a loop that pixels leave one by one. `own_mask`: they may leave the
  // body so. `can_continue`: C++'s own `continue` leads to the next round.
  template <class Body>
  void loop_body(const std::string& loop_mask, bool own_mask, bool can_continue, const Body& body);

  void leave_by_break();
  void leave_by_continue();
  void leave_by_return() { leave(0); }
  // Whether statements stand in the function itself, outside of everything that jumps could leave.
  bool is_in_function() const { return scopes_.back().kind == Scope::Kind::function; }
  // Nothing is left to do in a loop's body that all pixels have left.
  void continue_if_empty();

 private:
  // What a jump may leave.
  struct Scope {
    enum class Kind { function, branch, loop, choice } kind;
    std::string loop_mask;    // what `break` leaves too; empty if all pixels leave together
    std::size_t outside = 0;  // how many masks there are around it
    bool can_continue = false;
  };

  template <class Body>
  void within(const std::string& mask, const Scope& scope, const Body& body);
  std::string from(std::size_t first) const;
  // The masks from the innermost to number `first`, and `also`.
  void leave(std::size_t first, const std::string& also = {});
  const Scope& innermost(bool is_break) const;

  CppWriter& out_;
  NameScope& names_;
  std::vector<std::string> masks_;
  std::vector<Scope> scopes_;
};

template <class Body>
void Masks::within(const std::string& mask, const Scope& scope, const Body& body) {
  scopes_.push_back(scope);
  if (!mask.empty()) masks_.push_back(mask);
  body();
  if (!mask.empty()) masks_.pop_back();
  scopes_.pop_back();
}

template <class Body>
void Masks::where(const Expression& condition, const Body& body) {
  const std::string inner = names_.take("active");
  out_.begin("if (Bool " + inner + " = " + current() + " && " + condition.at_least(Binding::prefix) +
             "; any__(" + inner + "))");
  within(inner, {Scope::Kind::branch, "", masks_.size(), false}, body);
  out_.end();
  names_.give_back(inner);
}

template <class Body>
void Masks::group(const std::string& mask, const Body& body) {
  out_.begin("if (any__(" + mask + "))");
  within(mask, {Scope::Kind::choice, "", masks_.size(), false}, body);
  out_.end();
}

template <class Body>
void Masks::loop(const Body& body) {
  out_.begin();
  const std::string mask = names_.take("loop");
  out_.statement("Bool " + mask + " = " + current());
  masks_.push_back(mask);
  body(mask);
  masks_.pop_back();
  out_.end();
  names_.give_back(mask);
}

template <class Body>
void Masks::loop_body(const std::string& loop_mask, bool own_mask, bool can_continue, const Body& body) {
  const Scope scope{Scope::Kind::loop, loop_mask, masks_.size(), can_continue};
  if (!own_mask) return within("", scope, body);
  const std::string inner = names_.take("active");
  out_.statement("Bool " + inner + " = " + current());
  within(inner, scope, body);
  names_.give_back(inner);
}

}  // namespace shadertwin::emit
