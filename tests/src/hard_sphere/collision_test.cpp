// SPDX-License-Identifier: BSD-3-Clause
#include "hard_sphere/collision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

#include "hard_sphere/impact.h"
#include "refuses.h"

namespace {

using namespace cohesion::hard_sphere;
using cohesion::Vector3;

CollisionPartner sphere(double mass, double radius, const Vector3& v, const Vector3& spin) {
  return {v, spin, 1.0 / mass, 1.0 / (0.4 * mass * radius * radius), radius};
}

const CollisionPartner one = sphere(2.0, 0.5, {1.0, 0.4, -0.2}, {3.0, -1.0, 0.5});
const CollisionPartner two = sphere(3.0, 0.7, {-0.6, 0.1, 0.3}, {-2.0, 0.7, 1.5});
const Vector3 k{0.6, 0.0, 0.8};

CollisionPartner after(const CollisionPartner& p, const ImpactOutcome& hit, double side) {
  CollisionPartner q = p;
  q.velocity += (side * p.inverse_mass) * hit.impulse;
  q.spin -= (p.radius * p.inverse_inertia) * hit.spin_impulse;
  return q;
}

double energy(const CollisionPartner& p) {
  double sum = 0.0;
  if (p.inverse_mass > 0.0) sum += 0.5 * dot(p.velocity, p.velocity) / p.inverse_mass;
  if (p.inverse_inertia > 0.0) sum += 0.5 * dot(p.spin, p.spin) / p.inverse_inertia;
  return sum;
}

Vector3 slip(const CollisionPartner& i, const CollisionPartner& j) {
  const Vector3 v = i.velocity - j.velocity;
  return v - dot(v, k) * k + cross(i.radius * i.spin + j.radius * j.spin, k);
}

// Every quantity is a sum of at most 20 terms of order 1, rounded by 1.1e-16 each.
constexpr double round_off = 5e-15;

ImpactOutcome hit(double e, double mu, const CollisionPartner& i, const CollisionPartner& j) {
  return compute_impact(Surface::core, k, {e, mu, 0.0}, i, j);
}

TEST(Collision, RestitutionWithoutFriction) {
  const ImpactOutcome h = hit(0.7, 0.0, one, two);
  const CollisionPartner i = after(one, h, -1.0), j = after(two, h, 1.0);
  EXPECT_NEAR(dot(k, i.velocity - j.velocity), -0.7 * dot(k, one.velocity - two.velocity),
              round_off);
  EXPECT_EQ(i.spin.x, one.spin.x);
  EXPECT_NEAR(energy(i) + energy(j) - energy(one) - energy(two), h.energy_change, round_off);
}

TEST(Collision, StickingStopsTheSurfaces) {
  const ImpactOutcome h = hit(0.9, 10.0, one, two);
  const CollisionPartner i = after(one, h, -1.0), j = after(two, h, 1.0);
  EXPECT_NEAR(norm(slip(i, j)), 0.0, round_off);
  EXPECT_NEAR(energy(i) + energy(j) - energy(one) - energy(two), h.energy_change, round_off);
}

TEST(Collision, SlidingHasTheCoulombImpulseAgainstTheSlip) {
  const double mu = 0.05;
  const ImpactOutcome h = hit(0.9, mu, one, two);
  const Vector3 tangential = h.impulse - h.normal_impulse * k;
  EXPECT_NEAR(norm(tangential), mu * h.normal_impulse, round_off);
  const Vector3 before = slip(one, two);
  EXPECT_NEAR(dot(tangential, before), norm(tangential) * norm(before), round_off);
  const CollisionPartner i = after(one, h, -1.0), j = after(two, h, 1.0);
  EXPECT_NEAR(dot(slip(i, j), before) / norm(before) / norm(slip(i, j)), 1.0, round_off);
  EXPECT_NEAR(energy(i) + energy(j) - energy(one) - energy(two), h.energy_change, round_off);
}

TEST(Collision, MomentumAndAngularMomentumAreConserved) {
  const ImpactOutcome h = hit(0.6, 0.2, one, two);
  const CollisionPartner i = after(one, h, -1.0), j = after(two, h, 1.0);
  // About the centre of i, j being one contact distance along k.
  const double distance = one.radius + two.radius;
  const auto spin = [&](const CollisionPartner& a, const CollisionPartner& b) {
    return (1.0 / a.inverse_inertia) * a.spin + (1.0 / b.inverse_inertia) * b.spin +
           cross(distance * k, (1.0 / b.inverse_mass) * b.velocity);
  };
  EXPECT_NEAR(norm(spin(i, j) - spin(one, two)), 0.0, round_off);
  EXPECT_NEAR(norm(2.0 * (i.velocity - one.velocity) + 3.0 * (j.velocity - two.velocity)), 0.0,
              round_off);
}

TEST(Collision, WallIsAPartnerOfInfiniteMass) {
  const CollisionPartner wall{{0.2, 0.0, 0.1}, {}, 0.0, 0.0, 0.0};
  const ImpactOutcome h = hit(0.8, 10.0, one, wall);
  const CollisionPartner i = after(one, h, -1.0), w = after(wall, h, 1.0);
  EXPECT_EQ(w.velocity.x, wall.velocity.x);
  EXPECT_EQ(w.spin.x, 0.0);
  EXPECT_NEAR(dot(k, i.velocity - wall.velocity), -0.8 * dot(k, one.velocity - wall.velocity),
              round_off);
  EXPECT_NEAR(norm(slip(i, wall)), 0.0, round_off);
}

TEST(Collision, SeparatesWithTheEnergyAddingSpeed) {
  const double least = 2.0 * dot(k, one.velocity - two.velocity), e = 0.6;
  const ImpactOutcome h = compute_impact(Surface::core, k, {e, 0.0, 0.0}, one, two, {least, 0.0});
  const CollisionPartner i = after(one, h, -1.0), j = after(two, h, 1.0);
  EXPECT_NEAR(dot(k, j.velocity - i.velocity), least, round_off);
  EXPECT_NEAR(energy(i) + energy(j) - energy(one) - energy(two), h.energy_change, round_off);
  EXPECT_GT(h.energy_change, 0.0);
  const ImpactOutcome without = hit(e, 0.0, one, two);
  EXPECT_NEAR(h.rest_rule_energy, h.energy_change - without.energy_change, round_off);

  const ImpactOutcome unchanged =
      compute_impact(Surface::core, k, {e, 0.0, 0.0}, one, two, {0.29 * least, 0.0});
  EXPECT_EQ(unchanged.normal_impulse, without.normal_impulse);
  EXPECT_EQ(unchanged.rest_rule_energy, 0.0);
}

// K: elastic below it, separation with at least K while restitution leaves less, and no change
// above K/e. It never adds energy.
TEST(Collision, SeparatesWithTheEnergyLimitedSpeed) {
  const double u = dot(k, one.velocity - two.velocity), e = 0.6;
  for (const double kept : {0.5 * e * u, 0.8 * u, 3.0 * u}) {
    const ImpactOutcome h = compute_impact(Surface::core, k, {e, 0.0, 0.0}, one, two, {0.0, kept});
    const CollisionPartner i = after(one, h, -1.0), j = after(two, h, 1.0);
    EXPECT_NEAR(dot(k, j.velocity - i.velocity), std::max(e * u, std::min(u, kept)), round_off);
    EXPECT_NEAR(energy(i) + energy(j) - energy(one) - energy(two), h.energy_change, round_off);
    EXPECT_LE(h.energy_change, 0.0);
    EXPECT_NEAR(h.rest_rule_energy, h.energy_change - hit(e, 0.0, one, two).energy_change,
                round_off);
  }
}

// Friction acts as in an elastic collision. The energy that it dissipates increases the speed of
// separation, up to K.
TEST(Collision, FrictionConservesEnergyBelowTheEnergyLimitedSpeed) {
  const double u = dot(k, one.velocity - two.velocity);
  for (const double friction : {0.05, 10.0}) {
    const ImpactOutcome elastic = hit(1.0, friction, one, two);
    const double b = one.inverse_mass + two.inverse_mass;
    const double most = std::sqrt(u * u - 2.0 * b * elastic.energy_change);
    EXPECT_GT(most, u * (1.0 + 1e-3));
    for (const double kept : {0.5 * (u + most), 2.0 * most}) {
      const ImpactOutcome h =
          compute_impact(Surface::core, k, {0.6, friction, 0.0}, one, two, {0.0, kept});
      const CollisionPartner i = after(one, h, -1.0), j = after(two, h, 1.0);
      EXPECT_NEAR(dot(k, j.velocity - i.velocity), std::min(kept, most), round_off);
      EXPECT_NEAR(norm(h.spin_impulse - elastic.spin_impulse), 0.0, round_off);
      const double change = energy(i) + energy(j) - energy(one) - energy(two);
      EXPECT_NEAR(change, h.energy_change, round_off);
      EXPECT_NEAR(change, std::min(0.0, 0.5 * (kept - most) * (kept + most) / b), round_off);
    }
  }
}

TEST(Collision, RejectsInvalidLaws) {
  expect_refused([] { require_valid(ImpactLaw{1.1, 0.0, 0.0}); }, "restitution e = 1.1");
  expect_refused([] { require_valid(ImpactLaw{std::nan(""), 0.0, 0.0}); }, "restitution");
  expect_refused([] { require_valid(ImpactLaw{1.0, -0.1, 0.0}); }, "friction");
  expect_refused([] { require_valid(ImpactLaw{1.0, 0.0, -1.0}); }, "depth");
}

}  // namespace
