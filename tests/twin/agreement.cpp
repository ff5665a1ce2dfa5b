#include "tests/twin/agreement.h"

#include <cmath>
#include <exception>
#include <functional>
#include <memory>

#include "host/gl/gl_device.h"
#include "host/player/fixed_clock.h"
#include "host/text/pipeline.h"
#include "reference/twin/twin_device.h"
#include "tests/skip.h"

namespace shadertwin {
namespace {

struct Runner {
  std::string name;
  std::function<std::unique_ptr<Player>()> open;
};

// What `check` runs; it has nothing to say here.
class Silent : public twin::Observer {
  void begin(int, int) override {}
  void found(int, SourceLine, int, int) override {}
  bool wants_values(int, int) override { return false; }
  void value(int, int, SourceLine, const void*, std::size_t) override {}
};

// Texts that the driver refuses must not fall back to others here.
std::unique_ptr<Player> open_gl(const std::string& device, const Project& project) {
  const auto first = [](const Project& p, const Pass& pass, const ShowsFault& shows_fault) {
    return std::vector{driver_sources(p, pass, shows_fault).front()};
  };
  return gl::make_player(gl::open_context(device), project,
                         {.dispatch = gl::Dispatch::fragment, .sources = first});
}

std::vector<Runner> runners(const Project& project, const AgreementOptions& options, Silent& silent) {
  std::vector<Runner> list = {{"llvmpipe", [&] { return open_gl("llvmpipe", project); }}};
  if (options.osmesa && has_osmesa()) list.push_back({"osmesa", [&] { return open_gl("osmesa", project); }});
  const auto twin = [&](const std::string& name, const twin::TwinOptions& how) {
    list.push_back({name, [&project, how] { return twin::make_player(project, how); }});
  };
  if (options.packets) twin("cpu", {});
  if (options.single) {
    twin::TwinOptions single;
    single.packets = false;
    twin("one pixel", single);
    twin::TwinOptions checking;
    checking.observer = &silent;
    twin("check", checking);
  }
  if (options.doubles) {
    twin::TwinOptions doubles;
    doubles.double_precision = true;
    twin("cpu/double", doubles);
  }
  return list;
}

std::vector<Image> play(Player& player, const Project& project, const AgreementOptions& options) {
  Schedule schedule;
  schedule.width = options.width;
  schedule.height = options.height;
  FixedClock clock(schedule, host_rules(project));
  std::vector<Image> images;
  for (int i = 0; i < options.frames; ++i) {
    player.render(clock.next());
    for (std::size_t pass = 0; pass < project.passes.size(); ++pass)
      if (project.passes[pass].kind != PassKind::cubemap && project.passes[pass].kind != PassKind::sound)
        images.push_back(player.read(static_cast<int>(pass)));
  }
  return images;
}

bool agree(float a, float b, float tolerance) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return true;
  return std::abs(a - b) <= tolerance * std::max(1.0F, std::max(std::abs(a), std::abs(b)));
}

std::string difference(const std::vector<Image>& a, const std::vector<Image>& b, float tolerance) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    int different = 0;
    std::string first;
    for (int y = 0; y < a[i].height; ++y) {
      for (int x = 0; x < a[i].width; ++x) {
        for (int c = 0; c < 4; ++c) {
          const float p = a[i].at(x, y)[c];
          const float q = b[i].at(x, y)[c];
          if (agree(p, q, tolerance) || different++ > 0) continue;
          first = std::to_string(x) + ", " + std::to_string(y) + " channel " + std::to_string(c) + ": " +
                  std::to_string(q) + " instead of " + std::to_string(p);
        }
      }
    }
    if (different > 0)
      return std::to_string(different) + " of " + std::to_string(a[i].rgba.size()) +
             " values differ in picture " + std::to_string(i) + ", first at " + first;
  }
  return {};
}

}  // namespace

std::vector<std::string> disagreements(const Project& project, const AgreementOptions& options) {
  std::vector<std::string> lines;
  std::vector<Image> expected;
  Silent silent;
  for (const Runner& runner : runners(project, options, silent)) {
    try {
      const std::vector<Image> images = play(*runner.open(), project, options);
      if (expected.empty())
        expected = images;
      else if (const std::string text = difference(expected, images, options.tolerance); !text.empty())
        lines.push_back(runner.name + ": " + text);
    } catch (const std::exception& e) {
      lines.push_back(runner.name + ": " + e.what());
    }
  }
  return lines;
}

}  // namespace shadertwin
