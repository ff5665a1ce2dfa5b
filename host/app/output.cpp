#include "host/app/output.h"

#include <cstdio>
#include <regex>

#include "host/base/error.h"
#include "host/base/output_file.h"
#include "host/media/audio_writer.h"
#include "host/media/video_writer.h"

namespace shadertwin::app {

namespace {

class LastPicture final : public Output {
 public:
  explicit LastPicture(std::string name) : name_(std::move(name)) { const OutputFile probe(name_); }
  bool wants_every_frame() const override { return false; }
  void add(const Image& picture) override { write_image(picture, name_); }
  void finish() override {}

 private:
  std::string name_;
};

// frame_%04d.png: one place for the number, with the width and the zero of printf.
const std::regex& number_pattern() {
  static const std::regex pattern("%(0?)([0-9]?)d");
  return pattern;
}

class NumberedPictures final : public Output {
 public:
  explicit NumberedPictures(std::string pattern) : pattern_(std::move(pattern)) {
    const OutputFile probe(name(0));
  }
  bool wants_every_frame() const override { return true; }
  void add(const Image& picture) override { write_image(picture, name(frames_++)); }
  void finish() override {}

 private:
  std::string name(int frame) const {
    std::smatch match;
    std::regex_search(pattern_, match, number_pattern());
    std::string digits = std::to_string(frame);
    const std::size_t width = match[2].length() == 0 ? 0 : static_cast<std::size_t>(match[2].str()[0] - '0');
    if (digits.size() < width) digits.insert(0, width - digits.size(), match[1].length() == 0 ? ' ' : '0');
    return match.prefix().str() + digits + match.suffix().str();
  }

  std::string pattern_;
  int frames_ = 0;
};

class Video final : public Output {
 public:
  Video(const OutputOptions& options, const media::VideoSettings& settings)
      : writer_(media::VideoWriter::create(options.name, settings)) {
    if (!options.quiet)
      for (const std::string& warning : writer_->warnings()) std::fprintf(stderr, "%s\n", warning.c_str());
  }
  bool wants_every_frame() const override { return true; }
  void add(const Image& picture) override { writer_->add(picture); }
  bool wants_sound() const override { return writer_->has_sound(); }
  void add_sound(std::span<const float> samples) override { writer_->add_sound(samples); }
  void finish() override { writer_->finish(); }

 private:
  std::unique_ptr<media::VideoWriter> writer_;
};

}  // namespace

OutputKind output_kind(const std::string& name) {
  if (media::is_video(name)) return OutputKind::video;
  if (media::can_write_audio(name)) return OutputKind::sound;
  if (!can_write(name)) {
    std::vector<OutputFormat> all = image_formats();
    for (const auto& more : {media::video_formats(), media::audio_formats()})
      all.insert(all.end(), more.begin(), more.end());
    throw Error(ExitStatus::usage, name + ": the output must end in " + list_of(all));
  }
  const auto numbers = std::distance(std::sregex_iterator(name.begin(), name.end(), number_pattern()), {});
  if (numbers > 1) throw Error(ExitStatus::usage, name + ": only one %d can be numbered");
  return numbers == 1 ? OutputKind::pictures : OutputKind::picture;
}

std::string output_help() {
  return list_of(image_formats(), true) + " of the last frame, or with %04d in the name of every frame; " +
         list_of(media::video_formats(), true) + " of all frames; the Sound pass as " +
         list_of(media::audio_formats(), true);
}

std::unique_ptr<Output> open_output(const OutputOptions& options, glm::ivec2 size, double fps) {
  const std::string& name = options.name;
  const OutputKind kind = output_kind(name);
  if (kind == OutputKind::video)
    return std::make_unique<Video>(options,
                                   media::VideoSettings{.width = size.x,
                                                        .height = size.y,
                                                        .fps = fps,
                                                        .crf = options.crf,
                                                        .full_chroma = options.full_chroma,
                                                        .sample_rate = options.sound ? sound_rate : 0});
  if (kind == OutputKind::pictures) return std::make_unique<NumberedPictures>(name);
  return std::make_unique<LastPicture>(name);
}

}  // namespace shadertwin::app
