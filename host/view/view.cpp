#include "host/view/view.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

#include "host/base/error.h"
#include "host/image/image.h"
#include "host/text/load.h"
#include "host/text/text_warnings.h"
#include "host/view/canvas.h"
#include "host/view/capture.h"
#include "host/view/dashboard.h"
#include "host/view/keys.h"
#include "host/view/playing.h"
#include "host/view/presenter.h"
#include "host/view/reloader.h"
#include "host/view/sample_count.h"
#include "host/view/shown_text.h"
#include "host/view/sound_output.h"
#include "host/view/window.h"

namespace shadertwin::view {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

constexpr int settling_frames = 3;  // Dear ImGui needs so many to take in what happened

class View {
 public:
  explicit View(const ViewOptions& options)
      : options_(options),
        window_(stem_of(options.shader) + " - loading", options.size),
        dashboard_(window_, options.quiet),
        presenter_(window_.context()),
        read_(FileWatch::now()),
        playing_(options.shader, load(options.shader, options.accept)),
        clock_(options.clock, host_rules(playing_.project())),
        capture_(options.output.empty() ? stem_of(options.shader) : options.output),
        sound_(options.sound_player, [this](const std::string& line) { warn({line}); }),
        reloader_([this](const fs::path& shader) { return load(shader); }, options.shader, playing_.project(),
                  read_) {
    if (!options.pass.empty()) playing_.show(need_pass(playing_.project(), options.pass));
    name_window();
  }

  void run() {
    draw();  // what is pressed meanwhile finds a picture
    play_sound();
    while (!window_.should_close()) {
      window_.wait(rest());
      for (const Event& event : window_.take_events()) handle(event);
      if (auto result = reloader_.take()) take(std::move(*result));
      if (const auto problem = sound_.take_problem()) {
        dashboard_.lay_over(*problem);
        settling_ = settling_frames;
      }
      if (dashboard_.expire()) settling_ = 1;
      const glm::ivec2 pixels = window_.pixels();
      if (pixels.x <= 0 || pixels.y <= 0 || Clock::now() < next_) continue;
      const bool drew = draw();
      if (!drew && settling_ == 0) continue;
      if (settling_ > 0) --settling_;
      present(pixels);
    }
  }

 private:
  // Loading, which happens in the reloader's thread but for the first time.

  Loaded load(const fs::path& shader, const std::function<void(const Project&)>& accept = {}) {
    Project project = load_project(shader, options_.load);
    if (accept) accept(project);
    warn(all_warnings(project));
    auto stage = options_.other_player ? make_uploading_stage(window_, project, options_.other_player)
                                       : make_shared_stage(window_, project, options_.player);
    warn(stage->warnings());
    return {std::move(project), std::move(stage)};
  }

  void warn(const std::vector<std::string>& lines) const {
    if (!options_.quiet)
      for (const std::string& line : lines) std::fprintf(stderr, "%s\n", line.c_str());
  }

  void play_sound() {
    sound_.play(playing_.project(), shader_date(options_.clock.date.value_or(ClockReading::now().date), 0.0));
  }

  void take(Reloader::Result result) {
    settling_ = settling_frames;
    if (!result.loaded.has_value()) return dashboard_.lay_over(result.problem);
    dashboard_.clear_problem();
    reloading_since_ = result.since;
    halted_at_.reset();
    samples_.restart();
    const bool same =
        result.shader == playing_.shader() && result.loaded->project.dialect == playing_.project().dialect;
    frame_.reset();
    waiting_ = false;
    try {
      playing_.replace(result.shader, std::move(*result.loaded));
    } catch (const Error& e) {
      dashboard_.lay_over(e.what());
    }
    if (same)
      clock_.restart_frames();
    else
      clock_.restart(host_rules(playing_.project()));
    play_sound();
    name_window();
  }

  void name_window() { window_.set_title(stem_of(playing_.shader()) + " - " + playing_.shown().name); }

  // What a hand does.

  void handle(const Event& event) {
    settling_ = settling_frames;
    switch (event.kind) {
      case Event::Kind::key_down:
        if (const auto action = action_for(event.code, event.modifiers))
          perform(*action);
        else if (const auto code = browser_code(event.code);
                 code.has_value() && !dashboard_.wants_keys(playing_))
          input(playing_.hears_keyboard(), [&] { clock_.keyboard().press(*code); });
        break;
      case Event::Kind::key_up:
        if (const auto code = browser_code(event.code); code.has_value() && clock_.keyboard().held(*code))
          input(playing_.hears_keyboard(), [&] { clock_.keyboard().release(*code); });
        break;
      case Event::Kind::button_down:
        if (dashboard_.wants_mouse(playing_, event.position)) break;
        if (dashboard_.inspects()) {
          print_commands(event.position);
          break;
        }
        clock_.set_button(event.code, true);
        input(playing_.hears_mouse(),
              [&] { clock_.mouse().press(canvas_.to_picture(event.position), canvas_.size()); });
        break;
      case Event::Kind::button_up:
        clock_.set_button(event.code, false);
        if (clock_.mouse().down()) input(playing_.hears_mouse(), [&] { clock_.mouse().release(); });
        break;
      case Event::Kind::move:
        cursor_ = event.position;
        if (clock_.mouse().down())
          input(playing_.hears_mouse(),
                [&] { clock_.mouse().move(canvas_.to_picture(event.position), canvas_.size()); });
        break;
      case Event::Kind::drop:
        reloader_.open(event.file);
        break;
      case Event::Kind::other:
        break;
    }
  }

  // What the shader hears a paused picture follows, and an accumulating one starts over.
  template <typename Change>
  void input(bool heard, Change change) {
    change();
    if (!heard) return;
    samples_.restart();
    if (clock_.paused()) clock_.force();
  }

  void perform(Action action) {
    if (dashboard_.toggle(action)) return;
    switch (action) {
      case Action::reset:
        clock_.reset();
        samples_.restart();
        break;
      case Action::pause:
        clock_.set_paused(!clock_.paused());
        if (clock_.paused()) sound_.rest();
        break;
      case Action::mute:
        sound_.mute(!sound_.muted());
        dashboard_.notice(sound_.muted() ? "sound off" : "sound on");
        break;
      case Action::step:
        clock_.step();
        break;
      case Action::previous_pass:
      case Action::next_pass:
        playing_.show_neighbour(action == Action::next_pass ? 1 : -1);
        name_window();
        break;
      case Action::scale:
        canvas_.rescale();
        break;
      case Action::full_screen:
        window_.toggle_full_screen();
        break;
      case Action::screenshot:
        attempt([this] { screenshot(); });
        break;
      case Action::record:
        attempt([this] { toggle_recording(); });
        break;
      case Action::quit:
        window_.close();
        break;
      default:
        break;
    }
  }

  template <typename Deed>
  void attempt(Deed deed) {
    try {
      deed();
    } catch (const Error& e) {
      dashboard_.notice(e.what());
    }
  }

  void screenshot() {
    screenshot_due_ = !frame_.has_value();
    if (screenshot_due_) return;
    const std::string name = capture_.screenshot(playing_.stage().read(playing_.pass()));
    dashboard_.notice(name + ".png and .exr: frame " + std::to_string(frame_->index));
  }

  void toggle_recording() {
    if (!capture_.recording()) {
      capture_.start();
      clock_.set_recording(options_.recording_rate);
    } else {
      clock_.set_recording(std::nullopt);
      dashboard_.notice(capture_.stop());
    }
  }

  void print_commands(glm::dvec2 position) {
    if (!frame_.has_value()) return;
    const ShownTexture picture = playing_.stage().picture(playing_.pass());
    if (picture.texture == 0) return;
    const std::string pass = playing_.shows_last() ? "" : playing_.shown().name;
    const FrameCommand command{playing_.shader().string(), all_options(), options_.clock.rate.value_or(0.0),
                               options_.clock.t0, options_.clock.date};
    std::fputs(
        commands_for_pixel(command, *frame_, pass, place_in(picture, canvas_.across(position)).at).c_str(),
        stdout);
    std::fflush(stdout);
  }

  std::string all_options() {
    std::string text = options_.options_text;
    const std::string edits = playing_.uniforms().edits_as_options();
    if (!edits.empty()) text += (text.empty() ? "" : " ") + edits;
    return text;
  }

  // The picture.

  // Seconds until there is something to do; negative: until something happens.
  double rest() const {
    const auto until = [](Clock::time_point time) {
      return std::max(0.0, std::chrono::duration<double>(time - Clock::now()).count());
    };
    const bool due = settling_ > 0 || (clock_.due() && !halted_at_.has_value());
    const auto notice_until = dashboard_.notice_until();
    if (!due) return notice_until.has_value() ? until(*notice_until) : -1.0;
    // A player in a thread of its own ends the wait when it is done.
    if (settling_ == 0 && waiting_) return 0.1;
    return until(next_);
  }

  // Draws a frame if one is due and the last one is done. True if there is a new picture.
  bool draw() {
    const bool was_waiting = waiting_;
    try {
      waiting_ = !playing_.stage().ready();
      if (waiting_) return false;
      if (was_waiting) record();
      const glm::ivec2 size = canvas_.size();
      if (pixels_.x != 0 && size != pixels_) clock_.restart_frames();
      if (halted_at_.has_value() && *halted_at_ == size) return was_waiting;
      if (!clock_.due()) return was_waiting;
      if (halted_at_.has_value()) dashboard_.clear_problem();
      halted_at_.reset();
      pixels_ = size;
      const ClockReading now = ClockReading::now();
      Frame frame = clock_.next(now, size);
      if (clock_.paused())
        sound_.rest();
      else
        sound_.follow(frame.time, now.seconds, clock_.by_frames());
      frame.uniforms = playing_.uniforms().values();
      samples_.add(frame.index == 0);
      playing_.stage().draw(frame);
      frame_ = frame;
      if (screenshot_due_) attempt([this] { screenshot(); });
      waiting_ = !playing_.stage().ready();
      if (!waiting_) record();
      return !waiting_ || was_waiting;
    } catch (const Error& e) {
      dashboard_.lay_over(e.what());
      sound_.rest();
      halted_at_ = canvas_.size();
      settling_ = settling_frames;
      return false;
    }
  }

  void record() {
    if (capture_.recording()) attempt([this] { capture_.add(playing_.stage().read(playing_.pass())); });
  }

  void present(glm::ivec2 pixels) {
    const auto start = Clock::now();
    window_.context().make_current();
    const ShownTexture picture = playing_.stage().picture(playing_.pass());
    if (picture.texture != 0 && !halted_at_.has_value())
      presenter_.draw(picture, pixels, dashboard_.paints());
    else
      presenter_.clear(pixels);
    if (dashboard_.draw(scene())) input(true, [] {});
    playing_.stage().shown();
    window_.swap();
    if (reloading_since_.has_value() && !waiting_) {
      const double ms = std::chrono::duration<double, std::milli>(Clock::now() - *reloading_since_).count();
      reloading_since_.reset();
      dashboard_.notice(stem_of(playing_.shader()) + ": reloaded in " + std::to_string(std::lround(ms)) +
                        " ms");
    }
    // Where the display does not hold the swap back (off screen, say), frames must not come faster than it
    // shows them.
    const auto interval = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(0.97 / window_.refresh_rate()));
    next_ = std::max(next_ + interval, start);
  }

  Scene scene() {
    Scene scene{.playing = playing_,
                .presenter = presenter_,
                .clock = clock_,
                .size = pixels_,
                .scale = canvas_.scale(),
                .samples = {},
                .sample_seconds = 0.0,
                .recorded = capture_.recorded(),
                .cursor = canvas_.across(cursor_)};
    if (playing_.accumulates()) {
      scene.samples = samples_.count();
      scene.sample_seconds = samples_.seconds();
    }
    return scene;
  }

  ViewOptions options_;
  Window window_;  // before everything that lives in its contexts
  Canvas canvas_{window_};
  Dashboard dashboard_;
  Presenter presenter_;
  FileWatch::Stamp read_;  // when reading the first project began
  Playing playing_;
  LiveClock clock_;
  glm::ivec2 pixels_{0};                 // of the last frame
  std::optional<Frame> frame_;           // the last one of what plays now
  bool screenshot_due_ = false;          // asked for before there was one
  bool waiting_ = false;                 // for a player in its own thread
  std::optional<glm::ivec2> halted_at_;  // drawing failed at this size

  Capture capture_;
  SoundOutput sound_;

  SampleCount samples_;
  glm::dvec2 cursor_{0.0};

  int settling_ = settling_frames;  // frames to show although nothing moves
  Clock::time_point next_;          // when the next may be shown
  std::optional<Clock::time_point> reloading_since_;
  Reloader reloader_;  // last: its thread uses the window
};

}  // namespace

void run_view(const ViewOptions& options) {
  View(options).run();
}

}  // namespace shadertwin::view
