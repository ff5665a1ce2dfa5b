#include "host/view/panels.h"

#include <imgui.h>

#include <array>

#include "host/project/kinds.h"
#include "host/view/keys.h"

namespace shadertwin::view {

namespace {

constexpr ImGuiWindowFlags fixed_panel = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                         ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove |
                                         ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoInputs;
constexpr float margin = 8.0F;
const ImVec4 red(1.0F, 0.45F, 0.4F, 1.0F);
const ImVec4 amber(1.0F, 0.8F, 0.3F, 1.0F);
const ImVec4 grey(0.65F, 0.65F, 0.65F, 1.0F);

void put(float x, float y, ImVec2 pivot) {
  ImGui::SetNextWindowPos({x, y}, ImGuiCond_Always, pivot);
}

bool edit(const CustomUniform& uniform, UniformValue& value) {
  const int count = info(uniform.type).components;
  const char* name = uniform.name.c_str();
  if (uniform.type == UniformType::mat4) {
    ImGui::TextDisabled("%s (mat4)", name);
    return false;
  }
  if (uniform.is_color && count == 3) return ImGui::ColorEdit3(name, value.data(), ImGuiColorEditFlags_Float);
  if (uniform.is_color && count == 4) return ImGui::ColorEdit4(name, value.data(), ImGuiColorEditFlags_Float);
  if (info(uniform.type).is_integer) {
    std::array<int, 4> numbers{};
    for (std::size_t i = 0; i < 4; ++i) numbers[i] = static_cast<int>(value[i]);
    const int low = static_cast<int>(uniform.min[0]);
    const int high = static_cast<int>(uniform.max[0]);
    const bool changed =
        uniform.has_range ? ImGui::SliderScalarN(name, ImGuiDataType_S32, numbers.data(), count, &low, &high)
                          : ImGui::DragScalarN(name, ImGuiDataType_S32, numbers.data(), count, 0.1F);
    for (std::size_t i = 0; i < 4; ++i) value[i] = static_cast<float>(numbers[i]);
    return changed;
  }
  return uniform.has_range ? ImGui::SliderScalarN(name, ImGuiDataType_Float, value.data(), count,
                                                  &uniform.min[0], &uniform.max[0], "%.4g")
                           : ImGui::DragScalarN(name, ImGuiDataType_Float, value.data(), count, 0.01F,
                                                nullptr, nullptr, "%.4g");
}

// Sliders go by the uniform's own steps, counted from its minimum.
void snap(const CustomUniform& uniform, UniformValue& value) {
  for (std::size_t i = 0; i < 4; ++i)
    if (uniform.step[i] > 0.0F)
      value[i] = uniform.min[i] + glm::round((value[i] - uniform.min[i]) / uniform.step[i]) * uniform.step[i];
}

}  // namespace

void draw_help(bool& open) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowSizeConstraints({0, 0}, screen);
  ImGui::SetNextWindowBgAlpha(0.95F);
  if (ImGui::Begin(
          "shadertwin: keys", &open,
          ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoCollapse)) {
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
      for (const Binding& binding : bindings()) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextColored(amber, "%s", binding.name);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(binding.help);
      }
      ImGui::EndTable();
    }
    ImGui::TextColored(grey, "All other keys and the mouse go to the shader.");
    ImGui::TextColored(grey, "A file or folder dropped here opens.");
  }
  ImGui::End();
}

void draw_hud(const HudValues& v) {
  put(margin, margin, {0, 0});
  if (ImGui::Begin("hud", nullptr, fixed_panel)) {
    ImGui::Text("%.1f fps  %.2f ms", v.frames_per_second,
                v.frames_per_second > 0.0 ? 1000.0 / v.frames_per_second : 0.0);
    for (const PassTime& pass : v.passes)
      if (pass.milliseconds >= 0.0) ImGui::Text("%8.3f ms  %s", pass.milliseconds, pass.name.c_str());
    ImGui::Text("%dx%d%s  %s", v.size.x, v.size.y, v.scale.c_str(), v.shown.c_str());
    ImGui::Text("frame %d  %.2f s", v.frame, v.time);
    if (v.samples.has_value()) ImGui::Text("accumulated %d frames in %.1f s", *v.samples, v.sample_seconds);
    ImGui::TextColored(grey, "%s", v.device.c_str());
    if (v.paused) ImGui::TextColored(amber, "paused");
    if (v.recorded >= 0) ImGui::TextColored(red, "recording: %d frames", v.recorded);
  }
  ImGui::End();
}

void draw_problem(const std::string& text) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  put(screen.x / 2, screen.y - margin, {0.5F, 1.0F});
  ImGui::SetNextWindowSizeConstraints({screen.x - 2 * margin, 0},
                                      {screen.x - 2 * margin, screen.y - 2 * margin});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.25F, 0.02F, 0.02F, 0.9F));
  ImGui::PushStyleColor(ImGuiCol_Border, red);
  if (ImGui::Begin("problem", nullptr, fixed_panel)) {
    ImGui::PushTextWrapPos(screen.x - 4 * margin);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
  }
  ImGui::End();
  ImGui::PopStyleColor(2);
}

void draw_notice(const std::string& text) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  put(screen.x - margin, margin, {1.0F, 0.0F});
  if (ImGui::Begin("notice", nullptr, fixed_panel)) ImGui::TextUnformatted(text.c_str());
  ImGui::End();
}

void draw_inspector(const InspectorValues& v, bool& open, bool& paint) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x - margin, screen.y - margin}, ImGuiCond_Appearing, {1.0F, 1.0F});
  if (ImGui::Begin(
          "pixel", &open,
          ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing)) {
    constexpr std::array faces = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
    ImGui::Text("%d, %d%s%s", v.pixel.x, v.pixel.y, v.face < 0 ? "" : "  ",
                v.face < 0 ? "" : faces[static_cast<std::size_t>(v.face)]);
    for (const InspectedPass& pass : v.passes)
      ImGui::Text("%-10s %12.7g %12.7g %12.7g %12.7g", pass.name.c_str(), static_cast<double>(pass.value.x),
                  static_cast<double>(pass.value.y), static_cast<double>(pass.value.z),
                  static_cast<double>(pass.value.w));
    ImGui::Checkbox("paint NaN and infinities", &paint);
  }
  ImGui::End();
}

UniformEdits draw_uniforms(const std::vector<CustomUniform>& uniforms, std::vector<UniformValue>& values,
                           bool& open) {
  UniformEdits edits;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x - margin, margin}, ImGuiCond_FirstUseEver, {1.0F, 0.0F});
  if (ImGui::Begin("uniforms", &open,
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing)) {
    ImGui::PushItemWidth(ImGui::GetFontSize() * 14.0F);
    for (std::size_t i = 0; i < uniforms.size(); ++i)
      if (edit(uniforms[i], values[i])) {
        snap(uniforms[i], values[i]);
        edits.changed = true;
      }
    ImGui::PopItemWidth();
    edits.copy = ImGui::Button("copy as -D options");
    ImGui::SameLine();
    edits.reset = ImGui::Button("defaults");
  }
  ImGui::End();
  return edits;
}

}  // namespace shadertwin::view
