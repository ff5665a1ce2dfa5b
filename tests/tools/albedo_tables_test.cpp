// The albedo tables that are committed are those that the tool prints.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

namespace {

std::string output_of(const char* command) {
  std::string text;
  std::FILE* const pipe = popen(command, "r");
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
    text.append(buffer.data(), count);
  EXPECT_EQ(pclose(pipe), 0);
  return text;
}

TEST(AlbedoTables, StandInCommonAsTheToolPrintsThem) {
  std::stringstream common;
  common << std::ifstream(SHADERTWIN_SOURCE_DIR "/shadertoy/common.glsl").rdbuf();
  const std::string printed = output_of(ALBEDO_TABLES " 2>/dev/null");
  int tables = 0;
  for (std::size_t start = 0; start < printed.size(); ++tables) {
    const std::size_t end = printed.find(");\n", start) + 3;
    const std::string table = printed.substr(start, end - start);
    EXPECT_NE(common.str().find(table), std::string::npos) << table.substr(0, table.find('\n'));
    start = end;
  }
  EXPECT_EQ(tables, 3);
}

}  // namespace
