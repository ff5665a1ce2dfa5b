#include "host/text/main_text.h"

#include <algorithm>
#include <array>

#include "host/base/assert.h"
#include "host/project/project.h"

namespace shadertwin {

namespace {

constexpr const char* out = "shadertoy_out_color = ";

std::string shown(const std::string& color, bool opaque) {
  return out + (opaque ? "vec4(" + color + ".rgb, 1.0)" : color) + "; }\n";
}

MainText image_main(const MainOptions& options) {
  const std::string check =
      options.asserts ? "if (shadertwin_failed >= 0) shadertoy_color.rgb = vec3(shadertwin_failed == 0 || "
                        "shadertwin_failed == "
                        "3, shadertwin_failed == 1 || shadertwin_failed == 3, shadertwin_failed == 2); "
                      : "";
  return {options.image_is_inout ? "void mainImage(inout vec4, in vec2);\n"
                                 : "void mainImage(out vec4, in vec2);\n",
          "void main() { vec4 shadertoy_color = vec4(0.0); mainImage(shadertoy_color, gl_FragCoord.xy); " +
              check + shown("shadertoy_color", options.opaque)};
}

MainText vr_main(const MainOptions& options) {
  return {"void mainVR(out vec4, in vec2, in vec3, in vec3);\n",
          "void main() { float shadertwin_width = 0.5 * iResolution.x; "
          "float shadertwin_eye = gl_FragCoord.x < shadertwin_width ? 0.0 : 1.0; "
          "vec2 shadertwin_pixel = gl_FragCoord.xy - vec2(shadertwin_eye * shadertwin_width, 0.0); "
          "vec2 shadertwin_view = (2.0 * shadertwin_pixel - vec2(shadertwin_width, iResolution.y)) / "
          "iResolution.y; "
          "vec4 shadertoy_color = vec4(0.0); mainVR(shadertoy_color, shadertwin_pixel, "
          "vec3(0.064 * (shadertwin_eye - 0.5), 0.0, 0.0), normalize(vec3(shadertwin_view, -1.0))); " +
              shown("shadertoy_color", options.opaque)};
}

MainText cubemap_main(const MainOptions& /*options*/) {
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

MainText sound_main(const MainOptions& options) {
  const std::string side = std::to_string(sound_block_side);
  return {options.sound_of_time ? "vec2 mainSound(in float);\n" : "vec2 mainSound(in int, in float);\n",
          "void main() { int shadertwin_sample = int(gl_FragCoord.x) + " + side +
              " * int(gl_FragCoord.y); float shadertwin_time = iTimeOffset + float(shadertwin_sample) / "
              "iSampleRate; "
              "shadertoy_out_color = vec4(mainSound(" +
              (options.sound_of_time ? "" : "iSampleOffset + shadertwin_sample, ") +
              "shadertwin_time), 0.0, 1.0); }\n"};
}

struct EntryPoint {
  std::string_view name;
  std::string_view parameters;
  MainText (*main)(const MainOptions& options);
};

constexpr std::array<EntryPoint, 4> entry_points = {{
    {"mainImage", "(out vec4, in vec2)", image_main},
    {"mainVR", "(out vec4, in vec2, in vec3, in vec3)", vr_main},
    {"mainCubemap", "(out vec4, in vec2, in vec3, in vec3)", cubemap_main},
    {"mainSound", "(in int, float)", sound_main},
}};

const EntryPoint* find_entry(std::string_view name) {
  const auto* const found = std::find_if(entry_points.begin(), entry_points.end(),
                                         [&](const EntryPoint& entry) { return entry.name == name; });
  return found == entry_points.end() ? nullptr : found;
}

const EntryPoint& need_entry(std::string_view name) {
  const EntryPoint* const entry = find_entry(name);
  SHADERTWIN_ASSERT(entry != nullptr);
  return *entry;
}

}  // namespace

bool is_entry_point(std::string_view name) {
  return name == "main" || find_entry(name) != nullptr;
}

std::string signature(std::string_view entry) {
  return std::string(entry).append(need_entry(entry).parameters);
}

MainText main_text(std::string_view entry, const MainOptions& options) {
  return need_entry(entry).main(options);
}

std::string assert_text() {
  return "int shadertwin_failed = -1; void st_assert(bool condition, int kind) { if (!condition) "
         "shadertwin_failed = "
         "kind; } void st_assert(bool condition) { st_assert(condition, 0); }\n";
}

}  // namespace shadertwin
