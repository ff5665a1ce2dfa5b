#include "host/player/video_input.h"

#include "host/media/video_reader.h"
#include "host/media/webcam.h"

namespace shadertwin {

namespace {

class VideoInput final : public MovingInput {
 public:
  VideoInput(const std::filesystem::path& file, bool flip) : reader_(file, flip) {}

  bool update(const Frame& frame) override { return reader_.show(frame.time); }
  const Texture& texture() const override { return reader_.picture(); }
  double time() const override { return reader_.position(); }
  const std::string& warning() const { return reader_.warning(); }

 private:
  media::VideoReader reader_;
};

class WebcamInput final : public MovingInput {
 public:
  explicit WebcamInput(std::unique_ptr<media::Webcam> webcam) : webcam_(std::move(webcam)) {}

  bool update(const Frame&) override { return webcam_->update(); }
  const Texture& texture() const override { return webcam_->picture(); }
  double time() const override { return 0.0; }

 private:
  std::unique_ptr<media::Webcam> webcam_;
};

}  // namespace

std::unique_ptr<MovingInput> open_video_input(const Input& input, std::vector<std::string>& warnings) {
  if (input.files.empty()) return nullptr;
  auto video = std::make_unique<VideoInput>(input.files.front(), input.sampler.vflip);
  if (!video->warning().empty()) warnings.push_back(video->warning());
  return video;
}

std::unique_ptr<MovingInput> open_webcam_input(const Input& input, std::vector<std::string>& warnings) {
  std::string problem;
  std::unique_ptr<media::Webcam> webcam = media::Webcam::open(input.sampler.vflip, problem);
  if (webcam) return std::make_unique<WebcamInput>(std::move(webcam));
  warnings.push_back("webcam: warning: " + problem + ": the channel stays black");
  return nullptr;
}

}  // namespace shadertwin
