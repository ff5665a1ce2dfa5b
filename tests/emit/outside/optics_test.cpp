#include <cmath>

#include "optics.h"

int main() {
  const bool reflects = std::abs(optics::normal_reflectance() - 0.04F) < 1e-7F;
  const bool bounces =
      optics::bounced(optics::vec3(1, -1, 0), optics::vec3(0, 1, 0)) == optics::vec3(1, 1, 0);
  return reflects && bounces ? 0 : 1;
}
