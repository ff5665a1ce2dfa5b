// What browsers refuse is found at its line, and what they take is left alone: refused.txt and accepted.txt,
// which tests/web/refused.test.mjs puts to a browser.
#include <gtest/gtest.h>

#include <fstream>

#include "host/base/error.h"
#include "host/text/load.h"
#include "reference/check/rules.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

struct Case {
  std::string text;  // the line of the file
  std::string code;
  std::string words;  // that the finding has to have
  int line = 1;       // where it is wrong
  bool buffer = false;
};

Case make_case(const std::string& text, const std::string& place, std::string code) {
  std::string words;
  if (const std::size_t arrow = code.find("  => "); arrow != std::string::npos) {
    words = code.substr(arrow + 5);
    code.resize(arrow);
  }
  for (std::size_t at = 0; (at = code.find("\\n", at)) != std::string::npos;) code.replace(at, 2, "\n");
  if (place == "in") code = "void mainImage(out vec4 c, in vec2 p) {\n" + code + "\n}\n";
  if (place == "out") code += "\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(p, 0.0, 1.0); }\n";
  const std::size_t mark = code.find("//!");
  const std::size_t end = mark == std::string::npos ? 0 : mark;
  const auto lines =
      static_cast<int>(std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
  return {text, code, words, mark == std::string::npos && place == "in" ? 2 : lines + 1, place == "buffer"};
}

std::vector<Case> read_cases(const std::string& file) {
  std::vector<Case> cases;
  std::ifstream stream(SHADERTWIN_SOURCE_DIR "/tests/check/" + file);
  for (std::string text; std::getline(stream, text);)
    for (const std::string place : {"in", "out", "all", "buffer"})
      if (text.starts_with(place + ": "))
        cases.push_back(make_case(text, place, text.substr(place.size() + 2)));
  return cases;
}

// What a browser says with the finding: `error` of the loader, or a line of `check`, for the tab's own file.
std::vector<check::Finding> findings(const Case& each) {
  const ScratchFolder folder;
  folder.write(each.buffer ? "buffer_a.glsl" : "image.glsl", each.code);
  if (each.buffer) folder.write("image.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }\n");
  LoadOptions options;
  std::vector<check::Finding> found;
  try {
    for (check::Finding& finding : check::read_rules(load_project(folder.path(), options)).findings)
      if (finding.kind == "webgl2") found.push_back(std::move(finding));
  } catch (const Error& error) {
    const std::string text = error.what();
    const std::size_t at = text.find(".glsl:");
    EXPECT_NE(at, std::string::npos) << text;
    found.push_back({text.substr(0, at + 5), std::stoi(text.substr(at + 6)), "webgl2", text});
  }
  return found;
}

TEST(Corpus, WhatBrowsersRefuseIsFoundAtItsLine) {
  const std::vector<Case> cases = read_cases("refused.txt");
  EXPECT_GT(cases.size(), 150U);
  for (const Case& each : cases) {
    const auto found = findings(each);
    std::string all;
    for (const auto& finding : found) all += to_line(finding) + '\n';
    EXPECT_FALSE(each.words.empty()) << each.text;
    EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                            [&](const auto& finding) {
                              return finding.line == each.line &&
                                     finding.text.find(each.words) != std::string::npos;
                            }))
        << each.text << "\nwanted on line " << each.line << ": " << each.words << "\nfound:\n"
        << all;
  }
}

TEST(Corpus, WhatBrowsersTakeIsLeftAlone) {
  const std::vector<Case> cases = read_cases("accepted.txt");
  EXPECT_GT(cases.size(), 40U);
  for (const Case& each : cases)
    for (const auto& finding : findings(each)) ADD_FAILURE() << each.text << '\n' << to_line(finding);
}

}  // namespace
}  // namespace shadertwin
