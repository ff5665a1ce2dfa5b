// What is drawn over the picture: Dear ImGui, from its start to its end.
#pragma once

#include "host/view/window.h"

namespace shadertwin::view {

class Overlay {
 public:
  // Listens to the window's events before passing them on. The window's context must be current here and at
  // every call. Throws Error(device) if Dear ImGui can't draw here.
  explicit Overlay(Window& window);
  ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  void begin();
  // Draws what was put between.
  void end();
  // Whether a click at a place in window units is for a panel.
  bool wants_mouse(glm::dvec2 position) const;
  // Whether a text field takes the keys.
  bool wants_keys() const;

 private:
  Window& window_;
};

}  // namespace shadertwin::view
