// Which operations of a shader call functions of ours, and which are left as they are. What they draw is
// judged by tests/emit/shaders/green on every player.
#include "host/text/define_operations.h"

#include <gtest/gtest.h>

#include "host/text/define_undefined.h"
#include "host/text/load.h"
#include "host/text/make_precise.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

// The pass whose function f(float x, int i, uint u, vec2 v, ivec2 k) has this body.
PassSource defined_source(const std::string& body, const std::string& globals = "") {
  const ScratchFolder folder;
  const Project project = load_project(
      folder.write("shader.glsl", globals + "void f(float x, int i, uint u, vec2 v, ivec2 k) { " + body +
                                      " }\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(0.0); }\n"),
      {.settings = {.undefined = Undefined::raw}});
  return define_undefined(project, project.passes[0].source).value();
}

// What the body becomes, without spaces.
std::string defined(const std::string& body, const std::string& globals = "") {
  std::string text = defined_source(body, globals).body;
  std::erase(text, ' ');
  const std::size_t start = text.find('{', text.find("voidf(")) + 1;
  return text.substr(start, text.find("}\nvoidmainImage") - start);
}

TEST(DefineOperations, CallsFunctionsOfOurs) {
  EXPECT_EQ(defined("x = mod(x, v.x);"), "x=shadertwin_safe_mod(x,v.x);");
  EXPECT_EQ(defined("x = mod(x, 0.0);"), "x=shadertwin_safe_mod(x,0.0);");
  EXPECT_EQ(defined("v = pow(v, vec2(x, 2.0));"), "v=shadertwin_safe_pow(v,vec2(x,2.0));");
  EXPECT_EQ(defined("x = atan(v.y, v.x);"), "x=shadertwin_safe_atan(v.y,v.x);");
  EXPECT_EQ(defined("x = smoothstep(x, x, 0.5);"), "x=shadertwin_safe_smoothstep(x,x,0.5);");
  EXPECT_EQ(defined("i = clamp(i, k.x, 9);"), "i=shadertwin_safe_clamp(i,k.x,9);");
}

TEST(DefineOperations, LeavesWhatCanDoNoHarm) {
  for (const char* body : {"x=mod(x,2.0);",
                           "v=mod(v,vec2(1.0,2.0));",
                           "x=pow(x,0.5);",
                           "x=pow(2.0,x);",
                           "x=atan(x,1.0);",
                           "x=atan(x);",
                           "x=smoothstep(0.0,1.0,x);",
                           "x=smoothstep(1.0,0.0,x);",
                           "x=clamp(x,0.0,1.0);",
                           "i=clamp(i,0,9);",
                           "i=i/2;",
                           "u=u%u;",
                           "u=u/u;",
                           "x=x/2.0;",
                           "x=x/v.x;",
                           "i=i<<i;",
                           "constfloaty=mod(1.0,0.0);",
                           "i=int(u);",
                           "x=float(i);",
                           "constinty=int(3e9);"}) {
    std::string text = body;
    if (const auto at = text.find("const"); at != std::string::npos) text.insert(at + 5, " ");
    for (const char* type : {"float", "int"})
      if (const auto at = text.find(std::string(" ") + type); at != std::string::npos)
        text.insert(at + 1 + std::string(type).size(), " ");
    EXPECT_EQ(defined(text), body);
  }
}

TEST(DefineOperations, FindsTheOperandsOfRemaindersAndQuotients) {
  EXPECT_EQ(defined("i = i % 3;"), "i=shadertwin_safe_modulo(i,3);");
  EXPECT_EQ(defined("i = 1 + i * 2 % 3 - 4;"), "i=1+shadertwin_safe_modulo(i*2,3)-4;");
  EXPECT_EQ(defined("i = -i % -k.x;"), "i=shadertwin_safe_modulo(-i,-k.x);");
  EXPECT_EQ(defined("i = 4 - i % k[0];"), "i=4-shadertwin_safe_modulo(i,k[0]);");
  EXPECT_EQ(defined("i = (i % 3 + 3) % 3;"), "i=shadertwin_safe_modulo((shadertwin_safe_modulo(i,3)+3),3);");
  EXPECT_EQ(defined("i = i % 3 % k.y;"), "i=shadertwin_safe_modulo(shadertwin_safe_modulo(i,3),k.y);");
  EXPECT_EQ(defined("i = i / k.y;"), "i=shadertwin_safe_divide(i,k.y);");
  EXPECT_EQ(defined("if (x > 0.0) i %= x > 1.0 ? 3 : 4; else i++;"),
            "if(x>0.0)shadertwin_safe_modulo_to(i,x>1.0?3:4);elsei++;");
  EXPECT_EQ(defined("k = ivec2(1, 2).yx % k;"), "k=shadertwin_safe_modulo(ivec2(1,2).yx,k);");
}

TEST(DefineOperations, FindsTheArgumentThatIsConverted) {
  EXPECT_EQ(defined("i = int(x);"), "i=int(shadertwin_safe_int(x));");
  EXPECT_EQ(defined("k = ivec2(i, x + 1.0);"), "k=ivec2(i,shadertwin_safe_int(x+1.0));");
  EXPECT_EQ(defined("k = ivec2(v);"), "k=ivec2(shadertwin_safe_int(v));");
  EXPECT_EQ(defined("u = uint(floor(x));"), "u=uint(shadertwin_safe_uint(floor(x)));");
  EXPECT_EQ(defined("i = int(float(int(x)));"),
            "i=int(shadertwin_safe_int(float(int(shadertwin_safe_int(x)))));");
  EXPECT_EQ(defined("u = uint(v[int(x)]);"),
            "u=uint(shadertwin_safe_uint(v[shadertwin_at((int(shadertwin_safe_int(x))),1)]));");
}

TEST(DefineOperations, FindsDivisorsThatACompilerMayKnowToBeZero) {
  const std::string whole = "x=shadertwin_safe_over(x,";
  EXPECT_EQ(defined("x = x / 0.0;"), whole + "0.0);");
  EXPECT_EQ(defined("v = v / vec2(0.0, x);"), "v=shadertwin_safe_over(v,vec2(0.0,x));");
  EXPECT_NE(defined("float z = 0.0; x = x / z;").find(whole), std::string::npos);
  EXPECT_NE(defined("for (int n = 0; n < 3; n++) x = x / float(n);").find(whole), std::string::npos);
  EXPECT_NE(defined("float y = 1.0; x = x / (y - 1.0);").find(whole), std::string::npos);
  EXPECT_EQ(defined("float z = 2.0; x = x / z;"), "floatz=2.0;x=x/z;");
  EXPECT_EQ(defined("float z = x; x = 1.0 / z;"), "floatz=x;x=1.0/z;");
  const std::string globals = "float inverse_of(float a) { return 1.0 / a; }\n";
  EXPECT_NE(defined_source("x = inverse_of(0.0);", globals).body.find("safe_over"), std::string::npos);
  EXPECT_EQ(defined_source("x = inverse_of(x);", globals).body.find("safe_over"), std::string::npos);
}

TEST(DefineOperations, FindsNumeratorsThatACompilerMayKnowToBeZero) {
  EXPECT_EQ(defined("x = 0.0 / x;"), "x=shadertwin_safe_over(0.0,x);");
  EXPECT_EQ(defined("v = vec2(x, 0.0) / v;"), "v=shadertwin_safe_over(vec2(x,0.0),v);");
  EXPECT_EQ(defined("float z = 0.0; z /= x;"), "floatz=0.0;shadertwin_safe_over_to(z,x);");
  EXPECT_EQ(defined("mat2 m = mat2(0.0) / x;"), "mat2m=shadertwin_safe_over(mat2(0.0),x);");
  EXPECT_EQ(defined("x = 0.0 / -2.0 + x;"), "x=0.0/-2.0+x;");
  EXPECT_EQ(defined("float z = 0.0; z /= -2.0;"), "floatz=0.0;shadertwin_safe_over_to(z,-2.0);");
  EXPECT_EQ(defined("for (int n = 0; n < 3; n++) x = float(n) / 3.0;"), "for(intn=0;n<3;n++)x=float(n)/3.0;");
  EXPECT_EQ(defined("float z = 2.0; x = z / x;"), "floatz=2.0;x=z/x;");
}

TEST(DefineOperations, FollowsZerosThroughTheText) {
  const auto defines = [](const std::string& body, const std::string& globals = "") {
    return defined_source(body, globals).body.find("safe_over") != std::string::npos;
  };
  for (const char* body :
       {"float z = x; z = 0.0; x = z / x;", "float z; x = z / x;", "v.x = 0.0; x = v.x / x;",
        "vec2 w = vec2(0.0); w.x = x; v = w / x;", "float z = 1.0; z -= 1.0; x = z / x;",
        "float z = x * 0.0; x = z / x;", "float z = x > 1.0 ? 0.0 : 0.0; x = z / x;",
        "float z = 0.0; for (int n = 0; n < 3; ++n) { x = z / x; z += x; }",
        "for (float n; n < 3.0; ++n) x = x / n;", "float n; x = x / n++;",
        "for (int n = -1; n < 2; ++n) x = x / float(n);", "for (int n = 1; n > -2; --n) x = x / float(n);",
        "float n = -1.0; n += 1.0; x = x / n;", "uint n = 3u; n >>= 2; x = x / float(n);"})
    EXPECT_TRUE(defines(body)) << body;
  for (const char* body :
       {"float z = 0.0; z = x; x = z / x;", "float z = 0.0; z += x; x = z / x;",
        "float z = 0.0; for (int n = 0; n < 3; ++n) z += x; x = z / x;",
        "for (int n = 1; n < 3; ++n) x = x / float(n);", "for (float n; n++ < 3.0;) x = x / n;",
        "float n; x = x / ++n;", "float n = 1.0; n += 0.5; n *= 2.0; x = x / n;"})
    EXPECT_FALSE(defines(body)) << body;
  EXPECT_TRUE(defines("float z; clear(z); x = z / x;", "void clear(out float a) { a = 0.0; }\n"));
  EXPECT_FALSE(defines("float z; fill(z); x = z / x;", "void fill(out float a) { a = iTime; }\n"));
}

TEST(DefineOperations, AddsTheFunctionsThatAreCalled) {
  EXPECT_EQ(defined_source("x += 1.0;").helpers.find("shadertwin"), std::string::npos);
  const std::string helpers = defined_source("v = mod(v, x); v = mod(v, v); v = mod(v, x);").helpers;
  const auto count = [&](const std::string& text) {
    std::size_t found = 0;
    for (std::size_t at = helpers.find(text); at != std::string::npos; at = helpers.find(text, at + 1))
      ++found;
    return found;
  };
  EXPECT_EQ(count("float shadertwin_safe_mod(float x, float y)"), 1U);
  EXPECT_EQ(count("vec2 shadertwin_safe_mod(vec2 a, float b)"), 1U);
  EXPECT_EQ(count("vec2 shadertwin_safe_mod(vec2 a, vec2 b)"), 1U);
  const std::string matrices = defined_source("mat3x2 m = mat3x2(0.0) / x; m /= x;").helpers;
  const std::size_t columns = matrices.find("vec2 shadertwin_safe_over(vec2 a, float b)");
  EXPECT_LT(columns, matrices.find("mat3x2 shadertwin_safe_over(mat3x2 a, float b)"));
  EXPECT_NE(matrices.find("mat3x2 shadertwin_safe_over_to(inout mat3x2 a, float b)"), std::string::npos);
}

TEST(DefineOperations, AreAsPreciseAsTheRest) {
  const ScratchFolder folder;
  const Project project = load_project(
      folder.write("shader.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(mod(p.x, p.y)); }\n"));
  const PassSource defined = define_undefined(project, project.passes[0].source).value();
  EXPECT_NE(make_precise(project, defined).helpers.find("precise float r = mod ( x , y )"),
            std::string::npos);
}

}  // namespace
}  // namespace shadertwin
