// What every stage makes of small shaders, held to files beside them: NAME.expected/ beside NAME.glsl (or the
// folder NAME) has the text of each pass as each device compiles it. With SHADERTWIN_UPDATE_GOLDENS=1 in the
// environment the files are written anew instead; `git diff` then shows what a change of the pipeline or the
// emitter does.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "host/base/error.h"
#include "host/project/project.h"
#include "host/text/define_undefined.h"
#include "host/text/hide_known_values.h"
#include "host/text/load.h"
#include "host/text/make_precise.h"
#include "host/text/render.h"
#include "reference/emit/emit_cpp.h"

namespace shadertwin {
namespace {

namespace fs = std::filesystem;

using Texts = std::map<std::string, std::string>;  // by file name

std::vector<fs::path> shaders() {
  std::vector<fs::path> found;
  for (const char* folder : {"tests/emit/shaders", "tests/text/shaders"})
    for (const auto& entry : fs::directory_iterator(fs::path(SHADERTWIN_SOURCE_DIR) / folder))
      if (entry.path().extension() == ".glsl" || fs::exists(entry.path() / "image.glsl"))
        found.push_back(fs::relative(entry.path(), SHADERTWIN_SOURCE_DIR));
  std::sort(found.begin(), found.end());
  return found;
}

template <typename Make>
void add(Texts& texts, const std::string& name, const Make& make) {
  try {
    texts[name] = make();
  } catch (const Error& error) {
    texts[name] = std::string("refused: ") + error.what() + '\n';
  }
}

std::string plain(std::string name) {
  std::erase(name, ' ');
  return name;
}

Texts texts_of(const fs::path& shader) {
  const Project project = load_project(shader);
  Texts texts;
  for (const Pass& pass : project.passes) {
    const PassSource defined = define_undefined(project, pass.source).value();
    const std::string stem = project.passes.size() == 1 ? "" : plain(pass.name) + ".";
    add(texts, stem + "webgl.frag", [&] { return render(pass.source); });
    add(texts, stem + "es300.frag", [&] { return render(defined); });
    add(texts, stem + "es320.frag",
        [&] { return render(make_precise(project, hide_known_values(project, defined))); });
    if (std::string why; can_run_as_compute(pass, &why))
      add(texts, stem + "es310.comp", [&] { return render(defined, ShaderStage::compute); });
    else
      texts[stem + "es310.comp"] = "runs as fragments: " + why + '\n';
    add(texts, stem + "scalar.cpp", [&] { return emit_cpp(project, pass); });
    add(texts, stem + "packets.cpp", [&] { return emit_cpp(project, pass, {.packets = true}); });
  }
  return texts;
}

std::string contents(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

// Where two texts part, for people.
std::string first_difference(const std::string& expected, const std::string& made) {
  std::istringstream a(expected), b(made);
  std::string left, right;
  for (int line = 1;; ++line) {
    const bool more = static_cast<bool>(std::getline(a, left));
    if (!std::getline(b, right)) right = "(end)";
    if (!more) left = "(end)";
    if (left != right || !more) return "line " + std::to_string(line) + "\n  -" + left + "\n  +" + right;
  }
}

class Golden : public testing::TestWithParam<fs::path> {};

TEST_P(Golden, TextsAreAsCommitted) {
  fs::current_path(SHADERTWIN_SOURCE_DIR);  // the names of files stand in the texts
  const fs::path shader = GetParam();
  const fs::path folder = shader.parent_path() / (shader.stem().string() + ".expected");
  const Texts texts = texts_of(shader);
  if (const char* update = std::getenv("SHADERTWIN_UPDATE_GOLDENS"); update != nullptr && *update == '1') {
    fs::remove_all(folder);
    fs::create_directories(folder);
    for (const auto& [name, text] : texts) std::ofstream(folder / name, std::ios::binary) << text;
    return;
  }
  for (const auto& [name, text] : texts)
    EXPECT_TRUE(fs::exists(folder / name) && contents(folder / name) == text)
        << (folder / name) << ": " << first_difference(contents(folder / name), text)
        << "\ntools/update_goldens writes what is made now; read its diff";
  for (const auto& entry : fs::directory_iterator(folder))
    EXPECT_TRUE(texts.contains(entry.path().filename().string())) << entry.path() << " is made no more";
}

INSTANTIATE_TEST_SUITE_P(Shaders, Golden, testing::ValuesIn(shaders()),
                         [](const auto& parameter) { return parameter.param.stem().string(); });

}  // namespace
}  // namespace shadertwin
