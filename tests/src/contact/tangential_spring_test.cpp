// SPDX-License-Identifier: BSD-3-Clause
#include "contact/tangential_spring.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "constants.h"

namespace cohesion::contact {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double much = 1e300;  // of normal impulse: never slides

double kinetic(double mass, const Vector3& v) { return 0.5 * mass * dot(v, v); }

}  // namespace

TEST(TangentialSpring, BalancesTheEnergyOfEveryStep) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int sliding = 0;
  for (int n = 0; n < 5000; n++) {
    const TangentialSpring spring(
        {std::exp(5.0 * uniform(random)), std::exp(5.0 * uniform(random)), 0.5});
    const double mass = std::exp(uniform(random)), time = std::exp(3.0 * uniform(random));
    const Vector3 s{uniform(random), uniform(random), 0.0},
        v{uniform(random), uniform(random), 0.0};
    const double normal = std::exp(3.0 * uniform(random));
    const double at_end = (1.0 + uniform(random)) * normal / time;
    const TangentialStep step = spring.advance(s, v, time, 1.0 / mass, normal, at_end);
    const Vector3 after = v + (1.0 / mass) * step.impulse;
    const double before = kinetic(mass, v) + spring.stored_energy(s);
    const double rest = kinetic(mass, after) + spring.stored_energy(step.displacement) +
                        step.damped + step.friction;
    // Some thirty roundings of the largest term.
    const double largest = before + std::abs(step.damped) + std::abs(step.friction) +
                           spring.stored_energy(step.displacement) + kinetic(mass, after);
    EXPECT_NEAR(rest, before, 64 * eps * largest);
    // Neither dashpot nor slider ever gives energy.
    EXPECT_GE(step.damped, 0.0);
    EXPECT_GE(step.friction, -64 * eps * largest);
    // The Coulomb cap, reached when it slides.
    EXPECT_LE(norm(step.impulse), 0.5 * normal * (1.0 + 4 * eps));
    sliding += norm(step.impulse) >= 0.5 * normal * (1.0 - 4 * eps);
  }
  EXPECT_GT(sliding, 1000);
  EXPECT_LT(sliding, 4500);
}

TEST(TangentialSpring, SticksAtTheMidpointRulesFrequencyWithoutLoss) {
  // A rotation by 2 atan(w T/2) per step in the plane of w s and v, w = sqrt(K_t/m_t).
  const TangentialSpring spring({2.0, 0.0, 1.0});
  const double mass = 3.0, w = std::sqrt(2.0 / 3.0);
  for (const double time : {0.01, 1.0, 40.0}) {
    Vector3 s{0.0, 0.0, 0.0}, v{1.0, 0.0, 0.0};
    for (int n = 1; n <= 100; n++) {
      const TangentialStep step = spring.advance(s, v, time, 1.0 / mass, much, much);
      v += (1.0 / mass) * step.impulse;
      s = step.displacement;
      const double angle = n * 2.0 * std::atan(0.5 * w * time);
      // A few roundings per step, of amplitudes w s and v, as seen through 1/(w T).
      EXPECT_NEAR(v.x, std::cos(angle), 16 * eps * n * (1.0 + w * time));
      EXPECT_NEAR(w * s.x, std::sin(angle), 16 * eps * n * (1.0 + w * time));
      EXPECT_EQ(step.friction, 0.0);
    }
  }
}

TEST(TangentialSpring, SlidingCarriesTheCoulombForceAndItsWorkIsLost) {
  // Long sliding: the surface moves at u all the time (a very heavy partner).
  const TangentialSpring spring({100.0, 0.0, 0.3});
  const double heavy = 1e12, time = 0.01, normal_force = 2.0, u = 1.0;
  Vector3 s{};
  const Vector3 v{0.0, u, 0.0};
  double lost = 0.0;
  for (int n = 0; n < 100; n++) {
    const TangentialStep step =
        spring.advance(s, v, time, 1.0 / heavy, normal_force * time, normal_force);
    s = step.displacement;
    lost += step.friction + step.damped;
  }
  // The spring is stretched to mu_f N/K_t, and friction has taken mu_f N over the way, less what
  // the spring holds, and less what it saved while it was stretched, mu_f N s/2 in all. A step that
  // starts to slide within it counts as sliding whole: mu_f N u T.
  EXPECT_NEAR(s.y, 0.3 * normal_force / 100.0, 1e-14);
  EXPECT_NEAR(lost, 0.3 * normal_force * (u * 1.0 - s.y), 0.3 * normal_force * u * time);
}

TEST(TangentialSpring, SlidingOpposesTheMotionAtTheCoulombForce) {
  const Vector3 v{0.6, -0.8, 0.0};
  const double coulomb = 0.4 * 0.05 / 0.1;
  // Spring and dashpot under the Coulomb force: s = (mu_f N/K_t) (1 - exp(-K_t T/eta_t)).
  for (const double stiffness : {1.0, 50.0}) {
    const TangentialSpring spring({stiffness, 0.2, 0.4});
    const TangentialStep step = spring.advance({}, v, 0.1, 1.0, 0.05, 0.5);
    EXPECT_NEAR(step.impulse.x, -0.4 * 0.05 * 0.6, 4 * eps);
    EXPECT_NEAR(step.impulse.y, 0.4 * 0.05 * 0.8, 4 * eps);
    const double s = norm(step.displacement);
    EXPECT_NEAR(stiffness * s, -coulomb * std::expm1(-stiffness * 0.1 / 0.2), 16 * eps);
    EXPECT_NEAR(dot(step.displacement, v), s, 16 * eps);  // along v, of length 1
  }
}

TEST(TangentialSpring, IsOfSecondOrderWhereSlidingEnds) {
  // Under N = sin t the surfaces slide, stick while N is large, and slide again. All scales are 1.
  const auto end_velocity = [](double damping, double friction, int steps) {
    const TangentialSpring spring({1.0, damping, friction});
    const double time = 0.95 * pi / steps;
    Vector3 s{}, v{1.0, 0.0, 0.0};
    for (int n = 0; n < steps; n++) {
      const double normal = std::cos(n * time) - std::cos((n + 1) * time);
      const TangentialStep step = spring.advance(s, v, time, 1.0, normal, std::sin((n + 1) * time));
      v += step.impulse;
      s = step.displacement;
    }
    return v.x;
  };
  for (const double damping : {0.0, 0.01, 0.3})
    for (const double friction : {0.5, 0.7, 1.0}) {
      const double exact = end_velocity(damping, friction, 100000);
      for (const int steps : {10, 30, 100, 300})
        EXPECT_NEAR(end_velocity(damping, friction, steps), exact, std::pow(pi / steps, 2));
    }
}

TEST(TangentialSpring, WithoutSpringTheDashpotSlides) {
  const TangentialSpring spring({0.0, 0.5, 0.3});
  const TangentialStep sticking = spring.advance({}, {1.0, 0.0, 0.0}, 0.1, 1.0 / 2.0, much, much);
  // m_t (v' - v) = -eta T (v + v')/2
  EXPECT_NEAR(sticking.impulse.x, -0.05 / (1.0 + 0.025 / 2.0), 4 * eps);
  const TangentialStep sliding = spring.advance({}, {1.0, 0.0, 0.0}, 0.1, 1.0 / 2.0, 0.1, 1.0);
  EXPECT_NEAR(sliding.impulse.x, -0.03, 4 * eps);
  EXPECT_EQ(spring.stored_energy(sliding.displacement), 0.0);
  // All of the work of the impulse is lost, to the dashpot and the slider.
  EXPECT_NEAR(sliding.damped + sliding.friction, 0.03 * (1.0 - 0.25 * 0.03), 8 * eps);
}

TEST(TangentialSpring, NothingHappensWithoutContactOrFriction) {
  const TangentialStep apart = TangentialSpring({2.0, 0.5, 0.3})
                                   .advance({0.1, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.0, 1.0, 0.0, 0.0);
  EXPECT_EQ(norm(apart.impulse), 0.0);
  EXPECT_EQ(apart.displacement.x, 0.1);
  const TangentialStep smooth =
      TangentialSpring({2.0, 0.5, 0.0}).advance({}, {1.0, 0.0, 0.0}, 0.1, 1.0, 5.0, 50.0);
  EXPECT_EQ(norm(smooth.impulse), 0.0);
  // Neither does a contact that is pulled apart by its dashpot push sideways.
  const TangentialStep pulled =
      TangentialSpring({2.0, 0.5, 0.3}).advance({}, {1.0, 0.0, 0.0}, 0.1, 1.0, -5.0, -50.0);
  EXPECT_EQ(norm(pulled.impulse), 0.0);
}

TEST(TangentialSpring, StaysStableAtAnyDampingAndStiffness) {
  for (const double damping : {0.0, 1.0, 1e6, 1e12})
    for (const double stiffness : {0.0, 1.0, 1e6, 1e12}) {
      const TangentialSpring spring({stiffness, damping, 1.0});
      Vector3 s{}, v{1.0, 0.0, 0.0};
      for (int n = 0; n < 1000; n++) {
        const TangentialStep step = spring.advance(s, v, 0.1, 1.0, much, much);
        v += step.impulse;
        s = step.displacement;
        // No more energy than it began with, but for the rounding of each step.
        ASSERT_LE(kinetic(1.0, v) + spring.stored_energy(s), 0.5 * (1.0 + 1e-12 * (n + 1)));
      }
    }
}

TEST(Plane, TurningKeepsTheLengthInTheNewPlane) {
  const Vector3 s{3e-7, -1e-7, 2e-7};
  const Vector3 n{0.1e-3, 1.0e-3, 0.3e-3};
  const Plane plane{n, 1.0 / dot(n, n)};
  const Vector3 turned = plane.turned_into(s);
  // Rounding: some four products or sums in each length, four in the part along the normal.
  EXPECT_NEAR(norm(turned) / norm(s), 1.0, 4 * eps);
  EXPECT_NEAR(dot(turned, n), 0.0, 4 * eps * norm(s) * norm(n));
  EXPECT_EQ(norm(plane.turned_into({})), 0.0);
  EXPECT_EQ(norm(plane.turned_into(2.0 * n)), 0.0);
}

}  // namespace cohesion::contact
