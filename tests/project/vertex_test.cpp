#include <gtest/gtest.h>

#include "host/text/load.h"
#include "host/text/map_log.h"
#include "host/text/render.h"
#include "tests/project/temp_folder.h"

namespace shadertwin {
namespace {

constexpr const char* corner = "void main() { gl_Position = vec4(float(gl_VertexID), 0, 0, 1); }\n";

TEST(Vertex, PassHasTheTextThatItNamesWithItsOwnLines) {
  const TempFolder folder;
  folder.write("half.glsl", "const float half_ = 0.5;\n");
  folder.write("v.glsl", std::string("#include \"half.glsl\"\n") + corner);
  const Project project =
      load_project(folder.write("x.glsl", std::string("#iVertex \"file://v.glsl\"\n") + empty_image));
  ASSERT_TRUE(project.passes[0].vertex.has_value());
  const PassSource& vertex = *project.passes[0].vertex;
  EXPECT_NE(vertex.body.find("gl_VertexID"), std::string::npos);
  EXPECT_NE(vertex.head.find("uniform vec3 iResolution;"), std::string::npos);
  EXPECT_EQ(vertex.head.find(" out "), std::string::npos);
  EXPECT_EQ(map_log(project, vertex, "0:" + std::to_string(first_body_line(vertex) + 2) + "(1): error: bad"),
            folder.path().string() + "/v.glsl:2: error: bad");
  EXPECT_TRUE(project.warnings.empty());
}

TEST(Vertex, DefaultIsTheHostsOwn) {
  const TempFolder folder;
  const Project project =
      load_project(folder.write("x.glsl", std::string("#iVertex \"default\"\n") + empty_image));
  EXPECT_FALSE(project.passes[0].vertex.has_value());
}

TEST(Vertex, LastOfSeveralCountsAndItsOwnChannelsDoNot) {
  const TempFolder folder;
  folder.write("a.glsl", corner);
  folder.write("b.glsl", std::string("#iKeyboard\n// b\n") + corner);
  const Project project = load_project(
      folder.write("x.glsl", std::string("#iVertex \"a.glsl\"\n#iVertex \"b.glsl\"\n") + empty_image));
  EXPECT_NE(project.passes[0].vertex->written.find("// b"), std::string::npos);
  EXPECT_FALSE(project.passes[0].keyboard);
  const std::string at = folder.path().string();
  EXPECT_EQ(project.warnings,
            (std::vector<std::string>{
                at + "/x.glsl:1: warning: this #iVertex does not count: there is a later one",
                at + "/b.glsl:1: warning: in a vertex shader no directive counts but #include"}));
}

TEST(Vertex, WhatTheExtensionRefusesIsOneLine) {
  const TempFolder folder;
  folder.write("v.glsl", corner);
  folder.write("v.vert", corner);
  folder.write("empty.glsl", "float f() { return 1.0; }\n");
  const auto error = [&](const std::string& path, ExitStatus status = ExitStatus::shader) {
    return load_error(folder, folder.write("x.glsl", "\n#iVertex \"" + path + "\"\n" + empty_image), status);
  };
  EXPECT_EQ(error("self"), "x.glsl:2: error: #iVertex \"self\": a pass can't be its own vertex shader");
  EXPECT_EQ(error("https://a.b/v.glsl"),
            "x.glsl:2: error: #iVertex \"https://a.b/v.glsl\": nothing is fetched");
  EXPECT_EQ(error("v.vert"), "x.glsl:2: error: #iVertex \"v.vert\": the file must end in .glsl");
  EXPECT_EQ(error("no.glsl", ExitStatus::file), "x.glsl:2: error: can't find \"no.glsl\", the vertex shader");
  EXPECT_EQ(error("empty.glsl"), "empty.glsl:1: error: a vertex shader needs a main()");
  EXPECT_EQ(load_error(folder, folder.path() / "v.glsl", ExitStatus::shader),
            "v.glsl:1: error: this is a vertex shader: a shader that is drawn names it by #iVertex");
}

}  // namespace
}  // namespace shadertwin
