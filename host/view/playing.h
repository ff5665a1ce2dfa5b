// The project that plays, and what a hand has chosen about it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "host/project/project.h"
#include "host/view/live_uniforms.h"
#include "host/view/reloader.h"
#include "host/view/stage.h"

namespace shadertwin::view {

// The name that a shader goes by: its file's or folder's, without extension.
std::string stem_of(const std::filesystem::path& shader);

class Playing {
 public:
  Playing(std::filesystem::path shader, Loaded loaded);

  // Puts another project in this one's place. Of the same shader, the shown pass, the uniforms and on
  // shadertoy.com the buffers stay. Throws Error if the buffers can't be copied; the new project then plays
  // without.
  void replace(const std::filesystem::path& shader, Loaded loaded);

  const std::filesystem::path& shader() const { return shader_; }
  const Project& project() const { return project_; }
  Stage& stage() { return *stage_; }
  LiveUniforms& uniforms() { return uniforms_; }
  const LiveUniforms& uniforms() const { return uniforms_; }

  int pass() const { return pass_; }
  const Pass& shown() const { return project_.passes[static_cast<std::size_t>(pass_)]; }
  bool shows_last() const { return pass_ + 1 == static_cast<int>(project_.passes.size()); }
  void show(int pass);
  // Shows the next pass (1) or the previous one (-1) that has a picture.
  void show_neighbour(int direction);

  // Whether a pass reads what it, or a later one, drew in the frame before.
  bool accumulates() const { return accumulates_; }
  // Whether the keyboard, or the mouse, can change the picture.
  bool hears_keyboard() const { return hears_keyboard_; }
  bool hears_mouse() const { return hears_mouse_; }

 private:
  void put_on(Loaded loaded);

  std::filesystem::path shader_;
  Project project_;
  std::unique_ptr<Stage> stage_;
  LiveUniforms uniforms_;
  int pass_ = 0;
  bool accumulates_ = false;
  bool hears_keyboard_ = false;
  bool hears_mouse_ = false;
};

}  // namespace shadertwin::view
