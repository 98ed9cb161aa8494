// SPDX-License-Identifier: BSD-3-Clause
#include "event_stepping/plane_pair.h"

#include <gtest/gtest.h>

#include "event_stepping/pair_run.h"

namespace cohesion::event_stepping {
namespace {

constexpr double inverse_mass = 1.0 / (2650.0 * 4.0 / 3.0 * 3.14159265358979 * 1.25e-10);

}  // namespace

TEST(PlanePair, IsTheLimitOfALargeSecondSphere) {
  const double r = thesis::radius, large = 1e6 * r;
  contact::Adhesion a = thesis::adhesion(5e-19);
  for (const double v : {1e-3, 4e-3, 0.1})
    for (const double along : {0.0, 0.05}) {
      const double dt = 0.25 * thesis::contact_time;
      const Body particle{r, inverse_mass};
      PairRun<PlanePair> plane(thesis::contact(), a, particle, {0.0, 0.0}, dt,
                               {{0, 0, r + 1.3e-7}, {0, 0, -v}});
      PairRun<SpherePair> sphere(thesis::contact(), a, particle, {large, 0.0}, dt,
                                 {{0, 0, large + r + 1.3e-7}, {along, 0, -v}});
      for (int n = 0; n < 60; n++) plane.step(), sphere.step();
      // Centrifugal acceleration u^2/(1e6 r) = 5e-6 m/s^2 over 60 steps: 7e-9 m/s; the distance of
      // 500 m is held to 1e-13 m, which a contact turns into w0 1e-13 = 3e-9 m/s, a step into
      // 1e-13 m/dt = 5e-9 m/s.
      EXPECT_NEAR(plane.approach(), sphere.approach(), 5e-8) << v << " " << along;
      EXPECT_EQ(plane.last().inside, sphere.last().inside) << v << " " << along;
      EXPECT_NEAR(plane.distance() - r, sphere.distance() - r - large, 5e-8 * 60.0 * dt + 1e-12)
          << v << " " << along;
    }
}

TEST(PlanePair, RestitutionIsExactForAnyStepAndPhase) {
  const double mu = 1.0 / inverse_mass;
  const contact::LinearSpringDashpot law(800.0, 0.79e-3, mu);
  for (const double part : {2.0, 4.0, 10.0, 50.0})
    for (int phase = 0; phase < 8; phase++) {
      const double dt = law.contact_time() / part, v = 0.3;
      PairRun<PlanePair> run(thesis::contact(), {}, {thesis::radius, inverse_mass}, {0.0, 0.0}, dt,
                             {{0, thesis::radius + v * dt * (phase + 0.37) / 8.0, 0}, {0, -v, 0}});
      ASSERT_TRUE(run.run_to_escape(200));
      // Position is rounded to 1e-19 m in each of < 60 steps, an error of w0 1e-19 = 2e-15 m/s
      // each.
      EXPECT_NEAR(run.state().velocity.y, v * law.restitution(), 3e-13);
    }
}

TEST(PlanePair, EscapesAtTheVelocityOfAnEquallyHeavyPair) {
  // Two thesis particles have reduced mass m/2; a particle of that mass against a plane with the
  // same adhesion moves alike: same escape velocity (sphere_pair_test.cpp).
  const double escape = 0.0026749904905705694;
  const Body particle{thesis::radius, 1.0 / thesis::reduced_mass};
  for (const double part : {2.0, 4.0, 10.0, 50.0})
    for (int phase = 0; phase < 8; phase++)
      for (const double off : {-1e-8, 1e-8}) {
        const double dt = thesis::contact_time / part, v = escape * (1.0 + off);
        PairRun<PlanePair> run(
            thesis::contact(), thesis::adhesion(5e-19), particle, {0.0, 0.0}, dt,
            {{thesis::radius + thesis::range + v * dt * (phase + 0.37) / 8.0, 0, 0}, {-v, 0, 0}});
        EXPECT_EQ(run.run_to_escape(4 * static_cast<int>(part)), off > 0.0) << part << " " << phase;
      }
}

}  // namespace cohesion::event_stepping
