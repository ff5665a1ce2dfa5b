#include "host/view/playing.h"

#include <utility>

#include "host/project/host_rules.h"
#include "host/project/kinds.h"

namespace shadertwin::view {

namespace fs = std::filesystem;

std::string stem_of(const fs::path& shader) {
  const fs::path name = shader.has_filename() ? shader : shader.parent_path();
  const std::string stem = fs::absolute(name).lexically_normal().stem().string();
  return stem.empty() ? "shader" : stem;
}

Playing::Playing(fs::path shader, Loaded loaded) : shader_(std::move(shader)) {
  put_on(std::move(loaded));
}

void Playing::replace(const fs::path& shader, Loaded loaded) {
  const bool same = shader == shader_;
  const std::string name = shown().name;
  if (!same) uniforms_ = LiveUniforms();
  shader_ = shader;
  const std::unique_ptr<Stage> before = std::move(stage_);
  const HostRules earlier = host_rules(project_);
  put_on(std::move(loaded));
  if (!same) return;
  if (const int pass = find_pass(project_, name); pass >= 0) show(pass);
  if (earlier.keeps_pictures_on_reload && host_rules(project_).keeps_pictures_on_reload && before->ready())
    stage_->continue_from(*before);
}

void Playing::put_on(Loaded loaded) {
  project_ = std::move(loaded.project);
  stage_ = std::move(loaded.stage);
  uniforms_.declare(project_.uniforms);
  accumulates_ = false;
  hears_keyboard_ = hears_mouse_ = project_.first_person_controls;
  for (std::size_t reader = 0; reader < project_.passes.size(); ++reader) {
    const Pass& pass = project_.passes[reader];
    hears_keyboard_ = hears_keyboard_ || pass.keyboard;
    hears_mouse_ = hears_mouse_ || pass.source.body.find("iMouse") != std::string::npos;
    for (const Input& input : pass.inputs) {
      hears_keyboard_ = hears_keyboard_ || input.kind == InputKind::keyboard;
      accumulates_ =
          accumulates_ || (input.kind == InputKind::pass && input.pass >= static_cast<int>(reader));
    }
  }
  show(static_cast<int>(project_.passes.size()) - 1);
}

void Playing::show(int pass) {
  pass_ = pass;
  stage_->show(pass);
}

void Playing::show_neighbour(int direction) {
  const int count = static_cast<int>(project_.passes.size());
  int pass = pass_;
  do pass = (pass + direction + count) % count;
  while (!traits(project_.passes[static_cast<std::size_t>(pass)]).every_frame);
  show(pass);
}

}  // namespace shadertwin::view
