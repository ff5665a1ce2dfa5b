// Calls GLSL functions from C++: a probe is a small Shadertoy shader that reads the inputs of many cases from
// a float texture, calls functions of the path tracer and writes their results. The same file runs on every
// player.
#pragma once

#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "host/image/image.h"
#include "host/player/player.h"
#include "host/project/project.h"

namespace shadertwin {

// A way to run a shader.
struct Backend {
  std::string name;  // a C++ identifier: part of the names of tests
  std::function<std::unique_ptr<Player>(const Project&)> create;
};

// What this build can run on. The first one is the one the others are compared with.
const std::vector<Backend>& backends();

// How many cases most tables have.
constexpr std::size_t million = std::size_t{1} << 20;

// Cases by texels: `size` vec4 for each case.
class Table {
 public:
  Table(std::size_t cases, int size)
      : cases_(cases), size_(size), texels_(cases * static_cast<std::size_t>(size)) {}
  std::size_t cases() const { return cases_; }
  int size() const { return size_; }
  glm::vec4& at(std::size_t i, int texel) { return texels_[index(i, texel)]; }
  const glm::vec4& at(std::size_t i, int texel) const { return texels_[index(i, texel)]; }

 private:
  std::size_t index(std::size_t i, int texel) const {
    return i * static_cast<std::size_t>(size_) + static_cast<std::size_t>(texel);
  }
  std::size_t cases_;
  int size_;
  std::vector<glm::vec4> texels_;
};

// A function of a file in this folder.
struct Probe {
  std::string file;
  int function = 0;  // what the shader sees as iFrame
  int inputs = 1;    // texels a case
  int outputs = 1;
  std::vector<std::pair<std::string, std::string>> defines = {};
};

// The results of every case. Throws Error(shader) if the probe does not compile.
Table run_probe(const Backend& backend, const Probe& probe, const Table& inputs);

// A whole shader of this folder, played for some frames.
struct Take {
  std::string file;
  int width = 32;
  int height = 18;
  int frames = 1;
  std::vector<std::pair<std::string, std::string>> defines = {};
  std::string pass = {};  // the last one if empty
  int first_frame = 0;    // iFrame of the first one
  double time = 0.0;      // iTime of the first one, seconds
};

// What the pass holds after the last frame.
Image run_shader(const Backend& backend, const Take& take);

}  // namespace shadertwin
