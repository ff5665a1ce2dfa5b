#include "host/project/tabs_settings.h"

#include <algorithm>

#include "host/base/error.h"
#include "host/project/channels.h"
#include "host/project/json_text.h"
#include "host/project/kinds.h"
#include "host/project/media.h"
#include "host/project/paths.h"
#include "host/project/text_file.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

// The kind of input that a setting of this name binds; null if it binds none.
const InputKindInfo* kind_of(const std::string& key) {
  for (const InputKindInfo& kind : input_kinds)
    if (kind.source != InputSource::nothing && key == kind.name) return &kind;
  return nullptr;
}

class SettingsReader {
 public:
  SettingsReader(const fs::path& file, Project& project)
      : folder_(file.parent_path()), name_(display_name(file)), project_(project) {}

  void read(const Json& document) {
    for (const auto& [pass_name, channels] : need_object(document, name_, "the document").items()) {
      const int pass = find_pass(project_, pass_name);
      if (pass < 0) fail("there is no tab \"" + pass_name + "\"");
      for (const auto& [channel, input] : need_object(channels, name_, "\"" + pass_name + "\"").items()) {
        if (channel.size() != 9 || !channel.starts_with("iChannel") || channel[8] < '0' || channel[8] > '3')
          fail("\"" + channel + "\" is not one of iChannel0 to iChannel3");
        project_.passes[static_cast<std::size_t>(pass)].inputs[static_cast<std::size_t>(channel[8] - '0')] =
            read_input(need_object(input, name_, channel), pass_name + "." + channel);
      }
    }
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw Error(ExitStatus::file, name_ + ": error: " + message);
  }

  fs::path find(const std::string& path) const {
    std::string refused;
    const std::optional<fs::path> file = file_inside(folder_, path, refused);
    if (!refused.empty()) fail("\"" + path + "\" " + refused);
    if (!file) fail("there is no file \"" + path + "\" in the folder");
    return *file;
  }

  Input read_input(const Json& settings, const std::string& where) const {
    Input input;
    for (const auto& [key, value] : settings.items()) {
      const InputKindInfo* kind = kind_of(key);
      if (kind == nullptr) continue;
      if (input.kind != InputKind::none) fail(where + " is bound twice");
      input.kind = kind->kind;
      bind(value, where + "." + key, input);
    }
    if (input.kind == InputKind::none) fail(where + " has no buffer, texture, cubemap ...");
    input.sampler = info(input.kind).site_sampler;
    for (const auto& [key, value] : settings.items()) read_setting(key, value, where, input);
    return input;
  }

  void bind(const Json& value, const std::string& where, Input& input) const {
    const InputKindInfo& kind = info(input.kind);
    if (kind.source == InputSource::pass) {
      input.pass = find_pass(project_, need_string(value, name_, where));
      if (input.pass < 0) fail("there is no tab \"" + value.get<std::string>() + "\"");
    } else if (kind.source == InputSource::undrawn) {
      const std::string& name = need_string(value, name_, where);
      const auto known = std::find_if(pass_kinds.begin(), pass_kinds.end(), [&](const PassTraits& pass) {
        return pass.is_read && pass.name == name;
      });
      if (known == pass_kinds.end()) fail(where + " is no kind of pass that is read: \"" + name + "\"");
      input.undrawn = known->kind;
    } else if (kind.files == 6) {
      bind_cubemap(value, where, input);
    } else if (kind.files == 1) {
      input.files = {find(need_string(value, name_, where))};
    } else if (value != true) {
      fail(where + " can only be true");
    }
  }

  void bind_cubemap(const Json& value, const std::string& where, Input& input) const {
    if (value.is_array()) {
      if (value.size() != 6) fail(where + " needs six faces");
      for (const Json& face : value) input.files.push_back(find(need_string(face, name_, where)));
      return;
    }
    const std::string& pattern = need_string(value, name_, where);
    if (!has_wildcard(pattern)) fail(where + " needs {} where the faces' names differ, or six names");
    std::string refused;
    file_inside(folder_, pattern, refused);
    std::string missing;
    if (refused.empty()) input.files = find_faces({folder_ / pattern}, missing);
    for (const fs::path& face : input.files)
      if (refused.empty()) file_inside(folder_, face.lexically_relative(folder_).string(), refused);
    if (!refused.empty()) fail("\"" + pattern + "\" " + refused);
    if (input.files.empty()) fail("the cubemap is not complete: " + missing + " is missing");
  }

  void read_setting(const std::string& key, const Json& value, const std::string& where, Input& input) const {
    Sampler& sampler = input.sampler;
    if (key == "filter") {
      const std::string& filter = need_string(value, name_, where + ".filter");
      sampler.mag = filter == "nearest" ? MagFilter::nearest : MagFilter::linear;
      if (filter == "nearest")
        sampler.min = MinFilter::nearest;
      else if (filter == "linear")
        sampler.min = MinFilter::linear;
      else if (filter == "mipmap")
        sampler.min = MinFilter::linear_mipmap_linear;
      else
        fail(where + ".filter is one of nearest, linear, mipmap");
    } else if (key == "wrap") {
      const std::string& wrap = need_string(value, name_, where + ".wrap");
      if (wrap == "repeat")
        sampler.wrap = Wrap::repeat;
      else if (wrap == "clamp")
        sampler.wrap = Wrap::clamp;
      else if (wrap == "mirror")
        sampler.wrap = Wrap::mirror;
      else
        fail(where + ".wrap is one of clamp, repeat, mirror");
    } else if (key == "vflip") {
      if (!value.is_boolean()) fail(where + ".vflip is true or false");
      sampler.vflip = value.get<bool>();
    } else if (kind_of(key) == nullptr) {
      fail(where + " has an unknown setting \"" + key + "\"");
    }
  }

  fs::path folder_;
  std::string name_;
  Project& project_;
};

}  // namespace

void apply_tabs_settings(const fs::path& file, Project& project) {
  SettingsReader(file, project).read(parse_json(read_text(file), display_name(file)));
}

}  // namespace shadertwin
