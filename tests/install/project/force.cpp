// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "hamaker/small_gap.h"

int main() {
  using namespace cohesion;
  const hamaker::SmallGap law(hamaker::HamakerParameters{});
  std::printf("%.17g\n", 7.49e-19 / 6 * law.force(2e-9, two_spheres(0.5e-3, 0.5e-3)));
}
