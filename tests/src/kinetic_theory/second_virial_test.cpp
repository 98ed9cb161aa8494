// SPDX-License-Identifier: BSD-3-Clause
#include "kinetic_theory/second_virial.h"

#include "hamaker/small_gap.h"
#include "refuses.h"

namespace cohesion::kinetic_theory {
namespace {

using Attraction = hamaker::HamakerLaw<hamaker::SmallGap>;
constexpr double r = 0.5, d = 1.0;

/// A law with the surface adhesion `force` and the cut-offs, for two spheres of the radius r, whose
/// R* is r/2.
Attraction with_force(double force, double surface_cutoff, double outer_cutoff) {
  return Attraction(
      {6.0 * force * surface_cutoff * surface_cutoff / (0.5 * r), surface_cutoff, outer_cutoff});
}

}  // namespace

TEST(GaussLegendre, IntegratesWhatHasAClosedForm) {
  EXPECT_NEAR(gauss_legendre([](double x) { return std::pow(x, 9); }, 0.0, 2.0), 102.4, 1e-11);
  EXPECT_NEAR(gauss_legendre([](double x) { return std::exp(30.0 * x); }, 0.0, 1.0) * 30.0 /
                  std::expm1(30.0),
              1.0, 1e-12);
  EXPECT_NEAR(gauss_legendre([](double x) { return std::sin(x); }, -1.0, 1.0), 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(gauss_legendre([](double) { return 3.0; }, 2.0, 2.0), 0.0);
}

TEST(GaussLegendre, SaysWhenItCannot) {
  EXPECT_TRUE(std::isnan(gauss_legendre([](double x) { return 1.0 / x; }, 0.0, 1.0)));
}

TEST(SecondVirial, OfWellsIsTheClosedForm) {
  const struct {
    double lambda, depth_over_t, ratio;
  } rows[] = {{1.05, 1.0, 0.729}, {1.1, 0.5, 0.785}, {1.1, 1.0, 0.431}, {1.1, 0.0, 1.0}};
  for (const auto& [lambda, depth_over_t, ratio] : rows)
    EXPECT_NEAR(second_virial_of_well(lambda, depth_over_t), ratio, 0.0005) << lambda;
}

TEST(SecondVirial, OfAForceWithoutTailIsTheClosedForm) {
  // U = -F (H_cut - H): with a = F/T and g(H) = (d + H)^2, the integral of exp(a (H_cut - H)) g(H)
  // is [g/a + g'/a^2 + g''/a^3] exp(a (H_cut - H)) between the ends. The tail that is left is 1e-9
  // of H_cut long.
  for (const double a : {0.1, 10.0, 300.0}) {
    const double cut = 0.02, T = 2.0;
    const auto part = [&](double gap) {
      const double g = (d + gap) * (d + gap), slope = 2.0 * (d + gap), curve = 2.0;
      return (g + (slope + curve / a) / a) / a * std::exp(a * (cut - gap));
    };
    const double gathered = part(0.0) - part(cut) - (std::pow(d + cut, 3) - d * d * d) / 3.0;
    const double expected = 1.0 - 3.0 * gathered;
    EXPECT_NEAR(second_virial_of_attraction(with_force(a * T, cut, cut * (1.0 + 1e-9)), r, T),
                expected, 1e-8 * (1.0 + std::abs(expected)))
        << a;
  }
}

TEST(SecondVirial, OfWeakAttractionIsTheMeanOfItsEnergy) {
  // To first order b = 1 + 3/(d^3 T) int U r^2 dr, with U = -k (1/H - 1/H_out) between the cut-offs
  // and k = (A/6) R*; what follows is of the order of U/T = 1e-6 of that.
  const double cut = 0.001, out = 0.2, T = 1.0, force = 1e-6 * T / cut, k = force * cut * cut;
  const auto tail = [&](double H) {
    return -k *
           (d * d * std::log(H) + 2.0 * d * H + 0.5 * H * H - std::pow(d + H, 3) / (3.0 * out));
  };
  const double depth = k * (1.0 / cut - 1.0 / out) + force * cut;  // at touch; it falls by force H
  const auto below = [&](double H) {
    return -depth * std::pow(d + H, 3) / 3.0 +
           force * (d * d * H * H / 2.0 + 2.0 * d * H * H * H / 3.0 + std::pow(H, 4) / 4.0);
  };
  const double expected = 3.0 / T * (tail(out) - tail(cut) + below(cut) - below(0.0));
  const double found = second_virial_of_attraction(with_force(force, cut, out), r, T) - 1.0;
  // 1 + expected is what is computed: rounding 1e-16 of 1, over an expected 1e-8.
  EXPECT_NEAR(found / expected, 1.0, 1e-5);
}

TEST(SecondVirial, IsOneWithoutAttraction) {
  EXPECT_DOUBLE_EQ(second_virial_of_attraction(with_force(0.0, 0.01, 0.1), r, 1.0), 1.0);
}

TEST(SecondVirial, RefusesWhatItCannotBe) {
  const auto attraction = with_force(1.0, 0.01, 0.1);
  expect_refused([&] { second_virial_of_attraction(attraction, 0.0, 1.0); },
                 "radius of the spheres = 0");
  expect_refused([&] { second_virial_of_attraction(attraction, r, -1.0); }, "temperature T = -1");
  expect_refused([&] { second_virial_of_attraction(attraction, r, 1e-6); }, "must be below 709");
  expect_refused([&] { second_virial_of_well(0.9, 1.0); }, "ratio r_out/r of the well = 0.9");
  expect_refused([&] { second_virial_of_well(1.1, -1.0); }, "depth D of the well = -1");
}

}  // namespace cohesion::kinetic_theory
