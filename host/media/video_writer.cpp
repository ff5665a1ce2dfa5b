#include "host/media/video_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "host/base/error.h"
#include "host/base/output_file.h"
#include "host/media/muxer.h"
#include "host/media/palette.h"
#include "host/media/picture_converter.h"
#include "host/media/sound_encoder.h"

extern "C" {
#include <libavutil/opt.h>
}

namespace shadertwin::media {

namespace fs = std::filesystem;

namespace {

struct VideoFormat : OutputFormat {
  std::string_view codec;  // for people
  std::array<const char*, 2> encoders;
  const char* sound_encoder;  // null: there is no sound in it
  int crf;                    // by default; below 0: there is none, and no choice of chroma
  int worst_crf;
  int largest_side;
  double highest_rate;
  bool has_palette;    // and times in hundredths of a second, as GIF
  bool is_mp4;         // the container
  bool halves_chroma;  // without full_chroma the sides have to be even
};

constexpr std::array<VideoFormat, 3> formats = {{
    {{".mp4", "H.264"}, "H.264", {"libx264", "mpeg4"}, "aac", 18, 51, 16384, 1000.0, false, true, true},
    // VP9 has a size for itself; H.264 can only cut off whole pairs of pixels.
    {{".webm", "VP9"}, "VP9", {"libvpx-vp9", nullptr}, "libopus", 24, 63, 16384, 1000.0, false, false, false},
    {{".gif", "at most 50 frames a second"},
     "GIF",
     {"gif", nullptr},
     nullptr,
     -1,
     -1,
     65535,
     50.0,
     true,
     false,
     false},
}};

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw Error(ExitStatus::usage, file.string() + ": " + why);
}

const VideoFormat& check(const fs::path& file, const VideoSettings& s) {
  const VideoFormat* const format = find_format(formats, file);
  if (format == nullptr) refuse(file, "videos are written as " + list_of(video_formats()));
  if (s.width < 1 || s.height < 1 || std::max(s.width, s.height) > format->largest_side)
    refuse(file, std::string(format->codec) + " has at most " + std::to_string(format->largest_side) +
                     " pixels to a side");
  if (!(s.fps > 0.0) || s.fps > format->highest_rate) {
    refuse(file, "a video in " + std::string(format->codec) + " plays at most " +
                     std::to_string(static_cast<int>(format->highest_rate)) +
                     " frames a second: choose another --fps");
  }
  if (s.fps < 0.01) refuse(file, "a frame lasts at most 100 seconds in a video: choose another --fps");
  if (format->crf < 0 && (s.crf >= 0 || s.full_chroma))
    refuse(file, "--crf and --chroma are not for " + std::string(format->extension));
  if (s.crf > format->worst_crf)
    refuse(file, "--crf goes from 0 (lossless) to " + std::to_string(format->worst_crf) + " for " +
                     std::string(format->codec));
  if (format->halves_chroma && !s.full_chroma && (s.width % 2 != 0 || s.height % 2 != 0))
    refuse(file, std::string(format->codec) + " needs an even width and height, not " +
                     std::to_string(s.width) + "x" + std::to_string(s.height) +
                     ": choose another --size, --chroma 444 or .webm");
  return *format;
}

const AVCodec& find_encoder(const fs::path& file, const VideoFormat& format,
                            const std::vector<std::string>& wanted, std::vector<std::string>& warnings) {
  std::vector<std::string> names = wanted;
  if (names.empty())
    for (const char* name : format.encoders)
      if (name != nullptr) names.emplace_back(name);
  for (const std::string& name : names)
    if (const AVCodec* const codec = avcodec_find_encoder_by_name(name.c_str()); codec != nullptr) {
      if (name != names.front())
        warnings.push_back(file.string() + ": warning: libav has no encoder " + names.front() + " here, " +
                           name + " stands in for it");
      return *codec;
    }
  throw Error(ExitStatus::device, file.string() + ": libav has no encoder " + names.front() + " for " +
                                      std::string(format.codec) + " on this machine");
}

void set_option(AVCodecContext& codec, const char* name, const std::string& value) {
  // Only encoders that know the option are asked for it.
  av_opt_set(codec.priv_data, name, value.c_str(), 0);
}

class VideoWriterImpl final : public VideoWriter {
 public:
  VideoWriterImpl(const fs::path& file, const VideoSettings& settings)
      : format_(check(file, settings)),
        settings_(settings),
        target_(file),
        muxer_(target_.path(), file.string()),
        rate_(av_d2q(settings.fps, 1'000'000)) {
    const AVCodec& codec = find_encoder(file, format_, settings.encoders, warnings_);
    encoder_.emplace(muxer_, codec, [&](AVCodecContext& context) { configure(context); });
    encoder_->stream().avg_frame_rate = rate_;
    encoder_->stream().r_frame_rate = rate_;
    if (format_.has_palette)
      palette_.emplace(settings.width, settings.height);
    else
      converter_.emplace(encoder_->context());
    if (settings.sample_rate > 0 && format_.sound_encoder != nullptr) {
      const AVCodec& sound = find_encoder(file, format_, {format_.sound_encoder}, warnings_);
      sound_.emplace(muxer_, sound, settings.sample_rate);
    }
    if (format_.is_mp4) configure_mp4(muxer_.context());
    muxer_.begin();
  }

  void add(const Image& picture) override {
    const AVFrame& frame = format_.has_palette ? palette_->convert(picture) : converter_->convert(picture);
    FramePointer numbered(av_frame_clone(&frame));
    if (!numbered) throw std::bad_alloc();
    numbered->pts = time_of(frames_);
    numbered->pict_type = AV_PICTURE_TYPE_NONE;
    ++frames_;
    encoder_->encode(numbered.get(), frame_ticks_);
  }

  void add_sound(std::span<const float> samples) override {
    if (sound_) sound_->add(samples);
  }

  bool has_sound() const override { return sound_.has_value(); }

  void finish() override {
    encoder_->encode(nullptr, frame_ticks_);
    if (sound_) sound_->finish();
    if (format_.has_palette)
      av_opt_set_int(muxer_.context().priv_data, "final_delay", time_of(frames_) - time_of(frames_ - 1), 0);
    muxer_.end();
    target_.commit();
  }

  const std::vector<std::string>& warnings() const override { return warnings_; }

 private:
  // Of the frame's start, in the encoder's time base.
  std::int64_t time_of(std::int64_t frame) const {
    if (format_.has_palette) return av_rescale_q_rnd(frame, av_inv_q(rate_), {1, 100}, AV_ROUND_NEAR_INF);
    return frame * frame_ticks_;
  }

  void configure(AVCodecContext& c) {
    c.width = settings_.width;
    c.height = settings_.height;
    c.framerate = rate_;
    c.sample_aspect_ratio = {1, 1};
    if (format_.has_palette) {
      c.pix_fmt = AV_PIX_FMT_PAL8;
      c.time_base = {1, 100};
      return;
    }
    const std::string name = c.codec->name;
    // libvpx takes no time base above a second.
    frame_ticks_ = name == "libvpx-vp9" ? (rate_.den + rate_.num - 1) / rate_.num : 1;
    c.time_base = av_div_q(av_inv_q(rate_), {static_cast<int>(frame_ticks_), 1});
    c.pix_fmt = settings_.full_chroma ? AV_PIX_FMT_YUV444P : AV_PIX_FMT_YUV420P;
    c.color_range = AVCOL_RANGE_MPEG;
    c.colorspace = AVCOL_SPC_BT709;
    c.color_primaries = AVCOL_PRI_BT709;
    c.color_trc = AVCOL_TRC_BT709;
    c.chroma_sample_location = settings_.full_chroma ? AVCHROMA_LOC_UNSPECIFIED : AVCHROMA_LOC_LEFT;
    c.thread_count = 0;  // as many as there are cores
    const int crf = settings_.crf < 0 ? format_.crf : settings_.crf;
    set_option(c, "crf", std::to_string(crf));
    if (name == "libvpx-vp9") {
      c.bit_rate = 0;  // else crf is only a limit
      set_option(c, "deadline", "good");
      set_option(c, "cpu-used", "3");
      set_option(c, "row-mt", "1");
      if (crf == 0) set_option(c, "lossless", "1");
    } else if (name != "libx264") {
      c.flags |= AV_CODEC_FLAG_QSCALE;
      c.global_quality = FF_QP2LAMBDA * std::max(1, crf / 6);
    }
  }

  void configure_mp4(AVFormatContext& context) const {
    // The index at the front: a browser can start before it has the whole file.
    av_opt_set(context.priv_data, "movflags", "+faststart", 0);
    // The tracks' ends are stated in this unit, by default milliseconds: one in which frames and samples are
    // whole.
    std::int64_t unit =
        std::lcm(std::int64_t{rate_.num}, sound_ ? std::int64_t{settings_.sample_rate} : 1000);
    if (unit <= std::numeric_limits<std::int32_t>::max())
      av_opt_set_int(context.priv_data, "movie_timescale", unit, 0);
  }

  const VideoFormat& format_;
  VideoSettings settings_;
  std::vector<std::string> warnings_;
  OutputFile target_;
  Muxer muxer_;
  AVRational rate_;
  std::int64_t frame_ticks_ = 0;
  std::int64_t frames_ = 0;
  std::optional<Encoder> encoder_;
  std::optional<PictureConverter> converter_;
  std::optional<Palette> palette_;
  std::optional<SoundEncoder> sound_;
};

}  // namespace

std::vector<OutputFormat> video_formats() {
  return output_formats(formats);
}

std::string crf_help() {
  std::string text;
  for (const VideoFormat& format : formats)
    if (format.crf >= 0)
      text += (text.empty() ? "" : ", ") + std::string(format.extension) + " from 0 (lossless) to " +
              std::to_string(format.worst_crf) + " (worst), else " + std::to_string(format.crf);
  return text;
}

bool is_video(const fs::path& file) {
  return find_format(formats, file) != nullptr;
}

double highest_rate(const fs::path& file) {
  const VideoFormat* const format = find_format(formats, file);
  return format == nullptr ? 0.0 : format->highest_rate;
}

std::unique_ptr<VideoWriter> VideoWriter::create(const fs::path& file, const VideoSettings& settings) {
  return std::make_unique<VideoWriterImpl>(file, settings);
}

}  // namespace shadertwin::media
