#include "host/text/render.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "host/text/load.h"
#include "tests/project/temp_folder.h"

namespace shadertwin {
namespace {

Pass load_pass(const std::string& text) {
  const TempFolder folder;
  return load_project(folder.write("a.glsl", text)).passes[0];
}

TEST(RenderForCompute, MovesNoLine) {
  const Pass pass = load_pass("int x;\n" + std::string(empty_image));
  const std::string text = render(pass.source, ShaderStage::compute);
  const auto lines_before = [](const std::string& whole) {
    return std::count(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.find("int x;")), '\n');
  };
  EXPECT_EQ(lines_before(text), lines_before(render(pass.source)));
}

TEST(RenderForCompute, ReplacesWhatFragmentsHave) {
  const Pass pass = load_pass("void main() { gl_FragColor = gl_FragCoord; }\n");
  const std::string text = render(pass.source, ShaderStage::compute);
  EXPECT_TRUE(text.starts_with("#version 310 es\n"));
  EXPECT_NE(text.find("local_size_x = 8, local_size_y = 8"), std::string::npos);
  EXPECT_NE(text.find("void shadertwin_main() { shadertoy_out_color = shadertwin_frag_coord; }"),
            std::string::npos);
  EXPECT_EQ(text.find("out vec4"), std::string::npos);
}

TEST(CanRunAsCompute, SaysWhatIsInTheWay) {
  const auto reason = [](const std::string& text) {
    std::string why;
    EXPECT_FALSE(can_run_as_compute(load_pass(text), &why));
    return why;
  };
  const auto with = [](const std::string& statement) {
    return "void mainImage(out vec4 o, vec2 p) { " + statement + " }";
  };
  EXPECT_EQ(reason(with("o = dFdx(p).xxxx;")), "the shader uses dFdx");
  EXPECT_EQ(reason(with("o = fwidth(p).xxxx;")), "the shader uses fwidth");
  EXPECT_EQ(reason(with("discard;")), "the shader uses discard");
  EXPECT_EQ(reason("out vec4 mine; void main() { mine = vec4(1.0); }"), "the shader declares its own output");
  EXPECT_EQ(reason("#iChannel0 \"self\"\n#iChannel0::MinFilter \"LinearMipMapLinear\"\n" +
                   with("o = texture(iChannel0, p);")),
            "the shader uses texture on an input with mipmaps");
}

TEST(CanRunAsCompute, AcceptsWhatComputeCanDo) {
  EXPECT_TRUE(can_run_as_compute(load_pass(empty_image)));
  EXPECT_TRUE(can_run_as_compute(load_pass("// dFdx discard\n" + std::string(empty_image))));
  EXPECT_TRUE(can_run_as_compute(
      load_pass("#iChannel0 \"self\"\nvoid mainImage(out vec4 o, vec2 p) { o = texture(iChannel0, p); }")));
  EXPECT_TRUE(can_run_as_compute(
      load_pass("#iChannel0 \"self\"\n#iChannel0::MinFilter \"LinearMipMapLinear\"\n"
                "void mainImage(out vec4 o, vec2 p) { o = textureLod(iChannel0, p, 2.0); }")));
}

}  // namespace
}  // namespace shadertwin
