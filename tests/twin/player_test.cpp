// The twin player: regions, timeouts, the cache, and what goes wrong with compilers.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "host/base/error.h"
#include "host/player/fixed_clock.h"
#include "host/text/load.h"
#include "reference/twin/twin_device.h"
#include "tests/scratch_folder.h"

namespace shadertwin::player_test {
namespace {

namespace fs = std::filesystem;

// Sets an environment variable as long as it lives.
class Setting {
 public:
  Setting(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  ~Setting() { before_.empty() ? unsetenv(name_) : setenv(name_, before_.c_str(), 1); }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

 private:
  const char* name_;
  std::string before_;
};

constexpr const char* position = "void mainImage(out vec4 c, in vec2 p) { c = vec4(p, 0.1 * p.x, 1.0); }\n";

class Player : public testing::Test {
 protected:
  Project project(const std::string& text) const { return load_project(folder.write("shader.glsl", text)); }
  static Frame frame(int width = 8, int height = 6) {
    Schedule schedule;
    schedule.width = width;
    schedule.height = height;
    return FixedClock(schedule, host_rules(Dialect::vscode)).next();
  }
  static Image played(const Project& project, const twin::TwinOptions& options = {}) {
    const auto player = twin::make_player(project, options);
    player->render(frame());
    return player->read(0);
  }
  // A cache without twins. The headers that they share, which take longer to compile, are the suite's.
  Setting cache_without_twins() const {
    played(project(position));
    const fs::path fresh = folder.path() / "shadertwin";
    fs::create_directories(fresh);
    for (const auto& entry : fs::directory_iterator(fs::path(std::getenv("XDG_CACHE_HOME")) / "shadertwin"))
      if (entry.is_directory()) fs::create_directory_symlink(entry.path(), fresh / entry.path().filename());
    return {"XDG_CACHE_HOME", folder.path()};
  }
  std::size_t cached_twins() const {
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
      count += entry.path().extension() == ".so" ? 1 : 0;
    return count;
  }

  ScratchFolder folder;
};

TEST_F(Player, ReadsZeroFromABufferThatIsNotThere) {
  Project shader = project(
      "void mainImage(out vec4 c, in vec2 p) { c = vec4(texture(iChannel0, p).a, texture(iChannel1, p).a, 0, "
      "1); }");
  shader.passes[0].inputs[0].kind = InputKind::undrawn;
  const Image image = played(shader);
  EXPECT_EQ(image.at(0, 0)[0], 0.0F);
  EXPECT_EQ(image.at(0, 0)[1], 1.0F);
}

// They don't fit a thread's stack. llvmpipe compiles this for minutes.
TEST_F(Player, LargeVariablesHaveRoom) {
  const Project shader = load_project(fs::path(SHADERTWIN_SOURCE_DIR) / "tests/twin/large_variables.glsl");
  twin::TwinOptions one_by_one;
  one_by_one.packets = false;
  twin::TwinOptions in_doubles;
  in_doubles.double_precision = true;
  for (const twin::TwinOptions& options : {twin::TwinOptions(), one_by_one, in_doubles}) {
    const Image image = played(shader, options);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) EXPECT_EQ(image.at(x, y)[1], 1.0F) << x << ", " << y;
  }
}

TEST_F(Player, DrawsOnlyTheRegion) {
  twin::TwinOptions options;
  options.region = twin::Rectangle{2, 1, 3, 2};
  const Image image = played(project(position), options);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const bool inside = x >= 2 && x < 5 && y >= 1 && y < 3;
      EXPECT_EQ(image.at(x, y)[3], inside ? 1.0F : 0.0F) << x << ", " << y;
    }
  }
}

TEST_F(Player, DoubleTwinKeepsWhatFloatRounds) {
  twin::TwinOptions options;
  options.double_precision = true;
  // 1e-9 beside 0.5 is less than a float's last bit.
  const Project shader =
      project("void mainImage(out vec4 c, in vec2 p) { float x = p.x + 1e-9; c = vec4((x - p.x) * 1e9); }\n");
  EXPECT_EQ(played(shader).rgba[0], 0.0F);
  EXPECT_NEAR(played(shader, options).rgba[0], 1.0F, 1e-6F);
}

TEST_F(Player, EndlessLoopEndsAtTheTimeout) {
  twin::TwinOptions options;
  options.timeout = 0.2;
  const auto player = twin::make_player(project("void mainImage(out vec4 c, in vec2 p) { float x = "
                                                "p.x; while (x > -1.0) x = x * 0.5; c = vec4(x); }\n"),
                                        options);
  try {
    player->render(frame());
    FAIL() << "the loop came to an end";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::failed);
    EXPECT_NE(std::string(error.what()).find("--timeout"), std::string::npos);
  }
}

TEST_F(Player, EndlessLoopInAQuadEndsToo) {
  twin::TwinOptions options;
  options.timeout = 0.2;
  const auto player =
      twin::make_player(project("void mainImage(out vec4 c, in vec2 p) { float x = 1.0; for (;;) { x "
                                "+= dFdx(p.x); if (x < 0.0) break; } c = "
                                "vec4(x); }\n"),
                        options);
  EXPECT_THROW(player->render(frame()), Error);
}

TEST_F(Player, TimeoutLeavesShadersInTimeAlone) {
  twin::TwinOptions options;
  options.timeout = 100;
  EXPECT_EQ(played(project(position), options).rgba, played(project(position)).rgba);
}

TEST_F(Player, EveryTwinIsCompiledOnce) {
  const Setting cache = cache_without_twins();
  const Image first = played(project(position));
  EXPECT_EQ(cached_twins(), 1U);
  const Setting no_compiler("PATH",
                            folder.path());  // the cache alone has to do; CXX names the compiler for its key
  const Setting compiler("CXX", "/usr/bin/c++");
  EXPECT_EQ(played(project(position)).rgba, first.rgba);
  EXPECT_EQ(cached_twins(), 1U);
}

TEST_F(Player, TextsOfTheSameCppAreCompiledOnce) {
  const Setting cache = cache_without_twins();
  const Image first = played(project(position));
  const Setting no_compiler("PATH", folder.path());  // as above
  const Setting compiler("CXX", "/usr/bin/c++");
  EXPECT_EQ(
      played(project("void mainImage(out vec4 c, in vec2 p) { c = (vec4(p, 0.1 * p.x, (1.0))); }\n")).rgba,
      first.rgba);
  EXPECT_EQ(cached_twins(), 2U);  // the cache has it by another name
}

TEST_F(Player, DamagedTwinIsCompiledAgain) {
  const Setting cache = cache_without_twins();
  const Image first = played(project(position));
  for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
    if (entry.path().extension() == ".so") fs::resize_file(entry.path(), 100);
  }
  EXPECT_EQ(played(project(position)).rgba, first.rgba);
}

TEST_F(Player, CacheThatCantBeWrittenIsDoneWithout) {
  const Setting cache("XDG_CACHE_HOME", folder.write("file", "not a folder"));
  EXPECT_EQ(played(project(position)).rgba[3], 1.0F);
}

TEST_F(Player, MissingCompilerIsOneClearLine) {
  const Setting path("PATH", folder.path());
  const Setting compiler("CXX", "");
  try {
    played(project(position));
    FAIL() << "there is a compiler";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::device);
    EXPECT_STREQ(error.what(),
                 "the CPU twin needs a C++ compiler: install g++ or clang++, or name one in CXX");
  }
}

TEST_F(Player, CompilerThatFailsLeavesTheTextAndNamesIt) {
  const Setting cache("XDG_CACHE_HOME", folder.path());
  const fs::path compiler = folder.write("broken", "#!/bin/sh\necho 'x.cpp:1:1: error: no' >&2\nexit 1\n");
  fs::permissions(compiler, fs::perms::owner_all);
  const Setting choice("CXX", compiler);
  try {
    played(project(position));
    FAIL() << "the compiler works";
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_EQ(error.status(), ExitStatus::shader);
    EXPECT_TRUE(fs::exists(text.substr(0, text.find(':')))) << text;
    EXPECT_NE(text.find("error: no"), std::string::npos) << text;
  }
}

TEST_F(Player, CompilerThatDiesOfAShaderIsAskedForLess) {
  const Setting cache("XDG_CACHE_HOME", folder.path());
  const fs::path compiler = folder.write(
      "fragile",
      "#!/bin/sh\ncase \"$*\" in\n*no-tree-slp-vectorize*|*c++-header*) exec c++ \"$@\" ;;\nesac\n"
      "echo 'x.h:1:1: internal compiler error: Segmentation fault' >&2\nexit 1\n");
  fs::permissions(compiler, fs::perms::owner_all);
  const Setting choice("CXX", compiler);
  EXPECT_EQ(played(project(position)).at(3, 2)[0], 3.5F);
}

TEST_F(Player, RefusedShaderNamesTheUsersLine) {
  try {
    played(project("void mainImage(out vec4 c, in vec2 p) {\n  c = p;\n}\n"));
    FAIL() << "the shader compiles";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::shader);
    EXPECT_NE(std::string(error.what()).find("shader.glsl:2: error: "), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace shadertwin::player_test
