// shadertwin-ulp [DEVICE]: how far an OpenGL device is from the twin's built-in functions, as a Markdown
// table.
#include <cstdio>
#include <exception>

#include "tests/glsl/builtin_cases.h"
#include "tests/glsl/gl_draw.h"

int main(int argc, char** argv) {
  using namespace shadertwin::glsl;
  try {
    GlDraw device(argc > 1 ? argv[1] : "auto");
    const Draw draw = [&device](const std::string& shader, int width, int height) {
      return device(shader, width, height);
    };
    std::printf("%s, %s\n\n%s", device.info().renderer.c_str(), device.info().version.c_str(),
                table_head().c_str());
    for (const auto& cases : {common_cases(), elementary_cases(), vector_cases(), integer_cases()}) {
      for (const BuiltinCase& test : cases) std::printf("%s", table_row(measure(test, draw)).c_str());
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "shadertwin-ulp: %s\n", error.what());
    return 1;
  }
}
