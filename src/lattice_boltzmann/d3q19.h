// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

/// The lattice of 19 velocities: rest, to the six next nodes, to the twelve across an edge. Lengths
/// in spacings, times in steps. Source: Y. H. Qian, D. d'Humieres, P. Lallemand, Europhys. Lett. 17
/// (1992) 479.
namespace cohesion::lattice_boltzmann {

inline constexpr int directions = 19;

/// Opposite ones are neighbours: 2 k - 1 and 2 k.
inline constexpr std::array<std::array<int, 3>, directions> velocity{{{0, 0, 0},
                                                                      {1, 0, 0},
                                                                      {-1, 0, 0},
                                                                      {0, 1, 0},
                                                                      {0, -1, 0},
                                                                      {0, 0, 1},
                                                                      {0, 0, -1},
                                                                      {1, 1, 0},
                                                                      {-1, -1, 0},
                                                                      {1, -1, 0},
                                                                      {-1, 1, 0},
                                                                      {1, 0, 1},
                                                                      {-1, 0, -1},
                                                                      {1, 0, -1},
                                                                      {-1, 0, 1},
                                                                      {0, 1, 1},
                                                                      {0, -1, -1},
                                                                      {0, 1, -1},
                                                                      {0, -1, 1}}};

inline constexpr int opposite(int q) { return q == 0 ? 0 : q % 2 ? q + 1 : q - 1; }

inline constexpr double weight(int q) {
  return q == 0 ? 1.0 / 3.0 : q < 7 ? 1.0 / 18.0 : 1.0 / 36.0;
}

}  // namespace cohesion::lattice_boltzmann
