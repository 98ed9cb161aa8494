// SPDX-License-Identifier: BSD-3-Clause
#include "liquid/sphere_in_liquid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drag/particle_drag.h"
#include "vector3.h"

namespace cohesion::liquid {
namespace {

/// The slip after a time, u held: in `parts` steps of the law.
Vector3 slip_after(const SphereInLiquid& sphere, Vector3 slip, const Vector3& force, double time,
                   int parts) {
  for (int i = 0; i < parts; i++)
    slip -= (time / parts) * acceleration(sphere, slip, force, time / parts);
  return slip;
}

void expect_near(const Vector3& found, const Vector3& expected, double tolerance) {
  EXPECT_NEAR(found.x, expected.x, tolerance);
  EXPECT_NEAR(found.y, expected.y, tolerance);
  EXPECT_NEAR(found.z, expected.z, tolerance);
}

}  // namespace

TEST(SphereInLiquid, LetGoAtRestHasTheAccelerationOfItsMassAndTheAddedOne) {
  // (rho_e - rho_b) g/(rho_b + C rho_e), per volume 1, with a thousandth of the density: any step.
  const double rho = 1000.0, sphere_rho = 1.0, g = 9.81;
  const SphereInLiquid sphere{0.0, 0.0, sphere_rho, 0.5 * rho, {}};
  for (const double dt : {1e-9, 1e-3, 10.0})
    EXPECT_NEAR(acceleration(sphere, {}, {0.0, 0.0, (rho - sphere_rho) * g}, dt).z /
                    ((rho - sphere_rho) * g / (sphere_rho + 0.5 * rho)),
                1.0, 1e-15);
}

TEST(SphereInLiquid, InAnAcceleratingLiquidGoesThreeTimesAsFastWhenItHasNoMass) {
  // M dv/dt = rho V Du/Dt (pressure) + C rho V Du/Dt: (1 + C)/C = 3 for C = 1/2.
  const SphereInLiquid sphere{0.0, 0.0, 0.0, 0.5, {}};
  EXPECT_NEAR(acceleration(sphere, {}, {1.0 + 0.5, 0.0, 0.0}, 0.1).x, 3.0, 1e-15);
}

TEST(SphereInLiquid, WithoutLiftAndSquareIsParticleDragWithTheWholeMass) {
  for (const double dt : {1e-6, 0.1, 100.0}) {
    const SphereInLiquid sphere{2.0, 0.0, 0.3, 1.2, {}};
    const drag::ParticleDrag drag(2.0, 1.5, dt);
    const double plain = (drag.force(-0.7, 5.0) + 5.0) / 1.5;
    const double about = (drag.force_about(-0.7, 5.0) + 5.0) / 1.5;
    // Some ten roundings of terms that cancel at long steps: of 1.4 + 5 over 1.5.
    EXPECT_NEAR(acceleration(sphere, {-0.7, 0.0, 0.0}, {5.0, 0.0, 0.0}, dt).x, plain, 5e-15);
    EXPECT_NEAR(acceleration_about(sphere, {-0.7, 0.0, 0.0}, {5.0, 0.0, 0.0}, dt).x, about, 5e-15);
  }
}

TEST(SphereInLiquid, LiftIsTheSlipTimesTheVorticity) {
  // In a step that is short beside M/|L| the force is s x L, to the order of the step, 1e-9.
  const SphereInLiquid sphere{0.0, 0.0, 1.0, 0.5, {0.2, -0.4, 0.3}};
  const Vector3 slip{1.0, 2.0, -0.5};
  expect_near(1.5 * acceleration(sphere, slip, {}, 1e-9), cross(slip, sphere.lift), 2e-9);
}

TEST(SphereInLiquid, TurnsExactlyInAnyNumberOfSteps) {
  // Linear, so that the law is exact: one step or a thousand, with a rounding for each of them.
  const SphereInLiquid sphere{0.8, 0.0, 0.1, 0.5, {1.0, -2.0, 0.7}};
  const Vector3 slip{1.0, 2.0, -0.5}, force{0.4, -0.1, -2.0};
  const Vector3 once = slip_after(sphere, slip, force, 0.9, 1);
  expect_near(slip_after(sphere, slip, force, 0.9, 1000), once, 1000 * 4e-16 * 10.0);
  // Across L the slip turns, and decays with b/M, with nothing else: |s| = exp(-b t/M) |s_0|.
  const SphereInLiquid spun{0.8, 0.0, 0.1, 0.5, {0.0, 0.0, 3.0}};
  const Vector3 turned = slip_after(spun, {1.0, 0.0, 0.0}, {}, 0.9, 1);
  EXPECT_NEAR(norm(turned), std::exp(-0.8 * 0.9 / 0.6), 1e-15);
  // ds/dt = -(s x L)/M, so about L with |L|/M, as a screw along it: s x L of x and z is -y.
  EXPECT_NEAR(std::atan2(turned.y, turned.x),
              std::remainder(3.0 * 0.9 / 0.6, 2.0 * 3.14159265358979), 1e-13);
}

TEST(SphereInLiquid, FromTheMiddleSlipIsFromThatAtTheStart) {
  for (const double dt : {1e-5, 0.3, 5.0}) {
    const SphereInLiquid sphere{0.8, 0.0, 0.1, 0.5, {1.0, -2.0, 0.7}};
    const Vector3 slip{1.0, 2.0, -0.5}, force{0.4, -0.1, -2.0};
    const Vector3 a = acceleration(sphere, slip, force, dt);
    expect_near(acceleration_about(sphere, slip - 0.5 * dt * a, force, dt), a,
                1e-14 * (1.0 + norm(a)) * (1.0 + dt * dt));
  }
}

TEST(SphereInLiquid, WithTheSquareRisesAsTheHyperbolicTangent) {
  // From rest v = v_t tanh(F t/(M v_t)), v_t = sqrt(F/q): of second order in the step.
  const double force = 3.0, q = 2.0, inertia = 0.6, time = 0.3;
  const SphereInLiquid sphere{0.0, q, 0.1, 0.5, {}};
  const double terminal = std::sqrt(force / q);
  const double exact = terminal * std::tanh(force * time / (inertia * terminal));
  double last = 0.0;
  for (const int steps : {50, 100, 200}) {
    const double error = -slip_after(sphere, {}, {force, 0.0, 0.0}, time, steps).x - exact;
    // Halved steps leave a quarter: 4 to within a tenth, with the next order some 1/50.
    if (last != 0.0) {
      EXPECT_NEAR(last / error, 4.0, 0.4) << steps;
    }
    last = error;
  }
  EXPECT_LT(std::abs(last / exact), 1e-4);
}

TEST(SphereInLiquid, WithTheSquareKeepsAndFindsTheTerminalVelocityInStepsOfAnyLength) {
  const double force = 3.0, q = 2.0;
  const SphereInLiquid sphere{0.0, q, 1e-3, 0.5, {}};
  const double terminal = std::sqrt(force / q);
  for (const double dt : {1e-3, 1.0, 100.0}) {
    EXPECT_NEAR(acceleration(sphere, {-terminal, 0.0, 0.0}, {force, 0.0, 0.0}, dt).x * dt, 0.0,
                1e-14 * (1.0 + dt))
        << dt;
    // Stiff steps leave half of the distance with the sign turned.
    const double found = -slip_after(sphere, {}, {force, 0.0, 0.0}, 60.0 * dt, 60).x;
    if (dt >= 1.0) {
      EXPECT_NEAR(found, terminal, 1e-12) << dt;
    }
  }
}

}  // namespace cohesion::liquid
