// What a shader becomes for a driver with faults. tests/emit/shaders/green judges what it draws.
#include "host/text/work_around.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace shadertwin {
namespace {

PassSource source_of(const std::string& body) {
  PassSource source;
  source.body = body;
  return source;
}

bool always(Fault) {
  return true;
}

// Without spaces.
std::string rewritten(const std::string& body) {
  std::string text = work_around(source_of(body), always).body;
  std::erase(text, ' ');
  return text;
}

TEST(WorkAround, WidensWhatIsUnpackedByAFunction) {
  const PassSource result =
      work_around(source_of("void f(uint u) { vec2 v = unpackHalf2x16(u) * 2.0; }\n"), always);
  EXPECT_NE(result.body.find("shadertwin_unpackHalf2x16 ( u )"), std::string::npos) << result.body;
  EXPECT_NE(result.helpers.find("vec2 shadertwin_unpackHalf2x16(uint"), std::string::npos);
}

TEST(WorkAround, LeavesASwitchByBreak) {
  EXPECT_EQ(rewritten("void f() { for (;;) { switch (i) { default: continue; } } }\n"),
            "voidf(){for(;;){{boolshadertwin_continue_11=false;switch(i){default:{shadertwin_continue_11="
            "true;break;}}"
            "if(shadertwin_continue_11&&shadertwin_never==0)continue;}}}\n");
}

TEST(WorkAround, GuardsWhatGoesOnInALoopThatJumpsAtItsEnd) {
  EXPECT_EQ(rewritten("void f() { while (a) { if (b) continue; break; } }\n"),
            "voidf(){while(a){if(b){if(shadertwin_never==0)continue;}break;}}\n");
  EXPECT_EQ(rewritten("void f() { do if (b) continue; else break; while (a); }\n"),
            "voidf(){doif(b){if(shadertwin_never==0)continue;}elsebreak;while(a);}\n");
}

TEST(WorkAround, LeavesOtherLoopsAlone) {
  for (const char* body : {"void f() { for (;;) { if (b) continue; a++; } }\n",
                           "void f() { for (;;) { switch (i) { case 0: a++; break; } break; } }\n"})
    EXPECT_EQ(work_around(source_of(body), always).body, body);
}

TEST(WorkAround, AsksTheDriverOnlyForWhatTheShaderWouldMeet) {
  int asked = 0;
  const auto count = [&asked](Fault) { return ++asked, false; };
  work_around(source_of("void f() { for (;;) { if (b) continue; a++; } }\n"), count);
  EXPECT_EQ(asked, 0);
  const PassSource endangered = source_of("void f() { for (;;) { if (b) continue; break; } }\n");
  EXPECT_EQ(work_around(endangered, count).body, endangered.body);
  EXPECT_EQ(asked, 1);
}

TEST(WorkAround, KeepsEveryLineWhereItWas) {
  const std::string body =
      "\nvoid f()\n{\n  for (;;)\n  {\n    if (b)\n      continue;\n\n    break;\n  }\n}\n";
  const std::string text = rewritten(body);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), std::count(body.begin(), body.end(), '\n'));
}

TEST(WorkAround, ReadsBrokenTexts) {
  const std::string whole =
      "struct S { int a; };\nvoid f() { for (;;) { switch (i) { case 0: { continue; } default: if (a) break; "
      "else { "
      "continue; } } do { if (a) continue; } while (b); break; } }\n";
  for (std::size_t i = 0; i < whole.size(); ++i) {
    rewritten(whole.substr(0, i));
    rewritten(std::string(whole).erase(i, 1));
  }
}

}  // namespace
}  // namespace shadertwin
