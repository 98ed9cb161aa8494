// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>

#include "vector3.h"

namespace cohesion::shear {

/// The sums over particles from which mean profile and fluctuations follow: plain numbers, to be
/// added over ranks. To keep the differences small, positions are from the middle of the box and
/// velocities from a profile near the mean one.
struct ProfileSums {
  enum { mass, y, yy, u, yu = u + 3, uu = yu + 3, count = uu + 6 };
  std::array<double, count> values{};

  /// Adds a particle: mass [mass], position along the gradient [length], velocity [length/time].
  void add(double m, double at, const Vector3& v) {
    values[mass] += m;
    values[y] += m * at;
    values[yy] += m * at * at;
    const double c[3] = {v.x, v.y, v.z};
    for (int k = 0; k < 3; k++) {
      values[u + k] += m * c[k];
      values[yu + k] += m * at * c[k];
      values[uu + k] += m * c[k] * c[k];
    }
    values[uu + 3] += m * c[0] * c[1];
    values[uu + 4] += m * c[0] * c[2];
    values[uu + 5] += m * c[1] * c[2];
  }
};

/// The mean velocity u(y) = intercept + slope y along the flow, and the fluctuations v' about it.
struct MeanProfile {
  double slope = 0.0;      ///< [1/time]
  double intercept = 0.0;  ///< at y = 0, [length/time]
  double mass = 0.0;       ///< of all particles, [mass]
  /// Mean of v'v' weighted by mass: xx, yy, zz, xy, xz, yz, [length^2/time^2]
  std::array<double, 6> fluctuation{};

  double at(double position) const { return intercept + slope * position; }
};

/// Fits the line through the velocities along the flow with the least mass-weighted sum of squares;
/// across the flow the mean is subtracted. No particles: all zero. All at one height: a line
/// without slope.
inline MeanProfile fit(const ProfileSums& sums) {
  using S = ProfileSums;
  MeanProfile profile;
  const auto& s = sums.values;
  profile.mass = s[S::mass];
  if (!(profile.mass > 0.0)) return profile;
  const double y = s[S::y] / profile.mass;
  const double u[3] = {s[S::u] / profile.mass, s[S::u + 1] / profile.mass,
                       s[S::u + 2] / profile.mass};
  const double mean_yy = s[S::yy] / profile.mass;
  const double yy = mean_yy - y * y;
  double yu[3];
  for (int k = 0; k < 3; k++) yu[k] = s[S::yu + k] / profile.mass - y * u[k];
  // A spread that is only the rounding of the difference counts as none.
  if (yy > 8.0 * std::numeric_limits<double>::epsilon() * mean_yy) profile.slope = yu[0] / yy;
  profile.intercept = u[0] - profile.slope * y;

  constexpr int first[6] = {0, 1, 2, 0, 0, 1}, second[6] = {0, 1, 2, 1, 2, 2};
  for (int k = 0; k < 6; k++)
    profile.fluctuation[k] = s[S::uu + k] / profile.mass - u[first[k]] * u[second[k]];
  // Subtracting b y from the velocity along the flow: <(x - b y)^2> = xx - b xy for the b that fits
  // best.
  profile.fluctuation[0] -= profile.slope * yu[0];
  profile.fluctuation[3] -= profile.slope * yu[1];
  profile.fluctuation[4] -= profile.slope * yu[2];
  return profile;
}

}  // namespace cohesion::shear
