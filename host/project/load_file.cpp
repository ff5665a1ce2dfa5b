#include <algorithm>
#include <map>

#include "host/project/channels.h"
#include "host/project/load.h"
#include "host/project/text_file.h"
#include "host/project/vertex_text.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

class FileLoader {
 public:
  FileLoader(fs::path root, const LoadOptions& options)
      : root_(std::move(root)), options_(options), texts_(project_, root_) {
    project_.dialect = options.dialect.value_or(Dialect::vscode);
    project_.local = true;
  }

  Project load() {
    const int root = visit(root_);
    passes_[static_cast<std::size_t>(root)].kind = PassKind::image;
    put_in_order();
    const bool keyboard =
        std::any_of(flags_.begin(), flags_.end(), [](const PassFlags& f) { return f.keyboard; });
    for (std::size_t i = 0; i < project_.passes.size(); ++i) {
      project_.passes[i].strict = flags_[static_cast<std::size_t>(order_[i])].strict;
      project_.passes[i].keyboard = keyboard;
    }
    return std::move(project_);
  }

 private:
  // Depth first over the channels: a pass is drawn after all that it reads, except where they read each
  // other.
  int visit(const fs::path& file) {
    const fs::path key = identity(file);
    if (const auto known = visited_.find(key); known != visited_.end()) return known->second;
    const int index = static_cast<int>(passes_.size());
    visited_[key] = index;
    passes_.emplace_back();
    flags_.emplace_back();

    Pass pass;
    pass.name = unique_name(file.stem().string());
    names_.push_back(pass.name);
    pass.kind = PassKind::buffer;
    Body body;
    body.append(to_text(options_.settings.defines), -1, 0);
    const std::size_t code = body.size();
    std::vector<PlacedDirective> directives;
    texts_.append(file, body, directives);
    pass.code = body.text().substr(code);
    flags_[static_cast<std::size_t>(index)] = apply_directives(project_, directives);
    bind_channels(
        {.project = project_,
         .pass_file = file,
         .root = root_,
         .self = index,
         .find_pass = [this](const fs::path& other, const PlacedDirective&) { return visit(other); }},
        directives, pass.inputs);
    if (const auto vertex = find_vertex(project_, directives))
      pass.vertex = load_vertex(project_, texts_, *vertex, root_, options_);
    pass.source.body = body.text();
    pass.source.lines = body.lines();
    passes_[static_cast<std::size_t>(index)] = std::move(pass);
    order_.push_back(index);
    return index;
  }

  void put_in_order() {
    std::vector<int> place(passes_.size());
    for (std::size_t i = 0; i < order_.size(); ++i)
      place[static_cast<std::size_t>(order_[i])] = static_cast<int>(i);
    for (const int index : order_) {
      project_.passes.push_back(std::move(passes_[static_cast<std::size_t>(index)]));
      for (Input& input : project_.passes.back().inputs)
        if (input.pass >= 0) input.pass = place[static_cast<std::size_t>(input.pass)];
    }
  }

  std::string unique_name(const std::string& stem) const {
    std::string name = stem;
    for (int i = 2; std::find(names_.begin(), names_.end(), name) != names_.end(); ++i)
      name = stem + " " + std::to_string(i);
    return name;
  }

  Project project_;
  fs::path root_;
  const LoadOptions& options_;
  TextLoader texts_;
  std::vector<Pass> passes_;  // in the order in which they were found
  std::vector<PassFlags> flags_;
  std::vector<std::string> names_;
  std::vector<int> order_;
  std::map<fs::path, int> visited_;
};

}  // namespace

Project read_file(const fs::path& file, const LoadOptions& options) {
  return FileLoader(file, options).load();
}

}  // namespace shadertwin
