// Names that mean something to C++, to its headers, to the system's and to the twin's own, as names of
// everything: browsers take them all.
#include <fstream>
#include <sstream>

#include "host/base/error.h"
#include "host/text/load.h"
#include "tests/twin/every_player.h"

namespace shadertwin {
namespace {

class Names : public OnEveryPlayer {
 protected:
  // Declares every name of names.txt by `declaration` in front of mainImage() and adds `use` up, with `$` for
  // the name and `%` for a number of its own; every use gives that number.
  void expect_green(const std::string& declaration, const std::string& use) const {
    std::ifstream in(std::filesystem::path(SHADERTWIN_SOURCE_DIR) / "tests/twin/names.txt");
    std::string declarations;
    std::string uses;
    int sum = 0;
    int count = 0;
    for (std::string name; in >> name; ++count) {
      const int number = count % 7;
      declarations += with(declaration, name, number);
      uses += with(use, name, number);
      sum += number;
    }
    ASSERT_GT(count, 100);
    const std::string text =
        declarations + "void mainImage(out vec4 o_, vec2 p_) {\n  float sum_ = floor(p_.x * 1e-6);\n" + uses +
        "  o_ = sum_ == " + std::to_string(sum) + ".0 ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);\n}\n";
    LoadOptions options;
    options.dialect = Dialect::shadertoy;
    try {
      const Image image = pictures(load_project(folder.write("a.glsl", text), options), 1).back();
      EXPECT_EQ(pixel(image), glm::vec4(0, 1, 0, 1));
    } catch (const Error& error) {
      FAIL() << error.what();
    }
  }

 private:
  static std::string with(const std::string& pattern, const std::string& name, int number) {
    std::string text;
    for (const char c : pattern) {
      if (c == '$')
        text += name;
      else if (c == '%')
        text += std::to_string(number);
      else
        text += c;
    }
    return text + '\n';
  }
};

TEST_P(Names, OfVariables) {
  expect_green("float $ = %.0;", "  sum_ += $; { float $ = sum_; $ += 1.0; }");
}

TEST_P(Names, OfFunctionsAndParameters) {
  expect_green("float $(float $) { return $ + %.0; }", "  sum_ += $(0.0);");
}

TEST_P(Names, OfStructuresAndMembers) {
  expect_green("struct $ { float $; };", "  sum_ += $(%.0).$;");
}

TEST_P(Names, OfMacros) {
  expect_green("", "#define $ %.0\n  sum_ += $;\n#undef $");
}

SHADERTWIN_ON_EVERY_PLAYER(Names);

}  // namespace
}  // namespace shadertwin
