#include "host/project/write_json.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "host/base/error.h"
#include "host/language/entry_points.h"
#include "host/project/json_text.h"

namespace shadertwin {

namespace {

constexpr int image_id = 37;
constexpr int first_buffer_id = 257;
constexpr int cubemap_id = 41;
constexpr int keyboard_id = 33;
constexpr int first_media_id = 1000;

[[noreturn]] void fail(const Pass& pass, const std::string& what) {
  throw Error(ExitStatus::shader, pass.name + ": error: " + what);
}

const char* type_name(InputKind kind) {
  switch (kind) {
    case InputKind::texture:
      return "texture";
    case InputKind::cubemap:
      return "cubemap";
    case InputKind::volume:
      return "volume";
    case InputKind::pass:
      return "buffer";
    case InputKind::keyboard:
      return "keyboard";
    case InputKind::music:
      return "music";
    case InputKind::video:
      return "video";
    case InputKind::webcam:
      return "webcam";
    case InputKind::microphone:
      return "mic";
    case InputKind::none:
      break;
  }
  return "";
}

std::string constant(const CustomUniform& uniform) {
  constexpr std::array types = {"float", "vec2", "vec3", "vec4", "int", "ivec2", "ivec3", "ivec4"};
  const auto index = static_cast<std::size_t>(uniform.type);
  if (index >= types.size()) return "";
  std::ostringstream line;
  line.precision(9);
  line << "const " << types[index] << ' ' << uniform.name << " = " << types[index] << '(';
  for (std::size_t i = 0; i <= index % 4; ++i) line << (i == 0 ? "" : ", ") << uniform.value[i];
  line << ");\n";
  return line.str();
}

Json common_pass(const std::string& code) {
  return {{"inputs", Json::array()}, {"outputs", Json::array()}, {"code", code},
          {"name", "Common"},        {"description", ""},        {"type", "common"}};
}

class Writer {
 public:
  explicit Writer(const Project& project) : project_(project) { name_passes(); }

  std::string write() {
    Json passes = Json::array();
    passes.push_back(write_pass(project_.passes.back(), static_cast<int>(project_.passes.size()) - 1));
    if (const std::string common = common_text(); !common.empty()) passes.push_back(common_pass(common));
    for (std::size_t i = 0; i + 1 < project_.passes.size(); ++i)
      passes.push_back(write_pass(project_.passes[i], static_cast<int>(i)));
    const Json info = {{"id", ""},
                       {"date", "0"},
                       {"viewed", 0},
                       {"name", project_.title},
                       {"username", ""},
                       {"description", ""},
                       {"likes", 0},
                       {"published", 0},
                       {"flags", flags()},
                       {"usePreview", 0},
                       {"tags", Json::array()},
                       {"hasliked", 0}};
    const Json shader = {{"ver", "0.1"}, {"info", info}, {"renderpass", passes}};
    return Json({{"Shader", shader}}).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  }

 private:
  void name_passes() {
    int buffers = 0;
    for (std::size_t i = 0; i < project_.passes.size(); ++i) {
      const Pass& pass = project_.passes[i];
      switch (pass.kind) {
        case PassKind::image:
          ids_.push_back(image_id);
          break;
        case PassKind::cubemap:
          ids_.push_back(cubemap_id);
          break;
        case PassKind::sound:
          ids_.push_back(0);
          break;
        case PassKind::buffer:
          if (buffers == 4) fail(pass, "shadertoy.com has four buffers, and this is the fifth");
          ids_.push_back(first_buffer_id + letter_of(pass, buffers));
          ++buffers;
          break;
      }
    }
  }

  // A tab keeps its letter; a pass of the extension takes the next one.
  static int letter_of(const Pass& pass, int next) {
    const bool tab = pass.name.size() == 8 && pass.name.starts_with("Buffer ") && pass.name[7] >= 'A' &&
                     pass.name[7] <= 'D';
    return tab ? pass.name[7] - 'A' : next;
  }

  std::string common_text() const {
    std::string text;
    for (const CustomUniform& uniform : project_.uniforms) text += constant(uniform);
    return text + project_.common;
  }

  static const char* pass_type(PassKind kind) {
    constexpr std::array names = {"image", "buffer", "cubemap", "sound"};
    return names[static_cast<std::size_t>(kind)];
  }

  std::string pass_name(const Pass& pass, int index) const {
    switch (pass.kind) {
      case PassKind::image:
        return "Image";
      case PassKind::cubemap:
        return "Cubemap A";
      case PassKind::sound:
        return "Sound";
      default:
        return std::string("Buffer ") +
               static_cast<char>('A' + ids_[static_cast<std::size_t>(index)] - first_buffer_id);
    }
  }

  Json write_pass(const Pass& pass, int index) {
    const bool picture = pass.kind == PassKind::image || pass.kind == PassKind::buffer;
    const EntryPoints entry = find_entry_points(tokenize(pass.source.body));
    if (picture && entry.main && !entry.image)
      fail(pass, "shadertoy.com needs mainImage(), and this has main()");
    Json inputs = Json::array();
    for (int channel = 0; channel < max_channels; ++channel) {
      const Input& input = pass.inputs[static_cast<std::size_t>(channel)];
      if (input.kind == InputKind::none) continue;
      if (channel > 3) fail(pass, "shadertoy.com has no iChannel" + std::to_string(channel));
      inputs.push_back(write_input(pass, input, channel));
    }
    Json outputs = Json::array();
    if (const int id = ids_[static_cast<std::size_t>(index)]; id != 0)
      outputs.push_back({{"id", id}, {"channel", 0}});
    return {{"inputs", inputs},  {"outputs", outputs},
            {"code", pass.code}, {"name", pass_name(pass, index)},
            {"description", ""}, {"type", pass_type(pass.kind)}};
  }

  Json write_input(const Pass& pass, const Input& input, int channel) {
    int id = next_media_;
    std::string source;
    std::string type = type_name(input.kind);
    if (input.kind == InputKind::pass) {
      id = ids_[static_cast<std::size_t>(input.pass)];
      if (id == image_id)
        fail(pass, "shadertoy.com can't read the image in iChannel" + std::to_string(channel));
      source = id == cubemap_id ? "/media/previz/cubemap00.png"
                                : "/media/previz/buffer0" + std::to_string(id - first_buffer_id) + ".png";
      if (id == cubemap_id) type = "cubemap";
    } else if (input.kind == InputKind::keyboard) {
      id = keyboard_id;
      source = "/presets/tex00.jpg";
    } else {
      ++next_media_;
      if (!input.files.empty()) source = "/media/a/" + input.files[0].filename().string();
    }
    const Sampler& sampler = input.sampler;
    const char* filter = sampler.min == MinFilter::nearest  ? "nearest"
                         : sampler.min == MinFilter::linear ? "linear"
                                                            : "mipmap";
    const Json settings = {{"filter", filter},
                           {"wrap", sampler.wrap == Wrap::clamp ? "clamp" : "repeat"},
                           {"vflip", sampler.vflip ? "true" : "false"},
                           {"srgb", "false"},
                           {"internal", "byte"}};
    return {{"id", id},           {"src", source},       {"ctype", type},
            {"channel", channel}, {"sampler", settings}, {"published", 1}};
  }

  int flags() const {
    int flags = 0;
    for (const Pass& pass : project_.passes) {
      if (pass.has_vr) flags |= 1;
      if (pass.kind == PassKind::sound) flags |= 8;
      if (pass.kind == PassKind::buffer || pass.kind == PassKind::cubemap) flags |= 32;
      for (const Input& input : pass.inputs) {
        if (input.kind == InputKind::webcam) flags |= 2;
        if (input.kind == InputKind::microphone) flags |= 4;
        if (input.kind == InputKind::keyboard) flags |= 16;
      }
    }
    return flags;
  }

  const Project& project_;
  std::vector<int> ids_;  // of every pass's output; 0 for none
  int next_media_ = first_media_id;
};

}  // namespace

std::string write_json(const Project& project) {
  return project.json.empty() ? Writer(project).write() : project.json;
}

std::string with_common(const std::string& json, const std::string& text) {
  Json document = Json::parse(json);
  Json* shader = document.is_array()            ? &document[0]
                 : document.contains("Shader")  ? &document["Shader"]
                 : document.contains("shaders") ? &document["shaders"][0]
                                                : &document;
  Json& passes = (*shader)["renderpass"];
  const auto common =
      std::find_if(passes.begin(), passes.end(), [](const Json& pass) { return pass["type"] == "common"; });
  if (common == passes.end())
    passes.push_back(common_pass(text));
  else
    (*common)["code"] = text + (*common)["code"].get<std::string>();
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace shadertwin
