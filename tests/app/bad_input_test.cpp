// Wrong input gets one clear line, the right exit status, and leaves nothing behind.
#include <gtest/gtest.h>

#include "tests/app/command_line.h"

namespace shadertwin {
namespace {

constexpr const char* plain = "void mainImage(out vec4 c, in vec2 p) { c = vec4(p.xyxy); }\n";

class BadInput : public testing::Test {
 protected:
  void SetUp() override {
    folder.write("ok.glsl", plain);
    folder.write("out/.keep", "");
  }

  // Renders `arguments` to out/a.png and expects `status`, one line that holds every one of `words`, and no
  // file.
  void expect(int status, const std::string& arguments, const std::vector<std::string>& words,
              const std::string& before = "") {
    const Outcome outcome = run(folder, "render " + arguments + " -o out/a.png", before);
    EXPECT_EQ(outcome.status, status) << arguments << '\n' << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1) << arguments << '\n' << outcome.err;
    EXPECT_EQ(outcome.out, "");
    for (const std::string& word : words)
      EXPECT_NE(outcome.err.find(word), std::string::npos)
          << arguments << ": no '" << word << "' in " << outcome.err;
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder / "out")) ++files;
    EXPECT_EQ(files, 1U) << arguments << " left something behind";
  }

  ScratchFolder folder;
};

TEST_F(BadInput, CommandLine) {
  expect(2, "ok.glsl --size 0x0", {"--size 0x0"});
  expect(2, "ok.glsl --size 100000x100000", {"--size 100000x100000", "65536"});
  expect(2, "ok.glsl --size 20000x2", {"16384"});
  expect(2, "ok.glsl --size 12", {"WIDTHxHEIGHT"});
  expect(2, "ok.glsl --size -1x5", {"--size"});
  expect(2, "ok.glsl --frames -1", {"--frames"});
  expect(2, "ok.glsl --frames 0", {"--frames"});
  expect(2, "ok.glsl --frames many", {"--frames"});
  expect(2, "ok.glsl --fps 0", {"--fps"});
  expect(2, "ok.glsl --time nan", {"--time"});
  expect(2, "ok.glsl --date tomorrow", {"--date tomorrow"});
  expect(2, "ok.glsl --mouse 3", {"--mouse 3"});
  expect(2, "ok.glsl --keys q,nokey", {"nokey"});
  expect(2, "ok.glsl --keys q@5-4", {"q@5-4"});
  expect(2, "ok.glsl --keys q@5-", {"q@5-"});
  expect(2, "ok.glsl -D '3=4'", {"-D 3=4"});
  expect(2, "ok.glsl --seed x", {"--seed x"});
  expect(2, "ok.glsl --nonsense", {"--nonsense"});
  expect(2, "ok.glsl --on vulkan", {"vulkan"});
  expect(2, "ok.glsl --on egl/quick", {"/fragment or /compute"});
  expect(5, "ok.glsl --on egl:99", {"egl:99"});
  expect(2, "ok.glsl --on cpu/quick", {"cpu/double"});
  expect(2, "ok.glsl --on cpu --tile 1,2,3", {"--tile 1,2,3"});
  expect(2, "ok.glsl --on egl --tile 1,2,3,4", {"--tile"});
  EXPECT_EQ(run(folder, "render").status, 2);
  EXPECT_EQ(run(folder, "").status, 2);
  EXPECT_EQ(run(folder, "dance").status, 2);
  EXPECT_EQ(run(folder, "render ok.glsl").status, 2);
  EXPECT_EQ(run(folder, "--help").status, 0);
  EXPECT_EQ(run(folder, "render --help").status, 0);
}

TEST_F(BadInput, Shaders) {
  folder.write("brace.glsl", "float f(float x) {\n  if (x > 0.5) { return x;\n}\n" + std::string(plain));
  for (const std::string& on : with_osmesa({"llvmpipe/fragment", "llvmpipe/compute", "cpu", "cpu/double"}))
    expect(3, "brace.glsl --on " + on, {"brace.glsl:4: error:"});
  expect(4, "none.glsl", {"none.glsl"});
  expect(4, "out", {"image.glsl"});
  folder.write("missing.glsl", std::string("#include \"gone.glsl\"\n") + plain);
  expect(4, "missing.glsl", {"missing.glsl:1", "gone.glsl"});
  folder.write("cycle.glsl", std::string("#include \"other.glsl\"\n") + plain);
  folder.write("other.glsl", "#include \"cycle.glsl\"\n");
  expect(3, "cycle.glsl", {"other.glsl:1", "cycle.glsl"});
  folder.write("directive.glsl", std::string("\n#iChannel0 nothing\n") + plain);
  expect(3, "directive.glsl", {"directive.glsl:2"});
  folder.write("nomain.glsl", "float f() { return 1.; }\n");
  expect(3, "nomain.glsl", {"nomain.glsl", "main"});
  folder.write("syntax.glsl", "void mainImage(out vec4 c, in vec2 p) {\n c = unknown;\n}\n");
  expect(3, "syntax.glsl", {"syntax.glsl:2: error:", "unknown"});
}

// What browsers refuse before a compiler sees it, and compilers here would crash or never end on.
TEST_F(BadInput, ShadersThatAreTooLarge) {
  const auto image = [this](const std::string& name, const std::string& globals, const std::string& body) {
    folder.write(name, globals + "void mainImage(out vec4 c, in vec2 p) {\n" + body + "c = vec4(x);\n}\n");
  };
  const std::string index = "int n = int(p.x);\n";
  image("local.glsl", "", "float a[140000];\n" + index + "a[n] = 1.; float x = a[n];\n");
  image("global.glsl", "const int size = 400;\nvec4 a[size * size];\n",
        index + "a[n] = vec4(1.); float x = a[n].x;\n");
  image("struct.glsl", "struct S { mat4 m[40]; }; struct T { S s[40]; };\n",
        "T t;\n" + index + "t.s[n].m[n][0][0] = 1.; float x = t.s[n].m[n][0][0];\n");
  std::string many;
  for (int i = 0; i < 300; ++i) many += "float a" + std::to_string(i) + "[16000];\n";
  std::string uses = index + "float x = 0.;\n";
  for (int i = 0; i < 300; ++i) uses += "a" + std::to_string(i) + "[n] = 1.;\n";
  image("many.glsl", many, uses);
  std::string terms = "float x = p.x";
  for (int i = 0; i < 20000; ++i) terms += "+p.x";
  image("terms.glsl", "", terms + ";\n");
  for (const char* on :
       {"--on llvmpipe", "--on llvmpipe --init raw", "--on llvmpipe --precise", "--on cpu"}) {
    expect(3, std::string("local.glsl ") + on, {"local.glsl:2: error: 'a' has 64 KB or more"});
    expect(3, std::string("global.glsl ") + on, {"global.glsl:2: error: 'a' has 64 KB or more"});
    expect(3, std::string("struct.glsl ") + on, {"struct.glsl:3: error: 't' has 64 KB or more"});
    expect(3, std::string("many.glsl ") + on, {"error: the variables of the shader have more than 16 MB"});
    expect(3, std::string("terms.glsl ") + on, {"terms.glsl:2: error: ", "nested more than 4000 deep"});
  }
}

TEST_F(BadInput, Pictures) {
  const auto shader = [&](const std::string& name) {
    folder.write("t.glsl", "#iChannel0 \"" + name + "\"\n" + plain);
    return std::string("t.glsl");
  };
  expect(4, shader("gone.png"), {"gone.png"});
  folder.write("text.png", "this is not a picture");
  expect(4, shader("text.png"), {"text.png"});
  folder.write("empty.png", "");
  expect(4, shader("empty.png"), {"empty.png"});
  ASSERT_EQ(run(folder, "render ok.glsl --size 64x64 -o whole.png").status, 0);
  folder.write("cut.png", contents(folder / "whole.png").substr(0, 150));
  expect(4, shader("cut.png"), {"cut.png"});
  // A header that promises 65,536 columns.
  std::string wide = contents(folder / "whole.png");
  wide.replace(16, 4, std::string("\0\1\0\0", 4));
  folder.write("wide.png", wide);
  expect(4, shader("wide.png"), {"wide.png"});
  for (const char* face : {"px", "nx", "py", "ny", "pz"})
    std::filesystem::copy_file(folder / "whole.png", folder / ("cube_" + std::string(face) + ".png"));
  folder.write("t.glsl", std::string("#iChannel0 \"cube_{}.png\"\n#iChannel0::Type \"CubeMap\"\n") + plain);
  const Outcome five = run(folder, "render t.glsl -o out/a.png");
  EXPECT_EQ(five.status, 4);
  EXPECT_EQ(five.error_lines(), 1) << five.err;
  EXPECT_NE(five.err.find("cube_nz.png"), std::string::npos) << five.err;
}

TEST_F(BadInput, OutputPlaces) {
  const auto outcome = [&](const std::string& output, const std::string& before = "") {
    return run(folder, "render ok.glsl --size 64x36 -o " + output, before);
  };
  EXPECT_EQ(outcome("a.bmpx").status, 2);
  EXPECT_EQ(outcome("noextension").status, 2);
  EXPECT_EQ(outcome("nowhere/a.png").status, 4);
  EXPECT_EQ(outcome("a_%d_%d.png").status, 2);
  std::filesystem::create_directory(folder / "folder.png");
  EXPECT_EQ(outcome("folder.png").status, 4);
  // A disk that fills up, as a limit on the size of a file shows it: the old picture survives.
  ASSERT_EQ(outcome("a.exr").status, 0);
  const std::string before = contents(folder / "a.exr");
  const Outcome full = run(folder, "render ok.glsl --size 640x360 -o a.exr", "trap '' XFSZ; ulimit -f 8;");
  EXPECT_EQ(full.status, 4) << full.err;
  EXPECT_EQ(full.error_lines(), 1) << full.err;
  EXPECT_EQ(contents(folder / "a.exr"), before);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    EXPECT_FALSE(entry.path().filename().string().starts_with(".a")) << entry.path();
}

TEST_F(BadInput, AFullDiskBehindStandardOutput) {
  for (const std::string command : {"sweep ok.glsl --on cpu --size 8x8 --runs 1", "sweep --help"}) {
    const Outcome outcome = run(folder, command + " >/dev/full 2>err; echo $?");
    EXPECT_EQ(outcome.out, "4\n") << command;
    EXPECT_EQ(contents(folder / "err"), "shadertwin: standard output: can't be written\n") << command;
  }
}

TEST_F(BadInput, NoOpenGlAtAll) {
  // Libraries of those names that are no libraries, found first.
  folder.write("broken/libEGL.so.1", "nothing");
  folder.write("broken/libOSMesa.so.8", "nothing");
  const std::string hide = "env -u SHADERTWIN_DEVICE LD_LIBRARY_PATH='" + (folder / "broken").string() + "'";
  expect(5, "ok.glsl", {"libEGL", "libOSMesa", "apt install"}, hide);
  expect(5, "ok.glsl --on egl", {"libEGL"}, hide);
  expect(5, "ok.glsl --on osmesa", {"libOSMesa"}, hide);
  if (!has_osmesa()) return;
  // One of the two is enough.
  folder.write("half/libEGL.so.1", "nothing");
  const Outcome osmesa = run(folder, "render ok.glsl -o a.png",
                             "env -u SHADERTWIN_DEVICE LD_LIBRARY_PATH='" + (folder / "half").string() + "'");
  EXPECT_EQ(osmesa.status, 0) << osmesa.err;
}

}  // namespace
}  // namespace shadertwin
