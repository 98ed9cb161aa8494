// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "lattice_boltzmann/d3q19.h"
#include "lattice_boltzmann/relaxation.h"
#include "lattice_boltzmann/walls.h"

// One more version of the loop for processors that have wider vectors; a program takes it where it
// runs on one. Both round alike.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && \
    !defined(__SANITIZE_ADDRESS__)
#define COHESION_WIDER_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define COHESION_WIDER_VECTORS
#endif

namespace cohesion::lattice_boltzmann {

using Vector = std::array<double, 3>;

/// Where the populations of nodes come from and go to, by velocity, and there by node. A node
/// writes where it has read, and nowhere else.
struct PopulationPointers {
  std::array<const double*, directions> in;
  std::array<double*, directions> out;
};

/// (x, y, z) . c_q, without the products with zero that a compiler must keep.
template <int q>
[[gnu::always_inline]] inline double along(double x, double y, double z) {
  constexpr auto c = velocity[q];
  double sum = 0.0;
  if constexpr (c[0] != 0) sum = c[0] * x;
  if constexpr (c[1] != 0) sum = c[0] == 0 ? c[1] * y : sum + c[1] * y;
  if constexpr (c[2] != 0) sum = c[0] == 0 && c[1] == 0 ? c[2] * z : sum + c[2] * z;
  return sum;
}

/// Calls f with each velocity that opens a pair of opposite ones, as a constant.
template <class F, std::size_t... k>
[[gnu::always_inline]] inline void for_pairs(F f, std::index_sequence<k...>) {
  (f(std::integral_constant<int, 2 * k + 1>{}), ...);
}

/// The collisions of the nodes of some runs: equilibrium of incompressible flow (X. He, L.-S. Luo,
/// J. Stat. Phys. 88 (1997) 927), two relaxation times, a body force of second order (Z. Guo, C.
/// Zheng, B. Shi, Phys. Rev. E 65 (2002) 046308). Populations are deviations from those of the
/// fluid at rest, so that slow flow keeps its digits. force per mass [spacing/step^2].
COHESION_WIDER_VECTORS inline void collide(const PopulationPointers& row,
                                           const std::vector<Run>& runs,
                                           const Relaxation& relaxation, const Vector& force) {
  // By value, for the compiler to know that what is written changes none of them.
  const PopulationPointers at = row;
  const double even = relaxation.even(), odd = relaxation.odd();
  const double gx = force[0], gy = force[1], gz = force[2];
  const double even_force = 1.0 - 0.5 * even, odd_force = 1.0 - 0.5 * odd;
  constexpr auto pairs = std::make_index_sequence<directions / 2>{};
  for (const Run& run : runs)
#pragma GCC ivdep
    for (std::size_t x = run.first; x < run.first + run.nodes; x++) {
      double f[directions], density = at.in[0][x];
      double ux = 0.5 * gx, uy = 0.5 * gy, uz = 0.5 * gz;
      f[0] = at.in[0][x];
      for_pairs(
          [&](auto pair) __attribute__((always_inline)) {
            constexpr int q = pair;
            f[q] = at.in[q][x];
            f[q + 1] = at.in[q + 1][x];
            density += f[q] + f[q + 1];
            const double difference = f[q] - f[q + 1];
            if constexpr (velocity[q][0] != 0) ux += velocity[q][0] * difference;
            if constexpr (velocity[q][1] != 0) uy += velocity[q][1] * difference;
            if constexpr (velocity[q][2] != 0) uz += velocity[q][2] * difference;
          },
          pairs);
      const double uu = ux * ux + uy * uy + uz * uz, ug = ux * gx + uy * gy + uz * gz;
      const double isotropic = even * (density - 1.5 * uu) - 3.0 * even_force * ug;
      at.out[0][x] = (1.0 - even) * f[0] + weight(0) * isotropic;
      for_pairs(
          [&](auto pair) __attribute__((always_inline)) {
            constexpr int q = pair;
            constexpr double w = weight(q);
            const double cu = along<q>(ux, uy, uz), cg = along<q>(gx, gy, gz);
            const double half_sum =
                0.5 * (1.0 - even) * (f[q] + f[q + 1]) +
                w * (isotropic + cu * (4.5 * even * cu + 9.0 * even_force * cg));
            const double half_difference =
                0.5 * (1.0 - odd) * (f[q] - f[q + 1]) + 3.0 * w * (odd * cu + odd_force * cg);
            at.out[q][x] = half_sum + half_difference;
            at.out[q + 1][x] = half_sum - half_difference;
          },
          pairs);
    }
}

}  // namespace cohesion::lattice_boltzmann
