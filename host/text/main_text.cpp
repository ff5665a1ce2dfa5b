#include "host/text/main_text.h"

namespace shadertwin {

namespace {

constexpr const char* out = "shadertoy_out_color = ";

std::string shown(const std::string& color, bool opaque) {
  return out + (opaque ? "vec4(" + color + ".rgb, 1.0)" : color) + "; }\n";
}

}  // namespace

MainText image_main(bool opaque, bool asserts, bool inout) {
  const std::string check =
      asserts ? "if (shadertwin_failed >= 0) shadertoy_color.rgb = vec3(shadertwin_failed == 0 || "
                "shadertwin_failed == "
                "3, shadertwin_failed == 1 || shadertwin_failed == 3, shadertwin_failed == 2); "
              : "";
  return {inout ? "void mainImage(inout vec4, in vec2);\n" : "void mainImage(out vec4, in vec2);\n",
          "void main() { vec4 shadertoy_color = vec4(0.0); mainImage(shadertoy_color, gl_FragCoord.xy); " +
              check + shown("shadertoy_color", opaque)};
}

MainText vr_main(bool opaque) {
  return {"void mainVR(out vec4, in vec2, in vec3, in vec3);\n",
          "void main() { float shadertwin_width = 0.5 * iResolution.x; "
          "float shadertwin_eye = gl_FragCoord.x < shadertwin_width ? 0.0 : 1.0; "
          "vec2 shadertwin_pixel = gl_FragCoord.xy - vec2(shadertwin_eye * shadertwin_width, 0.0); "
          "vec2 shadertwin_view = (2.0 * shadertwin_pixel - vec2(shadertwin_width, iResolution.y)) / "
          "iResolution.y; "
          "vec4 shadertoy_color = vec4(0.0); mainVR(shadertoy_color, shadertwin_pixel, "
          "vec3(0.064 * (shadertwin_eye - 0.5), 0.0, 0.0), normalize(vec3(shadertwin_view, -1.0))); " +
              shown("shadertoy_color", opaque)};
}

MainText cubemap_main() {
  return {"uniform int shadertwin_face; void mainCubemap(out vec4, in vec2, in vec3, in vec3);\n",
          "void main() { vec2 st = 2.0 * gl_FragCoord.xy / iResolution.xy - 1.0; vec3 shadertwin_ray = "
          "shadertwin_face == 0 ? vec3(1.0, -st.y, -st.x) : shadertwin_face == 1 ? vec3(-1.0, -st.y, st.x) : "
          "shadertwin_face == 2 ? vec3(st.x, 1.0, st.y) : shadertwin_face == 3 ? vec3(st.x, -1.0, -st.y) : "
          "shadertwin_face == 4 ? vec3(st.x, -st.y, 1.0) : vec3(-st.x, -st.y, -1.0); "
          "vec4 shadertoy_color = vec4(0.0); "
          "mainCubemap(shadertoy_color, gl_FragCoord.xy, vec3(0.0), normalize(shadertwin_ray)); " +
              // The site keeps half floats. Rounded here, they are the same on every device and on the twin.
              shown("vec4(unpackHalf2x16(packHalf2x16(shadertoy_color.rg)), "
                    "unpackHalf2x16(packHalf2x16(shadertoy_color.ba)))",
                    false)};
}

MainText sound_main(bool of_time) {
  const std::string side = std::to_string(sound_block_side);
  return {of_time ? "vec2 mainSound(in float);\n" : "vec2 mainSound(in int, in float);\n",
          "void main() { int shadertwin_sample = int(gl_FragCoord.x) + " + side +
              " * int(gl_FragCoord.y); float shadertwin_time = iTimeOffset + float(shadertwin_sample) / "
              "iSampleRate; "
              "shadertoy_out_color = vec4(mainSound(" +
              (of_time ? "" : "iSampleOffset + shadertwin_sample, ") + "shadertwin_time), 0.0, 1.0); }\n"};
}

std::string assert_text() {
  return "int shadertwin_failed = -1; void st_assert(bool condition, int kind) { if (!condition) "
         "shadertwin_failed = "
         "kind; } void st_assert(bool condition) { st_assert(condition, 0); }\n";
}

}  // namespace shadertwin
