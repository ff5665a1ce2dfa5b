// What a device runs a text as.
#pragma once

namespace shadertwin {

enum class ShaderStage {
  fragment,
  // A fragment pass as a compute shader, one invocation a pixel: data-centre GPUs run those many times
  // faster. gl_FragCoord is that of a full-screen triangle at z = 0 (z is 0.5, w is 1). Pixel =
  // gl_GlobalInvocationID.xy + the uniform ivec2 `shadertwin_origin`; those outside of iResolution return at
  // once. A colour that the shader does not write is (0, 0, 0, 0).
  compute,
  vertex,
};

}  // namespace shadertwin
