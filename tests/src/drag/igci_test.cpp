// SPDX-License-Identifier: BSD-3-Clause
#include "drag/igci.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cohesion::drag {
namespace {

/// How far a function rises at phi
template <class Function>
double jump(const Function& f, double phi) {
  return f(std::nextafter(phi, 1.0)) - f(std::nextafter(phi, 0.0));
}

}  // namespace

TEST(Igci, HasTheValuesThatAHandFinds) {
  // h(0.05) = 0.868 exp(-0.019) - 0.176 exp(-5.96) = 0.851664 - 0.000454
  EXPECT_NEAR(Igci::h(0.05), 0.851210, 1e-6);
  // G(0.05) = exp(0.24 ln 0.05) (1.48 + exp(-0.9)) = 0.487253 * 1.886570
  EXPECT_NEAR(Igci::G(0.05), 0.919233, 1e-5);
  // s = 4^1.6 = 2^3.2 = 9.189587: 1 - 0.851210 * 0.919233 * 9.189587/9.589587
  EXPECT_NEAR(Igci::factor(0.05, 4.0), 0.250170, 1e-5);
  // (-0.09) (162 - 527 + 550.75 - 187.625) = (-0.09) (-1.875)
  EXPECT_NEAR(Igci::h(0.5), 0.16875, 1e-12);
}

TEST(Igci, JumpsNoFurtherThanItIsDocumentedTo) {
  for (const double phi : {0.0012, 0.014, 0.25, 0.455, 0.59})
    EXPECT_NEAR(jump(Igci::h, phi), 0.0, 0.002) << phi;
  EXPECT_NEAR(jump(Igci::G, 0.18), 0.0, 0.007);
}

TEST(Igci, LeavesFineCellsFewParticlesAndPackedBedsAsTheyAre) {
  for (const double phi : {0.001, 0.1, 0.4}) EXPECT_NEAR(Igci::factor(phi, 1e-9), 1.0, 1e-12);
  for (const double filter : {0.1, 10.0, 1e9}) {
    EXPECT_EQ(Igci::factor(0.0, filter), 1.0);
    EXPECT_EQ(Igci::factor(0.62, filter), 1.0);
  }
}

TEST(Igci, IsAShareOfTheDragThatFallsWithTheFilter) {
  for (int permille = 1; permille <= 640; permille++) {
    const double phi = permille / 1000.0;
    double last = 1.0;
    for (double filter = 1e-2; filter < 1e4; filter *= 1.5) {
      const double factor = Igci::factor(phi, filter);
      ASSERT_GT(factor, 0.0) << phi << " " << filter;
      // The root of h at 0.59 is one to the roundings of a factor of -2: no more than one.
      ASSERT_LE(factor, last + 1e-15) << phi << " " << filter;
      last = factor;
    }
  }
}

TEST(StokesTerminalSpeed, IsTheBalanceOfItsDrag) {
  // 3 pi mu d v = (rho_s - rho) g pi d^3/6
  const double d = 75e-6, rho_s = 1500.0, rho = 1.2, mu = 1.8e-5, g = 9.81;
  const double v = stokes_terminal_speed(d, rho_s, rho, mu, g);
  EXPECT_NEAR(3.0 * mu * d * v / ((rho_s - rho) * g * d * d * d / 6.0), 1.0, 1e-14);
}

}  // namespace cohesion::drag
