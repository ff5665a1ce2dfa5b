#include "host/gl/context.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <thread>

#include "host/base/error.h"
#include "tests/skip.h"

namespace shadertwin::gl {
namespace {

TEST(Context, EglAndOsmesaLiveSideBySide) {
  SHADERTWIN_NEEDS_OSMESA();
  const auto egl = open_context("egl");
  const auto osmesa = open_context("osmesa");
  for (int i = 0; i < 3; ++i) {
    egl->make_current();
    EXPECT_EQ(reinterpret_cast<const char*>(egl->functions().GetString(GL_VERSION)), egl->info().version);
    osmesa->make_current();
    EXPECT_EQ(reinterpret_cast<const char*>(osmesa->functions().GetString(GL_VERSION)),
              osmesa->info().version);
  }
  EXPECT_NE(egl->info().version, osmesa->info().version);
}

TEST(Context, ReleasedContextMovesToAnotherThread) {
  for (const std::string& name : with_osmesa({"egl"})) {
    std::unique_ptr<Context> context;
    std::thread([&] {
      context = open_context(name);
      context->release();
    }).join();
    context->make_current();
    EXPECT_EQ(reinterpret_cast<const char*>(context->functions().GetString(GL_VERSION)),
              context->info().version)
        << name;
  }
}

TEST(Context, ListsWhatItCanOpenByThoseNames) {
  const auto devices = list_devices();
  ASSERT_GE(devices.size(), with_osmesa({"egl"}).size());
  EXPECT_EQ(devices.front().name, "egl:0");
  EXPECT_EQ(devices.back().name == "osmesa", has_osmesa());
  for (const DeviceInfo& device : devices) {
    EXPECT_EQ(open_context(device.name)->info().renderer, device.renderer);
    EXPECT_GE(device.max_size, 2048);
    EXPECT_FALSE(device.vendor.empty());
  }
}

TEST(Context, LlvmpipeIsOnTheProcessorWhateverElseThereIs) {
  const DeviceInfo device = open_context("llvmpipe")->info();
  EXPECT_TRUE(device.software);
  EXPECT_TRUE(device.renderer.starts_with("llvmpipe")) << device.renderer;
  EXPECT_TRUE(device.name.starts_with("egl:")) << device.name;
}

// A variable of the environment, as it was at the end.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* text = std::getenv(name)) before_ = text;
    setenv(name, value, 1);
  }
  ~Variable() {
    if (before_)
      setenv(name_, before_->c_str(), 1);
    else
      unsetenv(name_);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

TEST(Context, TheEnvironmentNamesTheDeviceOfAuto) {
  SHADERTWIN_NEEDS_OSMESA();
  const Variable device("SHADERTWIN_DEVICE", "osmesa");
  EXPECT_EQ(open_context("auto")->info().name, "osmesa");
  EXPECT_TRUE(open_context("egl")->info().name.starts_with("egl:"));
}

ExitStatus status_of(const std::string& name) {
  try {
    open_context(name);
  } catch (const Error& e) {
    return e.status();
  }
  return ExitStatus::done;
}

TEST(Context, RefusesDevicesThatAreNotThere) {
  EXPECT_EQ(status_of("egl:99"), ExitStatus::device);
  EXPECT_EQ(status_of("egl:-1"), ExitStatus::usage);
  EXPECT_EQ(status_of("egl:0x"), ExitStatus::usage);
  EXPECT_EQ(status_of("vulkan"), ExitStatus::usage);
}

}  // namespace
}  // namespace shadertwin::gl
