// SPDX-License-Identifier: BSD-3-Clause
#include "advice/contact_numbers.h"

#include "advice/thesis_pair.h"
#include "refuses.h"

namespace cohesion::advice {
namespace {

/// Is x'' = -w0^2 x - 2 zeta w0 x', stepped by leapfrog with the velocity of the half step before,
/// still bounded after many steps?
bool stays_bounded(double step, double zeta) {
  double x = 1.0, v = 0.0;
  for (int i = 0; i < 200000; ++i) {
    v += step * (-x - 2.0 * zeta * v);
    x += step * v;
    if (std::abs(x) > 1e6) return false;
  }
  return true;
}

}  // namespace

TEST(ContactNumbers, OfTheThesisPair) {
  const ContactNumbers n(thesis_pair());
  // t_c is printed as 9.25e-5 s, dt as 2.25e-5 s; at e = 0.9487 the damping changes t_c by 1.4e-4.
  EXPECT_NEAR(n.contact_time(), 9.25e-5, 0.5e-7);
  EXPECT_NEAR(n.steps_per_contact(), 9.25e-5 / 2.25e-5, 0.01);
  // F_ad = A R*/(6 H_cut^2) = 5e-19 * 2.5e-4/(6 * 1.6e-19) = 1.30208e-4 N, m g = 1.36117e-5 N.
  EXPECT_NEAR(n.bond_number(), 9.5659, 1e-4);
  EXPECT_NEAR(n.static_overlap_over_diameter(), 1.30208e-4 / 800.0 / 1e-3, 1e-9);
  EXPECT_NEAR(n.spring_adhesion_energy(), 1.0596e-11, 1e-15);  // F_ad^2/1600
  EXPECT_NEAR(n.well_energy(), 1.0396e-13, 1e-17);
  // Integrated, see adhesive_contact_test.cpp: v = 0.1 m/s.
  EXPECT_NEAR(n.escape_velocity(), 2.6749667e-3, 1e-10);
  EXPECT_NEAR(n.impact_overlap_over_diameter(), 3.03096145e-3, 1e-11);
  EXPECT_NEAR(n.steps_in_cutoff(), 4e-10 / 0.1 / 2.25e-5, 1e-8);
}

TEST(ContactNumbers, SlowPairCrossesTheCutoffAtTheSpeedItGains) {
  PairParameters p = thesis_pair();
  p.speed = 0.0;
  EXPECT_NEAR(ContactNumbers(p).entry_speed(), 5.474411e-4, 1e-10);  // sqrt(2 W/mu)
  p.adhesion = {0.0, 4e-10, 0.0};
  EXPECT_TRUE(std::isinf(ContactNumbers(p).steps_in_cutoff()));
}

TEST(ContactNumbers, StableStepIsWhereLeapfrogBlowsUp) {
  PairParameters p = thesis_pair();
  const double mu = 0.5 * p.mass_i, w0 = std::sqrt(p.stiffness / mu);
  for (const double zeta : {0.0, 0.017, 0.5, 1.0, 3.0}) {
    p.damping = 2.0 * zeta * std::sqrt(p.stiffness * mu);
    const double limit = ContactNumbers(p).stable_step() * w0;
    // The leading root is beyond -1 by about the relative excess, 1e-3: 1e6 after 14,000 steps.
    EXPECT_TRUE(stays_bounded(limit * 0.999, zeta)) << zeta;
    EXPECT_FALSE(stays_bounded(limit * 1.001, zeta)) << zeta;
  }
}

TEST(ContactNumbers, SteadyStepOfElasticSpringsIsThatOfTheClosedForm) {
  // (w dt)^2 = 4 sin^2(w0 dt/2) of a pair. In space, normal springs allow sin^2 < 1/4, dt < t_c/3;
  // sliding ones, with w_t = w0 sqrt(7/2 K_t/K), sin^2 < 7/40. In a plane 1/3 and 7/30.
  for (const bool plane : {false, true})
    for (const double ratio : {0.0, 2.0 / 7.0, 1.0}) {
      PairParameters p = thesis_pair();
      p.adhesion = {};
      p.damping = 0.0;
      p.tangential_stiffness = ratio * p.stiffness;
      const double normal = std::asin(std::sqrt(plane ? 1.0 / 3.0 : 0.25));
      const double sliding = std::asin(std::sqrt(plane ? 7.0 / 30.0 : 7.0 / 40.0));
      const double half_phase =
          ratio > 0.0 ? std::min(normal, sliding / std::sqrt(3.5 * ratio)) : normal;
      const double w0 = std::sqrt(p.stiffness / (0.5 * p.mass_i));
      EXPECT_NEAR(ContactNumbers(p).steady_step(plane ? ClosestPacking::in_plane()
                                                      : ClosestPacking::in_space()),
                  2.0 * half_phase / w0, 1e-12 / w0)
          << plane << " " << ratio;
    }
}

TEST(ContactNumbers, SteadyStepOfDampedSpringsIsWhereASphereBetweenTwelveOthersSwingsUp) {
  // One sphere that swings against all neighbours: discrete springs of 4 times the pair's. With
  // adhesion all contacts may be taut, with a spring that ends at F_ad in 0.3 of the overlap at
  // rest: K_t 0.3 F_ad/K - F_ad = K' 0.3 F_ad/K - (K'/K) F_ad.
  for (const double e : {0.9, 0.5, 0.3})
    for (const bool taut : {false, true}) {
      PairParameters p = thesis_pair();
      if (!taut) p.adhesion = {};
      const double mu = 0.5 * p.mass_i;
      p.damping = contact::LinearSpringDashpot::from_restitution(p.stiffness, e, mu).damping();
      const double limit = ContactNumbers(p).steady_step(ClosestPacking::in_space());
      for (const double off : {-1e-3, 1e-3}) {
        const double dt = limit * (1.0 + off);
        auto spring = contact_solver::discrete_constants(p.stiffness, p.damping, mu, dt);
        if (taut) spring.stiffness += (p.stiffness - spring.stiffness) / 0.3;
        double x = 1.0, step = 0.0;  // step: v dt
        for (int n = 0; n < 100000 && std::abs(x) < 1e6; n++) {
          step -= 4.0 * dt / mu * (spring.stiffness * dt * x + spring.damping * step);
          x += step;
        }
        EXPECT_EQ(std::abs(x) < 1e6, off < 0.0) << e << " " << taut;
      }
    }
}

TEST(ContactNumbers, WallIsAPartnerOfInfiniteMass) {
  PairParameters p = thesis_pair();
  p.radius_j = p.mass_j = std::numeric_limits<double>::infinity();
  const ContactNumbers n(p);
  EXPECT_EQ(n.contact().spring().reduced_mass(), p.mass_i);
  EXPECT_EQ(n.static_overlap_over_diameter(),
            ContactNumbers(thesis_pair()).static_overlap_over_diameter());
  EXPECT_EQ(n.bond_number(), ContactNumbers(thesis_pair()).bond_number());
}

TEST(ContactNumbers, BondNumberWithoutGravityOrAdhesion) {
  PairParameters p = thesis_pair();
  p.gravity = 0.0;
  EXPECT_TRUE(std::isinf(ContactNumbers(p).bond_number()));
  p.adhesion.force = 0.0;
  EXPECT_EQ(ContactNumbers(p).bond_number(), 0.0);
}

TEST(ContactNumbers, AStiffTangentialSpringShortensTheContact) {
  PairParameters p = thesis_pair();
  const double steps = ContactNumbers(p).steps_per_contact();
  p.tangential_stiffness = 2.0 / 7.0 * p.stiffness;  // equal contact times
  EXPECT_NEAR(ContactNumbers(p).steps_per_contact(), steps, 1e-14 * steps);
  p.tangential_stiffness = p.stiffness;
  EXPECT_NEAR(ContactNumbers(p).steps_per_contact(), steps / std::sqrt(3.5), 1e-14 * steps);
}

TEST(ContactNumbers, TangentialAndRollingSpringSwingTogether) {
  PairParameters p = thesis_pair();
  const double mu = 0.5 * p.mass_i, K = p.tangential_stiffness = p.rolling_stiffness = p.stiffness;
  // Equal spheres: sliding changes the sum of the spins, rolling their difference.
  EXPECT_NEAR(ContactNumbers(p).tangential_frequency(), std::sqrt(3.5 * K / mu),
              1e-14 * std::sqrt(3.5 * K / mu));
  // A ball at a wall, spins in units of v/r: K [[1, -1], [-1, 2]] against m diag(1, 0.4), of which
  // 0.4 L^2 - 2.4 L + 1 = 0, L = 3 + sqrt(6.5).
  p.radius_j = p.mass_j = std::numeric_limits<double>::infinity();
  const double wall = std::sqrt((3.0 + std::sqrt(6.5)) * K / p.mass_i);
  EXPECT_NEAR(ContactNumbers(p).tangential_frequency(), wall, 1e-14 * wall);
  EXPECT_NEAR(ContactNumbers(p).frequency(), wall, 1e-14 * wall);
  // Rolling alone: K_r r^2/I.
  p.tangential_stiffness = 0.0;
  EXPECT_NEAR(ContactNumbers(p).tangential_frequency(), std::sqrt(2.5 * K / p.mass_i),
              1e-14 * std::sqrt(2.5 * K / p.mass_i));
  // A soft rolling spring is not the fastest.
  p.rolling_stiffness = 0.1 * K;
  EXPECT_EQ(ContactNumbers(p).frequency(), std::sqrt(K / p.mass_i));
}

TEST(ContactNumbers, RefusesWhatCannotBe) {
  const double inf = std::numeric_limits<double>::infinity();
  const auto with = [](double PairParameters::* member, double value) {
    PairParameters p = thesis_pair();
    p.*member = value;
    return p;
  };
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    for (const auto member : {&PairParameters::radius_i, &PairParameters::radius_j})
      expect_refused([=] { ContactNumbers n(with(member, bad)); }, "radius");
    for (const auto member : {&PairParameters::mass_i, &PairParameters::mass_j})
      expect_refused([=] { ContactNumbers n(with(member, bad)); }, "mass");
    expect_refused([=] { ContactNumbers n(with(&PairParameters::stiffness, bad)); }, "stiffness");
    expect_refused([=] { ContactNumbers n(with(&PairParameters::dt, bad)); }, "time step");
  }
  for (const double bad : {-1.0, std::nan(""), inf}) {
    expect_refused([=] { ContactNumbers n(with(&PairParameters::damping, bad)); }, "damping");
    expect_refused([=] { ContactNumbers n(with(&PairParameters::speed, bad)); }, "approach speed");
    expect_refused([=] { ContactNumbers n(with(&PairParameters::gravity, bad)); }, "gravity");
  }
  PairParameters walls = thesis_pair();
  walls.mass_i = walls.mass_j = inf;
  expect_refused([=] { ContactNumbers n(walls); }, "reduced mass");
  walls = thesis_pair();
  walls.radius_i = walls.radius_j = inf;
  expect_refused([=] { ContactNumbers n(walls); }, "diameter");
}

}  // namespace cohesion::advice
