#include "host/player/inputs.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>

#include "host/project/host_rules.h"

namespace shadertwin {

namespace {

// A texture of one channel: green and blue are 0, alpha is 1.
void keep_red(Texture& texture) {
  const std::size_t value = texture.texel_bytes() / 4;
  const float one = 1.0F;
  for (std::size_t i = 0; i < texture.data.size(); i += 4 * value) {
    std::fill_n(&texture.data[i + value], 2 * value, std::byte{0});
    if (value == 1)
      texture.data[i + 3] = std::byte{255};
    else
      std::memcpy(&texture.data[i + 3 * value], &one, sizeof one);
  }
}

glm::vec3 size_of(const Texture* texture) {
  return texture == nullptr ? glm::vec3(0.0F) : glm::vec3(texture->width, texture->height, texture->depth);
}

}  // namespace

Texture load_texture(const Input& input) {
  const SamplerShape shape = info(input.kind).shape;
  if (shape == SamplerShape::cube) {
    std::vector<std::filesystem::path> faces = input.files;
    // A cube that is turned over has its top at the bottom.
    if (input.sampler.vflip && faces.size() == 6) std::swap(faces[2], faces[3]);
    return read_cubemap(faces, input.sampler.vflip);
  }
  if (shape == SamplerShape::volume) return read_volume(input.files.front());
  Texture texture = read_texture(input.files.front(), input.sampler.vflip);
  if (input.red_only) keep_red(texture);
  return texture;
}

Input bound_input(const Pass& pass, std::size_t channel) {
  const Input& input = pass.inputs[channel];
  const InputKindInfo& kind = info(input.kind);
  const bool still = kind.source == InputSource::still;
  if (traits(pass).every_frame || (still && kind.shape != SamplerShape::cube)) return input;
  Input empty;
  empty.undrawn = input.undrawn;
  if (input.wanted() == InputKind::undrawn || info(input.wanted()).shape == SamplerShape::cube)
    empty.missing = input.wanted();
  return empty;
}

glm::ivec2 target_size(const PassTraits& kind, glm::ivec2 frame_size) {
  return kind.fills_frame() ? frame_size : glm::ivec2(kind.side);
}

glm::ivec2 picture_size(const PassTraits& kind, glm::ivec2 frame_size) {
  return target_size(kind, frame_size) * glm::ivec2(1, kind.faces);
}

glm::vec3 channel_size(const Project& project, const Input& input, const Texture* texture,
                       glm::ivec2 frame_size) {
  const HostRules rules = host_rules(project);
  const InputKindInfo& kind = info(input.wanted());
  switch (kind.source) {
    case InputSource::nothing:
      return glm::vec3(0.0F);
    case InputSource::moving:
      if (kind.is_audio) return rules.sound_has_size ? glm::vec3(512, 2, 1) : glm::vec3(0.0F);
      return size_of(texture);
    case InputSource::still:
      if (kind.shape != SamplerShape::cube) return size_of(texture);
      return rules.cubemap_has_size && input.kind != InputKind::none ? glm::vec3(0.0F, 0.0F, 1.0F)
                                                                     : glm::vec3(0.0F);
    case InputSource::pass:
    case InputSource::undrawn:
      if (input.kind == InputKind::none) return glm::vec3(0.0F);
      return {target_size(*pass_read(project, input), frame_size), 1};
    case InputSource::keyboard:
      return glm::vec3(256, rules.keyboard_rows, 1);
  }
  return glm::vec3(0.0F);
}

namespace {

// The passes in the order in which shadertoy.com loads them. A new shader has an Image there before other
// tabs.
std::vector<const Pass*> as_loaded(const Project& project) {
  std::vector<const Pass*> passes;
  for (const Pass& pass : project.passes) passes.push_back(&pass);
  std::stable_sort(passes.begin(), passes.end(), [](const Pass* a, const Pass* b) {
    return std::pair(a->tab, a->kind != PassKind::image) < std::pair(b->tab, b->kind != PassKind::image);
  });
  return passes;
}

}  // namespace

Project with_shared_samplers(Project project) {
  if (!host_rules(project).shared_samplers) return project;
  std::map<int, Wrap> wraps;  // by the pass that is read
  for (const Pass* pass : as_loaded(project))
    for (const Input& input : pass->inputs)
      if (input.kind == InputKind::pass) wraps[input.pass] = input.sampler.wrap;
  for (Pass& pass : project.passes) {
    std::map<int, Sampler> last;
    for (const Input& input : pass.inputs)
      if (input.kind == InputKind::pass) last[input.pass] = input.sampler;
    for (Input& input : pass.inputs) {
      if (input.kind != InputKind::pass) continue;
      input.sampler.min = last[input.pass].min;
      input.sampler.mag = last[input.pass].mag;
      input.sampler.wrap = wraps[input.pass];
    }
  }
  return project;
}

std::vector<bool> passes_with_history(const Project& project) {
  const HostRules rules = host_rules(project);
  const int count = static_cast<int>(project.passes.size());
  std::vector<bool> history(project.passes.size(), false);
  for (int reader = 0; reader < count; ++reader)
    for (const Input& input : project.passes[static_cast<std::size_t>(reader)].inputs)
      if (input.kind == InputKind::pass &&
          (input.pass == reader || (input.pass > reader && !rules.swaps_after_frame)))
        history[static_cast<std::size_t>(input.pass)] = true;
  if (rules.keeps_previous_pictures)
    for (std::size_t i = 0; i < history.size(); ++i)
      if (traits(project.passes[i]).is_read) history[i] = true;
  return history;
}

}  // namespace shadertwin
