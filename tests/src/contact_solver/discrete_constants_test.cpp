// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <complex>

#include "contact_solver/damped_oscillator.h"

namespace cohesion::contact_solver {
namespace {

constexpr double mass = 2.0, step = 0.05;

/// The solution of m x'' = -k x - c x', by its two modes.
Overlap motion(double stiffness, double damping, Overlap start, double t) {
  if (stiffness == 0.0 && damping == 0.0) return {start.x + start.v * t, start.v};
  const double alpha = 0.5 * damping / mass;
  const std::complex<double> root =
      std::sqrt(std::complex<double>(alpha * alpha - stiffness / mass));
  const std::complex<double> a = -alpha + root, b = -alpha - root;
  const auto of_a = (start.v - b * start.x) / (a - b) * std::exp(a * t);
  const auto of_b = (a * start.x - start.v) / (a - b) * std::exp(b * t);
  return {std::real(of_a + of_b), std::real(a * of_a + b * of_b)};
}

double rate_after(double rate, const DiscreteConstants& c, double x, double time) {
  return rate - time / mass * (c.stiffness * x + c.damping * rate);
}

/// Spring and dashpot: none, one of them, below and beyond critical damping (c = 20).
constexpr double cases[][2] = {{0, 0}, {0, 0.4}, {50, 0}, {50, 3}, {50, 60}};

}  // namespace

// x and v are of order 1; a velocity from two places has 1/step = 20 times their rounding, and the
// second place is some ten roundings off.
TEST(DiscreteConstants, MoveAParticleOnTheGridAsTheSolutionDoes) {
  for (const auto& [stiffness, damping] : cases) {
    const auto constants = discrete_constants(stiffness, damping, mass, step);
    const auto ends = discrete_end_constants(stiffness, damping, mass, step);
    Overlap start{0.3, -1.0};
    double x = start.x, rate = rate_after(start.v, ends.first, x, 0.5 * step);
    for (int n = 1; n <= 10; n++) {
      x += step * rate;
      const Overlap exact = motion(stiffness, damping, start, n * step);
      EXPECT_NEAR(x, exact.x, 1e-14 * n) << stiffness << " " << damping;
      EXPECT_NEAR(rate_after(rate, ends.last, x, 0.5 * step), exact.v, 1e-13 * n)
          << stiffness << " " << damping;
      rate = rate_after(rate, constants, x, step);
    }
  }
}

// Places half a swing apart have no velocity between them.
TEST(DiscreteConstants, EndsOfAStepOfHalfASwingAreThoseOfAnyStep) {
  const double half_swing = std::acos(-1.0) / std::sqrt(50.0 / mass);
  for (const double part : {0.97, 1.0, 1.2}) {
    const auto plain = discrete_constants(50.0, 0.0, mass, part * half_swing);
    const auto ends = discrete_end_constants(50.0, 0.0, mass, part * half_swing);
    for (const DiscreteConstants& c : {ends.first, ends.last}) {
      EXPECT_EQ(c.stiffness, plain.stiffness);
      EXPECT_EQ(c.damping, plain.damping);
    }
  }
}

}  // namespace cohesion::contact_solver
