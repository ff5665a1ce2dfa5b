#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "host/export/data_url.h"
#include "host/export/export.h"
#include "host/export/page.h"
#include "host/image/image.h"
#include "host/player/inputs.h"
#include "host/player/ping_pong.h"
#include "host/project/kinds.h"
#include "host/text/render.h"
#include "host/text/resolve_macros.h"

namespace shadertwin {

namespace {

using Json = nlohmann::ordered_json;

// WebGL's names.
template <typename Enum, std::size_t size>
using Names = std::array<std::pair<Enum, const char*>, size>;
constexpr Names<MinFilter, 6> min_names = {{{MinFilter::nearest, "NEAREST"},
                                            {MinFilter::linear, "LINEAR"},
                                            {MinFilter::nearest_mipmap_nearest, "NEAREST_MIPMAP_NEAREST"},
                                            {MinFilter::nearest_mipmap_linear, "NEAREST_MIPMAP_LINEAR"},
                                            {MinFilter::linear_mipmap_nearest, "LINEAR_MIPMAP_NEAREST"},
                                            {MinFilter::linear_mipmap_linear, "LINEAR_MIPMAP_LINEAR"}}};
constexpr Names<MagFilter, 2> mag_names = {{{MagFilter::nearest, "NEAREST"}, {MagFilter::linear, "LINEAR"}}};
constexpr Names<Wrap, 3> wrap_names = {
    {{Wrap::repeat, "REPEAT"}, {Wrap::clamp, "CLAMP_TO_EDGE"}, {Wrap::mirror, "MIRRORED_REPEAT"}}};

// In the order of their enums.
constexpr std::array<const char*, 6> source_names = {"nothing", "still",   "moving",
                                                     "pass",    "undrawn", "keyboard"};
constexpr std::array<const char*, 3> shape_names = {"flat", "cube", "volume"};

const char* name_of(const auto& names, auto value) {
  return std::find_if(names.begin(), names.end(), [=](const auto& row) { return row.first == value; })
      ->second;
}

class Describer {
 public:
  explicit Describer(const Project& project) : project_(project), ping_pong_(project) {}

  Json describe() {
    Json passes = Json::array();
    for (std::size_t i = 0; i < project_.passes.size(); ++i)
      passes.push_back(describe(project_.passes[i], ping_pong_.targets(i)));
    Json uniforms = Json::array();
    for (const CustomUniform& uniform : project_.uniforms) uniforms.push_back(describe(uniform));
    return {{"site", project_.dialect == Dialect::shadertoy},
            {"quirks", project_.vscode_quirks},
            {"muted", project_.muted},
            {"flies", project_.first_person_controls},
            {"files", project_.files},
            {"passes", passes},
            {"uniforms", uniforms},
            {"media", media_}};
  }

 private:
  Json describe(const Pass& pass, std::size_t targets) {
    Json inputs = Json::array();
    for (std::size_t i = 0; i < pass.inputs.size(); ++i)
      if (const Input input = bound_input(pass, i); input.wanted() != InputKind::none)
        inputs.push_back(describe(input, static_cast<int>(i)));
    return {{"name", pass.name},
            {"faces", traits(pass).faces},
            {"side", traits(pass).side},
            {"every_frame", traits(pass).every_frame},
            {"targets", targets},
            {"keyboard", pass.keyboard},
            {"vertex", pass.vertex ? describe(*pass.vertex, ShaderStage::vertex) : Json()},
            {"source", describe(pass.source, ShaderStage::fragment)},
            {"inputs", inputs}};
  }

  static Json describe(const PassSource& source, ShaderStage stage) {
    throw_if_refused(source);  // the text has no directives any more that a browser could refuse
    return {{"text", render(source, stage)},
            {"first_line", first_body_line(source)},
            {"lines", runs(source.lines)}};
  }

  // Consecutive lines of one file: [count, file, first line].
  static Json runs(const std::vector<SourceLine>& lines) {
    Json result = Json::array();
    for (std::size_t i = 0; i < lines.size();) {
      std::size_t end = i + 1;
      while (end < lines.size() && lines[end].file == lines[i].file &&
             lines[end].line == lines[i].line + static_cast<int>(end - i))
        ++end;
      result.push_back({end - i, lines[i].file, lines[i].line});
      i = end;
    }
    return result;
  }

  Json describe(const Input& input, int channel) {
    Texture texture;
    Json media = Json::array();
    const InputKindInfo& kind = info(input.wanted());
    if (info(input.kind).source == InputSource::still) {
      texture = load_texture(input);
      media = add_picture(input, texture);
    } else if (!input.files.empty()) {
      media.push_back(add(input.files.front().string(), [&] { return data_url(input.files.front()); }));
    }
    const glm::vec3 size =
        channel_size(project_, input, texture.width == 0 ? nullptr : &texture, glm::ivec2(0));
    const Sampler& sampler = input.sampler;
    return {{"channel", channel},
            {"kind", kind.name},
            {"missing", input.kind == InputKind::none},
            {"source", source_names[static_cast<std::size_t>(kind.source)]},
            {"shape", shape_names[static_cast<std::size_t>(shape_of(project_, input))]},
            {"audio", kind.is_audio},
            {"pass", input.pass},
            {"media", media},
            {"size", {size.x, size.y, size.z}},
            {"min", name_of(min_names, sampler.min)},
            {"mag", name_of(mag_names, sampler.mag)},
            {"wrap", name_of(wrap_names, sampler.wrap)},
            {"vflip", sampler.vflip},
            {"red", input.red_only},
            {"mipmaps", sampler.uses_mipmaps()}};
  }

  // Files that a browser reads as we do go in as they are: it decodes 8 bits a channel.
  Json add_picture(const Input& input, const Texture& texture) {
    const bool as_files =
        texture.format == Texture::Format::rgba8 && !texture.is_volume && !input.files.empty() &&
        std::all_of(input.files.begin(), input.files.end(),
                    [](const auto& file) { return media_type(file).starts_with("image/"); });
    Json indices = Json::array();
    if (as_files) {
      for (const auto& file : input.files)
        indices.push_back(add(file.string(), [&] { return data_url(file); }));
      return indices;
    }
    const std::size_t face_bytes = texture.data.size() / static_cast<std::size_t>(texture.faces);
    for (int face = 0; face < texture.faces; ++face) {
      const std::span<const std::byte> texels(
          texture.data.data() + face_bytes * static_cast<std::size_t>(face), face_bytes);
      std::string key(info(input.kind).name);
      for (const auto& file : input.files) key += ' ' + file.string();
      key += (input.sampler.vflip ? " flipped " : " ") + std::to_string(face);
      indices.push_back(add(key, [&] {
        return Json{{"width", texture.width},
                    {"height", texture.height},
                    {"depth", texture.depth},
                    {"format", texture.format == Texture::Format::rgba8 ? "rgba8" : "rgba32f"},
                    {"base64", base64(texels)}};
      }));
    }
    return indices;
  }

  // Each medium stands in the page once, whatever number of channels reads it.
  template <typename Make>
  std::size_t add(const std::string& key, const Make& make) {
    const auto [found, is_new] = media_index_.emplace(key, media_.size());
    if (is_new) media_.push_back(make());
    return found->second;
  }

  static Json describe(const CustomUniform& uniform) {
    return {{"name", uniform.name},       {"type", info(uniform.type).name},
            {"color", uniform.is_color},  {"value", uniform.value},
            {"range", uniform.has_range}, {"min", uniform.min},
            {"max", uniform.max},         {"step", uniform.step}};
  }

  const Project& project_;
  PingPong ping_pong_;
  Json media_ = Json::array();
  std::map<std::string, std::size_t> media_index_;
};

// JSON that an HTML parser leaves alone: "</script>" can't stand in it.
std::string json_in_html(const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string result;
  result.reserve(text.size());
  for (const char c : text)
    if (c == '<')
      result += "\\u003c";
    else
      result += c;
  return result;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  return result;
}

}  // namespace

std::string html_player(const Project& shader, const std::string& title) {
  const Project project = with_shared_samplers(shader);
  const std::map<std::string, std::string, std::less<>> parts = {
      {"title", escaped(title)},
      {"style", std::string(page_style)},
      {"script", std::string(page_script)},
      {"project", json_in_html(Describer(project).describe())}};
  std::string page;
  std::string_view rest = page_template;
  for (std::size_t open = rest.find("{{"); open != std::string_view::npos; open = rest.find("{{")) {
    const std::size_t close = rest.find("}}", open);
    page.append(rest.substr(0, open)).append(parts.find(rest.substr(open + 2, close - open - 2))->second);
    rest.remove_prefix(close + 2);
  }
  return page.append(rest);
}

}  // namespace shadertwin
