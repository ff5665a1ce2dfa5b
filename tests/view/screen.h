// A screen without a monitor, a window on it, and a hand: Xvfb, `shadertwin view` and xdotool.
#pragma once

#include <sys/types.h>

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "host/image/image.h"
#include "tests/scratch_folder.h"
#include "tests/skip.h"

namespace shadertwin {

// An X server of its own, 1280x1024, gone at the end.
class Screen {
 public:
  Screen();
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  // The value of DISPLAY; empty if no server could be started.
  const std::string& name() const { return name_; }
  // What it shows at (x, y) from the upper left: red, green, blue.
  glm::ivec3 pixel(int x, int y) const;
  // Runs xdotool with these arguments; returns what it prints.
  std::string hand(const std::string& arguments) const;

 private:
  ScratchFolder folder_;
  pid_t server_ = -1;
  std::string name_;
};

// `shadertwin view` in the upper left corner of a screen.
class RunningView {
 public:
  // Waits for the window. `arguments` are split at spaces.
  RunningView(const Screen& screen, const ScratchFolder& folder, const std::string& arguments,
              const std::vector<std::string>& environment = {});
  ~RunningView();
  RunningView(const RunningView&) = delete;
  RunningView& operator=(const RunningView&) = delete;

  bool running();
  pid_t pid() const { return pid_; }
  std::string err() const;
  std::string out() const;
  // Waits until stderr holds `text` behind its first `from` characters. False after a minute, or if the
  // program ends.
  bool says(const std::string& text, std::size_t from = 0);

  void key(const std::string& names) const;
  // Takes a screenshot by F12 and gives it as the EXR has it, and the number of its frame.
  struct Shot {
    Image image;
    int frame = -1;
    std::string name;  // of the files, without extension
  };
  Shot shoot();
  // Waits until two more frames have been drawn.
  void let_frames_pass();
  // Presses F7 so often, each time waiting for the frame.
  void step(int frames);
  // Presses Ctrl+Q and gives the exit status; -1 if the program does not end.
  int quit();
  // The exit status of a program that ends by itself; -1 if it does not within a minute.
  int wait_for_end();
  std::string window() const { return window_; }

 private:
  const Screen& screen_;
  const ScratchFolder& folder_;
  ScratchFolder captured_;
  pid_t pid_ = -1;
  int status_ = -1;
  std::string window_;
};

// Tries until `done`, at most a minute. Whether it was done.
bool eventually(const std::function<bool()>& done);

}  // namespace shadertwin
