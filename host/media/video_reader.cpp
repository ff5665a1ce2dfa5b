#include "host/media/video_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace shadertwin::media {

namespace {

constexpr std::int64_t none = AV_NOPTS_VALUE;

// How far a file may fall short of its own duration, in seconds, without a word: containers round, and sound
// is cut into blocks.
constexpr double forgiven = 0.25;

std::int64_t time_of(const AVPacket& packet) {
  return packet.pts != none ? packet.pts : packet.dts;
}

bool is_empty(const AVFrame& frame) {
  return frame.buf[0] == nullptr;
}

}  // namespace

VideoReader::VideoReader(std::filesystem::path file, bool flip) : file_(std::move(file)), converter_(flip) {
  open();
  index();
  decode_to(times_.front());
  if (is_empty(*shown_)) fail(file_, "none of its pictures can be decoded");
  converter_.convert(*shown_);
}

void VideoReader::open() {
  input_ = open_input(file_);
  stream_ = av_find_best_stream(input_.get(), AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
  if (stream_ < 0 || (input_->streams[stream_]->disposition & AV_DISPOSITION_ATTACHED_PIC) != 0)
    fail(file_, "has no moving picture in it");
  const AVStream& stream = *input_->streams[stream_];
  decoder_ = open_decoder(stream, file_);
  unit_ = av_q2d(stream.time_base);
  converter_.set_stream(*input_, stream, file_);
  for (unsigned i = 0; i < input_->nb_streams; ++i)
    if (static_cast<int>(i) != stream_) input_->streams[i]->discard = AVDISCARD_ALL;
  av_frame_unref(shown_.get());
  av_frame_unref(ahead_.get());
  drained_ = false;
}

// What the file says about its length need not hold: only its packets tell.
void VideoReader::index() {
  const InputFormat whole = open_input(file_);
  double end = -INFINITY;  // seconds, of whatever stream
  while (av_read_frame(whole.get(), packet_.get()) >= 0) {
    const AVPacket& packet = *packet_;
    if ((packet.flags & AV_PKT_FLAG_CORRUPT) == 0 && time_of(packet) != none &&
        static_cast<unsigned>(packet.stream_index) < whole->nb_streams) {
      const double unit = av_q2d(whole->streams[packet.stream_index]->time_base);
      end = std::max(end, static_cast<double>(time_of(packet) + packet.duration) * unit);
      if (packet.stream_index == stream_) {
        if ((packet.flags & AV_PKT_FLAG_DISCARD) == 0) times_.push_back(time_of(packet));
        if ((packet.flags & AV_PKT_FLAG_KEY) != 0) keyframes_.push_back(time_of(packet));
        last_duration_ = packet.duration;
      }
    }
    av_packet_unref(packet_.get());
  }
  if (times_.empty()) fail(file_, "has no picture in it");
  std::sort(times_.begin(), times_.end());
  std::sort(keyframes_.begin(), keyframes_.end());
  const bool is_guess =
      whole->duration == none || whole->duration_estimation_method == AVFMT_DURATION_FROM_BITRATE;
  measure(end, is_guess ? 0.0 : static_cast<double>(whole->duration) / AV_TIME_BASE);
}

// `end`: of all streams; `stated`: duration by the file's own words, 0 for none.
void VideoReader::measure(double end, double stated) {
  const std::size_t n = times_.size();
  const std::int64_t step = n > 1 ? times_[n - 1] - times_[n - 2] : last_duration_;
  const double pictures =
      static_cast<double>(std::max<std::int64_t>(times_.back() + step - times_.front(), 1)) * unit_;
  duration_ = std::max(pictures, end - static_cast<double>(times_.front()) * unit_);
  // Sound comes in blocks, the last of which may hold less than it has room for.
  if (std::abs(stated - duration_) < forgiven)
    duration_ = std::abs(stated - pictures) < 0.001 ? pictures : stated;
  if (stated > duration_ + forgiven) {
    char text[96];
    std::snprintf(text, sizeof text, "ends after %.2f of its %.2f seconds, and is repeated from there",
                  duration_, stated);
    warning_ = file_.generic_string() + ": warning: " + text;
  }
}

void VideoReader::start_at(std::int64_t keyframe) {
  const bool moved = seekable_ && av_seek_frame(input_.get(), stream_, keyframe, AVSEEK_FLAG_BACKWARD) >= 0;
  if (!moved) return open();
  avcodec_flush_buffers(decoder_.get());
  av_frame_unref(shown_.get());
  av_frame_unref(ahead_.get());
  drained_ = false;
}

// The next picture goes into ahead_. False at the end of the file.
bool VideoReader::decode_next() {
  for (;;) {
    const int code = avcodec_receive_frame(decoder_.get(), ahead_.get());
    if (code >= 0) {
      ahead_->pts = ahead_->best_effort_timestamp;
      return true;
    }
    if (drained_ || (code != AVERROR(EAGAIN) && code != AVERROR_INVALIDDATA)) return false;
    if (av_read_frame(input_.get(), packet_.get()) < 0) {
      drained_ = true;
      avcodec_send_packet(decoder_.get(), nullptr);
      continue;
    }
    // A packet that can't be decoded leaves a gap, in which the picture before it stays.
    if (packet_->stream_index == stream_ && (packet_->flags & AV_PKT_FLAG_CORRUPT) == 0)
      avcodec_send_packet(decoder_.get(), packet_.get());
    av_packet_unref(packet_.get());
  }
}

// Makes shown_ the last picture that is not later than `wanted`, or the first one there is.
void VideoReader::decode_to(std::int64_t wanted) {
  while (is_empty(*shown_) || shown_->pts < wanted) {
    if (is_empty(*ahead_) && !decode_next()) return;
    if (!is_empty(*shown_) && ahead_->pts != none && ahead_->pts > wanted) return;
    av_frame_unref(shown_.get());
    av_frame_move_ref(shown_.get(), ahead_.get());
  }
}

bool VideoReader::show(double seconds) {
  position_ = std::fmod(seconds, duration_);
  if (position_ < 0.0) position_ += duration_;
  if (std::llround(position_ / unit_) >= std::llround(duration_ / unit_)) position_ = 0.0;
  // Rounded: where a container keeps milliseconds, 1/60 s is the time 17 of its second picture.
  const auto moment = times_.front() + std::llround(position_ / unit_);
  const std::int64_t wanted = *std::prev(std::upper_bound(times_.begin(), times_.end(), moment));
  const std::int64_t before = shown_->pts;
  if (before == wanted) return false;

  const auto after = std::upper_bound(keyframes_.begin(), keyframes_.end(), wanted);
  const std::int64_t keyframe = after == keyframes_.begin() ? times_.front() : *std::prev(after);
  const std::int64_t reached = is_empty(*ahead_) ? before : std::max(before, ahead_->pts);
  constexpr std::ptrdiff_t near = 8;  // pictures that are decoded sooner than a seek is done
  const auto place = [&](std::int64_t time) { return std::lower_bound(times_.begin(), times_.end(), time); };
  if (wanted < before || (keyframe > reached && place(wanted) - place(reached) > near)) {
    start_at(keyframe);
    decode_to(wanted);
    // A container whose seeks go astray is read from its start.
    if (is_empty(*shown_) || shown_->pts > wanted) {
      seekable_ = false;
      open();
      decode_to(wanted);
    }
  } else {
    decode_to(wanted);
  }
  if (is_empty(*shown_) || shown_->pts == before) return false;
  converter_.convert(*shown_);
  return true;
}

}  // namespace shadertwin::media
