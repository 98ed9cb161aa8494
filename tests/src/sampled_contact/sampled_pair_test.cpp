// SPDX-License-Identifier: BSD-3-Clause
#include "sampled_contact/sampled_pair.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sampled_contact/sampled_contact.h"
#include "sampled_contact/sampled_hamaker.h"

namespace cohesion::sampled_contact {
namespace {

constexpr double radius = 5e-4, mass = 1.4e-6, speed = 0.1, e = 0.9;

contact::ContactParameters hertz(double restitution) {
  contact::ContactParameters p;
  contact::set_hertz(p, 5e6, 0.25);
  p.restitution = restitution;
  return p;
}

contact::NormalLaw law(double restitution) {
  return contact::normal_law(hertz(restitution), 0.5 * radius, 0.5 * mass);
}

SampledHamaker pair_without_attraction() {
  return {law(e),
          {hamaker::forms.front().law(hamaker::none, false), two_spheres(radius, radius)},
          2.0 * radius};
}

}  // namespace

TEST(SampledPair, RepulsionIsTheLawWhereThePairIs) {
  const double distance = 2.0 * radius - 1e-6, rate = 0.02, time = 1e-7;
  const double overlap = 2.0 * radius - distance;
  const StepWindow window{0.5 * time, 0.5 * time};
  const contact::LawPoint here = contact::point_of(law(e), overlap);
  const SampledHamaker pair = pair_without_attraction();
  const PairStep pressed = pair.advance({distance, 0, 0}, {-rate, 0, 0}, window, false);
  EXPECT_DOUBLE_EQ(pressed.force, here.force + here.damping * rate);
  EXPECT_DOUBLE_EQ(pressed.record.dissipated, time * here.damping * rate * rate);
  EXPECT_DOUBLE_EQ(pair.spring_energy(overlap), here.energy);
  const PairStep apart = pair.advance({2.0 * radius + overlap, 0, 0}, {-rate, 0, 0}, window, false);
  EXPECT_EQ(apart.force, 0.0);
  EXPECT_EQ(pair.spring_energy(-overlap), 0.0);
}

/// The dashpot sees the velocity of half a step before: a fraction w dt/2 = pi/(2 n) of what it
/// dissipates, 1 - e^2, is open at n steps per contact, and half of that of the speed.
TEST(SampledPair, RestitutionOfHertzComesWithTheStep) {
  const double contact_time = std::get<contact::HertzSpringDashpot>(law(1.0)).contact_time(speed);
  for (const double steps : {50.0, 400.0}) {
    const double dt = contact_time / steps;
    const SampledHamaker pair = pair_without_attraction();
    Vector3 separation{2.0 * radius + 0.3 * speed * dt, 0, 0}, velocity{-speed, 0, 0};
    for (int k = 0; k < 3 * steps; k++) {
      velocity += pair.advance(separation, velocity, {0.5 * dt, 0.5 * dt}, false).velocity_change;
      separation += dt * velocity;
    }
    EXPECT_NEAR(velocity.x / speed / e, 1.0, 0.5 * (1.0 - e * e) * pi / (2.0 * steps));
  }
}

/// Mindlin's spring stiffens with the overlap: its force stays where the overlap grows, and falls
/// with it.
TEST(SampledContact, TheTangentialSpringStiffensWithHertzOverlap) {
  contact::ContactParameters p = hertz(1.0);
  p.friction = 1e3;
  p.tangential_damping_ratio = 0.0;
  const double dt = 1e-7, slide = 1e-3;
  const SampledContact<SampledHamaker> contact(
      p, {hamaker::forms.front().law(hamaker::none, false), two_spheres(radius, radius)},
      {radius, 1.0 / mass}, {radius, 1.0 / mass}, {0.5 * dt, 0.5 * dt});
  const auto friction = [&](double overlap, double rate, double sideways, ContactHistory& history) {
    const PairMotion at{{2.0 * radius - overlap, 0, 0}, {-rate, sideways, 0}, {}, {}};
    return contact.advance<ContactHistory::with_friction>(at, {}, false, history, nullptr)
        .friction.y;
  };
  const double low = 1e-6, high = 1.21e-6;
  ContactHistory history;
  const double first = friction(low, 0.0, slide, history);
  EXPECT_LT(first, 0.0);
  // Pressed in without sliding further, the force stays.
  EXPECT_NEAR(friction(high, (high - low) / dt, 0.0, history) / first, 1.0, 1e-9);
  // Drawn back, it falls as sqrt(overlap).
  EXPECT_NEAR(friction(low, (low - high) / dt, 0.0, history) / first, std::sqrt(low / high), 1e-9);
}

}  // namespace cohesion::sampled_contact
