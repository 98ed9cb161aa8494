// SPDX-License-Identifier: BSD-3-Clause
#include "sampled_contact/sampled_well.h"

#include <gtest/gtest.h>

#include "contact_solver/thesis_contact.h"

namespace cohesion::sampled_contact {
namespace {

constexpr double core = 2.0 * thesis::radius, edge = 1.01 * core, depth = 5e-11;
constexpr double dt = 1e-5;
const StepWindow window{0.5 * dt, 0.5 * dt};
const double well_speed = std::sqrt(2.0 * depth / thesis::reduced_mass);

SampledWell pair() {
  return {contact::normal_contact(thesis::contact(), thesis::reduced_mass),
          {0.0, edge - core, depth},
          core};
}

/// Change of energy over D and flag after a step from the grid point.
std::pair<double, bool> step(double distance, double velocity, bool inside) {
  const PairStep now = pair().advance({distance, 0, 0}, {velocity, 3e-3, 0}, window, inside);
  const double after = velocity + now.velocity_change.x;
  EXPECT_EQ(now.velocity_change.y, 0.0);
  if (inside && velocity < 0.0) {
    EXPECT_EQ(now.velocity_change.x, 0.0);
  }
  return {0.5 * thesis::reduced_mass * (after * after - velocity * velocity) / depth, now.inside};
}

}  // namespace

TEST(SampledWell, GivesTheImpulseWhereThePairIsFoundBeyondTheEdge) {
  const double v = 2.0 * well_speed, slow = 0.5 * well_speed;
  // A few roundings of energies up to 5 D.
  const double few = 5e-15;
  const auto is = [&](std::pair<double, bool> got, double gain, bool inside) {
    EXPECT_NEAR(got.first, gain, few);
    EXPECT_EQ(got.second, inside);
  };
  is(step(0.999 * edge, -v, false), 1.0, true);
  is(step(0.999 * edge, -slow, false), 1.0, true);
  is(step(1.001 * edge, -v, false), 0.0, false);
  is(step(0.999 * edge, -v, true), 0.0, true);
  is(step(0.999 * edge, v, true), 0.0, true);
  is(step(1.001 * edge, v, true), -1.0, false);
  is(step(1.001 * edge, slow, true), 0.0, true);  // captured
  is(step(0.999 * edge, v, false), 0.0, false);   // parting: it never was in
  is(step(1.001 * edge, -v, true), 0.0, true);
  is(step(1.001 * edge, -slow, true), 0.0, true);  // on its way back
}

TEST(SampledWell, InContactItIsTheSampledSpring) {
  const double overlap = 1e-6, rate = 0.01;
  const PairStep now = pair().advance({core - overlap, 0, 0}, {-rate, 0, 0}, window, true);
  const double force = 800.0 * overlap + 0.79e-3 * rate;
  // The overlap is a difference of numbers a thousand times larger.
  EXPECT_NEAR(now.velocity_change.x, force * dt / thesis::reduced_mass,
              1e-12 * force * dt / thesis::reduced_mass);
  EXPECT_NEAR(pair().spring_energy(overlap), 400.0 * overlap * overlap, 1e-12 * 4e-10);
  EXPECT_EQ(pair().adhesion_energy(overlap), -depth);
}

}  // namespace cohesion::sampled_contact
