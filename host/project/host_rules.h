// What shadertoy.com and the VS Code extension "Shader Toy" do differently. Whoever loads, writes or draws a
// project, binds its channels or makes its frames asks here what to do, not whose project it is.
#pragma once

#include <cstdint>

#include "host/project/project.h"

namespace shadertwin {

// As they stand, shadertoy.com's rules.
struct HostRules {
  // Text.
  bool is_local = false;        // SHADER_TOY is defined
  bool has_performance = true;  // HW_PERFORMANCE is defined
  bool code_in_front = true;    // of the shader's: #version and #extension are refused
  bool main_in_front = true;    // main() stands there, too
  bool owns_names = true;  // main(), the form of mainImage() and the uniforms are not the shader's to declare
  bool has_asserts = true;         // st_assert() in the image
  bool has_local_inputs = false;   // iMouseButton, iViewMatrix, iKeyboard
  bool takes_older_names = false;  // of GLSL ES 1.00 and of older players
  // Channels.
  int channels = 4;                // the shader has iChannel0 and so on
  bool editor_samplers = true;     // what nothing is said of is as the site's editor has it
  bool shared_samplers = true;     // all that read a buffer share one texture object and its settings
  std::uint8_t empty_alpha = 255;  // of a channel that nothing is bound to; r, g and b are 0
  int keyboard_rows = 3;           // held, pressed, toggled; the fourth is released
  bool grey_tables = false;        // keyboard and sound are in r, g and b, else only in r; alpha is 1
  int analysed_samples = 2048;     // of sound, for one spectrum
  bool sound_has_size = true;      // iChannelResolution of music and the microphone
  bool cubemap_has_size =
      false;  // iChannelResolution of a cubemap of files: else (0, 0, 0), with it (0, 0, 1)
  bool always_has_audio = true;  // iSampleRate is set without a sound on any channel
  // Passes.
  bool opaque_image = true;              // the image's alpha becomes 1
  bool common_stands_alone = true;       // Common is compiled by itself, too
  bool clears_targets = false;           // before every pass, which shows where a shader discards
  bool keeps_pixels_on_resize = true;    // of buffers, from the lower left
  bool keeps_pictures_on_reload = true;  // the changed shader goes on from what was drawn
  bool keeps_previous_pictures = true;   // of all passes whose traits say so, not only where they are read
  bool warms_up = false;                 // all passes are drawn once before frame 0
  bool swaps_after_frame = false;        // the two pictures of a pass, instead of as soon as it is drawn
  bool reports_first_size = false;       // iChannelResolution of passes stays what it was at the start
  // Frames and what the user does.
  bool recounts_frames = false;  // from 0, after a reload or a resize
  double idle_time_delta =
      1.0 / 60.0;            // iTimeDelta of the first frame, and of one drawn while paused; seconds
  bool keeps_taps = false;   // a key that went down and up between two frames still reads as pressed
  float first_mouse = 0.0F;  // all of iMouse before the first click
  bool keeps_mouse_fractions = false;  // positions are neither floored nor kept inside the picture
  bool mouse_release_counts = false;   // iMouse.w is positive also on the first frame after the release
};

// `vscode_quirks` counts for the extension's projects only.
constexpr HostRules host_rules(Dialect dialect, bool vscode_quirks = false) {
  HostRules rules;
  if (dialect == Dialect::shadertoy) return rules;
  rules.is_local = true;
  rules.has_performance = false;
  rules.code_in_front = false;
  rules.main_in_front = false;
  rules.owns_names = false;
  rules.has_asserts = false;
  rules.has_local_inputs = true;
  rules.takes_older_names = true;
  rules.editor_samplers = false;
  rules.channels = max_channels;
  rules.shared_samplers = false;
  rules.keyboard_rows = 4;
  rules.grey_tables = true;
  rules.analysed_samples = 512;
  rules.sound_has_size = false;
  rules.cubemap_has_size = true;
  rules.always_has_audio = false;
  rules.opaque_image = false;
  rules.common_stands_alone = false;
  rules.clears_targets = true;
  rules.keeps_pixels_on_resize = false;
  rules.keeps_pictures_on_reload = false;
  rules.keeps_previous_pictures = false;
  rules.recounts_frames = true;
  rules.keeps_taps = true;
  if (!vscode_quirks) return rules;
  rules.empty_alpha = 0;
  rules.warms_up = true;
  rules.swaps_after_frame = true;
  rules.reports_first_size = true;
  rules.idle_time_delta = 0.0;
  rules.first_mouse = -1.0F;
  rules.keeps_mouse_fractions = true;
  rules.mouse_release_counts = true;
  return rules;
}

inline HostRules host_rules(const Project& project) {
  return host_rules(project.dialect, project.vscode_quirks);
}

}  // namespace shadertwin
