// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace cohesion::bed {

/// The mixing of coloured particles, from how many of each colour are in each cell.
struct Mixing {
  double index;    ///< Lacey's index [1]: 0 segregated, 1 mixed at random; NaN where undefined
  long cells;      ///< cells that hold particles
  long particles;  ///< all of them
};

/// Lacey's mixing index, M = (S0^2 - S^2)/(S0^2 - SR^2), for any number of colours and for cells
/// that hold different numbers of particles. With n_c particles in cell c of which n_ck are of
/// colour k, p_k the fraction of colour k among all N, sums over the C cells that hold particles:
///   S^2  = sum_c n_c/N sum_k (n_ck/n_c - p_k)^2   as it is,
///   S0^2 = sum_k p_k (1 - p_k)                    each cell of one colour: M = 0,
///   SR^2 = S0^2 (C - 1)/(N - 1)                   expectation when the colours are dealt out among
///                                                 the particles at random: M is then 1 in the
///                                                 mean.
/// SR^2 follows from the variance of drawing without replacement, p (1 - p)/n_c (N - n_c)/(N - 1).
/// M exceeds 1 where colours are spread more evenly than at random. Undefined when all particles
/// are of one colour, or no cell holds two.
/// Source: P. M. C. Lacey, Developments in the theory of particle mixing, J. Appl. Chem. 4 (1954)
/// 257, who has two colours and samples of equal size.
///
/// counts: n_ck at [c * colours + k], a whole number of cells.
inline Mixing lacey_index(const std::vector<long>& counts, std::size_t colours) {
  Mixing mixing{std::numeric_limits<double>::quiet_NaN(), 0, 0};
  std::vector<double> of_colour(colours, 0.0);
  double same = 0.0;  // sum_ck n_ck^2/n_c
  for (std::size_t cell = 0; cell + colours <= counts.size(); cell += colours) {
    long in_cell = 0;
    double squares = 0.0;
    for (std::size_t k = 0; k < colours; ++k) {
      const auto n = counts[cell + k];
      in_cell += n;
      squares += static_cast<double>(n) * static_cast<double>(n);
      of_colour[k] += static_cast<double>(n);
    }
    if (in_cell == 0) continue;
    same += squares / static_cast<double>(in_cell);
    mixing.particles += in_cell;
    ++mixing.cells;
  }
  if (mixing.cells == mixing.particles) return mixing;
  const auto all = static_cast<double>(mixing.particles);
  double squared_fractions = 0.0;  // sum_k p_k^2
  for (const double n : of_colour) squared_fractions += n / all * (n / all);
  const double segregated = 1.0 - squared_fractions;
  if (segregated <= 0.0) return mixing;
  const double random = segregated * static_cast<double>(mixing.cells - 1) / (all - 1.0);
  mixing.index = (1.0 - same / all) / (segregated - random);
  return mixing;
}

}  // namespace cohesion::bed
