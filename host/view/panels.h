// The panels over the picture. Each is told what to show and says what was asked for; none keeps anything.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/project/project.h"
#include "host/view/shown_text.h"

namespace shadertwin::view {

struct PassTime {
  std::string name;
  double milliseconds = -1.0;  // below 0: unknown
};

struct HudValues {
  double frames_per_second = 0.0;
  std::vector<PassTime> passes;
  glm::ivec2 size{0};
  std::string scale;
  int frame = 0;
  double time = 0.0;
  std::optional<int> samples;   // of a shader that accumulates, since the last restart or input
  double sample_seconds = 0.0;  // which took so long
  std::string shown;            // the pass on screen
  std::string device;
  bool paused = false;
  int recorded = -1;  // frames, while recording
};

struct InspectedPass {
  std::string name;
  glm::vec4 value{0.0F};
};

struct InspectorValues {
  glm::ivec2 pixel{0};
  int face = -1;  // of a cubemap
  std::vector<InspectedPass> passes;
};

// What was done in the uniforms' panel.
struct UniformEdits {
  bool changed = false;
  bool copy = false;
  bool reset = false;
};

void draw_help(bool& open);
void draw_hud(const HudValues& values);
// An error, or several lines of them, over the picture.
void draw_problem(const std::string& text);
// A line that comes and goes.
void draw_notice(const std::string& text);
// `paint` is toggled here too.
void draw_inspector(const InspectorValues& values, bool& open, bool& paint);
UniformEdits draw_uniforms(const std::vector<CustomUniform>& uniforms, std::vector<UniformValue>& values,
                           bool& open);

}  // namespace shadertwin::view
