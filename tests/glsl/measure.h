// Compares built-in functions as a device computes them with the same functions in C++, over many inputs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/image/image.h"
#include "tests/glsl/inputs.h"

namespace shadertwin::glsl {

// What a case computes with; GLSL knows them by these names too.
struct Arguments {
  vec4 a, b, c, d, e, f, g, h;
};

// One expression in both languages.
struct BuiltinCase {
  std::string name;
  std::vector<Domain> domains;  // of a, b ...; the others are 0
  std::string glsl;             // statements that set `vec4 r`
  vec4 (*cpp)(const Arguments&) = nullptr;
};

struct Difference {
  Arguments arguments;
  vec4 device;
  vec4 twin;
  int component = 0;
  double ulp = 0;
};

// How far a device is from C++ in one function. A NaN equals any NaN; zeros of different sign are not equal,
// but 0 ULP apart.
struct Deviation {
  std::string name;
  std::string domain;
  long count = 0;
  long equal = 0;
  double max_ulp = 0;       // infinity when only one of the two is a NaN
  double p99_ulp = 0;       // 99 of 100 values are no farther
  double max_absolute = 0;  // largest difference of two finite values
  Difference first;         // in reading order
  Difference worst;
};

// Draws a shader that has `void mainImage(out vec4 fragColor, in vec2 fragCoord)`, and gives back its pixels.
using Draw = std::function<Image(const std::string& shader, int width, int height)>;

// What `test` looks like to a device.
std::string shader_for(const BuiltinCase& test);

// Inputs: four components of width * height pixels.
Deviation measure(const BuiltinCase& test, const Draw& draw, int width = 512, int height = 512);

// One line: arguments, both values in hexadecimal and decimal, ULP.
std::string text(const Difference& difference, std::size_t arguments);

// The report of a device: a Markdown table with one line a case.
std::string table_head();
std::string table_row(const Deviation& deviation);

// Floats between a and b, counted across zero.
double ulp_distance(float a, float b);

}  // namespace shadertwin::glsl
