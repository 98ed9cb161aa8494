// SPDX-License-Identifier: BSD-3-Clause
#include "advice/unlike_walls.h"

#include <gtest/gtest.h>

namespace cohesion::advice {
namespace {

StickingRules rules(const std::string& name, const std::string& adhesion = "jkr") {
  StickingRules r;
  r.name = name;
  r.adhesion = adhesion;
  r.wall_words = "'cohesion " + adhesion + "'";
  r.without_words = "'cohesion off'";
  r.material_words = "'material_modulus'";
  return r;
}

Softening softening(double ratio, contact::Keep keep = contact::Keep::escape_velocity,
                    double power = contact::hertz_power) {
  return {{1e9, keep, power}, 1e9 * ratio};
}
const Softening not_given{{}, 1e7};

/// What there is to say of a wall and pairs of these softenings.
std::string of(const Softening& wall, const std::vector<Softening>& pairs) {
  StickingRules w = rules("fix w"), p = rules("pair_style gran");
  w.softenings = {wall};
  p.softenings = pairs;
  return other_softening(w, {p});
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(UnlikeWalls, OtherScheme) {
  StickingRules wall = rules("fix w"), pairs = rules("pair_style gran"), others = pairs;
  EXPECT_EQ(other_scheme(wall, {pairs}, "exact"), "");
  EXPECT_EQ(other_scheme(wall, {}, "exact"), "");
  others.is_exact = false;
  EXPECT_EQ(other_scheme(wall, {others, pairs}, "exact"), "");
  EXPECT_TRUE(has(other_scheme(wall, {others}, "exact"),
                  "fix w has 'scheme exact', and pair_style gran has 'scheme sampled'"));
}

TEST(UnlikeWalls, OtherAdhesion) {
  const StickingRules pairs = rules("pair_style gran");
  StickingRules none = rules("fix w", "");
  EXPECT_EQ(other_adhesion(rules("fix w"), {pairs}), "");
  EXPECT_EQ(other_adhesion(rules("fix w"), {rules("pair_style gran", "")}), "");
  EXPECT_EQ(other_adhesion(rules("fix w"), {rules("pair_style a", "hamaker"), pairs}), "");
  EXPECT_EQ(other_adhesion(rules("fix w", "hamaker"), {pairs}),
            "fix w has the adhesion of hamaker, and pair_style gran that of jkr: a particle sticks "
            "to the wall and to another particle by different criteria; use 'cohesion jkr' for the "
            "wall");
  EXPECT_EQ(other_adhesion(none, {pairs}),
            "fix w has no adhesion, and pair_style gran has that of jkr: particles stick to each "
            "other, but not to the wall; use 'cohesion jkr' for the wall, or 'cohesion off' if "
            "nothing shall stick to it");
  none.meant_without = true;
  EXPECT_EQ(other_adhesion(none, {pairs}), "");
}

/// f = (E*/E*_m)^(2/5) for Hertz and JKR, (K/K_m)^(1/2) for linear springs; the cure is the
/// stiffness times (f_pairs/f_wall)^(p + 1).
TEST(UnlikeWalls, OtherSoftening) {
  EXPECT_EQ(of(softening(1e-2), {softening(1e-2)}), "");
  EXPECT_EQ(of(softening(1e-2), {softening(1e-3), softening(1e-2)}), "");
  EXPECT_EQ(
      of(softening(1e-2), {softening(1e-3)}),
      "fix w has 0.01 times the modulus E* of the material (f = 0.158), and pair_style gran "
      "has 0.001 times the modulus E* of the material (f = 0.0631): what soft contacts do not "
      "keep of their materials (the pull-off force, or with 'material_keep force' the escape "
      "velocity) differs; give both the same f: multiply "
      "Young's modulus of the wall by 0.1");
  const auto linear = [](double ratio) {
    return softening(ratio, contact::Keep::escape_velocity, contact::linear_power);
  };
  EXPECT_TRUE(has(of(linear(1e-4), {linear(1e-2)}), "multiply the stiffness of the wall by 100"));
  // 0.01^(1/2) = 0.1 = 10^(-5/2 * 2/5).
  EXPECT_EQ(of(linear(1e-2), {softening(std::pow(10.0, -2.5))}), "");
  EXPECT_TRUE(
      has(of(linear(1e-2), {softening(1e-2)}), "multiply the stiffness of the wall by 2.5"));
}

TEST(UnlikeWalls, OneWithoutMaterial) {
  EXPECT_EQ(of(not_given, {not_given}), "");
  EXPECT_EQ(of(not_given, {softening(1e-2, contact::Keep::force)}), "");
  EXPECT_EQ(of(not_given, {softening(1.0)}), "");
  EXPECT_TRUE(has(of(not_given, {softening(1e-2)}),
                  "pair_style gran has 0.01 times the modulus E* of the material (f = 0.158), by "
                  "which its adhesion is scaled, and fix w has no material"));
  EXPECT_TRUE(has(of(softening(1e-2), {not_given}), "and pair_style gran has no material"));
}

TEST(UnlikeWalls, WhatIsKeptMayDiffer) {
  EXPECT_EQ(of(softening(1e-2), {softening(1e-2, contact::Keep::force)}), "");
  EXPECT_NE(of(softening(1e-2), {softening(1e-3, contact::Keep::force)}), "");
}

/// Of another law there is nothing to compare, and that is said.
TEST(UnlikeWalls, EachWallOnceByEachRule) {
  StickingRules wall = rules("fix w", "hamaker"), pairs = rules("pair_style gran");
  wall.softenings = {softening(1e-2)};
  pairs.softenings = {softening(1e-3)};
  EXPECT_EQ(warnings_of_walls({wall}, {pairs}, "exact").size(), 1u);
  wall.adhesion = "jkr";
  wall.is_exact = false;
  EXPECT_EQ(warnings_of_walls({wall}, {pairs}, "exact").size(), 2u);
}

}  // namespace cohesion::advice
