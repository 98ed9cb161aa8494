// SPDX-License-Identifier: BSD-3-Clause
#include "event_stepping/two_pass_contact.h"

#include <gtest/gtest.h>

#include <random>

#include "constants.h"
#include "event_stepping/pair_on_grid.h"

namespace cohesion::event_stepping {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
const Body particle{thesis::radius, 1.0 / thesis::mass};

using Spheres = PairOnGrid<SpherePair, ContactMemory::with_friction>;

/// Thesis particles that meet at `speed` and `angle` to the normal, half a step of flight before.
Spheres oblique(const contact::ContactParameters& p, double speed, double angle, double dt) {
  const Vector3 v{-speed * std::cos(angle), speed * std::sin(angle), 0.0};
  Spheres s(p, {}, particle, particle, dt);
  s.x[1] = Vector3{2.0 * thesis::radius, 0.0, 0.0} - 0.5 * dt * v;
  s.v[1] = v;
  return s;
}

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

}  // namespace

TEST(TwoPassContact, FrictionKeepsMomentumAndAngularMomentum) {
  std::mt19937 random(7);
  int lasted = 0;
  for (int n = 0; n < 50; n++) {
    contact::ContactParameters p = thesis::contact();
    p.friction = uniform(random, 0.05, 1.0);
    p.rolling_friction = uniform(random, 0.05, 0.2);
    const double dt = thesis::contact_time / uniform(random, 2.0, 30.0);
    const Body i{0.5e-3, 1.0 / thesis::mass}, j{0.8e-3, 1.0 / (4.1 * thesis::mass)};
    // Every other pair sticks.
    const double hamaker = n % 2 ? 2e-18 : 2e-16;
    PairOnGrid<SpherePair, ContactMemory::with_rolling> s(p, thesis::adhesion(hamaker), i, j, dt);
    const auto any = [&](double size) {
      return Vector3{uniform(random, -size, size), uniform(random, -size, size),
                     uniform(random, -size, size)};
    };
    s.x[0] = any(1e-3), s.x[1] = s.x[0] + Vector3{1.3001e-3, 0.0, 0.0};
    s.v[0] = any(0.1), s.v[1] = any(0.1) + Vector3{-0.2, 0.0, 0.0};
    s.spin[0] = any(200.0), s.spin[1] = any(200.0);
    const Vector3 momentum = s.momentum(), turning = s.angular_momentum();
    const double speed = 0.4 / i.inverse_mass, arm = 4e-3;
    const int steps = 200;
    s.steps(steps);
    lasted += s.lasted;
    // A few roundings of the largest momentum, also at the distance that flight leads to, per step.
    EXPECT_LT(norm(s.momentum() - momentum), 16 * eps * steps * 5.0 * speed);
    EXPECT_LT(norm(s.angular_momentum() - turning),
              16 * eps * steps * 5.0 * speed * (arm + 0.5 * steps * dt));
  }
  EXPECT_GT(lasted, 10);
  EXPECT_LT(lasted, 40);
}

TEST(TwoPassContact, FrictionBalancesTheEnergy) {
  // Kinetic energy of the true motion, stored energy and all losses, at every grid point. Not
  // exact: normal motion and friction of a step are added rather than composed, of first order in
  // the step: the pair turns by u_t t_c/R = 0.013 in contact, the step's part dt/t_c of that, times
  // the tangential share of the energy, sin^2 < 0.52. And friction changes the angular momentum at
  // an overlap x, where the centrifugal energy is followed to first order in x/R only: 1.5 (x/R)^2
  // of the tangential energy, for any step.
  for (const double friction : {0.05, 0.3, 5.0}) {
    contact::ContactParameters p = thesis::contact();
    p.friction = friction;
    double errors[2];
    int k = 0;
    for (const double part : {10.0, 100.0}) {
      Spheres s = oblique(p, 0.2, 0.8, thesis::contact_time / part);
      const double before = s.kinetic();
      double worst = 0.0;
      for (int n = 0; n < 2.0 * part; n++) {
        s.step();
        worst = std::max(worst, std::abs(s.energy - before) / before);
        EXPECT_GE(s.now.friction, -1e-15 * before) << friction;
        EXPECT_GE(s.now.tangential_damping, 0.0) << friction;
      }
      EXPECT_FALSE(s.memory.in_range());
      EXPECT_GT(s.lost, 0.0);
      errors[k++] = worst;
    }
    const double overlap = 0.2 * std::cos(0.8) / 33957.0 / (2.0 * thesis::radius);
    const double centrifugal = 1.5 * overlap * overlap * 0.52;
    EXPECT_LT(errors[0], 0.013 * 0.52 / 10.0 + centrifugal);
    EXPECT_LT(errors[1], 0.013 * 0.52 / 100.0 + centrifugal);
  }
}

TEST(TwoPassContact, TheDashpotOfALastingContactTakesTheEnergyOfItsSwing) {
  // A bound pair that swings about its rest, x = a exp(-alpha t) (cos q t + alpha/q sin q t), as it
  // does exactly on the grid: all of the energy K a^2/2 is lost in the end. The tally begins in the
  // middle of what the first step loses, 2 alpha dt of the energy, of which it knows the share to
  // second order in w0 dt and alpha dt.
  contact::ContactParameters p = thesis::elastic();
  p.restitution = 0.95;
  p.damping = -1.0;
  const auto law = contact::normal_contact(p, thesis::reduced_mass);
  const double w0_squared = 800.0 / thesis::reduced_mass;
  const double alpha = 0.5 * law.damping() / thesis::reduced_mass;
  const DampedOscillator oscillator(w0_squared, alpha);
  const contact::Adhesion a = thesis::adhesion(2e-18);
  for (const double part : {4.0, 10.0, 40.0}) {
    const double dt = thesis::contact_time / part;
    PairOnGrid<SpherePair, ContactMemory::normal_only> s(p, a, particle, particle, dt);
    const Overlap start{0.5 * a.force / 800.0, 0.0}, next = oscillator.after(dt, start, 0.0);
    s.x[1].x = 2.0 * thesis::radius - a.force / 800.0 - next.x;
    s.v[1].x = -(next.x - start.x) / dt;
    s.memory = {ContactMemory::lasting, 1e6, 0.0, {}, {}};
    s.step();
    const double begin = s.energy;
    const double swing = 400.0 * next.x * next.x + 0.5 * thesis::reduced_mass * next.v * next.v;
    const int steps = static_cast<int>(12.0 / alpha / dt);
    for (int n = 0; n < steps; n++) {
      s.step();
      ASSERT_TRUE(s.lasted);
    }
    const double few = w0_squared * dt * dt + alpha * dt;
    EXPECT_NEAR((s.energy - begin) / swing, 0.0, 2.0 * alpha * dt * few + 1e-8) << part;
  }
}

TEST(TwoPassContact, MindsOthersUnlessItsDashpotTakesFarMoreThanOneForceErrs) {
  // 20 (dt/t_c)^3 < 1 - e^2, and ln(1/e) dt/t_c < 0.02.
  const auto minds = [](double e, double part) {
    contact::ContactParameters p;
    p.stiffness = 800.0;
    p.restitution = e;
    const Body body{thesis::radius, 1.0 / thesis::mass};
    const double t = contact::normal_contact(p, thesis::reduced_mass).contact_time();
    return TwoPassContact<SpherePair>(p, {}, body, body, e > 0.0 ? t / part : 1e-6).minds_others();
  };
  for (const double part : {4.0, 6.0, 10.0, 20.0, 100.0}) {
    EXPECT_TRUE(minds(1.0, part));
    EXPECT_TRUE(minds(0.0, part));
    const double most = std::sqrt(1.0 - 20.0 / (part * part * part));
    const double least = std::exp(-0.02 * part);
    EXPECT_TRUE(minds(std::min(most * 1.0001, 1.0), part)) << part;
    EXPECT_TRUE(minds(least * 0.9999, part)) << part;
    EXPECT_EQ(minds(most * 0.9999, part), most * 0.9999 < least) << part;
    EXPECT_EQ(minds(least * 1.0001, part), least * 1.0001 > most) << part;
  }
}

TEST(TwoPassContact, KicksNoMoreThanItSays) {
  std::mt19937 random(12);
  int met = 0, parted = 0;
  double nearest = 0.0;
  for (int n = 0; n < 8000; n++) {
    contact::ContactParameters p = thesis::contact();
    p.damping = -1.0;
    p.restitution = uniform(random, 0.05, 1.0);
    p.friction = uniform(random, 0.0, 1.0);
    const double dt = thesis::contact_time / uniform(random, 2.5, 30.0);
    const Body i{0.5e-3, 1.0 / thesis::mass}, j{0.8e-3, 1.0 / (4.1 * thesis::mass)};
    const TwoPassContact<SpherePair> contact(p, thesis::adhesion(n % 2 ? 2e-18 : 0.0), i, j, dt);
    const double speed = std::pow(10.0, uniform(random, -4.0, 0.0));
    const auto any = [&](double size) {
      return Vector3{uniform(random, -size, size), uniform(random, -size, size),
                     uniform(random, -size, size)};
    };
    const bool in_range = n % 3 != 0;
    const double gap =
        in_range ? uniform(random, -5e-6, 0.0) : 1e-7 + uniform(random, 0.0, speed * dt);
    const PairMotion motion{
        {{i.radius + j.radius + gap, 0.0, 0.0}, any(speed)}, any(100.0), any(100.0)};
    const FollowedStart start{motion, {}, {}, 0.0};
    const auto f = contact.follow<ContactMemory::with_friction>(start, {}, {}, in_range);
    if (!f.normal.interacts) continue;
    met += !in_range && f.normal.normal.contact_time > 0.0;
    parted += in_range && !f.normal.inside;
    const double most = contact.most_kick(start);
    EXPECT_LE(norm(f.change.relative.velocity), most) << n;
    EXPECT_LE(norm(f.change.relative.separation), most * dt) << n;
    nearest = std::max(nearest, norm(f.change.relative.velocity) / most);
  }
  EXPECT_GT(met, 100);
  EXPECT_GT(parted, 100);
  // It is no idle bound either.
  EXPECT_GT(nearest, 0.2);
}

TEST(TwoPassContact, PredictorOfALastingContactIsWhatIsFollowed) {
  std::mt19937 random(11);
  int lasted = 0, slid = 0;
  for (int n = 0; n < 400; n++) {
    contact::ContactParameters p = thesis::contact();
    p.friction = uniform(random, 0.05, 1.0);
    const double dt = thesis::contact_time / uniform(random, 5.0, 30.0);
    const Body i{0.5e-3, 1.0 / thesis::mass}, j{0.8e-3, 1.0 / (4.1 * thesis::mass)};
    const TwoPassContact<SpherePair> contact(p, thesis::adhesion(2e-18), i, j, dt);
    const auto any = [&](double size) {
      return Vector3{uniform(random, -size, size), uniform(random, -size, size),
                     uniform(random, -size, size)};
    };
    const double distance = i.radius + j.radius - uniform(random, 0.0, 5e-6);
    const PairMotion motion{{{distance, 0.0, 0.0}, any(0.2)}, any(100.0), any(100.0)};
    const Vector3 stretch{0.0, uniform(random, -1e-6, 1e-6), uniform(random, -1e-6, 1e-6)};
    const FollowedStart start{motion, stretch, {}, 0.0};
    PairMotion found;
    if (!contact.predict_lasting<ContactMemory::with_friction>(start, found)) continue;
    const auto f = contact.follow<ContactMemory::with_friction>(start, {}, {}, true);
    ASSERT_TRUE(f.normal.inside);
    ASSERT_EQ(f.normal.normal.contact_time, dt);
    lasted++;
    slid += f.sliding.friction > 0.0;
    // The plane of contact is that of another moment of the step, by at most the square of the
    // whole turning: so much of the stretch, of the rate at which surfaces slide, of the limit and
    // of the impulse is another, each by at most that part of all speeds.
    const Vector3& v = motion.relative.velocity;
    const double turned = norm(v) * dt / distance;
    const double speed = norm(v) + i.radius * norm(motion.spin_i) + j.radius * norm(motion.spin_j) +
                         800.0 / thesis::reduced_mass * norm(stretch) * dt;
    const double most = 4.0 * turned * turned * speed;
    const PairMotion& expected = f.change;
    EXPECT_LT(norm(found.relative.velocity - expected.relative.velocity), most);
    EXPECT_LT(norm(found.relative.separation - expected.relative.separation), most * dt);
    EXPECT_LT(norm(found.spin_i - expected.spin_i), 2.5 * most / i.radius);
    EXPECT_LT(norm(found.spin_j - expected.spin_j), 2.5 * most / j.radius);
  }
  EXPECT_GT(lasted, 100);
  EXPECT_GT(slid, 20);
  EXPECT_LT(slid, lasted - 20);
}

TEST(TwoPassContact, SlidingImpactsObeyTheHardSphereLaw) {
  // Walton: tangential impulse mu_f times the normal one, which is mu (1 + e) v_n.
  const double angle = 80.0 * pi / 180.0, speed = 0.01, friction = 0.1;
  for (const double part : {4.0, 50.0}) {
    contact::ContactParameters p = thesis::contact();
    p.friction = friction;
    Spheres s = oblique(p, speed, angle, thesis::contact_time / part);
    s.steps(static_cast<int>(2.0 * part));
    ASSERT_FALSE(s.memory.in_range());
    const double normal = thesis::reduced_mass * (1.0 + s.contact.normal_contact().restitution()) *
                          speed * std::cos(angle);
    // The stiff limit: the normal turns by u_t t_c/R = 1e-3 in contact, the centrifugal term lowers
    // the normal impulse by about u_t/(v_n) of that. The steps' angles add that of dt.
    const double turned = speed * thesis::contact_time / (2.0 * thesis::radius);
    EXPECT_NEAR(s.normal_impulse / normal, 1.0, 6.0 * turned);
    // With u_t = 5.7 v_n against mu_f (1 + e) 7/2 = 0.68 it slides all the time but for the start,
    // until K_t s reaches mu_f F: both grow linearly, and s faster.
    EXPECT_NEAR(norm(s.tangential_impulse) / (friction * normal), 1.0, 8.0 * turned);
    // Both spin up alike, J r/I.
    EXPECT_NEAR(s.spin[0].z / (2.5 * norm(s.tangential_impulse) / (thesis::mass * thesis::radius)),
                1.0, 8.0 * turned);
    EXPECT_NEAR(s.spin[1].z / s.spin[0].z, 1.0, 1e-12);
  }
}

TEST(TwoPassContact, StickingImpactsReverseTheSurfaceVelocity) {
  // K_t/K = 2/7, no damping, no slip: the tangential spring swings half a period in contact,
  // Walton's tangential restitution is 1: J_t = -2 m_t u_t with m_t = 2 mu/7.
  const double angle = 0.4, speed = 0.01, dt = thesis::contact_time / 500.0;
  contact::ContactParameters p = thesis::elastic();
  p.friction = 1e3;
  Spheres s = oblique(p, speed, angle, dt);
  const double before = s.kinetic();
  s.steps(1000);
  ASSERT_FALSE(s.memory.in_range());
  const double expected = 2.0 * (2.0 / 7.0) * thesis::reduced_mass * speed * std::sin(angle);
  // The contact turns by u_t t_c/R = 4e-4; the midpoint rule's phase error, pi (w dt)^2/12 = 1e-5,
  // enters squared.
  const double turned = speed * thesis::contact_time / (2.0 * thesis::radius);
  EXPECT_NEAR(norm(s.tangential_impulse) / expected, 1.0, 3.0 * turned);
  EXPECT_NEAR(s.kinetic() / before, 1.0, 3.0 * turned);
}

TEST(TwoPassContact, WhatOthersDoAlongAWallIsNotSeenAlongItsNormal) {
  contact::ContactParameters p = thesis::contact();
  p.friction = 0.3;
  const double dt = thesis::contact_time / 10.0;
  const TwoPassContact<PlanePair> contact(p, thesis::adhesion(2e-18), particle, {0.0, 0.0}, dt);
  const Vector3 normal{0.6, -0.48, 0.64}, along{0.8, 0.36, -0.48};
  ASSERT_NEAR(dot(normal, along), 0.0, eps);
  PairMotion others;
  others.relative = {3e-5 * along, 2.0 * along};
  // A contact that goes on, one that ends, and one that begins in the step.
  const double cases[][2] = {{0.999, -0.02}, {0.9999, 0.1}, {1.0003, -0.1}};
  for (const auto& [distance, rate] : cases) {
    const bool in = distance < 1.0;
    ContactMemory before;
    if (in) before = {ContactMemory::inside, 3.0, 0.0, {}, {}};
    const PairMotion grid{{(distance * thesis::radius) * normal, rate * normal}, {}, {}};
    const auto begins = contact.start<ContactMemory::with_friction>(grid, grid, before);
    const auto predicted = contact.follow<ContactMemory::normal_only>(begins, {}, {}, in);
    const auto with = contact.follow<ContactMemory::normal_only>(begins, others, {}, in);
    ASSERT_GT(predicted.normal.normal.contact_time, 0.0);
    // Rounding: an eps of the speed along the wall, and of the distance in a step.
    const double speed = 8 * eps * (2.0 + 2.0 * thesis::radius / dt);
    EXPECT_NEAR(norm(with.change.relative.velocity - predicted.change.relative.velocity), 0.0,
                4.0 * speed);
    EXPECT_NEAR(norm(with.change.relative.separation - predicted.change.relative.separation), 0.0,
                4.0 * speed * dt);
    ContactMemory one = before, two = before;
    const Action pushed = contact.finish<ContactMemory::normal_only>(begins, {}, predicted, one);
    const Action same = contact.finish<ContactMemory::normal_only>(begins, others, with, two);
    ASSERT_GT(norm(pushed.impulse), 0.0);
    EXPECT_NEAR(norm(same.impulse - pushed.impulse), 0.0, 4.0 * thesis::mass * speed);
    EXPECT_EQ(one.phase, two.phase);
    EXPECT_NEAR(one.ahead, two.ahead, 4.0 * speed);
    // Friction sees it.
    const auto still = contact.follow<ContactMemory::with_friction>(begins, {}, {}, in);
    const auto rubbed = contact.follow<ContactMemory::with_friction>(begins, others, {}, in);
    EXPECT_NEAR(norm(still.sliding.impulse), 0.0, thesis::mass * speed);
    EXPECT_GT(norm(rubbed.sliding.impulse), 0.1 * 0.3 * predicted.normal.normal.repulsion_impulse);
  }
}

}  // namespace cohesion::event_stepping
