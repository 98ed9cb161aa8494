// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cohesion::kinetic_theory {

/// Integral of the smooth f from a to b: Gauss and Legendre's rule of five points in 1, 2, 4, ...
/// equal pieces, until twice as many change it by no more than 1e-12 of the integral of |f| or by
/// no more than `room`; at most in 2^16, NaN when that is not enough.
template <class Function>
double gauss_legendre(const Function& f, double a, double b, double room = 0.0) {
  struct Point {
    double place, weight;  // of the piece from -1 to 1
  };
  constexpr std::array points{
      Point{0.0, 128.0 / 225.0}, Point{0.5384693101056831, 0.4786286704993665},
      Point{-0.5384693101056831, 0.4786286704993665}, Point{0.9061798459386640, 0.2369268850561891},
      Point{-0.9061798459386640, 0.2369268850561891}};
  double before = std::numeric_limits<double>::infinity();
  for (int pieces = 1; pieces <= 1 << 16; pieces *= 2) {
    const double half = 0.5 * (b - a) / pieces;
    double sum = 0.0, size = 0.0;
    for (int n = 0; n < pieces; n++)
      for (const Point& p : points) {
        const double term = p.weight * f(a + half * (2 * n + 1 + p.place));
        sum += term;
        size += std::abs(term);
      }
    if (std::abs(sum * half - before) <= std::max(1e-12 * std::abs(size * half), room))
      return sum * half;
    before = sum * half;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace cohesion::kinetic_theory
