// A driver is said to have a fault exactly if it draws such shaders wrong as they are written.
#include "host/gl/driver_faults.h"

#include <filesystem>

#include "host/text/load.h"
#include "tests/gl/play.h"

namespace shadertwin {
namespace {

class DriverFaults : public OnEveryDevice {
 protected:
  // Whether the shader of tests/emit/shaders/green paints green.
  bool is_green(const std::string& shader, Undefined undefined) const {
    const std::filesystem::path shaders =
        std::filesystem::path(SHADERTWIN_SOURCE_DIR) / "tests/emit/shaders/green";
    const Project project =
        load_project(shaders / shader, {.settings = {.undefined = undefined}, .dialect = Dialect::shadertoy});
    return pixel(frames(project, 1, small()).back()) == glm::vec4(0, 1, 0, 1);
  }

  static bool shows(Fault fault) {
    const auto context = gl::open_context(GetParam().name);
    context->make_current();
    return gl::shows_fault(context->functions(), fault);
  }
};

TEST_P(DriverFaults, AreFoundOutByTrying) {
  EXPECT_NE(is_green("half-unpacked-in-full.glsl", Undefined::raw), shows(Fault::half_arithmetic));
  EXPECT_NE(is_green("switch-default-continue.glsl", Undefined::raw), shows(Fault::lost_continue));
}

TEST_P(DriverFaults, AreWorkedAround) {
  EXPECT_TRUE(is_green("half-unpacked-in-full.glsl", Undefined::zero));
  EXPECT_TRUE(is_green("switch-default-continue.glsl", Undefined::zero));
}

SHADERTWIN_ON_EVERY_DEVICE(DriverFaults);

}  // namespace
}  // namespace shadertwin
