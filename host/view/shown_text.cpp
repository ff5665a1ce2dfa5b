#include "host/view/shown_text.h"

#include <charconv>

#include "host/project/kinds.h"

namespace shadertwin::view {

namespace {

// The shortest text that reads back as the same float.
std::string number(float value) {
  std::array<char, 32> text{};
  const auto [end, failure] = std::to_chars(text.data(), text.data() + text.size(), value);
  std::string result(text.data(), end);
  if (result.find_first_of(".en") == std::string::npos) result += ".0";  // GLSL's floats have a point
  return result;
}

std::string number(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string glsl_value(UniformType type, const UniformValue& value) {
  const auto component = [&](int i) {
    const float v = value[static_cast<std::size_t>(i)];
    return info(type).is_integer ? std::to_string(static_cast<int>(v)) : number(v);
  };
  if (info(type).components == 1) return component(0);
  std::string text = std::string(info(type).name) + '(';
  for (int i = 0; i < info(type).components; ++i) text += (i == 0 ? "" : ", ") + component(i);
  return text + ')';
}

}  // namespace

std::string quoted(const std::string& argument) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%";
  if (!argument.empty() && argument.find_first_not_of(plain) == std::string::npos) return argument;
  std::string text = "'";
  for (const char c : argument) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + '\'';
}

std::string uniforms_as_options(const std::vector<CustomUniform>& uniforms,
                                const std::vector<UniformValue>& values) {
  std::string text;
  for (std::size_t i = 0; i < uniforms.size() && i < values.size(); ++i)
    if (uniforms[i].type != UniformType::mat4)
      text += (text.empty() ? "-D " : " -D ") +
              quoted(uniforms[i].name + '=' + glsl_value(uniforms[i].type, values[i]));
  return text;
}

std::string commands_for_pixel(const FrameCommand& command, const Frame& frame, const std::string& pass,
                               glm::ivec2 pixel) {
  std::string play =
      quoted(command.shader) + " --size " + std::to_string(frame.width) + 'x' + std::to_string(frame.height);
  std::optional<Date> date = command.date;
  // Real time can't be repeated frame by frame: the nearest thing is one frame at that time.
  if (command.fps > 0.0) {
    play += " --fps " + number(command.fps) + " --frames " + std::to_string(frame.index + 1);
    if (command.t0 != 0.0) play += " --time " + number(command.t0);
  } else {
    play += " --time " + number(frame.time);
    if (date.has_value()) date = later(*date, frame.time - command.t0);
  }
  if (date.has_value() && *date != Date()) play += " --date " + date->text();
  if (frame.mouse != glm::vec4(0.0F))
    play += " --mouse " + std::to_string(static_cast<int>(frame.mouse.x)) + ',' +
            std::to_string(static_cast<int>(frame.mouse.y)) + (frame.mouse.z > 0.0F ? ",down" : "");
  if (!pass.empty()) play += " --pass " + quoted(pass);
  if (!command.options.empty()) play += ' ' + command.options;
  return "shadertwin debug " + play + " --pixel " + std::to_string(pixel.x) + ',' + std::to_string(pixel.y) +
         '\n' + "shadertwin compare " + play + " --on auto --on cpu\n";
}

}  // namespace shadertwin::view
