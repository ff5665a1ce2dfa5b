// What hides the values that a compiler would know from it.
#include "host/text/hide_known_values.h"
#include "host/text/load.h"

#include <gtest/gtest.h>

#include "host/text/syntax_tree.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

PassSource hidden(const std::string& statement) {
  const ScratchFolder folder;
  const Project project = load_project(folder.write(
      "shader.glsl",
      "float f(float a) { return a; }\nvoid mainImage(out vec4 c, in vec2 p) {\n" + statement + "\n}\n"));
  const PassSource result = hide_known_values(project, project.passes[0].source);
  EXPECT_NO_THROW(SyntaxTree(project, result, Folding::float32)) << result.helpers << '\n' << result.body;
  return result;
}

// `wanted`: with [x] for the hidden x.
void expect_line(const std::string& statement, std::string wanted) {
  for (std::size_t at = 0; (at = wanted.find_first_of("[]")) != std::string::npos;)
    wanted.replace(at, 1, wanted[at] == '[' ? "uintBitsToFloat(floatBitsToUint(" : ") ^ shadertwin_zero)");
  EXPECT_NE(hidden(statement).body.find(wanted), std::string::npos) << hidden(statement).body;
}

TEST(HideKnownValues, OfEveryArgumentButConstants) {
  expect_line("float a = 0.7; c = vec4(sin(a));", "sin ( [a] )");
  expect_line("c = vec4(atan(p, p.yx), p);", "atan ( [p] , [p . yx] )");
  expect_line("c = vec4(pow(p.x, 2.0));", "pow ( [p . x] , 2.0 )");
  expect_line("c = vec4(exp(f(p.x) * max(p.x, 1.0)));", "exp ( [f ( p . x ) * max ( p . x , 1.0 )] )");
  expect_line("c = cos(sin(vec4(p, 0.0, 1.0)));", "cos ( [sin ( [vec4 ( p , 0.0 , 1.0 )] )] )");
  expect_line("c = vec4(exp(-p.x) + exp((p.x) * p.y));", "exp ( [- p . x] ) + exp ( [( p . x ) * p . y] )");
}

TEST(HideKnownValues, LeavesWhatIsRoundedOnceOrComputedBeforehand) {
  for (const char* statement : {"c = vec4(sqrt(p.x) + floor(p.y) / p.x);", "c = vec4(sin(0.7));",
                                "const float k = exp(0.5); c = vec4(k);"})
    EXPECT_TRUE(hidden(statement).helpers.empty()) << statement;
}

TEST(HideKnownValues, LinesStayWhereTheyWere) {
  expect_line("c =\n  vec4(\n  sin(p.x));", "\nsin ( [p . x] ) ) ;\n");
}

}  // namespace
}  // namespace shadertwin
