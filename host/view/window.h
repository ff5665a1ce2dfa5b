// A window, what a hand does in it, and OpenGL contexts that share their objects with it.
#pragma once

#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "host/gl/context.h"

struct GLFWwindow;

namespace shadertwin::view {

// One thing that a hand did, in the order in which it happened.
struct Event {
  enum class Kind { key_down, key_up, button_down, button_up, move, drop, other };
  Kind kind = Kind::other;
  int code = 0;              // GLFW's key or button
  int modifiers = 0;         // GLFW's
  glm::dvec2 position{0.0};  // of the mouse, window units from the upper left
  std::filesystem::path file;
};

// GLFW, from the first window to the last object that uses it. Main thread only, like all of GLFW.
class Glfw {
 public:
  // Throws Error(device) without a display.
  Glfw();
  ~Glfw();
  Glfw(const Glfw&) = delete;
  Glfw& operator=(const Glfw&) = delete;
};

// OpenGL ES 3 through EGL; where EGL can't, through the display's own interface.
class WindowContext final : public gl::Context {
 public:
  // `window` must outlive this and have a context.
  explicit WindowContext(GLFWwindow* window);
  ~WindowContext() override;

 private:
  void bind() override;
  void unbind() override;

  GLFWwindow* window_;
};

class Window {
 public:
  // `size`: of the picture in pixels. Throws Error(device) without a display or without OpenGL ES 3.
  Window(const std::string& title, glm::ivec2 size);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* handle() const { return window_; }
  WindowContext& context() { return *context_; }
  // Contexts for players, which share objects with the window's. Any thread may take one and give it back (by
  // destroying it); there are two, so that a new player can be made while the old one still plays. Throws
  // Error(device) if both are taken.
  std::unique_ptr<gl::Context> take_player_context();

  glm::ivec2 size() const;       // window units
  glm::ivec2 pixels() const;     // of the framebuffer; 0 when it can't be seen
  double content_scale() const;  // how much larger text must be for this display
  double refresh_rate() const;   // Hz
  void set_title(const std::string& title);
  void toggle_full_screen();
  bool full_screen() const;
  void set_clipboard(const std::string& text);

  bool should_close() const;
  void close();
  // Sleeps until something happens, at most `seconds` (negative: without limit).
  void wait(double seconds);
  // What happened since the last call. Also draws what was drawn to the screen's attention: see dirty().
  std::vector<Event> take_events();
  void swap();

  // Ends a wait() from any thread.
  static void wake();

 private:
  struct Pool;

  static void listen(GLFWwindow* window);

  Glfw glfw_;
  GLFWwindow* window_ = nullptr;
  std::vector<Event> events_;
  std::unique_ptr<WindowContext> context_;
  std::shared_ptr<Pool> pool_;
  glm::ivec4 windowed_{0};  // place and size before full screen
};

}  // namespace shadertwin::view
