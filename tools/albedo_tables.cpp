// Prints the tables of directional albedos in shadertoy/common.glsl: of its GGX lobes, by quadrature, fitted
// so that what is interpolated between their entries lies above the truth, but for rounding. On stderr: how
// far it lies off at worst.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

namespace {

using std::numbers::pi;
using Reflectance = std::function<double(double cosine)>;

constexpr int rows = 32;     // roughness from 0 to 1
constexpr int columns = 16;  // square root of the cosine from 0 to 1
using Table = std::array<double, rows * columns>;

// Nodes in [0, 1] and weights of Gauss and Legendre's rule.
struct Node {
  double at, weight;
};
std::vector<Node> gauss_legendre(int count) {
  std::vector<Node> nodes;
  for (int i = 0; i < count; ++i) {
    double x = std::cos(pi * (i + 0.75) / (count + 0.5));
    double slope = 0.0;
    for (int step = 0; step < 8; ++step) {
      double value = x;
      double before = 1.0;
      for (int n = 2; n <= count; ++n)
        before = std::exchange(value, ((2 * n - 1) * x * value - (n - 1) * before) / n);
      slope = count * (x * value - before) / (x * x - 1.0);
      x -= value / slope;
    }
    nodes.push_back({0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope)});
  }
  return nodes;
}

// Heitz 2014, equation 72.
double lambda(double cosine, double alpha) {
  const double tangent2 = (1.0 - cosine * cosine) / (cosine * cosine);
  return 0.5 * (std::sqrt(1.0 + alpha * alpha * tangent2) - 1.0);
}

// The part of the light from a direction that the lobe reflects: the mean, over visible normals (Heitz 2018,
// listing 1, the plane of incidence in x and z), of the reflectance times what is neither masked nor
// shadowed.
double albedo(double cosine, double roughness, const Reflectance& reflectance) {
  static const std::vector<Node> nodes = gauss_legendre(64);
  const double alpha = std::max(roughness * roughness, 0.001);  // ALPHA_MIN
  const double sine = std::sqrt(1.0 - cosine * cosine);
  const double length = std::hypot(alpha * sine, cosine);
  const double x = alpha * sine / length;
  const double z = cosine / length;
  const double squeeze = 0.5 * (1.0 + z);
  const double seen = lambda(cosine, alpha);
  double sum = 0.0;
  for (const Node& radius : nodes)
    for (const Node& turn : nodes) {  // half of the disk: the other is its mirror image
      const double r2 = radius.at;
      const double across = std::sqrt(r2) * std::sin(pi * (turn.at - 0.5));
      const double side2 = r2 - across * across;
      const double along = (1.0 - squeeze) * std::sqrt(1.0 - side2) + squeeze * across;
      const double up = std::sqrt(std::max(0.0, 1.0 - side2 - along * along));
      // The half vector, across (a), along (b) and towards (w) the stretched direction.
      const double hx = alpha * (up * x - along * z);
      const double hz = along * x + up * z;
      const double h2 = hx * hx + alpha * alpha * side2 + hz * hz;
      const double voh = (sine * hx + cosine * hz) / std::sqrt(h2);
      const double out = 2.0 * voh * hz / std::sqrt(h2) - cosine;
      if (out > 0.0)
        sum +=
            radius.weight * turn.weight * reflectance(voh) * (1.0 + seen) / (1.0 + seen + lambda(out, alpha));
    }
  return sum;
}

double mirror(double /*cosine*/) {
  return 1.0;
}

// Fresnel's equations for an index of 1.5, from outside.
double glass(double cosine) {
  const double t = std::sqrt(1.0 - (1.0 - cosine * cosine) / 2.25);
  const double s = (cosine - 1.5 * t) / (cosine + 1.5 * t);
  const double p = (t - 1.5 * cosine) / (t + 1.5 * cosine);
  return 0.5 * (s * s + p * p);
}

// A place in the table, with the truth there.
struct Sample {
  int cell = 0;                     // of the entry at the lower roughness and cosine
  std::array<double, 4> weights{};  // of that entry, the next column's, and the same in the next row
  double truth = 0.0;
  bool counts = true;  // towards what the table may lie above the truth
};
constexpr std::array<int, 4> corners = {0, 1, columns, columns + 1};

double interpolated(const Table& table, const Sample& sample) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i)
    sum += sample.weights[i] * table[static_cast<std::size_t>(sample.cell + corners[i])];
  return sum;
}

// `steps` places along each side of every cell.
std::vector<Sample> samples(int steps, const Reflectance& reflectance) {
  std::vector<Sample> all;
  for (int j = 0; j <= (rows - 1) * steps; ++j)
    for (int i = 0; i <= (columns - 1) * steps; ++i) {
      const int row = std::min(j / steps, rows - 2);
      const int column = std::min(i / steps, columns - 2);
      const double fy = static_cast<double>(j) / steps - row;
      const double fx = static_cast<double>(i) / steps - column;
      const double root = std::max(static_cast<double>(i) / (steps * (columns - 1)), 0.004);
      const double cosine = root * root;
      const double roughness = static_cast<double>(j) / (steps * (rows - 1));
      all.push_back({.cell = row * columns + column,
                     .weights = {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy},
                     .truth = albedo(cosine, roughness, reflectance) / reflectance(cosine),
                     .counts = cosine > 0.1});
    }
  return all;
}

// Newton's method, entry after entry, for the least sum of costs: the fourth power of how far it lies off, so
// that the worst is small, and more for what lies below. What lies there still is then lifted.
Table fit(const std::vector<Sample>& samples) {
  std::array<std::vector<std::pair<const Sample*, double>>, rows * columns> touched;
  for (const Sample& sample : samples)
    for (std::size_t i = 0; i < 4; ++i)
      if (sample.weights[i] > 0.0)
        touched[static_cast<std::size_t>(sample.cell + corners[i])].emplace_back(&sample, sample.weights[i]);
  Table table;
  table.fill(1.0);
  for (int sweep = 0; sweep < 2000; ++sweep)
    for (std::size_t entry = 0; entry < table.size(); ++entry) {
      double first = 0.0;
      double second = 1e-30;
      for (const auto& [sample, weight] : touched[entry]) {
        const double off = interpolated(table, *sample) / sample->truth - 1.0;
        const double limit = off < 0.0 ? 0.3 : sample->counts ? 1.0 : 4.0;
        const double x = off / limit;
        const double slope = weight / sample->truth / limit;
        first += 4.0 * x * x * x * slope;
        second += 12.0 * (x * x + 1e-9) * slope * slope;
      }
      table[entry] -= first / second;
    }
  for (int sweep = 0; sweep < 300; ++sweep)
    for (const Sample& sample : samples) {
      const double missing = (1.0 - 0.0003) * sample.truth - interpolated(table, sample);
      if (missing <= 0.0) continue;
      double length2 = 0.0;
      for (const double weight : sample.weights) length2 += weight * weight;
      for (std::size_t i = 0; i < 4; ++i)
        table[static_cast<std::size_t>(sample.cell + corners[i])] += missing * sample.weights[i] / length2;
    }
  for (double& entry : table) entry = std::round(entry * 1e4) / 1e4;
  return table;
}

void print(const char* name, const std::vector<double>& values) {
  std::printf("const float %s[%zu] = float[%zu](", name, values.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    std::printf("%s%.4f%s", i % 13 == 0 ? "\n    " : " ", values[i], i + 1 < values.size() ? "," : ");\n");
}

void print_fitted(const char* name, const Reflectance& reflectance) {
  const Table table = fit(samples(4, reflectance));
  print(name, {table.begin(), table.end()});
  double below = 0.0;
  double above = 0.0;
  for (const Sample& sample : samples(7, reflectance)) {
    const double off = interpolated(table, sample) / sample.truth - 1.0;
    below = std::max(below, -off);
    if (sample.counts) above = std::max(above, off);
  }
  std::fprintf(stderr, "%s: %.3f %% below the truth at worst, %.3f %% above it for cosines over 0.1\n", name,
               100.0 * below, 100.0 * above);
}

}  // namespace

int main() {
  print_fitted("GGX_ALBEDO", mirror);
  print_fitted("GLOSS_ALBEDO", glass);
  std::vector<double> means;
  for (int row = 0; row < rows; ++row) {
    double mean = 0.0;
    for (const Node& node : gauss_legendre(64))
      mean += node.weight * 2.0 * node.at * albedo(node.at, static_cast<double>(row) / (rows - 1), glass);
    means.push_back(mean);
  }
  print("GLOSS_MEAN", means);
}
