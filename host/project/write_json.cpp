#include "host/project/write_json.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "host/base/error.h"
#include "host/language/entry_points.h"
#include "host/project/json_text.h"
#include "host/project/kinds.h"

namespace shadertwin {

namespace {

constexpr int keyboard_id = 33;
constexpr int first_media_id = 1000;

[[noreturn]] void fail(const Pass& pass, const std::string& what) {
  throw Error(ExitStatus::shader, pass.name + ": error: " + what);
}

std::string constant(const CustomUniform& uniform) {
  if (uniform.type == UniformType::mat4) return "";
  const UniformTypeInfo& type = info(uniform.type);
  std::ostringstream line;
  line.precision(9);
  line << "const " << type.name << ' ' << uniform.name << " = " << type.name;
  for (int i = 0; i < type.components; ++i)
    line << (i == 0 ? "(" : ", ") << uniform.value[static_cast<std::size_t>(i)];
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
      const PassTraits& kind = traits(pass);
      int id = kind.site_output;
      if (kind.most > 1) {
        if (buffers == kind.most) fail(pass, "shadertoy.com has four buffers, and this is the fifth");
        id += letter_of(pass, buffers);
        ++buffers;
      }
      ids_.push_back(id);
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

  std::string pass_name(const Pass& pass, int index) const {
    return tab_name(traits(pass), ids_[static_cast<std::size_t>(index)] - traits(pass).site_output);
  }

  Json write_pass(const Pass& pass, int index) {
    const EntryPoints entry = find_entry_points(tokenize(pass.source.body));
    if (traits(pass).fills_frame() && entry.main && !entry.has(traits(pass).entry))
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
            {"description", ""}, {"type", traits(pass).name}};
  }

  Json write_input(const Pass& pass, const Input& input, int channel) {
    int id = next_media_;
    std::string source;
    std::string type(info(input.kind).site_name);
    if (const PassTraits* const kind = pass_read(project_, input)) {
      id = input.kind == InputKind::pass ? ids_[static_cast<std::size_t>(input.pass)] : undrawn_id(*kind);
      if (!kind->is_read)
        fail(pass, "shadertoy.com can't read the " + std::string(kind->name) + " in iChannel" +
                       std::to_string(channel));
      type = kind->name;
      source = "/media/previz/" + type + '0' + std::to_string(id - kind->site_output) + ".png";
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

  // The first id of the kind that no pass has: there is one, as there is a pass that is not there.
  int undrawn_id(const PassTraits& kind) const {
    int id = kind.site_output;
    while (std::find(ids_.begin(), ids_.end(), id) != ids_.end()) ++id;
    return id;
  }

  int flags() const {
    int flags = 0;
    for (const Pass& pass : project_.passes) {
      if (pass.has_vr) flags |= 1;
      flags |= traits(pass).site_flag;
      for (const Input& input : pass.inputs) flags |= info(input.kind).site_flag;
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
