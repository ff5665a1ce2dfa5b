#include "host/view/stage.h"

#include <chrono>
#include <future>
#include <optional>
#include <utility>

#include "host/player/inputs.h"
#include "host/project/kinds.h"

namespace shadertwin::view {

namespace {

// A point in one context's work that another waits for on the GPU.
class Fence {
 public:
  ~Fence() { reset(); }
  Fence() = default;
  Fence(const Fence&) = delete;
  Fence& operator=(const Fence&) = delete;

  void set(const gl::Functions& gl) {
    reset();
    gl_ = &gl;
    sync_ = gl.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.Flush();
  }
  void wait(const gl::Functions& gl) {
    if (sync_ == nullptr) return;
    gl.WaitSync(sync_, 0, GL_TIMEOUT_IGNORED);
    reset();
  }

 private:
  void reset() {
    if (sync_ != nullptr) gl_->DeleteSync(std::exchange(sync_, nullptr));
  }

  const gl::Functions* gl_ = nullptr;
  GLsync sync_ = nullptr;
};

class SharedStage final : public Stage {
 public:
  SharedStage(Window& window, const Project& project, gl::PlayerOptions options)
      : window_(window), project_(project) {
    options.timers = true;
    auto device = std::make_unique<gl::GlDevice>(window.take_player_context(), project, options);
    device_ = device.get();
    player_.emplace(std::move(device));
    device_->context().release();  // made in one thread, played in another
  }
  ~SharedStage() override { device_->context().make_current(); }

  void draw(const Frame& frame) override {
    gl::Context& context = device_->context();
    context.make_current();
    seen_.wait(context.functions());
    milliseconds_ = player_->milliseconds();
    player_->render(frame);
    drawn_.set(context.functions());
    size_ = {frame.width, frame.height};
  }
  bool ready() override { return true; }
  void show(int) override {}
  ShownTexture picture(int pass) override {
    if (size_.x == 0) return {};
    drawn_.wait(window_.context().functions());
    const PassTraits& kind = traits(project_.passes[static_cast<std::size_t>(pass)]);
    if (!kind.every_frame) return {};
    return {static_cast<GLenum>(kind.faces == 6 ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D),
            device_->name(player_->texture(pass)), target_size(kind, size_)};
  }
  void shown() override { seen_.set(window_.context().functions()); }
  Image read(int pass) override { return player_->read(pass); }
  std::vector<double> milliseconds() override { return milliseconds_; }
  std::string description() const override { return player_->description(); }
  std::vector<std::string> warnings() const override { return player_->warnings(); }
  bool continue_from(Stage& earlier) override {
    auto* other = dynamic_cast<SharedStage*>(&earlier);
    if (other == nullptr) return false;
    player_->continue_from(*other->player_,
                           [&](TextureId from, TextureId to) { device_->copy(*other->device_, from, to); });
    return true;
  }

 private:
  Window& window_;
  Project project_;
  gl::GlDevice* device_ = nullptr;  // the player's
  std::optional<Player> player_;
  Fence drawn_;
  Fence seen_;
  glm::ivec2 size_{0};
  std::vector<double> milliseconds_;
};

class UploadingStage final : public Stage {
 public:
  UploadingStage(Window& window, const Project& project, const MakePlayer& make_player)
      : window_(window), player_(project, make_player, Window::wake) {}
  ~UploadingStage() override {
    if (texture_.name() != 0) window_.context().make_current();
  }

  void draw(const Frame& frame) override {
    drawn_ = true;
    pending_pass_ = pass_;
    const auto start = std::chrono::steady_clock::now();
    pending_ = player_.ask([this, frame, pass = pass_, start](Player& player) {
      player.render(frame);
      player.finish();
      frame_milliseconds_ =
          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
      return player.read(pass);
    });
  }
  bool ready() override {
    if (pending_.valid() && pending_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
      last_milliseconds_ = frame_milliseconds_;
      upload();
    }
    return !pending_.valid();
  }
  void show(int pass) override {
    if (pass == pass_) return;
    pass_ = pass;
    if (!drawn_ || !ready()) return;
    pending_pass_ = pass;
    pending_ = player_.ask([pass](Player& player) { return player.read(pass); });
  }
  ShownTexture picture(int pass) override {
    return pass == uploaded_pass_ ? ShownTexture{GL_TEXTURE_2D, texture_.name(), size_} : ShownTexture{};
  }
  Image read(int pass) override {
    if (pending_.valid()) upload();
    return player_.ask([pass](Player& player) { return player.read(pass); }).get();
  }
  std::vector<double> milliseconds() override { return {last_milliseconds_}; }
  std::string description() const override { return player_.description(); }

 private:
  void upload() {
    const Image image = pending_.get();
    uploaded_pass_ = pending_pass_;
    window_.context().make_current();
    const gl::Functions& gl = window_.context().functions();
    gl.ActiveTexture(GL_TEXTURE0);
    if (size_ != glm::ivec2(image.width, image.height)) {
      size_ = {image.width, image.height};
      texture_ = gl::TextureObject(gl);
      gl.BindTexture(GL_TEXTURE_2D, texture_.name());
      gl.TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, size_.x, size_.y);
    }
    gl.BindTexture(GL_TEXTURE_2D, texture_.name());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size_.x, size_.y, GL_RGBA, GL_FLOAT, image.rgba.data());
  }

  Window& window_;
  gl::TextureObject texture_;
  glm::ivec2 size_{0};
  int pass_ = 0;
  int pending_pass_ = 0;
  int uploaded_pass_ = -1;
  bool drawn_ = false;
  double frame_milliseconds_ = -1.0;  // written by the player's thread before its result is ready
  double last_milliseconds_ = -1.0;
  std::future<Image> pending_;
  PlayerThread player_;  // last: its thread writes to the members above
};

}  // namespace

std::unique_ptr<Stage> make_shared_stage(Window& window, const Project& project, gl::PlayerOptions options) {
  return std::make_unique<SharedStage>(window, project, options);
}

std::unique_ptr<Stage> make_uploading_stage(Window& window, const Project& project,
                                            const MakePlayer& make_player) {
  return std::make_unique<UploadingStage>(window, project, make_player);
}

}  // namespace shadertwin::view
