#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "host/base/error.h"
#include "host/export/export.h"
#include "host/export/output_folder.h"
#include "host/project/kinds.h"
#include "host/project/write_json.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

const char* filter_name(const Sampler& sampler) {
  if (sampler.mag == MagFilter::nearest && sampler.min == MinFilter::nearest) return "nearest";
  return sampler.min == MinFilter::nearest || sampler.min == MinFilter::linear ? "linear" : "mipmap";
}

const char* wrap_name(Wrap wrap) {
  if (wrap == Wrap::mirror) return "mirror";
  return wrap == Wrap::clamp ? "clamp" : "repeat";
}

class TabsWriter {
 public:
  TabsWriter(const Project& project, const fs::path& folder) : project_(project), output_(folder) {
    project_.json.clear();  // tabs in our order, not in that of the document
  }

  void write() {
    const Json document = Json::parse(write_json(project_));
    for (const Json& tab : document.at("Shader").at("renderpass")) {
      names_.push_back(tab.at("name"));
      output_.write(file_stem(names_.back()) + ".glsl", tab.at("code"));
    }
    for (const Pass& pass : project_.passes) bind(pass);
    output_.write("shadertoy.json", settings_.dump(2) + "\n");
    output_.write("BINDINGS.txt", note_);
    output_.commit();
  }

 private:
  // What write_json called the pass. After the image and Common the others stand there in our order.
  std::string name_of(const Pass& pass) const {
    const auto index = static_cast<std::size_t>(&pass - project_.passes.data());
    if (index + 1 == project_.passes.size()) return "Image";
    std::vector<std::string> others;
    for (const std::string& name : names_)
      if (name != "Image" && name != "Common") others.push_back(name);
    return others.at(index);
  }

  // The medium's name in the folder; two files of one name get different ones.
  std::string add_file(const fs::path& file) {
    const auto known = files_.find(file);
    if (known != files_.end()) return known->second;
    std::string name = file.filename().string();
    const auto taken = [&] {
      return std::any_of(files_.begin(), files_.end(),
                         [&](const auto& entry) { return entry.second == name; });
    };
    for (int i = 2; taken(); ++i)
      name = file.stem().string() + "_" + std::to_string(i) + file.extension().string();
    output_.copy(file, name);
    files_.emplace(file, name);
    return name;
  }

  void bind(const Pass& pass) {
    const std::string name = name_of(pass);
    std::string lines;
    for (std::size_t i = 0; i < pass.inputs.size(); ++i) {
      const Input& input = pass.inputs[i];
      if (input.kind == InputKind::none) continue;
      const std::string channel = "iChannel" + std::to_string(i);
      Json& settings = settings_[name][channel];
      const std::string what = describe(input, settings);
      const bool sampled = info(input.kind).has_settings;
      if (sampled) {
        settings["filter"] = filter_name(input.sampler);
        settings["wrap"] = wrap_name(input.sampler.wrap);
        if (input.kind != InputKind::pass) settings["vflip"] = input.sampler.vflip;
      }
      lines += "  " + channel + "  " + what;
      if (sampled)
        lines += std::string("; filter ") + filter_name(input.sampler) + ", wrap " +
                 wrap_name(input.sampler.wrap) +
                 (input.kind == InputKind::pass ? ""
                  : input.sampler.vflip         ? ", vflip on"
                                                : ", vflip off");
      lines += '\n';
    }
    if (!lines.empty()) note_ += '\n' + name + '\n' + lines;
  }

  std::string describe(const Input& input, Json& settings) {
    const InputKindInfo& kind = info(input.kind);
    const std::string name(kind.name);
    Json& value = settings[name];
    if (kind.source == InputSource::pass) {
      value = name_of(project_.passes[static_cast<std::size_t>(input.pass)]);
      return value;
    }
    if (kind.source == InputSource::undrawn) {
      value = traits(input.undrawn).name;
      return name;
    }
    if (kind.files == 0) {
      value = true;
      return name;
    }
    std::string list;
    Json files = Json::array();
    for (const fs::path& file : input.files) {
      files.push_back(add_file(file));
      list += (list.empty() ? "" : ", ") + add_file(file);
    }
    value = kind.files == 1 ? files.front() : files;
    return name + ' ' + list;
  }

  Project project_;
  OutputFolder output_;
  std::vector<std::string> names_;  // of the tabs
  std::map<fs::path, std::string> files_;
  Json settings_ = Json::object();
  std::string note_ =
      "What to bind to which channel on shadertoy.com, tab by tab; make the tabs in this order of buffers.\n"
      "The site offers its own pictures, sounds and videos only: choose what comes near, or play the folder "
      "with\n"
      "shadertwin, which reads the same from shadertoy.json.\n";
};

}  // namespace

void write_tabs(const Project& project, const fs::path& folder) {
  TabsWriter(project, folder).write();
}

}  // namespace shadertwin
