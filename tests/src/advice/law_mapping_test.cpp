// SPDX-License-Identifier: BSD-3-Clause
#include "advice/law_mapping.h"

#include <gtest/gtest.h>

#include "contact_solver/thesis_contact.h"
#include "refuses.h"

namespace cohesion::advice {
namespace {

constexpr double width = 1e-5;
const HeadOnPair spheres{contact::normal_contact(thesis::contact(), thesis::reduced_mass),
                         two_spheres(thesis::radius, thesis::radius), 2.0 * thesis::radius};
const HeadOnPair wall{contact::normal_contact(thesis::contact(), thesis::mass),
                      sphere_and_plane(thesis::radius), thesis::radius};
const HamakerKind smooth{&hamaker::forms[0], 4e-10, 1e-7, 0.0};
const HamakerKind rough{&hamaker::forms[1], 4e-10, 1e-7, 2e-8};

}  // namespace

TEST(LawMapping, BothWaysThroughAllSchemes) {
  const double step = thesis::contact_time / 10.0;
  for (const HeadOnPair& pair : {spheres, wall})
    for (const HamakerKind& kind : {smooth, rough})
      for (const auto hamaker_step : {std::optional<double>{}, std::optional{step}})
        for (const auto well_step : {std::optional<double>{}, std::optional{step}}) {
          const double speed = well_escape(pair, 5e-11, width, well_step).mean;
          const double a = hamaker_constant_of(pair, speed, kind, hamaker_step);
          const double found = hamaker_escape(pair, kind.law(a), hamaker_step).mean;
          const double d = depth_of(pair, found, width, well_step);
          // Twice sampling_error of the exact velocity, which may be a tenth larger than the mean,
          // is what the search stops at; exact laws to rounding.
          const double tolerance = hamaker_step ? 2.2 * sampling_error : 1e-11;
          EXPECT_NEAR(found / speed, 1.0, tolerance);
          EXPECT_NEAR(std::sqrt(d / 5e-11), found / speed, well_step ? sampling_error : 1e-11);
        }
}

/// The constant that is found against the scheme written out: force at the grid, kick, drift. Share
/// of 600 speeds at 600 positions each, up to twice the exact escape velocity, that sticks.
TEST(LawMapping, FoundConstantHoldsAsWrittenOut) {
  const double step = thesis::contact_time / 10.0, speed = 4e-3, most = 2.0 * speed;
  const double a = hamaker_constant_of(spheres, speed, smooth, step);
  constexpr int n = 600;
  int stuck = 0;
  for (int i = 0; i < n; i++)
    for (int k = 0; k < n; k++) {
      double v = -most * (i + 0.5) / n;
      double x = 1e-7 - v * step * std::fmod((k + 0.5) / n + 0.7548776662 * i, 1.0);
      for (bool parting = false; !parting || x < 1e-7;) {
        const double gap = std::max(x, 4e-10);
        const double pull = x < 1e-7 ? a * thesis::radius / 12.0 / gap / gap : 0.0;
        const double push = x < 0.0 ? -800.0 * x - 0.79e-3 * v : 0.0;
        v += step * (push - pull) / thesis::reduced_mass;
        if (parting && v <= 0.0) {
          stuck++;
          break;
        }
        parting = v > 0.0;
        if (parting && x >= 1e-7) break;
        x += step * v;
      }
    }
  // The search stops at twice sampling_error; three standard errors of both means.
  const double tolerance = 2.0 * sampling_error + 3.0 * std::hypot(sampling_error, 2.0 / (2.0 * n));
  EXPECT_NEAR(most * stuck / n / n / speed, 1.0, tolerance);
}

TEST(LawMapping, ExactAtAnyStepIsEqualEscape) {
  const hamaker::AnyLaw law = smooth.law(7.49e-19);
  const SampledEscape found = hamaker_escape(spheres, law, std::nullopt);
  EXPECT_EQ(found.mean, found.slowest_parted);
  EXPECT_EQ(found.mean, found.fastest_stuck);
  EXPECT_EQ(depth_of(spheres, found.mean, width, std::nullopt),
            equal_depth(spheres.spring, adhesion_of(spheres, law)));
}

TEST(LawMapping, NothingHoldsAtNoSpeed) {
  EXPECT_EQ(depth_of(spheres, 0.0, width, 1e-5), 0.0);
  EXPECT_EQ(hamaker_constant_of(spheres, 0.0, smooth, std::nullopt), 0.0);
}

TEST(LawMapping, RefusesLawsThatAreNone) {
  expect_refused([] { HamakerKind{&hamaker::forms[0], 1e-7, 4e-10, 0.0}.law(1e-19); },
                 "surface cut-off");
  const HeadOnPair elastic{{800.0, 0.0, thesis::reduced_mass}, spheres.geometry, 1e-3};
  expect_refused([&] { hamaker_escape(elastic, smooth.law(1e-19), std::nullopt); },
                 "restitution e");
}

}  // namespace cohesion::advice
