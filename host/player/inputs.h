// What is bound to the channels of a pass: the files, and what the uniforms say of them.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "host/image/image.h"
#include "host/project/kinds.h"

namespace shadertwin {

// Reads the file or files of a texture or cubemap input. Throws Error(file).
Texture load_texture(const Input& input);

// What the pass has on a channel: `input`, but a sound has files only, so that it does not change with the
// frames. On shadertoy.com cubemaps are not bound to it either. The sampler's type stays.
Input bound_input(const Pass& pass, std::size_t channel);

// The project with the samplers that its passes are really read with. On shadertoy.com a buffer has one
// texture object: the last input of all that reads it, in the order of the tabs, sets how it wraps, the last
// channel of a pass how that pass filters it. The extension's inputs keep their own.
Project with_shared_samplers(Project project);

// iChannelResolution of an input. `texture`: what load_texture gave for a file input, else null.
// `frame_size`: of the pictures that buffers hold.
glm::vec3 channel_size(const Project& project, const Input& input, const Texture* texture,
                       glm::ivec2 frame_size);

// Width and height of what a pass of that kind fills, of each face, in a frame of that size.
glm::ivec2 target_size(const PassTraits& kind, glm::ivec2 frame_size);
// Those of its picture as Player::read() gives it: faces stand one above the other.
glm::ivec2 picture_size(const PassTraits& kind, glm::ivec2 frame_size);

// One flag for every pass: whether its previous picture is still needed while, or after, it draws a new one.
// True for passes that read themselves or, but for the extension with its quirks, are read by an earlier one.
// On shadertoy.com every buffer is kept twice, which shows when a shader discards: the old contents are then
// those of two frames ago.
std::vector<bool> passes_with_history(const Project& project);

}  // namespace shadertwin
