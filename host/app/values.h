// What the words of the command line mean: one type and one reader for each kind of value. Every reader
// throws Error(usage) that says what it expected; who calls it puts the option and the word in front.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/gl/gl_device.h"
#include "host/player/fixed_clock.h"

namespace shadertwin::app {

// A rectangle of pixels, from the lower left.
struct Region {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

// A player, as --on names it.
struct DeviceChoice {
  std::string text = "auto";    // as it was typed
  std::string device = "auto";  // auto, egl, egl:N, llvmpipe or osmesa; of the twin, cpu
  gl::Dispatch dispatch = gl::Dispatch::automatic;
  bool double_precision = false;  // of the twin

  bool is_twin() const { return device == "cpu"; }
};

using Define = std::pair<std::string, std::string>;  // a macro's name and its text

glm::ivec2 read_size(const std::string& text);   // WIDTHxHEIGHT, each from 1 to 65536
glm::ivec2 read_pixel(const std::string& text);  // X,Y, each from 0
Region read_region(const std::string& text);     // X,Y,WIDTH,HEIGHT
int read_frames(const std::string& text);        // from 1
int read_runs(const std::string& text);          // from 1
double read_rate(const std::string& text);       // above 0
double read_time(const std::string& text);       // finite
double read_timeout(const std::string& text);    // from 0
double read_share(const std::string& text);      // from 0 to 1
unsigned read_seed(const std::string& text);
Define read_define(const std::string& text);              // NAME is NAME=1
MouseStep read_mouse(const std::string& text);            // X,Y[,down][@FRAME]
std::vector<KeyStep> read_keys(const std::string& text);  // NAME[@FRAME[-RELEASE]],...
DeviceChoice read_device(const std::string& text);

}  // namespace shadertwin::app
