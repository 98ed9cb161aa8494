// SPDX-License-Identifier: BSD-3-Clause
#include "advice/stiffness_scaling.h"

#include <limits>

#include "refuses.h"

namespace cohesion::advice {
namespace {

constexpr double real_stiffness = 8e5;

contact::AdhesiveContact real_contact(double e, double force, double cutoff, double tail) {
  return {contact::LinearSpringDashpot::from_restitution(real_stiffness, e, 7e-7),
          {force, cutoff, tail}};
}

contact::AdhesiveContact softened(const contact::AdhesiveContact& real, double ratio) {
  const StiffnessScaling scaling(real_stiffness, real_stiffness / ratio);
  return {scaling.spring(real.spring()), scaling.adhesion(real.adhesion())};
}

/// F_ad and tail of A R*/(6 H^2) at R*/6 = 1.
contact::Adhesion adhesion_of(const hamaker::Parameters& c) {
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
          EXPECT_NEAR(soft.effective_restitution(faster * v),
                      real.effective_restitution(faster * v), 1e-12)
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
  const hamaker::Parameters real{5e-19, 4e-10, 1e-7};
  for (double ratio = 1.0; ratio <= 1.1e4; ratio *= 10.0) {
    const StiffnessScaling scaling(real_stiffness, real_stiffness / ratio);
    const hamaker::Parameters soft = scaling.hamaker(real);
    // Near f = k (2 - k) the root amplifies roundings; f = 0.01 leaves 1 - 0.8.
    EXPECT_NEAR(adhesion_of(soft).force / (scaling.factor() * adhesion_of(real).force), 1.0, 1e-13);
    EXPECT_NEAR(adhesion_of(soft).well_energy() / adhesion_of(real).well_energy(), 1.0, 1e-13);
    EXPECT_EQ(soft.outer_cutoff, real.outer_cutoff);
    EXPECT_LT(soft.surface_cutoff, soft.outer_cutoff);
  }
}

TEST(StiffnessScaling, HamakerConstantAndCutoffGrowAlikeWithoutOuterCutoff) {
  const hamaker::Parameters soft = StiffnessScaling(1e4, 1e2).hamaker({5e-19, 4e-10, 1e6});
  EXPECT_NEAR(soft.hamaker_constant / 5e-18, 1.0, 1e-14);
  EXPECT_NEAR(soft.surface_cutoff / 4e-9, 1.0, 1e-14);
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
  const hamaker::Parameters real{5e-19, 4e-10, 1e-7};
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
  const hamaker::Parameters real{5e-19, 4e-10, 1e-7};
  const auto note = [&](const Material& m) {
    return scaling_note(100.0, m, real, for_stiffness(100.0, m, real));
  };
  EXPECT_EQ(note({1e4, Keep::escape_velocity})
                .find("adhesion scaled from stiffness 10000 to 100, which keeps the escape "
                      "velocity: A 5e-19 -> "),
            0u);
  EXPECT_EQ(note({1e4, Keep::force}),
            "adhesion of stiffness 10000 left at stiffness 100, which keeps the pull-off force");
  EXPECT_EQ(note({}), "");
  EXPECT_EQ(note({100.0, Keep::escape_velocity}), "");
}

TEST(Material, MixedIsTheGeometricMeanOfWhatBothTell) {
  const Material a{100.0, Keep::force}, b{400.0, Keep::force};
  EXPECT_DOUBLE_EQ(mixed(a, b).stiffness, 200.0);
  EXPECT_EQ(mixed(a, b).keep, Keep::force);
  EXPECT_FALSE(mixed(a, {}).is_given());
  EXPECT_FALSE(mixed({}, {0.0, Keep::force}).is_given());
  expect_refused([&] { mixed(a, {400.0, Keep::escape_velocity}); }, "tell the pair what to keep");
}

}  // namespace cohesion::advice
