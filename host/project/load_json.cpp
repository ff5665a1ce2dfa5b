#include <algorithm>
#include <array>
#include <set>

#include "host/base/error.h"
#include "host/project/body.h"
#include "host/project/host_rules.h"
#include "host/project/json_inputs.h"
#include "host/project/json_text.h"
#include "host/project/kinds.h"
#include "host/project/load.h"
#include "host/project/text_file.h"
#include "host/project/text_loader.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t max_passes = 32;

class JsonLoader {
 public:
  JsonLoader(const fs::path& file, const LoadOptions& options)
      : name_(display_name(file)),
        options_(options),
        media_(options.media.empty() ? fs::absolute(file).parent_path() : options.media),
        text_(read_text(file)) {
    project_.dialect = options.dialect.value_or(Dialect::shadertoy);
    project_.local = host_rules(project_).is_local;
    if (!fs::is_directory(media_))
      throw Error(ExitStatus::file, media_.string() + ": error: the media folder is not there");
  }

  Project load() {
    const Json document = parse_json(text_, name_);
    const Json& shader = find_shader(document);
    if (const auto info = shader.find("info"); info != shader.end() && info->is_object())
      project_.title = text_member(*info, "name");
    const Json& passes = need_array(member(shader, "renderpass"), name_, "renderpass");
    if (passes.size() > max_passes) fail("there are " + std::to_string(passes.size()) + " passes");
    for (const Json& pass : passes) add_pass(need_object(pass, name_, "a pass"));
    put_in_order();
    bind_inputs();
    for (Parsed& parsed : parsed_) finish(parsed);
    project_.json = text_;
    return std::move(project_);
  }

 private:
  struct Parsed {
    Pass pass;
    JsonPass ids;
    const Json* json = nullptr;
  };

  [[noreturn]] void fail(const std::string& message) const {
    throw Error(ExitStatus::file, name_ + ": error: " + message);
  }
  const Json& member(const Json& object, const char* key) const {
    const auto found = object.find(key);
    if (found == object.end()) fail(std::string("there is no \"") + key + "\"");
    return *found;
  }
  static std::string text_member(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : "";
  }

  const Json& first_of(const Json& shaders) {
    need_array(shaders, name_, "shaders");
    if (shaders.empty()) fail("there is no shader");
    const Json& first = need_object(shaders.front(), name_, "a shader");
    if (shaders.size() > 1)
      project_.warnings.push_back(name_ + ": warning: the first of " + std::to_string(shaders.size()) +
                                  " shaders is taken");
    return first;
  }

  const Json& find_shader(const Json& document) {
    if (document.is_array()) return first_of(document);
    if (!document.is_object()) fail("the document is no shader");
    if (const auto error = document.find("Error"); error != document.end() && error->is_string())
      fail("this is Shadertoy's answer \"" + error->get<std::string>() + "\", no shader");
    if (const auto shader = document.find("Shader"); shader != document.end())
      return need_object(*shader, name_, "Shader");
    if (const auto shaders = document.find("shaders"); shaders != document.end()) return first_of(*shaders);
    if (document.contains("renderpass")) return document;
    fail("there is no shader: neither \"Shader\" nor \"shaders\" nor \"renderpass\"");
  }

  void add_pass(const Json& json) {
    const std::string type = need_string(member(json, "type"), name_, "a pass's type");
    const std::string code = unix_text(need_string(member(json, "code"), name_, "a pass's code"));
    if (type == "common") {
      common_.push_back(code);
      return;
    }
    Parsed parsed;
    parsed.json = &json;
    parsed.pass.code = code;
    parsed.pass.tab = static_cast<int>(parsed_.size());
    const auto known = std::find_if(pass_kinds.begin(), pass_kinds.end(),
                                    [&](const PassTraits& kind) { return kind.name == type; });
    if (known == pass_kinds.end()) fail("a pass has the unknown type \"" + type + "\"");
    parsed.pass.kind = known->kind;
    parsed.ids = identify(json, *known, name_);
    parsed_.push_back(std::move(parsed));
  }

  // Sound, buffers as they stand, cubemap, image.
  void put_in_order() {
    const auto rank = [](const Parsed& parsed) { return traits(parsed.pass).rank; };
    std::stable_sort(parsed_.begin(), parsed_.end(),
                     [&](const Parsed& a, const Parsed& b) { return rank(a) < rank(b); });
    const auto count = [&](PassKind kind) {
      return std::count_if(parsed_.begin(), parsed_.end(),
                           [&](const Parsed& p) { return p.pass.kind == kind; });
    };
    if (count(PassKind::image) != 1)
      throw Error(ExitStatus::shader, name_ + ": error: there are " + std::to_string(count(PassKind::image)) +
                                          " image passes, not one");
    for (const PassTraits& kind : pass_kinds)
      if (kind.most == 1 && count(kind.kind) > 1)
        fail("there are two passes of a kind that a shader has once");
    name_passes();
  }

  void name_passes() {
    int next = 0;
    for (Parsed& parsed : parsed_) {
      const PassTraits& kind = traits(parsed.pass);
      int& number = parsed.ids.number;
      if (kind.most > 1) {
        while (is_taken(next)) ++next;
        if (number < 0 || is_taken(number)) number = next;
        taken_.insert(number);
      }
      parsed.pass.name = tab_name(kind, number);
    }
  }
  bool is_taken(int number) const { return taken_.contains(number); }

  void bind_inputs() {
    std::vector<JsonPass> ids;
    for (const Parsed& parsed : parsed_) ids.push_back(parsed.ids);
    JsonInputs inputs(media_, name_, ids, options_.settings.muted, project_.warnings);
    for (Parsed& parsed : parsed_) inputs.bind(*parsed.json, parsed.pass);
    for (Parsed& parsed : parsed_) project_.passes.push_back(parsed.pass);
  }

  void append(const std::string& text, const std::string& pass, Body& body) {
    const std::string file = name_ + ":" + pass;
    const auto known = std::find(project_.files.begin(), project_.files.end(), file);
    const auto index = static_cast<int>(known - project_.files.begin());
    if (known == project_.files.end()) project_.files.push_back(file);
    body.append(text, index, 1);
    body.break_line();
  }

  void finish(Parsed& parsed) {
    Body body;
    body.append(to_text(options_.settings.defines), -1, 0);
    const std::size_t start = body.size();
    for (std::size_t i = 0; i < common_.size(); ++i)
      append(common_[i], i == 0 ? "Common" : "Common " + std::to_string(i + 1), body);
    project_.common = body.text().substr(start);
    append(parsed.pass.code, parsed.pass.name, body);
    Pass& pass = project_.passes[static_cast<std::size_t>(&parsed - parsed_.data())];
    pass.source.body = body.text();
    pass.source.lines = body.lines();
  }

  std::string name_;
  const LoadOptions& options_;
  fs::path media_;
  std::string text_;
  Project project_;
  std::vector<Parsed> parsed_;
  std::vector<std::string> common_;
  std::set<int> taken_;  // numbers of buffers
};

}  // namespace

Project read_json(const fs::path& file, const LoadOptions& options) {
  return JsonLoader(file, options).load();
}

}  // namespace shadertwin
