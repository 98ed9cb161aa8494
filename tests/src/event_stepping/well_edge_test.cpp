// SPDX-License-Identifier: BSD-3-Clause
#include "event_stepping/well_edge.h"

#include <gtest/gtest.h>

#include <limits>

#include "event_stepping/pair_run.h"

namespace cohesion::event_stepping {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double core = 2.0 * thesis::radius;
const Body particle{thesis::radius, 1.0 / thesis::mass};

}  // namespace

TEST(WellEdge, KnowsNoContact) {
  // Every path is refracted, through the place of the contact too: by 2 (asin(s/edge) -
  // asin(s/(n edge))), n = sqrt(1 + 2 D/(mu v^2)).
  const double depth = 1e-11, speed = 0.02;
  const double n = std::sqrt(1.0 + 2.0 * depth / thesis::reduced_mass / (speed * speed));
  for (const double ratio : {1.01, 1.5})
    for (const double part : {0.1, 4.0})
      for (const double share : {0.0, 0.3, 0.9}) {
        const double edge = ratio * core, offset = share * edge, dt = thesis::contact_time / part;
        const double along = std::sqrt(edge * edge - offset * offset) + 1e-5;
        PairRun<WellEdge> run(thesis::contact(), {0.0, edge - core, depth}, particle, particle, dt,
                              {{along, offset, 0}, {-speed, 0, 0}});
        const int steps = static_cast<int>(2.5 * edge / speed / dt) + 2;
        double least = 0.0;
        for (int k = 0; k < steps; k++) {
          run.step();
          least = std::min(least, run.stored());
          EXPECT_EQ(run.last().normal.contact_time, 0.0);
        }
        EXPECT_EQ(run.last().inside, false);
        EXPECT_EQ(least, -depth);
        EXPECT_EQ(run.stored(), 0.0);
        const Vector3 v = run.state().velocity;
        const double deflection = 2.0 * (std::asin(offset / edge) - std::asin(offset / n / edge));
        // Positions are rounded by 1e-19 m four times in each step, at random, 5 sigma; two events
        // of some ten roundings.
        const double slope = 2.0 / std::sqrt(1.0 - share * share);
        EXPECT_NEAR(std::atan2(v.y, -v.x), -deflection,
                    slope * (5.0 * std::sqrt(4.0 * steps) * 1e-19 / edge + 20.0 * eps));
        EXPECT_NEAR(norm(v) / speed, 1.0, 40.0 * eps);
      }
}

TEST(WellEdge, TurnsACapturedPairBackAtTheEdge) {
  const double depth = 5e-11, dt = 1e-5, edge = 1.01 * core;
  const double slow = 0.5 * std::sqrt(2.0 * depth / thesis::reduced_mass);
  PairRun<WellEdge> run(thesis::contact(), {0.0, edge - core, depth}, particle, particle, dt,
                        {{edge - 0.3 * slow * dt, 0, 0}, {slow, 0, 0}});
  run.set_inside(true, core - edge);
  run.step();
  EXPECT_TRUE(run.last().inside);
  EXPECT_NEAR(run.state().velocity.x / slow, -1.0, 8.0 * eps);
  EXPECT_NEAR(run.distance(), edge - 0.7 * slow * dt, 1e-18);
}

}  // namespace cohesion::event_stepping
