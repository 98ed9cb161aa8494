// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace cohesion {

/// What two unlike materials have of a quantity, of which both values are not negative: the
/// geometric mean, as the engines' own styles mix energies.
inline double geometric_mean(double a, double b) { return std::sqrt(a * b); }

}  // namespace cohesion
