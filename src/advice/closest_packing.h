// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact_solver/damped_oscillator.h"

namespace cohesion::advice {

/// (w dt)^2 of one discrete spring [1], whose dashpot takes the velocity of half a step before and
/// counts as stiffness. step [time]; inverse_mass [1/mass]: of the motion that stretches the
/// spring.
inline double squared_phase(const contact_solver::DiscreteConstants& spring, double step,
                            double inverse_mass) {
  return (spring.stiffness + 2.0 * spring.damping / step) * step * step * inverse_mass;
}

/// The square of the frequency of what swings fastest in the closest packing of equal spheres over
/// that of a pair, [1]: along the normals, with springs of friction and of rolling friction.
///
/// In space, twelve contacts, a sphere that swings against all neighbours has 4 times that of a
/// pair along the normals: 2 sum cos^2 = 8 springs on one sphere's mass, 2 on that of a pair.
/// Spheres that all spin alike, each surface sliding twice, have 2 sum sin^2 (5/2)/7 = 40/7 times
/// that of a pair's sliding; spheres that roll against all their neighbours 8 times. In a plane,
/// six contacts and spins across it, the sums of cos^2 and sin^2 are 3 and 6.
///
/// A wall does not swing against a sphere: its springs count once. With the three contacts above
/// it, a sphere swings along the normal of the wall with s_wall + 2 s_pair < 4 where 2 s_wall < 4
/// and 4 s_pair < 4. With its nine contacts, springs of friction of pairs reach 11/16 of 4, and
/// those of the wall may add 1.
///
/// Source: derived here; docs/theory/contact_steps.md.
struct ClosestPacking {
  double normal, sliding, rolling;

  static ClosestPacking in_space() { return {4.0, 40.0 / 7.0, 8.0}; }
  static ClosestPacking in_plane() { return {3.0, 30.0 / 7.0, 6.0}; }
  /// Of a contact with a wall, in space and in a plane: such that a sphere with its other contacts
  /// on one side, which are steady, is steady.
  static ClosestPacking at_wall() { return {2.0, 20.0 / 7.0, 4.0}; }

  /// Whether all of these swings stay steady, from squared_phase() of the springs of a pair. In
  /// longer steps a packing gains energy without bound.
  bool is_steady(double of_normal, double of_sliding, double of_rolling) const {
    return normal * of_normal < 4.0 && sliding * of_sliding + rolling * of_rolling < 4.0;
  }
};

}  // namespace cohesion::advice
