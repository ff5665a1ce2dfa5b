// createCamera, getRay and the orbit camera.
#include <cmath>
#include <numbers>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/shapes.h"

namespace shadertwin::camera_test {
namespace {

class GetRay : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(GetRay);
class OrbitCamera : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(OrbitCamera);

using std::numbers::pi;
constexpr double u = unit_roundoff;
const Probe rays{.file = "camera_rays.glsl", .inputs = 6, .outputs = 5};
const Probe vectors{.file = "orbit.glsl", .function = 0, .inputs = 2, .outputs = 4};
const Probe moves{.file = "orbit.glsl", .function = 1, .inputs = 2, .outputs = 4};

struct View {
  glm::dvec3 eye{3, 2, 9}, at{0.25, 0.7, 0}, up{0, 1, 0};
  double fovy = 40, aspect = 16.0 / 9.0, aperture = 0, focus = 1;
  double time0 = 0, time1 = 1;
};

void put(Table& inputs, std::size_t i, const View& view, const glm::dvec2& pixel_sample,
         const glm::dvec3& xi) {
  inputs.at(i, 0) = texel(view.eye);
  inputs.at(i, 1) = texel(view.at);
  inputs.at(i, 2) = texel(view.up);
  inputs.at(i, 3) = texel({view.fovy, view.aspect, view.aperture}, view.focus);
  inputs.at(i, 4) = texel({view.time0, view.time1, pixel_sample.x}, pixel_sample.y);
  inputs.at(i, 5) = texel(xi);
}

glm::dvec3 vec(const glm::vec4& v) {
  return glm::dvec3(v);
}

View random_view(Random& random) {
  View view;
  view.eye = random.log_uniform(0.1, 100) * random_direction(random);
  view.at = view.eye + random.log_uniform(0.1, 100) * random_direction(random);
  view.fovy = random.uniform(5, 120);
  view.aspect = random.uniform(0.5, 3);
  return view;
}

TEST_P(GetRay, CentreLooksAlongTheView) {
  Random random(61);
  Table inputs(1 << 16, 6);
  for (std::size_t i = 0; i < inputs.cases(); ++i)
    put(inputs, i, random_view(random), {0.5, 0.5}, {0.3, 0.6, 0.5});
  const Table got = run(rays, inputs);
  Bar bar("getRay, centre of the picture, sine of the angle to -n");
  Bar aim("getRay, centre of the picture, angle to the target");
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    bar.near(glm::length(glm::cross(vec(got.at(i, 1)), vec(got.at(i, 4)))), 0.0, 2.0 * u, {{"case", i}});
    const glm::dvec3 way = glm::normalize(vec(inputs.at(i, 1)) - vec(inputs.at(i, 0)));
    // Eye and target are up to 200 units out and 0.1 apart; their difference is exact in float only to a
    // unit.
    aim.near(glm::length(vec(got.at(i, 1)) - way), 0.0, 6.0 * u, {{"case", i}});
  }
}

TEST_P(GetRay, CornersStandAtTheFieldOfView) {
  Random random(62);
  Table inputs(1 << 16, 6);
  std::vector<View> views;
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    views.push_back(random_view(random));
    put(inputs, i, views.back(), {static_cast<double>(i % 2), static_cast<double>(i / 2 % 2)}, {0, 0, 0});
  }
  const Table got = run(rays, inputs);
  Bar angle("getRay, angle of the corners");
  Bar quadrant("getRay, corners in the wrong quadrant");
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    const glm::dvec3 d = vec(got.at(i, 1));
    const double x = glm::dot(d, vec(got.at(i, 2)));
    const double y = glm::dot(d, vec(got.at(i, 3)));
    const double z = -glm::dot(d, vec(got.at(i, 4)));
    const double tangent = std::tan(static_cast<double>(inputs.at(i, 3).x) * pi / 360.0);
    const double expected = std::atan(tangent * std::hypot(1.0, static_cast<double>(inputs.at(i, 3).y)));
    angle.near(std::atan2(std::hypot(x, y), z), expected, 3e-7 + 4.0 * u,
               {{"case", i}, {"fovy", views[i].fovy}});
    quadrant.holds((x > 0) == (i % 2 == 1) && (y > 0) == (i / 2 % 2 == 1), x, y, {{"case", i}});
  }
}

TEST_P(GetRay, BasisIsOrthonormalAndRightHanded) {
  Random random(63);
  Table inputs(1 << 16, 6);
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    View view = random_view(random);
    if (i % 8 == 1) view.up = view.at - view.eye;  // along the view
    if (i % 8 == 2) view.up = view.eye - view.at;
    if (i % 8 == 3) view.at = view.eye;                                           // nowhere to look
    if (i % 8 == 4) view.at = view.eye + glm::dvec3(0, i % 16 == 4 ? 5 : -5, 0);  // straight up and down
    if (i % 8 == 5) view.fovy = i % 16 == 5 ? 0 : 180;
    if (i % 8 == 6) view.up = glm::dvec3(0);
    put(inputs, i, view, {random.uniform(), random.uniform()},
        {random.uniform(), random.uniform(), random.uniform()});
  }
  const Table got = run(rays, inputs);
  Bar bar("createCamera, orthonormality");
  Bar unit("getRay, length of the direction");
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    const glm::dvec3 a = vec(got.at(i, 2));
    const glm::dvec3 b = vec(got.at(i, 3));
    const glm::dvec3 n = vec(got.at(i, 4));
    const Bar::Inputs where = {{"case", i}, {"kind", i % 8}};
    for (const double dot : {glm::dot(a, b), glm::dot(a, n), glm::dot(b, n)}) bar.near(dot, 0.0, 4e-7, where);
    for (const glm::dvec3& v : {a, b, n}) bar.near(glm::length(v), 1.0, 4e-7, where);
    bar.near(glm::dot(glm::cross(a, b), n), 1.0, 8e-7, where);
    unit.near(glm::length(vec(got.at(i, 1))), 1.0, 4.0 * u, where);
  }
}

TEST_P(GetRay, PinholeRaysStartAtTheEye) {
  Random random(64);
  Table inputs(1 << 16, 6);
  for (std::size_t i = 0; i < inputs.cases(); ++i)
    put(inputs, i, random_view(random), {random.uniform(), random.uniform()},
        {random.uniform(), random.uniform(), random.uniform()});
  const Table got = run(rays, inputs);
  Bar bar("getRay without a lens, origin");
  for (std::size_t i = 0; i < inputs.cases(); ++i)
    bar.near(glm::length(vec(got.at(i, 0)) - vec(inputs.at(i, 0))), 0.0, 0.0, {{"case", i}});
}

TEST_P(GetRay, LensRaysOfAPixelMeetInTheFocus) {
  Random random(65);
  Table inputs(million, 6);
  constexpr std::size_t per_pixel = 1024;
  for (std::size_t pixel = 0; pixel < million / per_pixel; ++pixel) {
    View view = random_view(random);
    const double distance = glm::distance(view.eye, view.at);
    view.aperture = random.uniform(0.01, 0.5) * distance;
    view.focus = random.uniform(0.3, 3);
    const glm::dvec2 sample(random.uniform(), random.uniform());
    for (std::size_t k = 0; k < per_pixel; ++k)
      put(inputs, pixel * per_pixel + k, view, sample,
          {random.uniform(), random.uniform(), random.uniform()});
  }
  const Table got = run(rays, inputs);
  Bar bar("getRay with a lens, distance from the focus over the way there");
  Bar lens("getRay with a lens, distance of the origin from the eye over the radius");
  for (std::size_t i = 0; i < million; ++i) {
    const glm::dvec3 a = vec(got.at(i, 2));
    const glm::dvec3 b = vec(got.at(i, 3));
    const glm::dvec3 n = vec(got.at(i, 4));
    const glm::dvec3 eye = vec(inputs.at(i, 0));
    const double plane = glm::distance(eye, vec(inputs.at(i, 1)));
    const double height = 2.0 * plane * std::tan(static_cast<double>(inputs.at(i, 3).x) * pi / 360.0);
    const auto focus = static_cast<double>(inputs.at(i, 3).w);
    const double x =
        (static_cast<double>(inputs.at(i, 4).z) - 0.5) * height * static_cast<double>(inputs.at(i, 3).y);
    const double y = (static_cast<double>(inputs.at(i, 4).w) - 0.5) * height;
    const glm::dvec3 target = eye + focus * (x * a + y * b - plane * n);
    const glm::dvec3 way = target - vec(got.at(i, 0));
    const double miss = glm::length(glm::cross(way, vec(got.at(i, 1))));
    bar.near(miss, 0.0, 4e-6 * (glm::length(way) + glm::length(eye)), {{"case", i}});
    const glm::dvec3 shift = vec(got.at(i, 0)) - eye;
    const double radius = 0.5 * static_cast<double>(inputs.at(i, 3).z);
    const double ratio = glm::length(shift) / radius;
    lens.holds(ratio <= 1.0 + 8.0 * u * glm::length(eye) / radius, ratio, 1.0, {{"case", i}});
  }
}

TEST_P(GetRay, TimesFillTheShutter) {
  Random random(66);
  Table inputs(1 << 16, 6);
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    View view;
    view.time0 = i % 4 == 0 ? 0.5 : random.uniform(-1, 1);
    view.time1 = i % 4 == 0 ? 0.5 : view.time0 + random.uniform(0, 2);
    const double xi = i % 4 == 1 ? 0.0 : i % 4 == 2 ? 1.0 - 0x1p-24 : random.uniform();
    put(inputs, i, view, {0.5, 0.5}, {0.5, 0.5, xi});
  }
  const Table got = run(rays, inputs);
  Bar bar("getRay, time");
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    const auto t0 = static_cast<double>(inputs.at(i, 4).x);
    const auto t1 = static_cast<double>(inputs.at(i, 4).y);
    bar.near(static_cast<double>(got.at(i, 0).w), t0 + static_cast<double>(inputs.at(i, 5).z) * (t1 - t0),
             t0 == t1 ? 0.0 : 4.0 * u * (std::abs(t0) + std::abs(t1)), {{"case", i}});
  }
}

TEST_P(OrbitCamera, StandsAtItsDistanceInARightHandedBasis) {
  Random random(67);
  Table inputs(million, 2);
  for (std::size_t i = 0; i < million; ++i) {
    inputs.at(i, 0) =
        texel({random.uniform(-100, 100), random.uniform(0.0016, 0.4984), random.log_uniform(0.1, 100)});
    inputs.at(i, 1) = texel({0, 0, 0});
  }
  const Table got = run(vectors, inputs);
  Bar distance("GetCameraVectors, distance from the target, relative");
  Bar basis("GetCameraVectors, orthonormality");
  Bar place("GetCameraVectors, position over the distance");
  for (std::size_t i = 0; i < million; ++i) {
    const glm::dvec3 position = vec(got.at(i, 0));
    const glm::dvec3 forward = vec(got.at(i, 1));
    const glm::dvec3 up = vec(got.at(i, 2));
    const glm::dvec3 right = vec(got.at(i, 3));
    const double azimuth = 2.0 * pi * static_cast<double>(inputs.at(i, 0).x);
    const double elevation = 2.0 * pi * static_cast<double>(inputs.at(i, 0).y);
    const auto reach = static_cast<double>(inputs.at(i, 0).z);
    const Bar::Inputs where = {{"azimuth", inputs.at(i, 0).x}, {"elevation", inputs.at(i, 0).y}};
    distance.near(glm::length(position) / reach, 1.0, 5e-7, where);
    const glm::dvec3 expected(std::sin(azimuth) * std::sin(elevation), -std::cos(elevation),
                              std::cos(azimuth) * std::sin(elevation));
    place.near(glm::length(position / reach - expected), 0.0, 8e-7, where);
    for (const glm::dvec3& v : {forward, up, right}) basis.near(glm::length(v), 1.0, 4e-7, where);
    for (const double dot : {glm::dot(forward, up), glm::dot(forward, right), glm::dot(up, right)})
      basis.near(dot, 0.0, 4e-7, where);
    basis.near(glm::dot(glm::cross(right, up), -forward), 1.0, 8e-7, where);
  }
}

TEST_P(OrbitCamera, AWholeTurnChangesNothing) {
  Table inputs(2048, 2);
  for (std::size_t i = 0; i < 1024; ++i) {
    const double azimuth = static_cast<double>(i) / 1024.0;
    inputs.at(2 * i, 0) = texel({azimuth, 0.3, 10});
    inputs.at(2 * i + 1, 0) = texel({azimuth + (i % 2 ? 7.0 : -3.0), 0.3, 10});
  }
  const Table got = run(vectors, inputs);
  Bar bar("GetCameraVectors, azimuth and azimuth + whole turns");
  for (std::size_t i = 0; i < 1024; ++i)
    bar.near(glm::distance(vec(got.at(2 * i, 0)), vec(got.at(2 * i + 1, 0))), 0.0, 2e-5,
             {{"azimuth", static_cast<double>(i) / 1024.0}});
}

// Scene 1's numbers.
constexpr double rest = 34.0;
constexpr double least_zoom = 14.0;

TEST_P(OrbitCamera, ZoomIsMonotoneAndDoesNotDependOnTheFrameRate) {
  // A quarter of a second pressed, at 24 to 144 frames a second; and the way back.
  const std::vector<double> rates = {24, 48, 60, 144};
  for (const bool down : {true, false}) {
    Table inputs(rates.size(), 2);
    for (std::size_t i = 0; i < rates.size(); ++i) {
      inputs.at(i, 0) = texel({0.1, 0.3, down ? rest : least_zoom}, 1.0 / rates[i]);
      inputs.at(i, 1) = texel({0, 0, down ? 1.0 : 0.0}, rates[i] / 4.0);
    }
    const Table got = run(moves, inputs);
    Bar bar("moveCamera, zoom after a quarter of a second, relative");
    const double from = down ? rest : least_zoom;
    const double to = down ? least_zoom : rest;
    for (std::size_t i = 0; i < rates.size(); ++i)
      bar.near(static_cast<double>(got.at(i, 0).z), to + (from - to) * std::exp(-6.0 / 4.0), 1e-3 * rest,
               {{"rate", rates[i]}});
  }
  Table inputs(600, 2);
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    inputs.at(i, 0) = texel({0.1, 0.3, i < 300 ? rest : least_zoom}, 1.0 / 60.0);
    inputs.at(i, 1) = texel({0, 0, i < 300 ? 1.0 : 0.0}, static_cast<double>(i % 300));
  }
  const Table got = run(moves, inputs);
  for (std::size_t i = 1; i < inputs.cases(); ++i) {
    const float zoom = got.at(i, 0).z;
    EXPECT_GE(zoom, static_cast<float>(least_zoom));
    EXPECT_LE(zoom, static_cast<float>(rest));
    if (i == 300) continue;
    const float change = zoom - got.at(i - 1, 0).z;
    EXPECT_GE(i < 300 ? -change : change, 0.0F) << "frame " << i;
  }
  EXPECT_EQ(got.at(299, 0).z, static_cast<float>(least_zoom)) << "comes to rest";
  EXPECT_EQ(got.at(599, 0).z, static_cast<float>(rest)) << "comes to rest";
}

TEST_P(OrbitCamera, AnglesStayWithinTheScenesLimitsAndOnRelease) {
  Random random(68);
  Table inputs(4096, 2);
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    inputs.at(i, 0) = texel({random.uniform(), random.uniform(0.24, 0.46), random.uniform(1, 100)},
                            random.log_uniform(1e-4, 100));
    inputs.at(i, 1) =
        i % 2 ? texel({random.uniform(-1, 1), random.uniform(-1, 1), 1}, 1 + static_cast<double>(i % 50))
              : texel({0, 0, 0}, 100);
  }
  const Table got = run(moves, inputs);
  Bar limits("moveCamera, elevation and zoom within the scene's limits");
  Bar kept("moveCamera, angles after a release");
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    const glm::vec4 orbit = got.at(i, 0);
    const auto elevation = static_cast<double>(orbit.y);
    limits.holds(elevation >= 85.0 / 360.0 - 1e-6 && elevation <= 170.0 / 360.0 + 1e-6 && orbit.z >= 14.0F &&
                     orbit.z <= 60.0F && orbit.x >= 0.0F && orbit.x < 1.0F,
                 elevation, 0.0, {{"case", i}, {"zoom", orbit.z}});
    if (i % 2 == 0)
      kept.holds(orbit.x == inputs.at(i, 0).x && orbit.y == inputs.at(i, 0).y, elevation,
                 static_cast<double>(inputs.at(i, 0).y), {{"case", i}});
  }
}

}  // namespace
}  // namespace shadertwin::camera_test
