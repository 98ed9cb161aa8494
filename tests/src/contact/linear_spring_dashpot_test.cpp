// SPDX-License-Identifier: BSD-3-Clause
#include "contact/linear_spring_dashpot.h"

#include <algorithm>
#include <limits>

#include "refuses.h"
#include "sphere.h"

namespace cohesion::contact {
namespace {

struct Collision {
  double restitution;
  double time;
  double overlap;
};

/// Integrates mu x'' = -K x - eta x' from x = 0, x' = 1 until the overlap is back at zero: fourth
/// order Runge-Kutta, the end found by one secant step. Knows nothing of the closed forms.
Collision integrate(double stiffness, double damping, double mass) {
  const double dt = 1e-4 / std::sqrt(stiffness / mass);
  const auto a = [=](double x, double v) { return -(stiffness * x + damping * v) / mass; };
  double x = 0.0, v = 1.0, t = 0.0, highest = 0.0;
  while (true) {
    const double k1x = v, k1v = a(x, v);
    const double k2x = v + 0.5 * dt * k1v, k2v = a(x + 0.5 * dt * k1x, v + 0.5 * dt * k1v);
    const double k3x = v + 0.5 * dt * k2v, k3v = a(x + 0.5 * dt * k2x, v + 0.5 * dt * k2v);
    const double k4x = v + dt * k3v, k4v = a(x + dt * k3x, v + dt * k3v);
    const double x1 = x + dt / 6.0 * (k1x + 2.0 * k2x + 2.0 * k3x + k4x);
    const double v1 = v + dt / 6.0 * (k1v + 2.0 * k2v + 2.0 * k3v + k4v);
    highest = std::max(highest, x1);
    if (x1 <= 0.0) {
      const double part = x / (x - x1);
      return {-(v + part * (v1 - v)), t + part * dt, highest};
    }
    x = x1, v = v1, t += dt;
  }
}

// The particle of the thesis' bed: 1 mm, 2650 kg/m3, K = 800 N/m, eta = 0.79e-3 kg/s.
const double sphere_mass = 2650.0 * sphere_volume(0.5e-3);
const LinearSpringDashpot bed(800.0, 0.79e-3, reduced_mass(sphere_mass, sphere_mass));

}  // namespace

TEST(LinearSpringDashpot, GivesTheRestitutionAndContactTimeOfTheThesisParticle) {
  // Printed with four and three digits.
  EXPECT_NEAR(bed.restitution(), 0.9487, 0.5e-4);
  EXPECT_NEAR(bed.contact_time(), 9.25e-5, 0.5e-7);
}

TEST(LinearSpringDashpot, AgreesWithIntegratedCollisions) {
  for (const double ratio : {0.0, 0.05, 0.3, 0.8, 0.95}) {  // of critical damping
    const LinearSpringDashpot law(2.0, ratio * 2.0 * std::sqrt(2.0 * 3.0), 3.0);
    const Collision found = integrate(law.stiffness(), law.damping(), law.reduced_mass());
    // The secant end is exact to (w0 dt)^2 = 1e-8, the largest sampled overlap likewise.
    EXPECT_NEAR(law.restitution(), found.restitution, 2e-8) << ratio;
    EXPECT_NEAR(law.contact_time() / found.time, 1.0, 2e-8) << ratio;
    EXPECT_NEAR(law.maximum_overlap(1.0) / found.overlap, 1.0, 2e-8) << ratio;
  }
}

TEST(LinearSpringDashpot, InversesReturnWhatTheyWereGiven) {
  for (const double e : {0.05, 0.5, 0.9487, 1.0}) {
    // A handful of roundings through exp and log: 1e-14 relative.
    const auto by_e = LinearSpringDashpot::from_restitution(800.0, e, 7e-7);
    EXPECT_NEAR(by_e.restitution() / e, 1.0, 1e-13);
    const auto by_overlap = LinearSpringDashpot::from_maximum_overlap(1e-5, 2.0, e, 7e-7);
    EXPECT_NEAR(by_overlap.maximum_overlap(2.0) / 1e-5, 1.0, 1e-13);
    EXPECT_NEAR(by_overlap.restitution() / e, 1.0, 1e-13);
  }
}

TEST(LinearSpringDashpot, ZeroRestitutionIsCriticalDamping) {
  const auto law = LinearSpringDashpot::from_restitution(800.0, 0.0, 2.0);
  EXPECT_DOUBLE_EQ(law.damping(), 2.0 * std::sqrt(800.0 * 2.0));
  EXPECT_EQ(law.restitution(), 0.0);
  EXPECT_EQ(law.contact_time(), std::numeric_limits<double>::infinity());
}

TEST(LinearSpringDashpot, ZeroRestitutionNeverEndsTheContactForAnyStiffnessAndMass) {
  // 2 sqrt(mu K) and sqrt(K/mu) round differently for each pair of values.
  for (const double stiffness : {0.1, 3.0, 800.0, 1.7e7})
    for (const double mass : {6.9e-7, 0.3, 1.1, 77.7}) {
      const auto law = LinearSpringDashpot::from_restitution(stiffness, 0.0, mass);
      EXPECT_EQ(law.contact_time(), std::numeric_limits<double>::infinity())
          << stiffness << " " << mass;
    }
}

TEST(LinearSpringDashpot, MaximumOverlapHoldsAtAndBeyondCriticalDamping) {
  // x_max w0/v0 for K = mu = 1, evaluated with mpmath at 30 digits from
  // x = exp(-alpha t) sinh(p t)/p at the root of its derivative, p = sqrt(alpha^2 - 1), for
  // alpha = 1 (x = t exp(-t): exp(-1)), 1.25 (2^(-5/3)) and 3.
  const double expected[][2] = {
      {2.0, 0.367879441171442322}, {2.5, 0.314980262473718291}, {6.0, 0.154173649075832208}};
  // exp and atanh are good to a few units in the last place.
  for (const auto& [damping, overlap] : expected)
    EXPECT_NEAR(LinearSpringDashpot(1.0, damping, 1.0).maximum_overlap(1.0) / overlap, 1.0, 2e-15);
}

TEST(LinearSpringDashpot, MaximumOverlapIsContinuousThroughCriticalDamping) {
  const double critical = 2.0 * std::sqrt(800.0 * 2.0);
  const double w0 = std::sqrt(800.0 / 2.0);
  for (const double nearly : {1.0 - 1e-6, 1.0 + 1e-6}) {
    const LinearSpringDashpot law(800.0, nearly * critical, 2.0);
    // x_max w0/v0 = exp(-1) at critical damping; its slope in alpha/w0 is of order one.
    EXPECT_NEAR(law.maximum_overlap(1.0) * w0, std::exp(-1.0), 2e-6);
  }
}

TEST(LinearSpringDashpot, OverdampedMaximumOverlapTendsToTheDashpotAlone) {
  // Without spring the particle stops after mu v0/eta; the spring changes that by O((w0/alpha)^2).
  const LinearSpringDashpot law(1e-6, 1.0, 1.0);
  EXPECT_NEAR(law.maximum_overlap(3.0), 3.0, 3.0 * 2e-5);
}

TEST(LinearSpringDashpot, RefusesWhatCannotBe) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, inf}) {
    expect_refused([=] { LinearSpringDashpot(bad, 1.0, 1.0); }, "stiffness");
    expect_refused([=] { LinearSpringDashpot(1.0, 1.0, bad); }, "reduced mass");
    expect_refused([=] { LinearSpringDashpot::from_restitution(bad, 0.9, 1.0); }, "stiffness");
    expect_refused([=] { LinearSpringDashpot::from_restitution(1.0, 0.9, bad); }, "reduced mass");
    expect_refused([=] { LinearSpringDashpot::from_maximum_overlap(1.0, 1.0, 0.9, bad); },
                   "reduced mass");
    expect_refused([=] { LinearSpringDashpot::from_maximum_overlap(bad, 1.0, 0.9, 1.0); },
                   "overlap");
    expect_refused([=] { LinearSpringDashpot::from_maximum_overlap(1.0, bad, 0.9, 1.0); }, "speed");
  }
  for (const double bad : {-1e-9, nan, inf})
    expect_refused([=] { LinearSpringDashpot(1.0, bad, 1.0); }, "damping");
  for (const double bad : {-0.1, 1.0000001, nan})
    expect_refused([=] { LinearSpringDashpot::from_restitution(1.0, bad, 1.0); }, "restitution");
}

}  // namespace cohesion::contact
