#define GLFW_INCLUDE_NONE
#include "host/view/window.h"

#include <GLFW/glfw3.h>

#include <array>
#include <cstdlib>
#include <utility>

#include "host/base/error.h"

namespace shadertwin::view {

namespace {

constexpr const char* no_window = "shadertwin render draws without a window";

std::string last_problem() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text == nullptr ? "no reason given" : text;
}

// How to ask for a context. GLES through EGL is what the headless players have; a native ES context comes
// next.
struct Attempt {
  int api;
  int major;
  int minor;
};
constexpr std::array<Attempt, 6> attempts = {{{GLFW_EGL_CONTEXT_API, 3, 2},
                                              {GLFW_EGL_CONTEXT_API, 3, 1},
                                              {GLFW_EGL_CONTEXT_API, 3, 0},
                                              {GLFW_NATIVE_CONTEXT_API, 3, 2},
                                              {GLFW_NATIVE_CONTEXT_API, 3, 1},
                                              {GLFW_NATIVE_CONTEXT_API, 3, 0}}};

GLFWwindow* create(const std::string& title, glm::ivec2 size, const Attempt& attempt, bool visible,
                   GLFWwindow* share) {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
  glfwWindowHint(GLFW_CONTEXT_CREATION_API, attempt.api);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, attempt.major);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, attempt.minor);
  glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHint(GLFW_ALPHA_BITS, 0);
  return glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, share);
}

std::vector<Event>& events_of(GLFWwindow* window) {
  return *static_cast<std::vector<Event>*>(glfwGetWindowUserPointer(window));
}

}  // namespace

Glfw::Glfw() {
  if (glfwInit() == GLFW_TRUE) return;
  throw Error(ExitStatus::device, "no window opens here (" + last_problem() + "); " + no_window);
}

Glfw::~Glfw() {
  glfwTerminate();
}

WindowContext::WindowContext(GLFWwindow* window) : window_(window) {
  make_current();
  load([](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); }, "window", false);
}

WindowContext::~WindowContext() {
  release();
}

void WindowContext::bind() {
  glfwMakeContextCurrent(window_);
}

void WindowContext::unbind() {
  glfwMakeContextCurrent(nullptr);
}

// Hidden windows own the contexts of players: GLFW makes and destroys windows on the main thread only, while
// players come and go on any.
struct Window::Pool {
  // What a player gets: gives its place back when the player is gone.
  class Lent final : public gl::Context {
   public:
    Lent(std::shared_ptr<Pool> pool, std::size_t place) : pool_(std::move(pool)), place_(place) {
      make_current();
      load([](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); }, "window",
           false);
    }
    ~Lent() override {
      release();
      const std::lock_guard lock(pool_->mutex);
      pool_->taken[place_] = false;
    }

   private:
    void bind() override { glfwMakeContextCurrent(pool_->windows[place_]); }
    void unbind() override { glfwMakeContextCurrent(nullptr); }

    std::shared_ptr<Pool> pool_;
    std::size_t place_;
  };

  std::array<GLFWwindow*, 2> windows{};
  std::array<bool, 2> taken{};
  std::mutex mutex;
};

Window::Window(const std::string& title, glm::ivec2 size) : pool_(std::make_shared<Pool>()) {
  std::string problem;
  for (const Attempt& attempt : attempts) {
    window_ = create(title, size, attempt, true, nullptr);
    if (window_ == nullptr) {
      if (problem.empty()) problem = last_problem();
      continue;
    }
    for (GLFWwindow*& hidden : pool_->windows) {
      hidden = create(title, {1, 1}, attempt, false, window_);
      if (hidden == nullptr)
        throw Error(ExitStatus::device, "the window's OpenGL can't be shared: " + last_problem());
    }
    break;
  }
  if (window_ == nullptr)
    throw Error(ExitStatus::device, "no OpenGL ES 3 for a window (" + problem + "); " + no_window);
  listen(window_);
  glfwSetWindowUserPointer(window_, &events_);
  context_ = std::make_unique<WindowContext>(window_);
  glfwSwapInterval(1);
}

Window::~Window() {
  context_.reset();
  for (GLFWwindow* hidden : pool_->windows) glfwDestroyWindow(hidden);
  glfwDestroyWindow(window_);
}

std::unique_ptr<gl::Context> Window::take_player_context() {
  std::size_t place = 0;
  {
    const std::lock_guard lock(pool_->mutex);
    while (place < pool_->taken.size() && pool_->taken[place]) ++place;
    if (place == pool_->taken.size())
      throw Error(ExitStatus::device, "every context of the window is in use");
    pool_->taken[place] = true;
  }
  return std::make_unique<Pool::Lent>(pool_, place);
}

void Window::listen(GLFWwindow* window) {
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int modifiers) {
    if (action != GLFW_REPEAT)
      events_of(w).push_back(
          {action == GLFW_PRESS ? Event::Kind::key_down : Event::Kind::key_up, key, modifiers, {}, {}});
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
    Event event{
        action == GLFW_PRESS ? Event::Kind::button_down : Event::Kind::button_up, button, modifiers, {}, {}};
    glfwGetCursorPos(w, &event.position.x, &event.position.y);
    events_of(w).push_back(event);
  });
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    events_of(w).push_back({Event::Kind::move, 0, 0, {x, y}, {}});
  });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    if (count > 0) events_of(w).push_back({Event::Kind::drop, 0, 0, {}, paths[0]});
  });
  // Whatever else needs the window drawn anew.
  const auto other = [](GLFWwindow* w) { events_of(w).emplace_back(); };
  glfwSetWindowRefreshCallback(window, other);
  glfwSetScrollCallback(window, [](GLFWwindow* w, double, double) { events_of(w).emplace_back(); });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned) { events_of(w).emplace_back(); });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { events_of(w).emplace_back(); });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int) { events_of(w).emplace_back(); });
}

glm::ivec2 Window::size() const {
  glm::ivec2 size(0);
  glfwGetWindowSize(window_, &size.x, &size.y);
  return size;
}

glm::ivec2 Window::pixels() const {
  if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE) return glm::ivec2(0);
  glm::ivec2 size(0);
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

double Window::content_scale() const {
  float x = 1.0F;
  float y = 1.0F;
  glfwGetWindowContentScale(window_, &x, &y);
  return x;
}

double Window::refresh_rate() const {
  const GLFWvidmode* mode = nullptr;
  if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) mode = glfwGetVideoMode(monitor);
  return mode != nullptr && mode->refreshRate > 0 ? mode->refreshRate : 60.0;
}

void Window::set_title(const std::string& title) {
  glfwSetWindowTitle(window_, title.c_str());
}

bool Window::full_screen() const {
  return glfwGetWindowMonitor(window_) != nullptr;
}

void Window::toggle_full_screen() {
  if (full_screen()) {
    glfwSetWindowMonitor(window_, nullptr, windowed_.x, windowed_.y, windowed_.z, windowed_.w, 0);
    return;
  }
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
  if (mode == nullptr) return;
  glfwGetWindowPos(window_, &windowed_.x, &windowed_.y);
  glfwGetWindowSize(window_, &windowed_.z, &windowed_.w);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::set_clipboard(const std::string& text) {
  glfwSetClipboardString(window_, text.c_str());
}

bool Window::should_close() const {
  return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

void Window::close() {
  glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void Window::wait(double seconds) {
  if (!events_.empty() || seconds == 0.0)
    glfwPollEvents();
  else if (seconds < 0.0)
    glfwWaitEvents();
  else
    glfwWaitEventsTimeout(seconds);
}

std::vector<Event> Window::take_events() {
  return std::exchange(events_, {});
}

void Window::swap() {
  glfwSwapBuffers(window_);
}

void Window::wake() {
  glfwPostEmptyEvent();
}

}  // namespace shadertwin::view
