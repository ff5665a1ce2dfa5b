#include "host/project/channels.h"

#include <algorithm>

#include "host/project/host_rules.h"
#include "host/project/kinds.h"
#include "host/project/paths.h"
#include "host/project/text_file.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

void warn(Project& project, const PlacedDirective& at, const std::string& message) {
  project.warnings.push_back(display_name(at.file) + ":" + std::to_string(at.directive.line) +
                             ": warning: " + message);
}

[[noreturn]] void fail(ExitStatus status, const PlacedDirective& at, const std::string& message) {
  fail_at(status, at.file, at.directive.line, message);
}

void bind_cubemap(const PlacedDirective& at, const std::vector<fs::path>& places, Input& input) {
  if (!has_wildcard(at.directive.text))
    fail(ExitStatus::shader, at, "a cubemap needs a path with {} where its faces' names differ");
  std::string missing;
  input.kind = InputKind::cubemap;
  input.files = find_faces(places, missing);
  if (input.files.empty())
    fail(ExitStatus::file, at, "the cubemap is not complete: " + missing + " is missing");
}

void bind_file(const ChannelContext& context, const PlacedDirective& at, const fs::path& file, Input& input) {
  input.kind = kind_of_file(at.directive.text);
  if (input.kind == InputKind::none)
    warn(context.project, at, "\"" + at.directive.text + "\" is nothing that a channel can show");
  else if (input.kind != InputKind::pass)
    input.files = {file};
  else if (identity(file) == identity(context.pass_file))
    input.pass = context.self;
  else
    input.pass = context.find_pass(file, at);
}

// What the path of an #iChannelN stands for.
Input bind_path(const ChannelContext& context, const PlacedDirective& at, bool cubemap) {
  const std::string& path = at.directive.text;
  Input input;
  if (path == "self" || path == "file://self") {
    input.kind = InputKind::pass;
    input.pass = context.self;
    return input;
  }
  if (is_remote(path)) {
    warn(context.project, at, "\"" + path + "\" is not fetched: the channel stays empty");
    return input;
  }
  const std::vector<fs::path> places = candidates(path, at.file, context.root);
  const std::optional<fs::path> found = find_file(places);
  if (cubemap || (has_wildcard(path) && !found)) {
    bind_cubemap(at, places, input);
    return input;
  }
  if (!found) {
    std::string tried;
    for (const fs::path& place : places) tried += (tried.empty() ? "" : ", ") + display_name(place);
    fail(ExitStatus::file, at, "can't find \"" + path + "\"; tried " + tried);
  }
  if (fs::is_directory(*found)) fail(ExitStatus::file, at, display_name(*found) + " is a folder");
  bind_file(context, at, *found, input);
  return input;
}

}  // namespace

void bind_channels(const ChannelContext& context, const std::vector<PlacedDirective>& directives,
                   std::array<Input, max_channels>& inputs) {
  using Kind = Directive::Kind;
  std::array<bool, max_channels> cubemap{};
  for (const PlacedDirective& at : directives)
    if (at.directive.kind == Kind::channel_cubemap)
      cubemap[static_cast<std::size_t>(at.directive.channel)] = at.directive.cubemap;
  for (const PlacedDirective& at : directives) {
    if (at.directive.kind != Kind::channel) continue;
    const auto channel = static_cast<std::size_t>(at.directive.channel);
    Input input = bind_path(context, at, cubemap[channel]);
    const InputKindInfo& kind = info(input.kind);
    input.sampler = host_rules(context.project).editor_samplers ? kind.site_sampler : kind.extension_sampler;
    // A DDS file is not flipped by the extension.
    if (!input.files.empty() && plain_name(input.files[0].extension().string()) == ".dds")
      input.sampler.vflip = false;
    inputs[channel] = std::move(input);
  }
  for (const auto& [directive, file] : directives) {
    Sampler& sampler = inputs[static_cast<std::size_t>(directive.channel)].sampler;
    if (directive.kind == Kind::channel_min) sampler.min = directive.min;
    if (directive.kind == Kind::channel_mag) sampler.mag = directive.mag;
    if (directive.kind == Kind::channel_wrap) sampler.wrap = directive.wrap;
  }
}

PassFlags apply_directives(Project& project, const std::vector<PlacedDirective>& directives) {
  using Kind = Directive::Kind;
  PassFlags flags;
  for (const PlacedDirective& at : directives) {
    const Directive& directive = at.directive;
    if (directive.kind == Kind::keyboard) flags.keyboard = true;
    if (directive.kind == Kind::strict_compatibility) flags.strict = true;
    if (directive.kind == Kind::first_person_controls) project.first_person_controls = true;
    if (directive.kind != Kind::uniform) continue;
    const CustomUniform& uniform = directive.uniform;
    const auto known = std::find_if(project.uniforms.begin(), project.uniforms.end(),
                                    [&](const CustomUniform& other) { return other.name == uniform.name; });
    if (known == project.uniforms.end())
      project.uniforms.push_back(uniform);
    else if (!(*known == uniform))
      fail(ExitStatus::shader, at, "#iUniform " + uniform.name + " is declared differently elsewhere");
  }
  return flags;
}

}  // namespace shadertwin
