// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::contact_solver {

/// The square of the frequency of what swings fastest in the closest packing of equal spheres over
/// that of a pair, [1]: along the normals, with springs of friction and of rolling friction.
///
/// In space, twelve contacts, a sphere that swings against all neighbours has 4 times that of a
/// pair along the normals: 2 sum cos^2 = 8 springs on one sphere's mass, 2 on that of a pair.
/// Spheres that all spin alike, each surface sliding twice, have 2 sum sin^2 (5/2)/7 = 40/7 times
/// that of a pair's sliding; spheres that roll against all their neighbours 8 times. In a plane,
/// six contacts and spins across it, the sums of cos^2 and sin^2 are 3 and 6.
///
/// Source: derived here.
struct ClosestPacking {
  double normal, sliding, rolling;

  static ClosestPacking in_space() { return {4.0, 40.0 / 7.0, 8.0}; }
  static ClosestPacking in_plane() { return {3.0, 30.0 / 7.0, 6.0}; }
};

}  // namespace cohesion::contact_solver
