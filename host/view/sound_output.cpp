#include "host/view/sound_output.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <future>
#include <memory>
#include <utility>
#include <vector>

#include "host/base/error.h"
#include "host/media/loudspeaker.h"
#include "host/player/recordings.h"
#include "host/player/sound.h"
#include "host/project/kinds.h"
#include "host/text/render.h"
#include "host/view/window.h"

namespace shadertwin::view {

namespace {

// Seconds that the device is ahead of the picture. It holds them itself, so that nobody has to be on time.
constexpr double lead = 0.15;
// Seconds by which the sound may be elsewhere than the picture.
constexpr double tolerance = 0.1;
constexpr double pace_window = 0.3;             // seconds over which the pace of frames is measured
constexpr std::size_t step = sound_rate / 100;  // samples that are made at a time
constexpr auto nap = std::chrono::milliseconds(5);

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// All that the sound of a project is made of.
std::string sounding_of(const Project& project) {
  if (project.muted) return {};
  std::string text;
  for (const Pass& pass : project.passes) {
    const bool sounds = !traits(pass).every_frame;
    if (sounds) text += render(pass.source);
    for (const Input& input : pass.inputs)
      if (sounds || info(input.kind).source == InputSource::moving)
        for (const auto& file : input.files) text += '\n' + file.string();
  }
  return text;
}

// The blocks of a Sound pass, each drawn while the one before is heard.
class BlocksAhead {
 public:
  BlocksAhead(const Project& project, const MakePlayer& make_player, const glm::vec4& date)
      : player_(sound_only(project), make_player), date_(date) {}

  Image get(int block) {
    if (!next_.valid() || next_block_ != block) ask(block);
    Image image = next_.get();
    ask(block + 1);
    return image;
  }

 private:
  void ask(int block) {
    if (next_.valid()) next_.wait();
    next_ = player_.ask([block, date = date_](Player& player) { return player.sound_block(block, date); });
    next_block_ = block;
  }

  PlayerThread player_;
  glm::vec4 date_;
  int next_block_ = -1;
  std::future<Image> next_;
};

}  // namespace

// What is heard of one project.
class SoundOutput::Source {
 public:
  // Throws Error.
  Source(const Project& project, const MakePlayer& make_player, const glm::vec4& date)
      : recordings_(project) {
    if (find_sound(project) < 0) return;
    blocks_.emplace(project, make_player, date);
    pass_.emplace([this](int block) { return blocks_->get(block); });
  }

  // Samples `first` and on, as loud as a device plays them.
  void read(std::int64_t first, std::span<float> stereo) {
    std::fill(stereo.begin(), stereo.end(), 0.0F);
    if (pass_) {
      pass_->seek(first);
      pass_->read(stereo);
    }
    recordings_.add(first, stereo);
    for (float& sample : stereo) sample = std::clamp(sample, -1.0F, 1.0F);
  }

 private:
  Recordings recordings_;
  std::optional<BlocksAhead> blocks_;
  std::optional<Sound> pass_;
};

// The device, and what it was given last.
class SoundOutput::Voice {
 public:
  explicit Voice(std::unique_ptr<media::Loudspeaker> speaker) : speaker_(std::move(speaker)) {}

  void rest() {
    if (placed_) speaker_->stop();
    placed_ = false;
  }
  // Gives the device the next samples. False if it has enough for now.
  bool go_on(Source& source, const Tempo& tempo) {
    const double here = (tempo.time + (steady_seconds() - tempo.now) * tempo.speed) * sound_rate;
    const double ahead = lead * sound_rate * tempo.speed;
    const double slack = tolerance * sound_rate * tempo.speed;
    // The picture was reset, the sound took too long to make, or the two clocks went apart.
    if (placed_ && (next_ < here - slack || next_ > here + ahead + slack)) rest();
    if (!placed_) next_ = std::round(here);
    placed_ = true;
    if (next_ >= here + ahead) return false;
    make(source, tempo.speed);
    if (speaker_->play(out_)) {
      next_ += static_cast<double>(step) * tempo.speed;
      return true;
    }
    placed_ = false;
    return false;
  }

 private:
  // At another pace than its own, sound is stretched between its samples.
  void make(Source& source, double speed) {
    out_.resize(2 * step);
    const auto first = static_cast<std::int64_t>(std::floor(next_));
    if (speed == 1.0) return source.read(first, out_);
    const double last = next_ + static_cast<double>(step - 1) * speed;
    in_.resize(2 * static_cast<std::size_t>(static_cast<std::int64_t>(std::floor(last)) - first + 2));
    source.read(first, in_);
    for (std::size_t i = 0; i < step; ++i) {
      const double at = next_ + static_cast<double>(i) * speed - static_cast<double>(first);
      const auto from = static_cast<std::size_t>(at);
      const auto part = static_cast<float>(at - std::floor(at));
      for (std::size_t side = 0; side < 2; ++side)
        out_[2 * i + side] = std::lerp(in_[2 * from + side], in_[2 * from + 2 + side], part);
    }
  }

  std::unique_ptr<media::Loudspeaker> speaker_;
  bool placed_ = false;
  double next_ = 0.0;  // number of the sample that comes next
  std::vector<float> in_;
  std::vector<float> out_;
};

SoundOutput::SoundOutput(MakePlayer make_player, std::function<void(const std::string&)> warn)
    : make_player_(std::move(make_player)), warn_(std::move(warn)) {}

SoundOutput::~SoundOutput() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void SoundOutput::play(const Project& project, const glm::vec4& date) {
  std::string sounding = sounding_of(project);
  if (sounding == sounding_) return;
  sounding_ = std::move(sounding);
  {
    const std::lock_guard lock(mutex_);
    wanted_ = Wanted{project, date};
  }
  if (!thread_.joinable()) thread_ = std::thread([this] { work(); });
  wake_.notify_all();
}

void SoundOutput::follow(double time, double now, bool by_frames) {
  if (!thread_.joinable()) return;
  const std::lock_guard lock(mutex_);
  if (!by_frames) {
    tempo_.speed = 1.0;
    mark_now_ = -1.0;
  } else if (mark_now_ < 0.0 || time < mark_time_) {
    mark_time_ = time;
    mark_now_ = now;
  } else if (now - mark_now_ >= pace_window) {
    tempo_.speed = std::clamp((time - mark_time_) / (now - mark_now_), 0.05, 20.0);
    mark_time_ = time;
    mark_now_ = now;
  }
  tempo_ = {time, now, tempo_.speed, !muted_};
  wake_.notify_all();
}

void SoundOutput::rest() {
  if (!thread_.joinable()) return;
  const std::lock_guard lock(mutex_);
  tempo_.running = false;
  mark_now_ = -1.0;
  wake_.notify_all();
}

void SoundOutput::mute(bool muted) {
  muted_ = muted;
  if (muted) rest();
}

std::optional<std::string> SoundOutput::take_problem() {
  const std::lock_guard lock(mutex_);
  return std::exchange(problem_, std::nullopt);
}

void SoundOutput::work() {
  std::unique_ptr<Source> source;
  std::unique_ptr<Voice> voice;
  bool opened = false;
  bool running = false;
  for (bool enough = false;;) {
    std::optional<Wanted> wanted;
    Tempo tempo;
    {
      std::unique_lock lock(mutex_);
      const auto has_news = [&] {
        return stop_ || wanted_.has_value() || (source && voice && tempo_.running != running);
      };
      if (!running)
        wake_.wait(lock, has_news);
      else if (enough)
        wake_.wait_for(lock, nap, has_news);
      if (stop_) break;
      wanted = std::exchange(wanted_, std::nullopt);
      tempo = tempo_;
    }
    try {
      if (wanted) {
        source.reset();
        if (has_sound(wanted->project))
          source = std::make_unique<Source>(wanted->project, make_player_, wanted->date);
        if (source && !std::exchange(opened, true)) {
          std::string why;
          if (auto speaker = media::Loudspeaker::open(sound_rate, why))
            voice = std::make_unique<Voice>(std::move(speaker));
          else
            warn_("warning: there is no loudspeaker (" + why + "): the sound is not heard");
        }
      }
      running = tempo.running && source && voice;
      if (running)
        enough = !voice->go_on(*source, tempo);
      else if (voice)
        voice->rest();
    } catch (const Error& error) {
      source.reset();
      running = false;
      if (voice) voice->rest();
      {
        const std::lock_guard lock(mutex_);
        problem_ = error.what();
      }
      Window::wake();
    }
  }
}

}  // namespace shadertwin::view
