// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <complex>
#include <random>

#include "event_stepping/pair_run.h"

namespace cohesion::event_stepping {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
const Body small{thesis::radius, 1.0 / thesis::mass};
const Body large{0.8e-3, 1.0 / (4.1 * thesis::mass)};
constexpr double dt = thesis::contact_time / 10.0;
constexpr double pull = 1e-4;  // [N]: adhesion that holds the pairs at rest

contact::ContactParameters rolling(double coefficient) {
  contact::ContactParameters p = thesis::contact();
  p.rolling_friction = coefficient;
  return p;
}

/// A pair at rest under the adhesion `pull`; only its spins change. x is the line of centres.
template <class Pair>
struct Pressed {
  CohesiveContact<Pair> contact;
  Body i, j;
  PairMotion motion;
  Vector3 memory{};
  RollingStep last{};
  double lost = 0.0;

  Pressed(const contact::ContactParameters& p, const Body& of_i, const Body& of_j)
      : contact(p, {pull, thesis::range, pull * thesis::range}, of_i, of_j, {0.5 * dt, 0.5 * dt}),
        i(of_i),
        j(of_j) {
    motion.relative.separation.x = i.radius + j.radius - pull / p.stiffness;
  }
  void step() {
    last = contact.rolling(motion, {}, contact.advance(motion.relative, true), memory);
    motion.spin_i += inverse_inertia(i) * last.torque_i;
    motion.spin_j -= inverse_inertia(j) * last.torque_i;
    memory = last.memory;
    lost += last.spring.damped + last.spring.friction;
  }
  double energy_of_spin() const {
    double sum = 0.5 / inverse_inertia(i) * dot(motion.spin_i, motion.spin_i);
    if (j.inverse_mass > 0.0) sum += 0.5 / inverse_inertia(j) * dot(motion.spin_j, motion.spin_j);
    return sum;
  }
  double energy() const {
    return energy_of_spin() + contact.friction_energy(last.spring.displacement) + lost;
  }
};

}  // namespace

TEST(RollingFriction, RollsWithTheReducedRadiusAndTheInertiaOfBoth) {
  const Pressed<SpherePair> pair(rolling(0.1), small, large);
  const double reduced = 0.5e-3 * 0.8e-3 / 1.3e-3;
  EXPECT_NEAR(pair.contact.rolling_radius() / reduced, 1.0, 4 * eps);
  const double inertia = 0.4 * thesis::mass * 0.25e-6, other = 0.4 * 4.1 * thesis::mass * 0.64e-6;
  EXPECT_NEAR(
      pair.contact.inverse_rolling_mass() / (reduced * reduced * (1.0 / inertia + 1.0 / other)),
      1.0, 16 * eps);
  const Pressed<PlanePair> wall(rolling(0.1), small, {0.0, 0.0});
  EXPECT_EQ(wall.contact.rolling_radius(), 0.5e-3);
  EXPECT_NEAR(wall.contact.inverse_rolling_mass() * thesis::mass, 2.5, 16 * eps);
}

TEST(RollingFriction, SwingsAndDecaysAtTheClosedForm) {
  // m_r v' = -K_r s - eta_r v, s' = v: s = (v0/q) Im exp(l t), l = -alpha + i q. The midpoint rule
  // has the same modes, with (1 + l T/2)/(1 - l T/2) in place of exp(l T): phase and decay of
  // second order in the step.
  Pressed<SpherePair> pair(rolling(0.1), small, large);
  const double radius = pair.contact.rolling_radius(),
               mass = 1.0 / pair.contact.inverse_rolling_mass();
  const double stiffness = 2.0 / 7.0 * 800.0, damping = 0.5 * 0.79e-3;
  const double alpha = 0.5 * damping / mass, q = std::sqrt(stiffness / mass - alpha * alpha);
  const std::complex<double> l(-alpha, q), factor = (1.0 + 0.5 * dt * l) / (1.0 - 0.5 * dt * l);
  EXPECT_NEAR(std::arg(factor) / (q * dt), 1.0, std::norm(l) * dt * dt / 12.0);

  pair.motion.spin_i = {7.0, 2e-3, -1e-3};  // about x nothing rolls
  pair.motion.spin_j = {-3.0, 1e-3, 1e-3};
  const Vector3 v0 = radius * Vector3{0.0, 1e-3, -2e-3};
  std::complex<double> power = 1.0;
  const int steps = 100;
  for (int n = 1; n <= steps; n++) {
    pair.step();
    power *= factor;
    const double part = std::imag(l * power) / q;
    const Vector3 expected = part * v0;
    const Vector3 found = radius * (pair.motion.spin_i - pair.motion.spin_j);
    // Some ten roundings a step.
    EXPECT_NEAR(found.y, expected.y, 16 * eps * n * norm(v0));
    EXPECT_NEAR(found.z, expected.z, 16 * eps * n * norm(v0));
    EXPECT_EQ(pair.last.spring.friction, 0.0);
  }
  EXPECT_LT(std::abs(power), 0.9);
  EXPECT_EQ(pair.motion.spin_i.x, 7.0);
  EXPECT_EQ(pair.motion.spin_j.x, -3.0);
}

TEST(RollingFriction, SpinningPairIsBrakedByTheCoulombTorque) {
  // Equal spheres with opposite spins: I w' = -R mu_R N, R = r/2, as long as they roll.
  const double coefficient = 0.05, spin = 20.0;
  Pressed<SpherePair> pair(rolling(coefficient), small, small);
  pair.motion.spin_i = {0.0, spin, 0.0};
  pair.motion.spin_j = {0.0, -spin, 0.0};
  const double start = pair.energy_of_spin();
  const double rate = inverse_inertia(small) * 0.5 * thesis::radius * coefficient * pull;
  const int stops = static_cast<int>(spin / rate / dt);
  ASSERT_GT(stops, 200);
  double before = spin;
  for (int n = 1; n < stops; n++) {
    pair.step();
    // The first steps stretch the spring to mu_R N/K_r at R 2 w: less than half a step here.
    // The overlap at rest, 1.25e-7 m, is that of two rounded distances of 1e-3 m: 2e-19 m of it.
    if (n > 1) {
      EXPECT_NEAR((before - pair.motion.spin_i.y) / (rate * dt), 1.0, 1e-11);
    }
    EXPECT_NEAR(pair.motion.spin_i.y, -pair.motion.spin_j.y, 4 * eps * spin);
    before = pair.motion.spin_i.y;
  }
  for (int n = 0; n < 4000; n++) pair.step();
  // At rest, the energy lost but for what the spring swings with, which decays at alpha =
  // eta_r/(2 m_r).
  const double decay =
      std::exp(-0.5 * 0.5 * 0.79e-3 * pair.contact.inverse_rolling_mass() * 4000 * dt);
  EXPECT_LT(decay, 1e-2);
  const double swing = coefficient * pull / std::sqrt(2.0 / 7.0 * 800.0);  // sqrt(2 energy)
  EXPECT_LE(pair.energy_of_spin(), 0.5 * swing * swing * 2.0 * decay * decay);
  EXPECT_NEAR(pair.energy() / start, 1.0, 64 * eps * (stops + 4000));
  EXPECT_GT(pair.lost, 0.999 * start);
}

TEST(RollingFriction, HoldsBelowTheCoulombTorqueAndYieldsAboveIt) {
  // A steady torque on a sphere at a wall, in each step as another contact's: below R mu_R N it
  // comes to rest, above it the spin grows by what is left over.
  const double coefficient = 0.05, most = thesis::radius * coefficient * pull;
  for (const double part : {0.4, 1.2}) {
    Pressed<PlanePair> wall(rolling(coefficient), small, {0.0, 0.0});
    PairMotion others;
    others.spin_i.z = inverse_inertia(small) * part * most * dt;
    double before = 0.0;
    for (int n = 0; n < 4000; n++) {
      before = wall.motion.spin_i.z;
      const PairStep normal = wall.contact.advance(wall.motion.relative, true);
      const RollingStep step = wall.contact.rolling(wall.motion, others, normal, wall.memory);
      wall.motion.spin_i += others.spin_i + inverse_inertia(small) * step.torque_i;
      wall.memory = step.memory;
    }
    if (part < 1.0) {
      // The swing about T/(R^2 K_r) has decayed, exp(-alpha t).
      const double decay =
          std::exp(-0.25 * 0.79e-3 * wall.contact.inverse_rolling_mass() * 4000 * dt);
      ASSERT_LT(decay, 1e-5);
      const double w = std::sqrt(2.0 / 7.0 * 800.0 * wall.contact.inverse_rolling_mass());
      EXPECT_LT(std::abs(wall.motion.spin_i.z), 2.0 * decay * others.spin_i.z / (w * dt));
    } else {
      EXPECT_NEAR((wall.motion.spin_i.z - before) / (others.spin_i.z * (1.0 - 1.0 / part)), 1.0,
                  1e-9);
    }
  }
}

TEST(RollingFriction, ChangesSignWithTheExchangeOfTheParticles) {
  const contact::ContactParameters p = rolling(0.1);
  const contact::Adhesion a{pull, thesis::range, pull * thesis::range};
  const CohesiveContact<SpherePair> there(p, a, small, large, {0.5 * dt, 0.5 * dt});
  const CohesiveContact<SpherePair> back(p, a, large, small, {0.5 * dt, 0.5 * dt});
  const PairMotion grid{
      {{1.29e-3, 3e-5, -2e-5}, {0.01, 0.02, -0.01}}, {3.0, -4.0, 5.0}, {1., 7., -2.}};
  const PairMotion reverse{
      {-grid.relative.separation, -grid.relative.velocity}, grid.spin_j, grid.spin_i};
  const PairMotion others{{}, {0.3, 0.1, 0.2}, {}}, of_reverse{{}, {}, others.spin_i};
  for (const double length : {0.0, 1e-9, 1e-5}) {
    const Vector3 memory{0.0, length, -length};
    const RollingStep one = there.rolling(grid, others, there.advance(grid.relative, true), memory);
    const RollingStep two =
        back.rolling(reverse, of_reverse, back.advance(reverse.relative, true), -memory);
    ASSERT_GT(norm(one.torque_i), 0.0);
    EXPECT_LT(norm(one.torque_i + two.torque_i), 64 * eps * norm(one.torque_i));
    EXPECT_LT(norm(one.memory + two.memory), 64 * eps * norm(one.memory));
  }
}

TEST(RollingFriction, NothingHappensToAPairThatTurnsAsOneBodyOrSpinsOrParts) {
  Pressed<SpherePair> pair(rolling(0.1), small, large);
  pair.motion.spin_i = pair.motion.spin_j = {1.0, 2.0, 3.0};
  pair.step();
  EXPECT_EQ(norm(pair.last.torque_i), 0.0);
  // About the normal it spins, which is not resisted; but for the rounding of its part in the
  // plane.
  pair.motion.spin_i = {5.0, 2.0, 3.0};
  pair.step();
  const double stopped = 1.0 / inverse_inertia(small);  // what stops a spin of 1
  EXPECT_LT(norm(pair.last.torque_i), 8 * eps * 5.0 * stopped);

  Pressed<SpherePair> smooth(rolling(0.0), small, large);
  smooth.motion.spin_i = {1.0, 2.0, 3.0};
  smooth.step();
  EXPECT_EQ(norm(smooth.last.torque_i), 0.0);

  // What the spring held is lost when the contact ends within the step.
  Pressed<SpherePair> parting(rolling(0.1), small, large);
  const Vector3 memory{0.0, 1e-9, 0.0};
  parting.motion.relative.velocity.x = 0.1;
  const PairStep normal = parting.contact.advance(parting.motion.relative, true);
  ASSERT_LT(normal.overlap_at_end, 0.0);
  ASSERT_GT(normal.normal.contact_time, 0.0);
  const RollingStep step = parting.contact.rolling(parting.motion, {}, normal, memory);
  EXPECT_EQ(norm(step.memory), 0.0);
  EXPECT_EQ(norm(step.spring.displacement), 0.0);
  EXPECT_GT(step.spring.friction + step.spring.damped, 0.0);
}

TEST(RollingFriction, AWallIsTheLimitOfALargeSphere) {
  Pressed<PlanePair> wall(rolling(0.02), small, {0.0, 0.0});
  const Body huge{1e6 * thesis::radius, 1e-18 / thesis::mass};
  Pressed<SpherePair> sphere(rolling(0.02), small, huge);
  // Far enough from rest for all of it: swings, and slides in between.
  wall.motion.spin_i = sphere.motion.spin_i = {0.0, 3.0, -4.0};
  for (int n = 0; n < 200; n++) {
    wall.step();
    sphere.step();
    // 1/ratio from R; the overlap of 1.25e-7 m is rounded by 6e-14 m beside the huge sphere.
    EXPECT_LT(norm(wall.motion.spin_i - sphere.motion.spin_i), 5.0 * (1e-6 + 1e-6));
  }
  EXPECT_LT(norm(wall.motion.spin_i), 4.0);
}

TEST(RollingFriction, NoStepGivesEnergyAndSlidingIsCapped) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int slid = 0;
  for (int n = 0; n < 1000; n++) {
    contact::ContactParameters p = rolling(0.5 + 0.5 * uniform(random));
    p.tangential_ratio = std::exp(4.0 * uniform(random));
    p.tangential_damping_ratio = std::exp(4.0 * uniform(random));
    Pressed<SpherePair> pair(p, small, large);
    const auto any = [&](double size) {
      return size * Vector3{uniform(random), uniform(random), uniform(random)};
    };
    pair.motion.spin_i = any(100.0), pair.motion.spin_j = any(100.0);
    const double start = pair.energy();
    for (int k = 0; k < 20; k++) {
      const double held = pull * dt * p.rolling_friction;
      pair.step();
      EXPECT_LE(norm(pair.last.spring.impulse), held * (1.0 + 1e-11));
      EXPECT_GE(pair.last.spring.friction, -64 * eps * start);
      EXPECT_GE(pair.last.spring.damped, 0.0);
      slid += pair.last.spring.friction > 64 * eps * start;
      ASSERT_NEAR(pair.energy(), start, 64 * eps * (k + 1) * start);
    }
  }
  EXPECT_GT(slid, 1000);
  EXPECT_LT(slid, 20000);
}

}  // namespace cohesion::event_stepping
