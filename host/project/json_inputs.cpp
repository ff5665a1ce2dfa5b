#include "host/project/json_inputs.h"

#include <algorithm>
#include <array>
#include <utility>

#include "host/base/error.h"
#include "host/project/media.h"
#include "host/project/paths.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t max_inputs = 64;

// Textures of which the site keeps one channel: Bayer, two sizes of grey noise, pebbles. The API numbers
// them, so they are known by their file as well.
constexpr std::array<std::string_view, 4> red_ids = {"Xdf3zn", "4sf3Rn", "4dXGzn", "4sf3Rr"};
constexpr std::array<std::string_view, 4> red_files = {
    "85a6d68622b36995ccb98a89bbb119edf167c914660e4450d313de049320005c.png",
    "0a40562379b63dfb89227e6d172f39fdce9022cba76623f1054a2c83d6c0ba5d.png",
    "0c7bf5fe9462d5bffbd11126e82908e39be3ce56220d900f633d58fb432e56f5.png",
    "ad56fba948dfba9ae698198c109e71f118a54d209c0ea50d77ea546abad89c57.png"};

bool has_one_channel(const std::string& id, const std::string& source) {
  return std::find(red_ids.begin(), red_ids.end(), id) != red_ids.end() ||
         std::any_of(red_files.begin(), red_files.end(),
                     [&](std::string_view file) { return source.ends_with(file); });
}

// An id is the API's number, or the string that the site uses: given for an output's number, too.
std::string read_id(const Json& object) {
  const auto id = object.find("id");
  if (id == object.end()) return "";
  const std::string text = id->is_string()           ? id->get<std::string>()
                           : id->is_number_integer() ? id->dump()
                                                     : "";
  for (const PassTraits& kind : pass_kinds)
    for (std::size_t i = 0; i * (site_id_length + 1) < kind.site_ids.size(); ++i)
      if (text == std::to_string(static_cast<std::size_t>(kind.site_output) + i))
        return std::string(kind.site_ids.substr(i * (site_id_length + 1), site_id_length));
  return text;
}

// The number of the output of that id among those of a kind, from 0; -1 if it is none of them.
int number_of_output(const PassTraits& kind, const std::string& id) {
  const std::size_t found = kind.site_ids.find(id);
  const bool is_one = id.size() == site_id_length && found != std::string_view::npos;
  return is_one ? static_cast<int>(found / (site_id_length + 1)) : -1;
}

// A string under one of two names; "" if there is none.
std::string either(const Json& object, const char* name, const char* other) {
  for (const char* key : {name, other})
    if (const auto found = object.find(key); found != object.end() && found->is_string())
      return found->get<std::string>();
  return "";
}

InputKind kind_of(const std::string& type) {
  if (type == "musicstream") return InputKind::music;
  for (const InputKindInfo& kind : input_kinds)
    if (kind.site_name == type) return kind.kind;
  return InputKind::none;
}

// The kind of pass that an input reads; null if it reads none. A type may be one of files, too.
const PassTraits* read_kind(const std::string& type, const std::string& id, const std::string& source) {
  for (const PassTraits& kind : pass_kinds)
    if (kind.is_read && type == kind.name &&
        (info(kind_of(type)).source != InputSource::still || number_of_output(kind, id) >= 0 ||
         source.starts_with("/media/previz/")))
      return &kind;
  return nullptr;
}

bool is_true(const Json& value) {
  return value.is_boolean() ? value.get<bool>() : value == "true";
}

Sampler read_sampler(const Json& input, InputKind kind) {
  Sampler sampler = info(kind).site_sampler;
  const auto settings = input.find("sampler");
  if (settings == input.end() || !settings->is_object()) return sampler;
  const bool fixed = !info(kind).has_settings;
  const std::string filter = either(*settings, "filter", "filter");
  if (!filter.empty() && !fixed) {
    sampler.mag = filter == "linear" || filter == "mipmap" ? MagFilter::linear : MagFilter::nearest;
    sampler.min = filter == "linear"   ? MinFilter::linear
                  : filter == "mipmap" ? MinFilter::linear_mipmap_linear
                                       : MinFilter::nearest;
  }
  const std::string wrap = either(*settings, "wrap", "wrap");
  if (!wrap.empty() && !fixed) sampler.wrap = wrap == "clamp" ? Wrap::clamp : Wrap::repeat;
  if (const auto vflip = settings->find("vflip"); vflip != settings->end()) sampler.vflip = is_true(*vflip);
  return sampler;
}

// The files that a source may stand for, the likeliest first. A cubemap is named by its first face: the
// others are NAME_1.jpg to NAME_5.jpg on the site; with names as the extension's (NAME_px.jpg) they may
// follow those.
std::vector<std::vector<std::string>> spellings(const std::string& source, InputKind kind) {
  if (info(kind).files != 6) return {{source}};
  const std::size_t dot = std::min(source.rfind('.'), source.size());
  const std::string stem = source.substr(0, dot);
  const std::string extension = source.substr(dot);
  std::vector<std::vector<std::string>> result = {{source}};
  for (int i = 1; i < 6; ++i) result[0].push_back(stem + "_" + std::to_string(i) + extension);
  for (const auto& set : face_names()) {
    if (!stem.ends_with(set[0])) continue;
    const std::string before = stem.substr(0, stem.size() - set[0].size());
    std::vector<std::string>& names = result.emplace_back();
    for (const std::string_view face : set) names.push_back(before + std::string(face) + extension);
  }
  return result;
}

}  // namespace

JsonPass identify(const Json& pass, const PassTraits& kind, const std::string& document) {
  JsonPass result;
  result.kind = kind.kind;
  if (const auto outputs = pass.find("outputs"); outputs != pass.end() && !outputs->is_null()) {
    need_array(*outputs, document, "outputs");
    if (!outputs->empty()) result.output = read_id(need_object(outputs->front(), document, "an output"));
  }
  if (kind.most == 1) return result;
  result.number = number_of_output(kind, result.output);
  if (result.number >= 0) return result;
  // "Buffer A", in old documents "Buf A".
  const std::string name = either(pass, "name", "name");
  if (name.size() > 4 && name.starts_with(kind.title.substr(0, kind.short_tab.size())) &&
      name[name.size() - 2] == ' ' && name.back() >= 'A' && name.back() < 'A' + kind.most)
    result.number = name.back() - 'A';
  return result;
}

JsonInputs::JsonInputs(fs::path media, std::string document, std::vector<JsonPass> passes, bool muted,
                       std::vector<std::string>& warnings)
    : media_(std::move(media)),
      document_(std::move(document)),
      passes_(std::move(passes)),
      muted_(muted),
      warnings_(warnings) {}

void JsonInputs::fail(const std::string& message) const {
  throw Error(ExitStatus::file, document_ + ": error: " + message);
}

void JsonInputs::warn(const std::string& subject, const std::string& message) {
  if (warned_.insert(subject).second) warnings_.push_back(document_ + ": warning: " + message);
}

void JsonInputs::bind(const Json& json, Pass& pass) {
  const auto inputs = json.find("inputs");
  if (inputs == json.end() || inputs->is_null()) return;
  need_array(*inputs, document_, "inputs");
  if (inputs->size() > max_inputs) fail(pass.name + " has " + std::to_string(inputs->size()) + " inputs");
  for (const Json& input : *inputs) {
    need_object(input, document_, "an input");
    const auto channel = input.find("channel");
    if (channel == input.end() || !channel->is_number_integer() || *channel < 0 || *channel > 3)
      fail("an input of " + pass.name + " has no channel from 0 to 3");
    pass.inputs[channel->get<std::size_t>()] = read(input);
  }
}

Input JsonInputs::read(const Json& json) {
  const std::string type = either(json, "ctype", "type");
  const std::string source = either(json, "src", "filepath");
  const std::string id = read_id(json);
  Input input;
  input.kind = kind_of(type);
  if (const PassTraits* const kind = read_kind(type, id, source))
    input = read_pass(id, source, *kind);
  else if (input.kind == InputKind::none)
    warn("type " + type, "an input has the unknown type \"" + type + "\"");
  else if (info(input.kind).files != 0)
    find_media(source, input.kind, input);
  if (input.kind == InputKind::none) {
    input.missing = kind_of(type);
    input.sampler = read_sampler(json, input.missing);
    return input;
  }
  input.sampler = read_sampler(json, input.kind);
  input.red_only = input.kind == InputKind::texture && has_one_channel(id, source);
  return input;
}

Input JsonInputs::read_pass(const std::string& id, const std::string& source, const PassTraits& kind) {
  Input input;
  for (std::size_t i = 0; i < passes_.size() && input.pass < 0; ++i)
    if (passes_[i].kind == kind.kind && !id.empty() && passes_[i].output == id)
      input.pass = static_cast<int>(i);
  // Without an id the thumbnail tells: buffer00.png is Buffer A.
  const std::string thumbnail = std::string(kind.name) + '0';
  const std::size_t digit = source.find(thumbnail) + thumbnail.size();
  const int number =
      source.find(thumbnail) != std::string::npos && digit < source.size() ? source[digit] - '0' : -1;
  for (std::size_t i = 0; i < passes_.size() && input.pass < 0; ++i)
    if (passes_[i].kind == kind.kind && (kind.most == 1 || (number >= 0 && passes_[i].number == number)))
      input.pass = static_cast<int>(i);
  input.kind = input.pass >= 0 ? InputKind::pass : InputKind::undrawn;
  input.undrawn = kind.kind;
  if (input.pass < 0)
    warn("pass " + id + source, "an input reads a pass that is not there: " + (id.empty() ? source : id));
  return input;
}

fs::path JsonInputs::find_one(const std::string& source, std::string& problem) const {
  std::string below = source.substr(std::min(source.find_first_not_of('/'), source.size()));
  const std::size_t slash = below.find_last_of('/');
  if (below.empty()) {
    problem = "has no file";
    return {};
  }
  std::optional<fs::path> file = file_inside(media_, below, problem);
  if (!file && problem.empty() && slash != std::string::npos)
    file = file_inside(media_, below.substr(slash + 1), problem);
  if (file && !fs::is_regular_file(*file)) file.reset();
  if (!file && problem.empty()) problem = "is not in " + media_.generic_string();
  return file.value_or(fs::path());
}

void JsonInputs::find_media(const std::string& source, InputKind kind, Input& input) {
  std::string complaint;
  for (const std::vector<std::string>& names : spellings(source, kind)) {
    std::string problem;
    input.files.clear();
    for (const std::string& name : names) {
      input.files.push_back(find_one(name, problem));
      if (problem.empty()) continue;
      if (complaint.empty()) complaint = "\"" + name + "\" " + problem;
      break;
    }
    if (problem.empty()) return;
  }
  if (kind != InputKind::music || !muted_)
    warn(complaint,
         complaint + ": " +
             (kind == InputKind::music ? "the channel is silent (--mute gives shadertoy.com's preview)"
                                       : "the channel stays empty"));
  input = {};
}

}  // namespace shadertwin
