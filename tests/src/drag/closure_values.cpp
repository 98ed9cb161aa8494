// SPDX-License-Identifier: BSD-3-Clause
// Prints the drag closures for closures_test.py, a line each, fields separated by spaces:
//   closure NAME LOWEST HIGHEST REYNOLDS EXPONENT    range of validity; whether n may be chosen
//   value NAME EPS SLIP DIAMETER DENSITY VISCOSITY BETA/(1-EPS)
#include <cstdio>

#include "drag/drag_closure.h"

int main() {
  using namespace cohesion::drag;
  constexpr double diameter = 1e-3, density = 1.205, viscosity = 1.75e-5;
  for (const Closure& closure : closures) {
    const char* name = closure.name.data();
    const Validity& range = closure.validity;
    std::printf("closure %s %.17g %.17g %.17g %d\n", name, range.lowest_void_fraction,
                range.highest_void_fraction, range.highest_reynolds,
                closure.with_exponent != nullptr);
    for (const double eps : {0.38, 0.55, 0.7, 0.9, 1.0})
      for (const double slip : {0.0, 2e-3, 0.4, 20.0})
        std::printf("value %s %.17g %.17g %.17g %.17g %.17g %.17g\n", name, eps, slip, diameter,
                    density, viscosity,
                    closure.per_solid_volume(eps, slip, diameter, density, viscosity));
  }
}
