#include "host/view/overlay.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <string_view>

#include "host/base/error.h"

namespace shadertwin::view {

namespace {

constexpr float font_size = 13.0F;  // the built-in font's own

}  // namespace

Overlay::Overlay(Window& window) : window_(window) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;               // leaves no file behind
  io.ConfigInputTextCursorBlink = false;  // a paused window draws nothing
  const auto scale = static_cast<float>(window.content_scale());
  ImFontConfig font;
  font.SizePixels = font_size * scale;
  io.Fonts->AddFontDefault(&font);
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = style.FrameRounding = 4.0F;
  style.Colors[ImGuiCol_WindowBg].w = 0.75F;
  style.ScaleAllSizes(scale);
  if (!ImGui_ImplGlfw_InitForOpenGL(window.handle(), true) || !ImGui_ImplOpenGL3_Init("#version 300 es"))
    throw Error(ExitStatus::device, "Dear ImGui can't draw in this window");
}

Overlay::~Overlay() {
  window_.context().make_current();
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void Overlay::begin() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Overlay::end() {
  ImGui::Render();
  if (ImGui::GetDrawData()->TotalVtxCount == 0) return;
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  // Its desktop code sets what OpenGL ES does not know; the errors are nobody's.
  const gl::Functions& gl = window_.context().functions();
  while (gl.GetError() != GL_NO_ERROR) {
  }
}

bool Overlay::wants_mouse(glm::dvec2 position) const {
  // WantCaptureMouse is about where the mouse was in the last frame, which may be long ago.
  const ImVec2 at(static_cast<float>(position.x), static_cast<float>(position.y));
  if (ImGui::IsAnyItemActive()) return true;
  for (ImGuiWindow* panel : ImGui::GetCurrentContext()->Windows)
    if (panel->WasActive && (panel->Flags & ImGuiWindowFlags_NoMouseInputs) == 0 &&
        panel->Rect().Contains(at) && panel->Name != std::string_view("Debug##Default"))
      return true;
  return false;
}

bool Overlay::wants_keys() const {
  return ImGui::GetIO().WantTextInput;
}

}  // namespace shadertwin::view
