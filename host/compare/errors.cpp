#include "host/compare/errors.h"

#include <cmath>

#include "host/base/assert.h"

namespace shadertwin {

namespace {

double weight(double reference) {
  return 1.0 / (reference * reference + relative_floor);
}

// visit(i) for every red, green and blue value.
template <typename Visit>
void for_each_value(const Image& image, const Visit& visit) {
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    if (i % 4 != 3) visit(i);
}

}  // namespace

PictureError picture_error(const Image& picture, const Image& reference) {
  SHADERTWIN_ASSERT_EQ(picture.rgba.size(), reference.rgba.size());
  PictureError result;
  for_each_value(picture, [&](std::size_t i) {
    const double x = picture.rgba[i];
    const double r = reference.rgba[i];
    if (std::isnan(x)) ++result.nan;
    if (std::isinf(x)) ++result.infinite;
    if (!std::isfinite(x) || !std::isfinite(r)) return;
    ++result.values;
    const double square = (x - r) * (x - r);
    result.mse += square;
    result.relative_mse += square * weight(r);
  });
  if (result.values == 0) return result;
  result.mse /= static_cast<double>(result.values);
  result.relative_mse /= static_cast<double>(result.values);
  return result;
}

ErrorParts error_parts(const Image& a, const Image& b, const Image& reference_a, const Image& reference_b) {
  SHADERTWIN_ASSERT_EQ(a.rgba.size(), reference_a.rgba.size());
  SHADERTWIN_ASSERT_EQ(b.rgba.size(), reference_b.rgba.size());
  SHADERTWIN_ASSERT_EQ(a.rgba.size(), b.rgba.size());
  ErrorParts result;
  std::size_t values = 0;
  for_each_value(a, [&](std::size_t i) {
    const double x = a.rgba[i];
    const double y = b.rgba[i];
    const double rx = reference_a.rgba[i];
    const double ry = reference_b.rgba[i];
    const double r = 0.5 * (rx + ry);
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(r)) return;
    ++values;
    result.relative_bias2 += (x - rx) * (y - ry) * weight(r);
    result.relative_variance += 0.5 * (x - y) * (x - y) * weight(r);
  });
  if (values == 0) return result;
  result.relative_bias2 /= static_cast<double>(values);
  result.relative_variance /= static_cast<double>(values);
  return result;
}

}  // namespace shadertwin
