#include <algorithm>
#include <array>

#include "host/project/channels.h"
#include "host/project/host_rules.h"
#include "host/project/kinds.h"
#include "host/project/load.h"
#include "host/project/tabs_settings.h"
#include "host/project/text_file.h"
#include "host/project/vertex_text.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

struct Tab {
  std::string name;
  std::string short_stem;  // what the file may be called instead, as plain_name gives it
  PassKind kind = PassKind::image;
};

// In drawing order.
std::vector<Tab> all_tabs() {
  std::vector<PassTraits> kinds(pass_kinds.begin(), pass_kinds.end());
  std::sort(kinds.begin(), kinds.end(), [](const auto& a, const auto& b) { return a.rank < b.rank; });
  std::vector<Tab> tabs;
  for (const PassTraits& kind : kinds)
    for (int i = 0; i < kind.most; ++i) {
      std::string short_stem(kind.short_tab);
      if (kind.most > 1) short_stem += static_cast<char>('a' + i);
      tabs.push_back({tab_name(kind, i), std::move(short_stem), kind.kind});
    }
  return tabs;
}

class FolderLoader {
 public:
  FolderLoader(fs::path folder, const LoadOptions& options)
      : folder_(std::move(folder)), options_(options), texts_(project_, folder_ / "image.glsl") {
    project_.dialect = options.dialect.value_or(Dialect::shadertoy);
    project_.local = host_rules(project_).is_local;
  }

  Project load() {
    list_files();
    const fs::path common = find({"Common", "common"});
    for (const Tab& tab : all_tabs()) {
      if (find(tab).empty()) continue;
      Pass& pass = project_.passes.emplace_back();
      pass.name = tab.name;
      pass.kind = tab.kind;
      files_of_passes_.push_back(find(tab));
    }
    if (project_.passes.empty() || project_.passes.back().kind != PassKind::image)
      throw Error(ExitStatus::file, display_name(folder_) + ": error: the folder has no image.glsl");
    for (std::size_t i = 0; i < project_.passes.size(); ++i) read_tab(static_cast<int>(i), common);
    if (const fs::path settings = folder_ / "shadertoy.json"; fs::exists(settings))
      apply_tabs_settings(settings, project_);
    const bool keyboard =
        std::any_of(flags_.begin(), flags_.end(), [](const PassFlags& f) { return f.keyboard; });
    for (std::size_t i = 0; i < project_.passes.size(); ++i) {
      project_.passes[i].keyboard = keyboard;
      project_.passes[i].strict = flags_[i].strict;
    }
    return std::move(project_);
  }

 private:
  void list_files() {
    std::error_code problem;
    for (fs::directory_iterator entry(folder_, problem), end; !problem && entry != end;
         entry.increment(problem))
      files_.push_back(entry->path());
    if (problem) throw Error(ExitStatus::file, display_name(folder_) + ": error: " + problem.message());
    std::sort(files_.begin(), files_.end());
  }

  // The tab's file; empty if there is none.
  fs::path find(const Tab& tab) const {
    static constexpr std::array<std::string_view, 4> extensions = {".glsl", ".frag", ".fs", ".txt"};
    fs::path found;
    for (const fs::path& file : files_) {
      const std::string stem = plain_name(file.stem().string());
      const std::string extension = plain_name(file.extension().string());
      if (stem != plain_name(tab.name) && stem != tab.short_stem) continue;
      if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end()) continue;
      if (!found.empty())
        throw Error(ExitStatus::file, display_name(file) + ": error: " + display_name(found) +
                                          " is the tab " + tab.name + " already");
      found = file;
    }
    return found;
  }

  void read_tab(int index, const fs::path& common) {
    const fs::path& file = files_of_passes_[static_cast<std::size_t>(index)];
    Pass& pass = project_.passes[static_cast<std::size_t>(index)];
    Body body;
    body.append(to_text(options_.settings.defines), -1, 0);
    std::vector<PlacedDirective> directives;
    if (!common.empty()) {
      const std::size_t start = body.size();
      texts_.append(common, body, directives);
      texts_.skip(common);
      project_.common = body.text().substr(start);
    }
    const std::size_t code = body.size();
    texts_.append(file, body, directives);
    pass.code = body.text().substr(code);
    for (const PlacedDirective& at : directives)
      if (at.directive.channel >= host_rules(project_).channels)
        fail_at(ExitStatus::shader, at.file, at.directive.line, "shadertoy.com has the channels 0 to 3");
    flags_.push_back(apply_directives(project_, directives));
    bind_channels({.project = project_,
                   .pass_file = file,
                   .root = folder_ / "image.glsl",
                   .self = index,
                   .find_pass = [this](const fs::path& other,
                                       const PlacedDirective& at) { return pass_of(other, at); }},
                  directives, pass.inputs);
    if (const auto vertex = find_vertex(project_, directives))
      pass.vertex = load_vertex(project_, texts_, *vertex, folder_ / "image.glsl", options_);
    pass.source.body = body.text();
    pass.source.lines = body.lines();
  }

  int pass_of(const fs::path& file, const PlacedDirective& at) const {
    for (std::size_t i = 0; i < files_of_passes_.size(); ++i)
      if (identity(files_of_passes_[i]) == identity(file)) return static_cast<int>(i);
    fail_at(ExitStatus::shader, at.file, at.directive.line,
            display_name(file) + " is not a tab that can be drawn");
  }

  Project project_;
  fs::path folder_;
  const LoadOptions& options_;
  TextLoader texts_;
  std::vector<fs::path> files_;
  std::vector<fs::path> files_of_passes_;
  std::vector<PassFlags> flags_;
};

}  // namespace

Project read_folder(const fs::path& folder, const LoadOptions& options) {
  return FolderLoader(folder, options).load();
}

}  // namespace shadertwin
