#include "host/view/dashboard.h"

#include <cstdio>
#include <utility>

#include "host/view/shown_text.h"

namespace shadertwin::view {

namespace {

constexpr std::chrono::seconds notice_time(4);

HudValues hud_values(const Scene& scene) {
  Playing& playing = scene.playing;
  HudValues v;
  v.frames_per_second = scene.clock.frame_rate();
  const auto times = playing.stage().milliseconds();
  if (times.size() == playing.project().passes.size())
    for (std::size_t i = 0; i < times.size(); ++i)
      v.passes.push_back({playing.project().passes[i].name, times[i]});
  else if (times.size() == 1)
    v.passes.push_back({"all passes", times[0]});
  v.size = scene.size;
  v.scale = scene.scale;
  v.shown = playing.shown().name;
  v.frame = scene.clock.index();
  v.time = scene.clock.time();
  v.samples = scene.samples;
  v.sample_seconds = scene.sample_seconds;
  v.device = playing.stage().description();
  v.paused = scene.clock.paused();
  v.recorded = scene.recorded;
  return v;
}

InspectorValues inspected(const Scene& scene) {
  Playing& playing = scene.playing;
  InspectorValues v;
  for (std::size_t i = 0; i < playing.project().passes.size(); ++i) {
    const ShownTexture picture = playing.stage().picture(static_cast<int>(i));
    if (picture.texture == 0) continue;
    const PixelPlace place = place_in(picture, scene.cursor);
    if (static_cast<int>(i) == playing.pass()) {
      v.pixel = place.at;
      v.face = picture.target == GL_TEXTURE_CUBE_MAP ? place.face : -1;
    }
    v.passes.push_back({playing.project().passes[i].name, scene.presenter.pixel(picture, place)});
  }
  return v;
}

}  // namespace

bool Dashboard::toggle(Action action) {
  bool* panel = action == Action::help        ? &help_
                : action == Action::hud       ? &hud_
                : action == Action::inspector ? &inspector_
                : action == Action::uniforms  ? &sliders_
                : action == Action::paint     ? &paint_
                                              : nullptr;
  if (panel == nullptr) return false;
  *panel = !*panel;
  return true;
}

bool Dashboard::wants_mouse(const Playing& playing, glm::dvec2 position) const {
  return shows_any(playing) && overlay_.wants_mouse(position);
}

bool Dashboard::wants_keys(const Playing& playing) const {
  return shows_any(playing) && overlay_.wants_keys();
}

void Dashboard::notice(const std::string& text) {
  if (!quiet_) std::fprintf(stderr, "%s\n", text.c_str());
  notice_ = text;
  notice_until_ = Clock::now() + notice_time;
}

std::optional<Dashboard::Clock::time_point> Dashboard::notice_until() const {
  return notice_.empty() ? std::nullopt : std::optional(notice_until_);
}

bool Dashboard::expire() {
  if (notice_.empty() || Clock::now() < notice_until_) return false;
  notice_.clear();
  return true;
}

void Dashboard::lay_over(const std::string& problem) {
  problem_ = problem;
  std::fprintf(stderr, "%s\n", problem_.c_str());
}

bool Dashboard::draw(const Scene& scene) {
  if (!shows_any(scene.playing)) return false;
  bool changed = false;
  overlay_.begin();
  if (hud_) draw_hud(hud_values(scene));
  if (!notice_.empty()) draw_notice(notice_);
  if (!problem_.empty()) draw_problem(problem_);
  if (inspector_) draw_inspector(inspected(scene), inspector_, paint_);
  if (sliders_ && !scene.playing.project().uniforms.empty()) changed = edit_uniforms(scene.playing);
  if (help_) draw_help(help_);
  overlay_.end();
  return changed;
}

bool Dashboard::shows_any(const Playing& playing) const {
  return hud_ || help_ || inspector_ || !notice_.empty() || !problem_.empty() ||
         (sliders_ && !playing.uniforms().declared().empty());
}

bool Dashboard::edit_uniforms(Playing& playing) {
  LiveUniforms& uniforms = playing.uniforms();
  auto values = uniforms.values();
  const UniformEdits edits = draw_uniforms(uniforms.declared(), values, sliders_);
  if (edits.changed) uniforms.set(values);
  if (edits.reset) uniforms.reset();
  if (edits.copy) {
    const std::string text = uniforms_as_options(uniforms.declared(), uniforms.values());
    window_.set_clipboard(text);
    notice("copied: " + text);
  }
  return edits.changed || edits.reset;
}

}  // namespace shadertwin::view
