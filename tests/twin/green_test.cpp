// Small shaders and projects that paint green where the answer is right and red where it is not, on every
// player.
#include <filesystem>

#include "host/base/error.h"
#include "host/text/load.h"
#include "tests/twin/every_player.h"

namespace shadertwin {
namespace {

namespace fs = std::filesystem;

class Green : public OnEveryPlayer {};

TEST_P(Green, EveryPixel) {
  int count = 0;
  for (const auto& entry :
       fs::directory_iterator(fs::path(SHADERTWIN_SOURCE_DIR) / "tests/emit/shaders/green")) {
    for (const bool precise : {false, true}) {
      SCOPED_TRACE(entry.path().filename().string() + (precise ? " --precise" : ""));
      ++count;
      LoadOptions options;
      options.dialect = Dialect::shadertoy;
      options.settings.precise = precise;
      try {
        const Image image = pictures(load_project(entry.path(), options), 1, 64, 8).back();
        int wrong = 0;
        for (int y = 0; y < image.height; ++y)
          for (int x = 0; x < image.width; ++x) wrong += pixel(image, x, y) != glm::vec4(0, 1, 0, 1);
        EXPECT_EQ(wrong, 0) << "of " << image.width * image.height << " pixels";
      } catch (const Error& error) {
        ADD_FAILURE() << error.what();
      }
    }
  }
  EXPECT_GT(count, 0);
}

SHADERTWIN_ON_EVERY_PLAYER(Green);

}  // namespace
}  // namespace shadertwin
