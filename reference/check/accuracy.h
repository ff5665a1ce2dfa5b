// Where a shader loses digits: what a twin with shadows (glsl/shadow.h) notes, put together over all frames.
#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/image/image.h"
#include "reference/check/finding.h"
#include "reference/check/run.h"
#include "reference/twin/abi.h"

namespace shadertwin::check {

struct AccuracyOptions {
  RunOptions run;
  int pass = 0;                     // the picture that is judged
  double threshold = 1.0 / 512.0;   // of picture_error(): half a step of an 8-bit picture
  std::optional<glm::ivec2> pixel;  // of that picture in the last frame, to be told operation by operation
};

// An operation, a comparison or a conversion of the shader's, wherever it is compiled.
struct Operation {
  std::string file;
  int line = 0;
  std::string text;          // as the shader has it
  twin::PlaceRecord record;  // summed up
  // `file:line` of the operation from which most of the error comes that lets a decision here differ; empty
  // if that is none or this one.
  std::string cause;
  // Numbers of the picture most of whose error comes from here, at or above the threshold.
  std::size_t pixels = 0;
  std::size_t not_numbers = 0;  // of them: just one of float and double is NaN
  double error = 0.0;           // the largest picture_error()
  double error_sum = 0.0;       // over those pixels
  twin::PixelPlace at;
};

// The numbers that a line assigns or returns, wherever it is compiled.
struct Line {
  std::string file;
  int line = 0;
  twin::NumberRecord record;  // summed up
};

// A result of the told pixel with a notable error.
struct Told {
  std::string file;
  int line = 0;
  std::string text;
  std::vector<twin::ShadowNumber> operands;
  twin::ShadowNumber result{};
  double own = 0.0;  // what is lost here, relative to the result
};

struct Accuracy {
  std::vector<Operation> operations;  // that lose digits, decide differently, or reach the picture
  std::vector<Line> lines;            // that assign numbers, by file and line
  std::size_t drawn = 0;              // pixels of the picture in all frames
  std::size_t pixels = 0;             // whose error is at or above the threshold
  double error = 0.0;                 // the largest picture_error()
  double mean_error = 0.0;
  twin::PixelPlace at;
  std::size_t without_origin = 0;  // of `pixels`: no operation is to blame
  std::size_t not_numbers = 0;     // pixels where just one of float and double is NaN
  Image heatmap;                   // of the last frame
  std::vector<Told> told;
  std::size_t untold = 0;  // further results, beyond what is kept
  std::array<twin::ShadowNumber, 4> told_pixel{};
};

// Draws the frames on a twin with shadows. Throws what twin::make_player() and Player::render() throw.
// `progress` is called with the number of frames that are done.
Accuracy measure_accuracy(const Project& project, const AccuracyOptions& options,
                          const std::function<void(int)>& progress = {});

// What `accuracy` tells. The kind is name_of(Loss), or `branch`.
struct AccuracyFinding : Finding {
  double weight = 0.0;  // the picture's error that it causes, summed over pixels
  double bits = 0.0;    // lost at the operation
  const Operation* operation = nullptr;
};

// The worst first: what moves the picture by the threshold or more. With `least_bits` also operations that
// lose so many bits without that, and what is seen in less than one pixel of a thousand: specks and edges, as
// every picture has them, are no findings otherwise, unless they are NaN.
std::vector<AccuracyFinding> accuracy_findings(const Accuracy& accuracy, std::optional<double> least_bits);

// Of 24 bits, those that an error of this share of a number takes.
double bits_lost(double share);

}  // namespace shadertwin::check
