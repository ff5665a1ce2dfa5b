#include "reference/twin/twin_device.h"

#include <oneapi/tbb/blocked_range2d.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_pipeline.h>

#include <algorithm>
#include <deque>
#include <optional>

#include "host/base/error.h"
#include "host/player/device.h"
#include "host/project/kinds.h"
#include "host/text/pipeline.h"
#include "host/text/render.h"
#include "reference/emit/emit_cpp.h"
#include "reference/twin/channels.h"
#include "reference/twin/deadline.h"
#include "reference/twin/module.h"
#include "reference/twin/quad_runner.h"
#include "reference/twin/surface.h"

namespace shadertwin::twin {
namespace {

// What threads share out: squares of so many pixels, whole packets each.
constexpr int tile = 16;

class TwinDevice final : public Device {
 public:
  TwinDevice(const Project& project, const TwinOptions& options)
      : Device(with_twin_sources(project)), options_(options) {
    for (const Pass& pass : project.passes)
      if (pass.vertex.has_value())
        throw Error(ExitStatus::device,
                    pass.name + ": error: the twin draws no triangles of a vertex shader (#iVertex)");
    compile_missing();
    modules_.resize(project.passes.size());
    for (std::size_t i = 0; i < modules_.size(); ++i)
      if (traits(project.passes[i]).every_frame) modules_[i] = load(this->project().passes[i]);
    first_places_.assign(modules_.size() + 1, 0);
    for (std::size_t i = 0; i < modules_.size(); ++i)
      first_places_[i + 1] =
          first_places_[i] +
          (modules_[i] ? static_cast<std::uint32_t>(modules_[i]->description().place_count) : 0U);
  }

  void begin() override { deadline_.emplace(options_.timeout); }
  void end() override { deadline_.reset(); }

  TextureId make_texture(Texture texels, bool mipmaps) override {
    surfaces_.emplace_back(std::move(texels), mipmaps);
    return last_surface();
  }
  void upload(TextureId texture, const Texture& texels) override { surface(texture).upload(texels); }
  TextureId make_target(bool cube, bool mipmaps) override {
    surfaces_.emplace_back(cube ? 6 : 1, mipmaps, numbers());
    return last_surface();
  }
  void resize(TextureId target, glm::ivec2 size, bool keep) override { surface(target).resize(size, keep); }
  void clear(TextureId target) override { surface(target).clear(); }

  void draw(const DrawCall& call) override {
    const Pass& pass = project().passes[call.pass];
    // A sound is compiled when it is to be heard.
    if (!modules_[call.pass]) modules_[call.pass] = load(pass);
    Surface& target = surface(call.target);
    if (call.clear) target.clear();
    if (options_.observer != nullptr) options_.observer->begin(static_cast<int>(call.pass), call.index);
    Channels channels;
    for (std::size_t i = 0; i < call.channels.size(); ++i)
      channels.bind(i, surface(call.channels[i].texture), call.channels[i].sampler);
    if (options_.shadows != nullptr) begin_shadows(call, target);
    for (int face = 0; face < target.faces(); ++face) draw_face(call, channels, target, face);
    if (deadline_->passed())
      throw Error(ExitStatus::failed,
                  pass.name + ": error: the time that --timeout gives a frame has run out");
    target.finish_drawing();
    if (options_.shadows != nullptr) end_shadows(call, target);
  }

  Image read(TextureId target) override { return surface(target).read(); }
  void finish() override {}

  std::string description() const override {
    return std::string(options_.double_precision ? "cpu/double: " : "cpu: ") + compiler_.name();
  }

  std::vector<std::string> warnings() const override { return {}; }

 private:
  static Project with_twin_sources(Project project) {
    for (Pass& pass : project.passes) pass.source = twin_source(project, pass);
    return project;
  }

  CompileOptions compile_options(const Pass& pass) const {
    CompileOptions compile;
    compile.uninitialised = options_.uninitialised;
    compile.debug =
        options_.stop_at && &pass == &project().passes.at(static_cast<std::size_t>(options_.stop_at->pass));
    compile.double_precision = options_.double_precision;
    compile.packets = runs_packets();
    if (options_.observer != nullptr) compile.extra_arguments = {"-DSHADERTWIN_CHECK", "-O1"};
    if (options_.shadows != nullptr) compile.extra_arguments = {"-DSHADERTWIN_SHADOW"};
    return compile;
  }

  bool runs_packets() const {
    return options_.packets && !options_.double_precision && options_.observer == nullptr &&
           options_.shadows == nullptr && !options_.stop_at;
  }

  Numbers numbers() const {
    if (options_.shadows != nullptr) return Numbers::shadows;
    return options_.double_precision ? Numbers::doubles : Numbers::floats;
  }

  CppOptions emit_options() const {
    CppOptions emit;
    emit.double_precision = options_.double_precision;
    emit.loop_guards = options_.timeout > 0;
    emit.checks = options_.observer != nullptr;
    emit.shadows = options_.shadows != nullptr;
    // GCC 12's own flag for it misses components and later rounds of loops.
    emit.initialise_locals = options_.uninitialised == Uninitialised::zero;
    emit.packets = runs_packets();
    return emit;
  }

  // The cache is asked before the shader is parsed: the key is everything that the C++ follows from.
  std::filesystem::path object_path(const Pass& pass) const {
    const CompileOptions compile = compile_options(pass);
    std::string key = cache_key(project(), pass, emit_options());
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
    for (const Pass& pass : project().passes) {
      const std::filesystem::path object = object_path(pass);
      // Passes of the same text need one twin.
      const auto is_same = [&](const Job& job) { return job.object == object; };
      if (std::filesystem::exists(object) || std::any_of(jobs.begin(), jobs.end(), is_same)) continue;
      std::string text = emit_cpp(project(), pass, emit_options());
      // An error in a sound keeps shadertoy.com from playing the pictures; it is compiled when it is to be
      // heard.
      if (traits(pass).every_frame) jobs.push_back({object, std::move(text), compile_options(pass)});
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
      compiler_.compile(emit_cpp(project(), pass, emit_options()), object, compile_options(pass));
      return std::make_unique<Module>(object);
    }
  }

  static std::string cache_key(const Project& project, const Pass& pass, const CppOptions& emit) {
    std::string key = emit_identity() + std::string(emit.double_precision ? " double" : " float") +
                      (emit.loop_guards ? " guarded" : "") + (emit.checks ? " checked" : "") +
                      (emit.shadows ? " shadows" : "") + (emit.initialise_locals ? " zeroed" : "") +
                      (emit.packets ? " packets" : "");
    for (const std::string& file : project.files) key += '\n' + file;  // #line names them
    for (const SourceLine& line : pass.source.lines)
      key += '\n' + std::to_string(line.file) + ':' + std::to_string(line.line);
    return key + '\n' + shadertwin::render(pass.source);
  }

  Surface& surface(TextureId id) { return surfaces_[static_cast<std::size_t>(id)]; }
  TextureId last_surface() const { return static_cast<TextureId>(surfaces_.size() - 1); }

  void draw_face(const DrawCall& call, const Channels& channels, Surface& target, int face) {
    const Module& module = *modules_[call.pass];
    UniformList uniforms(call.uniforms, project().uniforms, call.custom_uniforms);
    uniforms.add("shadertwin_face", face);
    channels.add_to(uniforms);

    const glm::ivec2 size = target.size();
    Rectangle region{0, 0, size.x, size.y};
    if (options_.region && call.pass + 1 == modules_.size() &&
        traits(project().passes[call.pass]).every_frame)
      region = clipped(*options_.region, size);
    const auto row = static_cast<std::size_t>(size.x);
    const std::size_t first = row * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(face);
    Request whole;
    whole.uniforms = uniforms.data();
    whole.uniform_count = uniforms.size();
    whole.row_pitch = std::ptrdiff_t{4} * size.x;
    whole.quads = needs_quads(module, channels);
    whole.run_quad = QuadRunner::run;
    whole.stop = &deadline_->stop();
    whole.log = options_.observer != nullptr ? &log_ : nullptr;
    const auto draw_rectangle = [&](int x0, int y0, int x1, int y1) {
      Request request = whole;
      ShadowLog shadow_log = shadow_log_;
      if (options_.shadows != nullptr) {
        Notes& notes = notes_.local();
        notes.records.resize(static_cast<std::size_t>(module.description().place_count));
        notes.numbers.resize(notes.records.size());
        shadow_log.records = notes.records.data();
        shadow_log.numbers = notes.numbers.data();
        shadow_log.moved =
            moved_.data() + first + row * static_cast<std::size_t>(y0) + static_cast<std::size_t>(x0);
        request.shadow_log = &shadow_log;
      }
      request.x0 = x0;
      request.y0 = y0;
      request.x1 = x1;
      request.y1 = y1;
      request.pixels =
          target.pixels(first + row * static_cast<std::size_t>(y0) + static_cast<std::size_t>(x0));
      if (request.quads) {
        QuadRunner& runner = quad_runners_.local();
        runner.reserve(module.stack_bytes());
        request.quad_runner = &runner;
      }
      module.render(request);
    };
    if (options_.stop_at && static_cast<std::size_t>(options_.stop_at->pass) == call.pass) {
      const Breakpoint& stop = *options_.stop_at;
      if (stop.frame == call.index && face == 0 && !call.warm_up) {
        region = clipped({stop.x, stop.y, 1, 1}, size);
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

  void begin_shadows(const DrawCall& call, const Surface& target) {
    moved_.assign(target.shadows().size() / 4, 0.0F);
    const ShadowObserver::Wanted wanted = options_.shadows->begin(static_cast<int>(call.pass), call.index);
    shadow_log_ = {};
    shadow_log_.first_place = first_places_[call.pass];
    shadow_log_.frame = call.index;
    shadow_log_.threshold = wanted.threshold;
    shadow_log_.is_picture = wanted.is_picture;
    shadow_log_.user = options_.shadows;
    if (!wanted.steps) return;
    shadow_log_.wants_steps = [](void* user, int x, int y) {
      return static_cast<ShadowObserver*>(user)->wants_steps(x, y);
    };
    shadow_log_.step = [](void* user, int place, const ShadowNumber* operands, int count,
                          const ShadowNumber* result, double own) {
      static_cast<ShadowObserver*>(user)->step(place, operands, count, *result, own);
    };
  }

  void end_shadows(const DrawCall& call, const Surface& target) {
    const Description& description = modules_[call.pass]->description();
    const int pass = static_cast<int>(call.pass);
    for (const Notes& notes : notes_)
      options_.shadows->noted(pass, first_places_[call.pass],
                              {description.places, static_cast<std::size_t>(description.place_count)},
                              notes.records, notes.numbers);
    notes_.clear();
    options_.shadows->drawn(pass, call.index, {target.size().x, target.size().y * target.faces()},
                            target.shadows(), moved_);
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

  static bool needs_quads(const Module& module, const Channels& channels) {
    const Description& description = module.description();
    return description.uses_derivatives || (description.uses_implicit_lod && channels.need_lod());
  }

  static Rectangle clipped(const Rectangle& region, glm::ivec2 size) {
    const int x0 = std::clamp(region.x, 0, size.x);
    const int y0 = std::clamp(region.y, 0, size.y);
    return {x0, y0, std::clamp(region.x + region.width, x0, size.x) - x0,
            std::clamp(region.y + region.height, y0, size.y) - y0};
  }

  // What one thread notes while a pass is drawn, one of both for each place.
  struct Notes {
    std::vector<PlaceRecord> records;
    std::vector<NumberRecord> numbers;
  };

  TwinOptions options_;
  CheckLog log_ = make_log(options_.observer);
  Compiler compiler_;
  std::vector<std::unique_ptr<Module>> modules_;
  std::deque<Surface> surfaces_;
  std::optional<Deadline> deadline_;
  oneapi::tbb::enumerable_thread_specific<QuadRunner> quad_runners_;
  std::vector<std::uint32_t> first_places_;  // of each pass among the places of all, and their number
  ShadowLog shadow_log_;                     // of the pass that is drawn
  std::vector<float> moved_;                 // of its pixels
  oneapi::tbb::enumerable_thread_specific<Notes> notes_;
};

}  // namespace

std::unique_ptr<Player> make_player(const Project& project, const TwinOptions& options) {
  return std::make_unique<Player>(std::make_unique<TwinDevice>(project, options));
}

}  // namespace shadertwin::twin

void shadertwin_debug_stop() {
  // Keeps the compiler from dropping the calls.
  asm volatile("");
}
