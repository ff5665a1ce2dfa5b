#include "reference/twin/twin_player.h"

#include <oneapi/tbb/blocked_range2d.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_pipeline.h>

#include <algorithm>
#include <chrono>

#include "host/base/error.h"
#include "host/player/inputs.h"
#include "host/player/ping_pong.h"
#include "host/player/uniforms.h"
#include "host/text/pipeline.h"
#include "host/text/render.h"
#include "reference/emit/emit_cpp.h"
#include "reference/twin/channels.h"
#include "reference/twin/deadline.h"
#include "reference/twin/module.h"
#include "reference/twin/quad_runner.h"

namespace shadertwin::twin {
namespace {

// What threads share out: squares of so many pixels, whole packets each.
constexpr int tile = 16;

// What a pass draws into: as many pictures as PingPong says.
struct Target {
  int width = 0;
  int height = 0;
  int faces = 1;
  std::vector<std::vector<double>> wide;  // of the double twin
  std::vector<Picture> pictures;
};

struct PassState {
  std::unique_ptr<Module> module;
  Channels channels;
  ChannelSizes sizes{};
  std::array<const MovingPictures::Moving*, max_channels> moving{};
  Target target;
};

class TwinPlayerImpl final : public TwinPlayer {
 public:
  TwinPlayerImpl(const Project& project, const TwinOptions& options)
      : project_(with_shared_samplers(project)), options_(options) {
    for (Pass& pass : project_.passes) pass.source = twin_source(project_, pass);
    passes_.resize(project_.passes.size());
    for (const Pass& pass : project_.passes)
      if (pass.vertex.has_value())
        throw Error(ExitStatus::device,
                    pass.name + ": error: the twin draws no triangles of a vertex shader (#iVertex)");
    compile_missing();
    for (std::size_t i = 0; i < passes_.size(); ++i) {
      if (project_.passes[i].kind == PassKind::sound) continue;
      passes_[i].module = load(project_.passes[i]);
      bind_inputs(i);
      passes_[i].target.faces = project_.passes[i].kind == PassKind::cubemap ? 6 : 1;
      passes_[i].target.pictures.resize(ping_pong_.targets(i));
      passes_[i].target.wide.resize(ping_pong_.targets(i));
    }
    for (const Pass& pass : project_.passes) {
      for (const Input& input : pass.inputs) {
        if (input.kind != InputKind::pass || !uses_mipmaps(input.sampler)) continue;
        for (Picture& picture : passes_[static_cast<std::size_t>(input.pass)].target.pictures)
          picture.want_mipmaps();
      }
    }
  }

  void render(const Frame& frame) override {
    const Deadline deadline(options_.timeout);
    const auto warm_up = ping_pong_.begin(frame);
    resize(frame.width, frame.height);
    tell_sizes();
    if (frame.index == 0) clear();
    keyboard_.update(frame);
    moving_.update(frame);
    if (warm_up) {
      draw_passes(*warm_up, deadline);
      ping_pong_.end_warm_up();
    }
    draw_passes(frame, deadline);
  }

  Image sound_block(int block, const glm::vec4& date) override {
    const int pass = find_sound(project_);
    if (pass < 0) throw Error(ExitStatus::usage, "the shader has no Sound pass (mainSound)");
    const auto index = static_cast<std::size_t>(pass);
    PassState& state = passes_[index];
    if (!state.module) {
      state.module = load(project_.passes[index]);
      bind_inputs(index);
      state.target.width = state.target.height = sound_block_side;
      state.target.pictures.resize(1);
      state.target.pictures[0].resize(sound_block_side, sound_block_side, 1, false);
      state.target.wide.assign(1, {});
      if (options_.double_precision) state.target.wide[0].assign(std::size_t{4} * sound_block_samples, 0.0);
    }
    const Deadline deadline(options_.timeout);
    Frame frame;
    frame.index = block;
    draw(index, uniforms_for_sound(block, date, state.sizes), frame, deadline);
    return read(pass);
  }

  Image read(int pass) override {
    const auto index = static_cast<std::size_t>(pass);
    const Target& target = passes_.at(index).target;
    Image image(target.width, target.height * target.faces);
    if (target.width != 0) target.pictures[ping_pong_.front(index)].copy_to(image.rgba.data());
    return image;
  }

  DoubleImage read_double(int pass) override {
    const auto index = static_cast<std::size_t>(pass);
    const Target& target = passes_.at(index).target;
    if (options_.double_precision)
      return {target.width, target.height * target.faces, target.wide[ping_pong_.front(index)]};
    const Image image = read(pass);
    return {image.width, image.height, {image.rgba.begin(), image.rgba.end()}};
  }

  void finish() override {}

  std::string description() const override {
    return std::string(options_.double_precision ? "cpu/double: " : "cpu: ") + compiler_.name();
  }

  std::vector<std::string> warnings() const override { return moving_.warnings(); }

 private:
  CompileOptions compile_options(const Pass& pass) const {
    CompileOptions compile;
    compile.uninitialised = options_.uninitialised;
    compile.debug =
        options_.stop_at && &pass == &project_.passes.at(static_cast<std::size_t>(options_.stop_at->pass));
    compile.double_precision = options_.double_precision;
    compile.packets = runs_packets();
    if (options_.observer != nullptr) compile.extra_arguments = {"-DSHADERTWIN_CHECK", "-O1"};
    return compile;
  }

  bool runs_packets() const {
    return options_.packets && !options_.double_precision && options_.observer == nullptr &&
           !options_.stop_at;
  }

  CppOptions emit_options() const {
    CppOptions emit;
    emit.double_precision = options_.double_precision;
    emit.loop_guards = options_.timeout > 0;
    emit.checks = options_.observer != nullptr;
    // GCC 12's own flag for it misses components and later rounds of loops.
    emit.initialise_locals = options_.uninitialised == Uninitialised::zero;
    emit.packets = runs_packets();
    return emit;
  }

  // The cache is asked before the shader is parsed: the key is everything that the C++ follows from.
  std::filesystem::path object_path(const Pass& pass) const {
    const CompileOptions compile = compile_options(pass);
    std::string key = cache_key(project_, pass, emit_options());
    // Debuggers look for the shader's files from the folder that the compiler ran in.
    if (compile.debug) key += '\n' + std::filesystem::current_path().string();
    return compiler_.object_path(key, compile);
  }

  // Compiles the passes that the cache does not hold side by side, the longest first. In front of them comes
  // what later passes and later shaders gain from: a cold cache would otherwise wait for it.
  void compile_missing() {
    struct Job {
      std::filesystem::path object;  // empty: no twin, but what all twins include
      std::string source;
      CompileOptions options;
    };
    std::vector<Job> jobs;
    for (const Pass& pass : project_.passes) {
      const std::filesystem::path object = object_path(pass);
      // Passes of the same text need one twin.
      const auto is_same = [&](const Job& job) { return job.object == object; };
      if (std::filesystem::exists(object) || std::any_of(jobs.begin(), jobs.end(), is_same)) continue;
      std::string text = emit_cpp(project_, pass, emit_options());
      // An error in a sound keeps shadertoy.com from playing the pictures; it is compiled when it is to be
      // heard.
      if (pass.kind != PassKind::sound) jobs.push_back({object, std::move(text), compile_options(pass)});
    }
    if (jobs.empty()) return;
    std::sort(jobs.begin(), jobs.end(),
              [](const Job& a, const Job& b) { return a.source.size() > b.source.size(); });
    jobs.insert(jobs.begin(), Job{{}, {}, jobs.front().options});
    const auto run = [&](std::size_t i) {
      if (jobs[i].object.empty())
        compiler_.prepare(jobs[i].options);
      else
        compiler_.compile(jobs[i].source, jobs[i].object, jobs[i].options);
    };
    // Unlike parallel_for_each a pipeline begins its items in order.
    std::size_t begun = 0;
    const auto take = [&](oneapi::tbb::flow_control& control) {
      if (begun == jobs.size()) control.stop();
      return begun++;
    };
    using oneapi::tbb::filter_mode;
    oneapi::tbb::parallel_pipeline(
        jobs.size(), oneapi::tbb::make_filter<void, std::size_t>(filter_mode::serial_in_order, take) &
                         oneapi::tbb::make_filter<std::size_t, void>(filter_mode::parallel, run));
  }

  std::unique_ptr<Module> load(const Pass& pass) const {
    const std::filesystem::path object = object_path(pass);
    try {
      return std::make_unique<Module>(object);
    } catch (const Error&) {  // damaged
      compiler_.compile(emit_cpp(project_, pass, emit_options()), object, compile_options(pass));
      return std::make_unique<Module>(object);
    }
  }

  static std::string cache_key(const Project& project, const Pass& pass, const CppOptions& emit) {
    std::string key = emit_identity() + std::string(emit.double_precision ? " double" : " float") +
                      (emit.loop_guards ? " guarded" : "") + (emit.checks ? " checked" : "") +
                      (emit.initialise_locals ? " zeroed" : "") + (emit.packets ? " packets" : "");
    for (const std::string& file : project.files) key += '\n' + file;  // #line names them
    for (const SourceLine& line : pass.source.lines)
      key += '\n' + std::to_string(line.file) + ':' + std::to_string(line.line);
    return key + '\n' + shadertwin::render(pass.source);
  }

  void bind_inputs(std::size_t index) {
    PassState& state = passes_[index];
    const Pass& pass = project_.passes[index];
    for (std::size_t i = 0; i < max_channels; ++i) {
      const Input input = bound_input(pass, i);
      if (input.kind == InputKind::texture || input.kind == InputKind::cubemap ||
          input.kind == InputKind::volume) {
        const Picture& picture = pictures_.load(input);
        state.channels.bind(i, picture, input.sampler);
        state.sizes[i] = channel_size(project_, input, &picture.texture(), {0, 0});
      } else if (input.kind == InputKind::keyboard) {
        state.sizes[i] = channel_size(project_, input, nullptr, {0, 0});
      } else if (input.missing == InputKind::pass ||
                 (input.wanted() == InputKind::none && project_.vscode_quirks)) {
        state.channels.bind(i, missing_pass_, input.sampler);
      } else if (input.kind != InputKind::pass) {
        state.moving[i] = moving_.load(input);
        if (state.moving[i] != nullptr)
          state.sizes[i] = channel_size(project_, input, &state.moving[i]->input->texture(), {0, 0});
      }
    }
  }

  // As GlPlayer's: buffers of shadertoy.com keep the lower left, and their first picture is the last one.
  void resize(int width, int height) {
    if (width == width_ && height == height_) return;
    for (std::size_t i = 0; i < passes_.size(); ++i) {
      if (project_.passes[i].kind == PassKind::sound) continue;
      Target& target = passes_[i].target;
      const bool cube = target.faces == 6;
      const int new_width = cube ? cubemap_pass_size : width;
      const int new_height = cube ? cubemap_pass_size : height;
      if (target.width == new_width && target.height == new_height) continue;
      const bool keeps =
          project_.dialect == Dialect::shadertoy && project_.passes[i].kind == PassKind::buffer;
      for (Picture& picture : target.pictures) picture.resize(new_width, new_height, target.faces, keeps);
      if (options_.double_precision) resize_wide(target, new_width, new_height, keeps);
      if (keeps) ping_pong_.set_front(i, 0);
      target.width = new_width;
      target.height = new_height;
    }
    width_ = width;
    height_ = height;
  }

  void tell_sizes() {
    for (std::size_t i = 0; i < passes_.size(); ++i) {
      for (std::size_t c = 0; c < max_channels; ++c) {
        const Input input = bound_input(project_.passes[i], c);
        if (input.kind == InputKind::pass)
          passes_[i].sizes[c] = channel_size(project_, input, nullptr, ping_pong_.reported_size());
      }
    }
  }

  static void resize_wide(Target& target, int width, int height, bool keeps) {
    const std::size_t row = std::size_t{4} * std::min(width, target.width);
    for (std::vector<double>& wide : target.wide) {
      std::vector<double> fresh(std::size_t{4} * width * height * target.faces, 0.0);
      for (int y = 0; keeps && y < std::min(height, target.height); ++y)
        std::copy_n(wide.begin() + std::ptrdiff_t{4} * target.width * y, row,
                    fresh.begin() + std::ptrdiff_t{4} * width * y);
      wide = std::move(fresh);
    }
  }

  void clear() {
    for (PassState& state : passes_) {
      for (Picture& picture : state.target.pictures) picture.clear();
      for (std::vector<double>& wide : state.target.wide) std::fill(wide.begin(), wide.end(), 0.0);
    }
  }

  void draw_passes(const Frame& frame, const Deadline& deadline) {
    for (std::size_t i = 0; i < passes_.size(); ++i)
      if (project_.passes[i].kind != PassKind::sound) draw(i, frame, deadline);
  }

  // What moves, or was drawn before, comes to its channels.
  void draw(std::size_t index, const Frame& frame, const Deadline& deadline) {
    PassState& state = passes_[index];
    const Pass& pass = project_.passes[index];
    for (std::size_t i = 0; i < max_channels; ++i) {
      if (pass.inputs[i].kind == InputKind::keyboard) state.channels.bind_keyboard(i, keyboard_.picture());
      if (pass.inputs[i].kind != InputKind::pass) continue;
      const auto source = static_cast<std::size_t>(pass.inputs[i].pass);
      state.channels.bind(i, passes_[source].target.pictures[ping_pong_.read_by(index, source)],
                          pass.inputs[i].sampler);
    }
    ChannelTimes times{};
    for (std::size_t i = 0; i < max_channels; ++i) {
      if (state.moving[i] == nullptr) continue;
      state.channels.bind(i, state.moving[i]->picture, pass.inputs[i].sampler);
      if (i < times.size()) times[i] = static_cast<float>(state.moving[i]->input->time());
    }
    state.channels.bind_keyboard(Channels::keyboard, keyboard_.picture());

    draw(index,
         uniforms_for(project_, pass, frame, {state.target.width, state.target.height}, state.sizes, times),
         frame, deadline);
  }

  void draw(std::size_t index, const Uniforms& values, const Frame& frame, const Deadline& deadline) {
    const Pass& pass = project_.passes[index];
    Target& target = passes_[index].target;
    const std::size_t back = ping_pong_.back(index);
    Picture& picture = target.pictures[back];
    // The extension clears every target before it draws, which shows where a shader discards.
    if (project_.dialect == Dialect::vscode) {
      picture.clear();
      std::fill(target.wide[back].begin(), target.wide[back].end(), 0.0);
    }
    if (options_.observer != nullptr) options_.observer->begin(static_cast<int>(index), frame.index);
    for (int face = 0; face < target.faces; ++face) draw_face(index, values, frame, face, deadline);
    if (deadline.passed())
      throw Error(ExitStatus::failed,
                  pass.name + ": error: the time that --timeout gives a frame has run out");
    if (options_.double_precision) picture.round_from(target.wide[back]);
    picture.finish_drawing();
    ping_pong_.drawn(index);
  }

  void draw_face(std::size_t index, const Uniforms& values, const Frame& frame, int face,
                 const Deadline& deadline) {
    PassState& state = passes_[index];
    Target& target = state.target;
    UniformList uniforms(values, project_.uniforms, frame.uniforms);
    uniforms.add("shadertwin_face", face);
    state.channels.add_to(uniforms);

    Rectangle region{0, 0, target.width, target.height};
    if (options_.region && index + 1 == passes_.size() && project_.passes[index].kind != PassKind::sound)
      region = clipped(*options_.region, target);
    const std::size_t first = std::size_t{4} * target.width * target.height * static_cast<std::size_t>(face);
    const std::size_t back = ping_pong_.back(index);
    Request whole;
    whole.uniforms = uniforms.data();
    whole.uniform_count = uniforms.size();
    whole.row_pitch = std::ptrdiff_t{4} * target.width;
    whole.quads = needs_quads(state);
    whole.run_quad = QuadRunner::run;
    whole.stop = &deadline.stop();
    whole.log = options_.observer != nullptr ? &log_ : nullptr;
    const auto draw_rectangle = [&](int x0, int y0, int x1, int y1) {
      Request request = whole;
      request.x0 = x0;
      request.y0 = y0;
      request.x1 = x1;
      request.y1 = y1;
      const std::size_t at = first + std::size_t{4} * (static_cast<std::size_t>(y0) * target.width + x0);
      if (options_.double_precision)
        request.pixels = target.wide[back].data() + at;
      else
        request.pixels = target.pictures[back].values() + at;
      if (request.quads) request.quad_runner = &quad_runners_.local();
      state.module->render(request);
    };
    if (options_.stop_at && static_cast<std::size_t>(options_.stop_at->pass) == index) {
      const Moment& stop = *options_.stop_at;
      if (stop.frame == frame.index && face == 0 && !ping_pong_.warming_up()) {
        region = clipped({stop.x, stop.y, 1, 1}, target);
        shadertwin_debug_stop();
      }
      return draw_rectangle(region.x, region.y, region.x + region.width, region.y + region.height);
    }
    const int x_end = region.x + region.width;
    const int y_end = region.y + region.height;
    const auto tiles_to = [](int end) { return (end + tile - 1) / tile; };
    const oneapi::tbb::blocked_range2d<int> tiles(region.y / tile, tiles_to(y_end), region.x / tile,
                                                  tiles_to(x_end));
    oneapi::tbb::parallel_for(tiles, [&](const oneapi::tbb::blocked_range2d<int>& part) {
      draw_rectangle(std::max(part.cols().begin() * tile, region.x),
                     std::max(part.rows().begin() * tile, region.y),
                     std::min(part.cols().end() * tile, x_end), std::min(part.rows().end() * tile, y_end));
    });
  }

  static CheckLog make_log(Observer* observer) {
    CheckLog log;
    log.user = observer;
    log.found = [](void* user, int kind, CheckPlace place, int x, int y) {
      static_cast<Observer*>(user)->found(kind, {place.file, place.line}, x, y);
    };
    log.wants_values = [](void* user, int x, int y) {
      return static_cast<Observer*>(user)->wants_values(x, y);
    };
    log.value = [](void* user, int x, int y, CheckPlace place, const void* bytes, std::size_t size) {
      static_cast<Observer*>(user)->value(x, y, {place.file, place.line}, bytes, size);
    };
    return log;
  }

  static bool needs_quads(const PassState& state) {
    const Description& description = state.module->description();
    return description.uses_derivatives || (description.uses_implicit_lod && state.channels.need_lod());
  }

  static Rectangle clipped(const Rectangle& region, const Target& target) {
    const int x0 = std::clamp(region.x, 0, target.width);
    const int y0 = std::clamp(region.y, 0, target.height);
    return {x0, y0, std::clamp(region.x + region.width, x0, target.width) - x0,
            std::clamp(region.y + region.height, y0, target.height) - y0};
  }

  Project project_;
  TwinOptions options_;
  CheckLog log_ = make_log(options_.observer);
  Compiler compiler_;
  PictureLibrary pictures_;
  MovingPictures moving_{project_};
  Keyboard keyboard_{project_.dialect};
  // What a buffer that is not there reads as: one that was never drawn.
  const Picture missing_pass_{Texture{.width = 1, .height = 1, .data = std::vector<std::byte>(4)}, false};
  std::vector<PassState> passes_;
  PingPong ping_pong_{project_};
  oneapi::tbb::enumerable_thread_specific<QuadRunner> quad_runners_;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace

std::unique_ptr<TwinPlayer> TwinPlayer::create(const Project& project, const TwinOptions& options) {
  return std::make_unique<TwinPlayerImpl>(project, options);
}

}  // namespace shadertwin::twin

void shadertwin_debug_stop() {
  // Keeps the compiler from dropping the calls.
  asm volatile("");
}
