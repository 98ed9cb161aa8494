// SPDX-License-Identifier: BSD-3-Clause
#include "contact/stiffness_scaling.h"

#include <limits>
#include <variant>

#include "advice/integrated_escape.h"
#include "contact/contact_parameters.h"
#include "contact/rebound.h"
#include "refuses.h"
#include "sphere.h"

namespace cohesion::contact {
namespace {

constexpr double real_stiffness = 8e5;

contact::AdhesiveContact real_contact(double e, double force, double cutoff, double tail) {
  return {contact::LinearSpringDashpot::from_restitution(real_stiffness, e, 7e-7),
          {force, cutoff, tail}};
}

contact::AdhesiveContact softened(const contact::AdhesiveContact& real, double ratio) {
  const StiffnessScaling scaling(real_stiffness, real_stiffness / ratio);
  return {{real_stiffness / ratio, scaling.factor() * real.spring().damping(),
           real.spring().reduced_mass()},
          scaling.adhesion(real.adhesion())};
}

/// F_ad and tail of A R*/(6 H^2) at R*/6 = 1.
contact::Adhesion adhesion_of(const hamaker::HamakerParameters& c) {
  return {c.hamaker_constant / (c.surface_cutoff * c.surface_cutoff), c.surface_cutoff,
          c.hamaker_constant * (1.0 / c.surface_cutoff - 1.0 / c.outer_cutoff)};
}

}  // namespace

TEST(StiffnessScaling, KeepsEscapeVelocityAndRestitutionAtAnySpeed) {
  // Force-dominated, well-dominated and mixed (F_ad^2/(2K) over W: infinite, 1e-3 and 0.8).
  const double cases[][3] = {{1.3e-4, 0.0, 0.0}, {1.3e-5, 4e-10, 1e-13}, {1.3e-4, 4e-11, 8e-15}};
  for (const double e : {0.1, 0.9487, 0.9999})
    for (const auto& [force, cutoff, tail] : cases)
      for (double ratio = 1.0; ratio <= 1.1e4; ratio *= 10.0) {
        const auto real = real_contact(e, force, cutoff, tail);
        const auto soft = softened(real, ratio);
        const double v = real.escape_velocity();
        // Exact but for roundings; zeta T is below 2 at e = 0.1, so nothing enlarges them much.
        EXPECT_NEAR(soft.escape_velocity() / v, 1.0, 1e-13) << ratio;
        EXPECT_NEAR(soft.spring().restitution() / e, 1.0, 1e-13);
        for (const double faster : {1.1, 3.0, 100.0})
          EXPECT_NEAR(effective_restitution(soft, faster * v),
                      effective_restitution(real, faster * v), 1e-12)
              << ratio << " " << faster;
      }
}

TEST(StiffnessScaling, WithoutItASoftSpringSticksMore) {
  // What the scaling is for: v_esc ~ 1/sqrt(K) where the force decides.
  const auto real = real_contact(0.9487, 1.3e-4, 0.0, 0.0);
  const auto soft = softened(real, 1e4);
  const contact::AdhesiveContact unscaled(soft.spring(), real.adhesion());
  EXPECT_NEAR(unscaled.escape_velocity() / real.escape_velocity(), 100.0, 1e-10);
}

TEST(StiffnessScaling, ScalingTheForceAloneLosesTheWell) {
  // Well-dominated, E_tail = F_ad H_cut: W falls to (1 + 1/100)/2 of itself, and v_esc to the root
  // of that, 0.711, but for what the force adds.
  const auto real = real_contact(0.9487, 1e-7, 4e-10, 4e-17);
  const auto soft = softened(real, 1e4);
  const contact::AdhesiveContact force_only(
      soft.spring(), {soft.adhesion().force, real.adhesion().cutoff, real.adhesion().tail_energy});
  EXPECT_NEAR(force_only.escape_velocity() / real.escape_velocity(), std::sqrt(0.505), 0.02);
}

TEST(StiffnessScaling, OverlapGrowsAsTheContactTime) {
  const auto real = real_contact(0.9487, 1.3e-4, 4e-10, 5e-14);
  const auto soft = softened(real, 100.0);
  EXPECT_NEAR(soft.static_overlap() / real.static_overlap(), 10.0, 1e-13);
  EXPECT_NEAR(soft.maximum_overlap(0.1) / real.maximum_overlap(0.1), 10.0, 1e-12);
  EXPECT_NEAR(soft.spring().contact_time() / real.spring().contact_time(), 10.0, 1e-12);
}

TEST(StiffnessScaling, HamakerParametersGiveTheScaledForceAndTheSameWell) {
  const hamaker::HamakerParameters real{5e-19, 4e-10, 1e-7};
  for (double ratio = 1.0; ratio <= 1.1e4; ratio *= 10.0) {
    const StiffnessScaling scaling(real_stiffness, real_stiffness / ratio);
    const hamaker::HamakerParameters soft = scaling.hamaker(real);
    // Near f = k (2 - k) the root amplifies roundings; f = 0.01 leaves 1 - 0.8.
    EXPECT_NEAR(adhesion_of(soft).force / (scaling.factor() * adhesion_of(real).force), 1.0, 1e-13);
    EXPECT_NEAR(adhesion_of(soft).well_energy() / adhesion_of(real).well_energy(), 1.0, 1e-13);
    EXPECT_EQ(soft.outer_cutoff, real.outer_cutoff);
    EXPECT_LT(soft.surface_cutoff, soft.outer_cutoff);
  }
}

TEST(StiffnessScaling, HamakerConstantAndCutoffGrowAlikeWithoutOuterCutoff) {
  const hamaker::HamakerParameters soft = StiffnessScaling(1e4, 1e2).hamaker({5e-19, 4e-10, 1e6});
  EXPECT_NEAR(soft.hamaker_constant / 5e-18, 1.0, 1e-14);
  EXPECT_NEAR(soft.surface_cutoff / 4e-9, 1.0, 1e-14);
}

namespace {

// Two spheres of 1 mm.
constexpr double reduced_radius = 2.5e-4, reduced_mass = 6.94e-7, real_young = 6e10;

contact::ContactParameters hertz(double young, double e, double work_of_adhesion = 0.0) {
  contact::ContactParameters p;
  contact::set_hertz(p, young, 0.25);
  p.restitution = e;
  p.work_of_adhesion = work_of_adhesion;
  return p;
}

double escape_of_hertz(double young, double e, const hamaker::HamakerParameters& h) {
  return advice::escape_velocity(
      contact::HertzSpringDashpot::from_restitution(hertz(young, e).modulus, reduced_radius, e,
                                                    reduced_mass),
      {h.hamaker_constant * reduced_radius / 6.0 / h.surface_cutoff / h.surface_cutoff,
       h.surface_cutoff,
       h.hamaker_constant * reduced_radius / 6.0 *
           (1.0 / h.surface_cutoff - 1.0 / h.outer_cutoff)});
}

contact::JkrSpringDashpot jkr(double young, double e, double w) {
  return std::get<contact::JkrSpringDashpot>(
      contact::normal_law(hertz(young, e, w), reduced_radius, reduced_mass));
}

double escape_of_jkr(double young, double e, double w) {
  return advice::escape_velocity(jkr(young, e, w),
                                 contact::HertzSpringDashpot::from_restitution(
                                     hertz(young, e).modulus, reduced_radius, e, reduced_mass));
}

/// E of Young's modulus, which no Poisson's ratio changes.
StiffnessScaling from_real(double young) { return {real_young, young, hertz_power}; }

}  // namespace

// Within 1e-3: the velocities are bisected to 1e-5, of impacts in steps of t_c/1000, whose error is
// of second order and at t_c/20 2e-4 (docs/verification/contact_motion.md).
TEST(StiffnessScaling, KeepsTheEscapeVelocityOfHertzsContact) {
  const hamaker::HamakerParameters real{7.49e-19, 4e-10, 1e-7};
  for (const double e : {0.5, 0.9, 0.99})
    for (const double young : {5e9, 5e8, 5e6}) {
      const hamaker::HamakerParameters soft = from_real(young).hamaker(real);
      EXPECT_NEAR(escape_of_hertz(young, e, soft) / escape_of_hertz(real_young, e, real), 1.0, 1e-3)
          << e << ' ' << young;
    }
}

TEST(StiffnessScaling, ASoftHertzContactWithoutItSticksMore) {
  // Of the force alone v_esc ~ F_ad^(5/6)/k^(1/3); the well adds to both.
  const hamaker::HamakerParameters real{7.49e-19, 4e-10, 1e-7};
  EXPECT_GT(escape_of_hertz(5e6, 0.9, real), 5.0 * escape_of_hertz(real_young, 0.9, real));
}

TEST(StiffnessScaling, KeepsTheEscapeVelocityOfJkrsContact) {
  const double w = 0.1;
  for (const double e : {0.5, 0.9, 1.0})
    for (const double young : {5e8, 5e6}) {
      const double soft = from_real(young).work_of_adhesion(w);
      EXPECT_NEAR(escape_of_jkr(young, e, soft) / escape_of_jkr(real_young, e, w), 1.0, 1e-3)
          << e << ' ' << young;
    }
}

TEST(StiffnessScaling, ScalesJkrsForcesByItsFactorAndLengthsByTheInverse) {
  const double young = 5e6, w = 0.1, f = std::pow(young / real_young, 0.4);
  const StiffnessScaling scaling = from_real(young);
  EXPECT_NEAR(scaling.factor() / f, 1.0, 1e-14);
  const auto real = jkr(real_young, 1.0, w), soft = jkr(young, 1.0, scaling.work_of_adhesion(w));
  // But for roundings: a few cube roots and powers.
  EXPECT_NEAR(soft.lowest_overlap() / real.lowest_overlap() * f, 1.0, 1e-13);
  EXPECT_NEAR(soft.touch_energy() / real.touch_energy(), 1.0, 1e-13);
  EXPECT_NEAR(soft.friction_load() / real.friction_load() / f, 1.0, 1e-13);
  // The radius of contact is a root, found until a step of Newton's is 1e-8 of it.
  for (const double x : {0.0, 1e-8, 1e-6})
    EXPECT_NEAR(soft.at(x / f).force / real.at(x).force / f, 1.0, 1e-6) << x;
}

TEST(StiffnessScaling, AnotherWorkOfAdhesionIsThatOfANewContact) {
  const auto one = jkr(5e6, 0.7, 0.1).with_work_of_adhesion(0.03), other = jkr(5e6, 0.7, 0.03);
  EXPECT_EQ(one.lowest_overlap(), other.lowest_overlap());
  EXPECT_EQ(one.at(1e-7).force, other.at(1e-7).force);
  EXPECT_EQ(one.at(1e-7).damping, other.at(1e-7).damping);
  expect_refused([&] { one.with_work_of_adhesion(-0.03); }, "work of adhesion");
}

TEST(StiffnessScaling, RefusesWhatCannotBe) {
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    expect_refused([=] { StiffnessScaling(bad, 1.0); }, "of the material");
    expect_refused([=] { StiffnessScaling(1.0, bad); }, "of the simulation");
  }
  const StiffnessScaling scaling(1e4, 1.0);
  expect_refused([=] { scaling.hamaker({-1.0, 4e-10, 1e-7}); }, "Hamaker constant");
  expect_refused([=] { scaling.hamaker({1.0, 0.0, 1e-7}); }, "surface cut-off");
  expect_refused([=] { scaling.hamaker({1.0, 4e-10, 4e-10}); }, "smaller than the outer");
  expect_refused([=] { scaling.hamaker({1.0, 4e-10, 5e-8}); }, "too small for the softened");
}

TEST(ForStiffness, ScalesToKeepTheEscapeVelocityAndLeavesToKeepTheForce) {
  const hamaker::HamakerParameters real{5e-19, 4e-10, 1e-7};
  const auto used = [&](const Material& m) { return for_stiffness(100.0, m, real); };
  EXPECT_EQ(used({1e4, Keep::escape_velocity}).surface_cutoff,
            StiffnessScaling(1e4, 100.0).hamaker(real).surface_cutoff);
  for (const Material& m :
       {Material{}, Material{100.0, Keep::escape_velocity}, Material{1e4, Keep::force}}) {
    EXPECT_EQ(used(m).hamaker_constant, real.hamaker_constant);
    EXPECT_EQ(used(m).surface_cutoff, real.surface_cutoff);
  }
}

TEST(ForStiffness, LogSaysWhatIsKept) {
  const hamaker::HamakerParameters real{5e-19, 4e-10, 1e-7};
  const auto note = [&](const Material& m) {
    return scaling_note(100.0, m, real, for_stiffness(100.0, m, real));
  };
  EXPECT_EQ(note({1e4, Keep::escape_velocity})
                .find("adhesion scaled from stiffness 10000 to 100, which keeps the escape "
                      "velocity: A 5e-19 -> "),
            0u);
  EXPECT_EQ(note({1e4, Keep::force}),
            "adhesion not scaled from stiffness 10000 to 100, which keeps the pull-off force");
  EXPECT_EQ(note({}), "");
  EXPECT_EQ(note({100.0, Keep::escape_velocity}), "");
}

TEST(ForStiffness, OfAModulusScalesWorkOfAdhesionByItsPowerAndSaysSo) {
  const Material velocity{1e10, Keep::escape_velocity, hertz_power};
  const double used = for_stiffness(1e7, velocity, 0.1);
  EXPECT_DOUBLE_EQ(used, 0.1 * std::pow(1e-3, 0.4));
  EXPECT_EQ(scaling_note(1e7, velocity, 0.1, used),
            "adhesion scaled from modulus E* 1e+10 to 1e+07, which keeps the escape velocity: work "
            "of adhesion 0.1 -> 0.00630957");
  const Material force{1e10, Keep::force, hertz_power};
  EXPECT_EQ(for_stiffness(1e7, force, 0.1), 0.1);
  EXPECT_EQ(scaling_note(1e7, force, 0.1, 0.1),
            "adhesion not scaled from modulus E* 1e+10 to 1e+07, which keeps the pull-off force");
}

TEST(Material, MixedIsTheGeometricMeanOfWhatBothTell) {
  const Material a{100.0, Keep::force}, b{400.0, Keep::force};
  EXPECT_DOUBLE_EQ(mixed(a, b).stiffness, 200.0);
  EXPECT_EQ(mixed(a, b).keep, Keep::force);
  EXPECT_FALSE(mixed(a, {}).is_specified());
  EXPECT_FALSE(mixed({}, {0.0, Keep::force}).is_specified());
  // 2/E* = 1/E*_a + 1/E*_b, as of contacts.
  const Material c{1e9, Keep::force, hertz_power}, d{3e9, Keep::force, hertz_power};
  EXPECT_DOUBLE_EQ(mixed(c, d).stiffness, 1.5e9);
  EXPECT_EQ(mixed(c, d).exponent, hertz_power);
  expect_refused([&] { mixed(a, {400.0, Keep::escape_velocity}); }, "tell the pair what to keep");
}

}  // namespace cohesion::contact
