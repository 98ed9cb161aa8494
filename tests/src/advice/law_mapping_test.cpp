// SPDX-License-Identifier: BSD-3-Clause
#include "advice/law_mapping.h"

#include <gtest/gtest.h>

#include "event_stepping/pair_run.h"
#include "refuses.h"

namespace cohesion::advice {
namespace {

namespace thesis = event_stepping::thesis;

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
          // Twice sampling_error is what the search stops at; exact laws to rounding.
          const double tolerance = hamaker_step ? 2.0 * sampling_error : 1e-11;
          EXPECT_NEAR(found / speed, 1.0, tolerance);
          EXPECT_NEAR(std::sqrt(d / 5e-11), found / speed, well_step ? sampling_error : 1e-11);
        }
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
  expect_refused(
      [] {
        HamakerKind{&hamaker::forms[0], 1e-7, 4e-10, 0.0}.law(1e-19);
      },
      "surface cut-off");
  const HeadOnPair elastic{{800.0, 0.0, thesis::reduced_mass}, spheres.geometry, 1e-3};
  expect_refused([&] { hamaker_escape(elastic, smooth.law(1e-19), std::nullopt); },
                 "restitution e");
}

}  // namespace cohesion::advice
