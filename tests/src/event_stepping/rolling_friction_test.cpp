// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <complex>
#include <random>

#include "event_stepping/pair_on_grid.h"

namespace cohesion::event_stepping {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
const Body small{thesis::radius, 1.0 / thesis::mass};
const Body large{0.8e-3, 1.0 / (4.1 * thesis::mass)};
const Body wall{0.0, 0.0};
constexpr double dt = thesis::contact_time / 10.0;
constexpr double pull = 1e-4;  // [N]: adhesion that holds the pairs at rest
constexpr double stiffness = 2.0 / 7.0 * 800.0, damping = 0.5 * 0.79e-3;  // of the rolling spring
constexpr int size = ContactMemory::with_rolling;

// The force of a contact on the grid is known to some roundings of the distance of 1e-3 m, in a
// step: 10 1e-19 m mu/dt^2 = 1e-14 N of `pull`.
constexpr double force_error = 1e-10;

contact::ContactParameters rolling(double coefficient) {
  contact::ContactParameters p = thesis::contact();
  p.rolling_friction = coefficient;
  return p;
}

const ContactMemory young{ContactMemory::inside, 0.0, 0.0, {}, {}};
const ContactMemory old{ContactMemory::lasting, 1e6, 0.0, {}, {}};

/// A pair at rest under the adhesion `pull`; only its spins change. x is the line of centres.
template <class Pair>
struct Pressed : PairOnGrid<Pair, size> {
  using PairOnGrid<Pair, size>::spin;
  using PairOnGrid<Pair, size>::body;

  Pressed(const contact::ContactParameters& p, const Body& i, const Body& j,
          const ContactMemory& before)
      : PairOnGrid<Pair, size>(p, {pull, thesis::range, pull * thesis::range}, i, j, dt) {
    this->x[1].x = i.radius + j.radius - pull / p.stiffness;
    this->memory = before;
  }
  double radius() const { return this->contact.bodies().rolling_radius(); }
  double answer() const { return this->contact.bodies().inverse_rolling_mass(); }
  /// On the grid.
  Vector3 rolling_velocity() const { return radius() * (spin[0] - spin[1]); }
  double energy_of_spin() const {
    double sum = 0.5 / inverse_inertia(body[0]) * dot(spin[0], spin[0]);
    if (body[1].inverse_mass > 0.0) sum += 0.5 / inverse_inertia(body[1]) * dot(spin[1], spin[1]);
    return sum;
  }
};

/// Rate of decay and frequency of a rolling spring.
struct Swing {
  double alpha, q;
  explicit Swing(double answer)
      : alpha(0.5 * damping * answer), q(std::sqrt(stiffness * answer - alpha * alpha)) {}
};

}  // namespace

TEST(RollingFriction, FollowedItSwingsAndDecaysAtTheClosedFormOfTheMidpointRule) {
  // m_r v' = -K_r s - eta_r v, s' = v: s = (v0/q) Im exp(l t), l = -alpha + i q. The midpoint rule
  // has the same modes, with (1 + l T/2)/(1 - l T/2) in place of exp(l T): phase and decay of
  // second order in the step.
  Pressed<SpherePair> pair(rolling(0.1), small, large, young);
  const Swing swing(pair.answer());
  const std::complex<double> l(-swing.alpha, swing.q);
  const std::complex<double> factor = (1.0 + 0.5 * dt * l) / (1.0 - 0.5 * dt * l);
  EXPECT_NEAR(std::arg(factor) / (swing.q * dt), 1.0, std::norm(l) * dt * dt / 12.0);

  pair.spin[0] = {7.0, 2e-3, -1e-3};  // about x nothing rolls
  pair.spin[1] = {-3.0, 1e-3, 1e-3};
  const Vector3 v0 = pair.radius() * Vector3{0.0, 1e-3, -2e-3};
  pair.memory.rolling.stretch = -dt * v0;  // to zero at the first grid point
  pair.may_begin = false;
  std::complex<double> power = 1.0;
  for (int n = 1; n <= 100; n++) {
    pair.step();
    ASSERT_FALSE(pair.lasted);
    power *= factor;
    const Vector3 expected = (std::imag(l * power) / swing.q) * v0;
    const PairMotion truth = pair.truth();
    const Vector3 found = pair.radius() * (truth.spin_i - truth.spin_j);
    // Some ten roundings a step.
    EXPECT_NEAR(found.y, expected.y, 16 * eps * n * norm(v0));
    EXPECT_NEAR(found.z, expected.z, 16 * eps * n * norm(v0));
    EXPECT_EQ(pair.followed.rolling.friction, 0.0);
  }
  EXPECT_LT(std::abs(power), 0.9);
  EXPECT_EQ(pair.spin[0].x, 7.0);
  EXPECT_EQ(pair.spin[1].x, -3.0);
}

TEST(RollingFriction, LastingItSwingsAndDecaysExactlyAtAnyStep) {
  // The same swing: s = (v0/q) exp(-alpha t) sin(q t) at grid points, the grid's velocity its
  // difference over a step.
  Pressed<SpherePair> pair(rolling(0.1), small, large, old);
  const Swing swing(pair.answer());
  const Vector3 v0 = pair.radius() * Vector3{0.0, 1e-3, -2e-3};
  const auto part = [&](double n) {
    return std::exp(-swing.alpha * n * dt) * std::sin(swing.q * n * dt) / swing.q;
  };
  const double start = -part(-1.0) / dt;
  pair.spin[0] = {7.0, 2e-3 * start, -1e-3 * start};
  pair.spin[1] = {-3.0, 1e-3 * start, 1e-3 * start};
  pair.memory.rolling.stretch = part(-1.0) * v0;
  const int steps = 1000;
  for (int n = 1; n <= steps; n++) {
    pair.step();
    ASSERT_TRUE(pair.lasted);
    const Vector3 expected = ((part(n) - part(n - 1)) / dt) * v0;
    // Some ten roundings of spins, and what they become in the swing.
    EXPECT_NEAR(pair.rolling_velocity().y, expected.y, 16 * eps * n * norm(v0));
    EXPECT_NEAR(pair.rolling_velocity().z, expected.z, 16 * eps * n * norm(v0));
  }
  EXPECT_LT(std::exp(-swing.alpha * steps * dt), 0.3);
  EXPECT_EQ(pair.spin[0].x, 7.0);
  EXPECT_EQ(pair.spin[1].x, -3.0);
}

TEST(RollingFriction, SpinningPairIsBrakedByTheCoulombTorque) {
  // Equal spheres with opposite spins: I w' = -R mu_R N, R = r/2, as long as they roll. It begins
  // as a young contact, and lasts.
  const double coefficient = 0.05, spin = 20.0;
  Pressed<SpherePair> pair(rolling(coefficient), small, small, ContactMemory::seen_inside());
  pair.spin[0] = {0.0, spin, 0.0};
  pair.spin[1] = {0.0, -spin, 0.0};
  const double start = pair.energy_of_spin();
  const double rate = inverse_inertia(small) * 0.5 * thesis::radius * coefficient * pull;
  const int stops = static_cast<int>(spin / rate / dt);
  ASSERT_GT(stops, 200);
  pair.step();
  const double before_any = pair.energy;
  double before = 0.0;
  for (int n = 2; n < stops; n++) {
    before = pair.spin[0].y;
    pair.step();
    // The first step stretches the spring to mu_R N/K_r at R 2 w, and half of its impulse is of the
    // second.
    if (n > 2) {
      EXPECT_NEAR((before - pair.spin[0].y) / (rate * dt), 1.0, force_error);
    }
    EXPECT_NEAR(pair.spin[0].y, -pair.spin[1].y, 4 * eps * spin);
  }
  EXPECT_TRUE(pair.lasted);
  pair.steps(4000);
  // At rest, the energy lost but for what the spring swings with, which decays at alpha.
  const Swing swing(pair.answer());
  const double decay = std::exp(-swing.alpha * 4000 * dt);
  EXPECT_LT(decay, 1e-2);
  const double held = 0.5 * coefficient * pull * coefficient * pull / stiffness;
  EXPECT_LE(pair.energy_of_spin(), held * 2.0 * decay * decay);
  // The mean force of a step works on the mean of the true velocities at its ends, which is the
  // grid's up to (J_(n+1) - J_n)/(4 m_r): in all J^2/(8 m_r) of the impulse with which the contact
  // began to be one that lasts.
  const double impulse = coefficient * pull * dt;
  EXPECT_NEAR(pair.energy, before_any,
              64 * eps * (stops + 4000) * start + impulse * impulse * pair.answer() / 8.0);
  EXPECT_GT(pair.lost, 0.999 * start);
}

TEST(RollingFriction, HoldsBelowTheCoulombTorqueAndYieldsAboveIt) {
  // A steady torque on a sphere at a wall, in each step as another contact's: below R mu_R N it
  // comes to rest, above it the spin grows by what is left over.
  const double coefficient = 0.05, most = thesis::radius * coefficient * pull;
  for (const double part : {0.4, 1.2}) {
    Pressed<PlanePair> pair(rolling(coefficient), small, wall, old);
    const double others = inverse_inertia(small) * part * most * dt;
    double before = 0.0;
    for (int n = 0; n < 4000; n++) {
      before = pair.spin[0].z;
      pair.step();
      pair.spin[0].z += others;
    }
    ASSERT_TRUE(pair.lasted);
    if (part < 1.0) {
      // The swing about the stretch at rest has decayed.
      const Swing swing(pair.answer());
      const double decay = std::exp(-swing.alpha * 4000 * dt);
      ASSERT_LT(decay, 1e-5);
      EXPECT_LT(std::abs(pair.spin[0].z), 2.0 * decay * others / (swing.q * dt));
    } else {
      EXPECT_NEAR((pair.spin[0].z - before) / (others * (1.0 - 1.0 / part)), 1.0,
                  force_error / (part - 1.0));
    }
  }
}

TEST(RollingFriction, FollowedItHoldsAgainstWhatOthersDoInTheStep) {
  // The same torque on a contact that is followed: it stretches the spring until that bears it,
  // and no further.
  const double coefficient = 0.05, part = 0.4;
  const double others_spin =
      inverse_inertia(small) * part * thesis::radius * coefficient * pull * dt;
  const Pressed<PlanePair> pair(rolling(coefficient), small, wall, young);
  const PairMotion still = pair.grid();
  PairMotion others, grid = still;
  others.spin_i.z = others_spin;
  ContactMemory memory = young;
  const Swing swing(pair.answer());
  const int steps = 4000;
  for (int n = 0; n < steps; n++) {
    memory.age = 0.0;
    // The others', too, is half done at the grid point.
    PairMotion truth = grid;
    const Action owed = pair.contact.owed<size>(grid.relative, memory);
    truth.spin_i += inverse_inertia(small) * owed.torque_i;
    if (n > 0) truth.spin_i += 0.5 * others.spin_i;
    const FollowedStart begins = pair.contact.start<size>(grid, truth, memory);
    const auto predicted = pair.contact.follow<size>(begins, {}, {}, memory.in_range());
    const auto f = pair.contact.follow<size>(begins, others, predicted.rolled(), memory.in_range());
    const Action action = pair.contact.finish<size>(begins, others, f, memory);
    grid.spin_i += inverse_inertia(small) * action.torque_i;
    grid.spin_i += (n > 0 ? 1.0 : 0.5) * others.spin_i;
    EXPECT_EQ(f.rolling.friction, 0.0);
  }
  // The midpoint rule's modes decay slower, by (w dt)^2/4 < 0.1 of the exponent.
  ASSERT_LT(swing.q * dt, 0.6);
  const double decay = std::exp(-0.9 * swing.alpha * steps * dt);
  ASSERT_LT(decay, 1e-4);
  EXPECT_LT(std::abs(grid.spin_i.z), 2.0 * decay * others_spin / (swing.q * dt));
  const double bears = part * coefficient * pull / stiffness;
  EXPECT_NEAR(norm(memory.rolling.stretch) / bears, 1.0, 4.0 * decay + 64 * eps);
}

TEST(RollingFriction, ChangesSignWithTheExchangeOfTheParticles) {
  const contact::ContactParameters p = rolling(0.1);
  const contact::Adhesion a{pull, thesis::range, pull * thesis::range};
  const TwoPassContact<SpherePair> there(p, a, small, large, dt), back(p, a, large, small, dt);
  const PairMotion grid{
      {{1.29e-3, 3e-5, -2e-5}, {0.01, 0.02, -0.01}}, {3.0, -4.0, 5.0}, {1., 7., -2.}};
  const PairMotion reverse{
      {-grid.relative.separation, -grid.relative.velocity}, grid.spin_j, grid.spin_i};
  const PairMotion others{{}, {0.3, 0.1, 0.2}, {}}, of_reverse{{}, {}, others.spin_i};
  for (const ContactMemory& kind : {young, old})
    for (const double length : {0.0, 1e-9, 1e-5}) {
      ContactMemory one = kind, two = kind;
      one.rolling.stretch = {0.0, length, -length};
      two.rolling.stretch = -one.rolling.stretch;
      Action from_there, from_back;
      const auto act = [&](const TwoPassContact<SpherePair>& c, const PairMotion& at,
                           const PairMotion& beside, ContactMemory& memory, Action& action) {
        if (memory.phase == ContactMemory::lasting)
          return c.one_force().advance_lasting<size>(at, memory, action, nullptr);
        const FollowedStart begins = c.start<size>(at, at, memory);
        const auto predicted = c.follow<size>(begins, {}, {}, memory.in_range());
        const auto f = c.follow<size>(begins, beside, predicted.rolled(), memory.in_range());
        action = c.finish<size>(begins, beside, f, memory);
        return false;
      };
      const bool lasts = kind.phase == ContactMemory::lasting;
      ASSERT_EQ(act(there, grid, others, one, from_there), lasts);
      ASSERT_EQ(act(back, reverse, of_reverse, two, from_back), lasts);
      ASSERT_GT(norm(from_there.torque_i), 0.0);
      const double few = 64 * eps;
      EXPECT_LT(norm(from_there.torque_i - from_back.torque_j), few * norm(from_there.torque_i));
      EXPECT_LT(norm(from_there.torque_j - from_back.torque_i), few * norm(from_there.torque_j));
      EXPECT_LT(norm(one.rolling.stretch + two.rolling.stretch), few * norm(one.rolling.stretch));
      EXPECT_LT(norm(one.rolling.impulse + two.rolling.impulse), few * norm(one.rolling.impulse));
    }
}

TEST(RollingFriction, NothingHappensToAPairThatTurnsAsOneBodyOrSpins) {
  for (const ContactMemory& kind : {young, old}) {
    Pressed<SpherePair> pair(rolling(0.1), small, large, kind);
    pair.spin[0] = pair.spin[1] = {1.0, 2.0, 3.0};
    pair.step();
    EXPECT_EQ(norm(pair.memory.rolling.impulse), 0.0);
    // About the normal it spins, which is not resisted; but for the rounding of its part in the
    // plane.
    pair.spin[0] = {5.0, 2.0, 3.0};
    pair.step();
    EXPECT_LT(norm(pair.memory.rolling.impulse), 8 * eps * 5.0 * pair.radius() / pair.answer());

    Pressed<SpherePair> smooth(rolling(0.0), small, large, kind);
    smooth.spin[0] = {1.0, 2.0, 3.0};
    smooth.step();
    EXPECT_EQ(norm(smooth.memory.rolling.impulse), 0.0);
    EXPECT_EQ(smooth.spin[0].y, 2.0);
  }
}

TEST(RollingFriction, WhatTheSpringHeldIsLostWhereTheContactEnds) {
  Pressed<SpherePair> parting(rolling(0.1), small, large, young);
  parting.memory.rolling.stretch = {0.0, 1e-9, 0.0};
  parting.v[1].x = 0.1;
  parting.step();
  ASSERT_LT(parting.followed.normal.overlap_at_end, 0.0);
  ASSERT_GT(parting.followed.normal.normal.contact_time, 0.0);
  EXPECT_EQ(norm(parting.memory.rolling.stretch), 0.0);
  EXPECT_EQ(norm(parting.followed.rolling.displacement), 0.0);
  EXPECT_GT(parting.now.rolling, 0.0);
}

TEST(RollingFriction, AWallIsTheLimitOfALargeSphere) {
  Pressed<PlanePair> beside(rolling(0.02), small, wall, young);
  const Body huge{1e5 * thesis::radius, 1e-15 / thesis::mass};
  Pressed<SpherePair> sphere(rolling(0.02), small, huge, young);
  // Far enough from rest for all of it: swings, and slides in between.
  beside.spin[0] = sphere.spin[0] = {0.0, 3.0, -4.0};
  for (int n = 0; n < 200; n++) {
    beside.step();
    sphere.step();
    // 1/ratio from R. The place of the huge sphere, 50 m away, is rounded by 7e-15 m: a force of
    // m 7e-15 m/dt^2 = 1e-6 of the pull, some of them in a step.
    EXPECT_LT(norm(beside.spin[0] - sphere.spin[0]), 5.0 * (1e-5 + 1e-5));
  }
  EXPECT_TRUE(beside.lasted);
  EXPECT_TRUE(sphere.lasted);
  EXPECT_LT(norm(beside.spin[0]), 4.0);
}

TEST(RollingFriction, NoFollowedStepGivesEnergyAllTalliesCloseAndSlidingIsCapped) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int slid = 0, lasted = 0;
  for (int n = 0; n < 1000; n++) {
    contact::ContactParameters p = rolling(0.5 + 0.5 * uniform(random));
    p.tangential_ratio = std::exp(4.0 * uniform(random));
    p.tangential_damping_ratio = std::exp(4.0 * uniform(random));
    Pressed<SpherePair> pair(p, small, large, young);
    // One force is not taken of springs and dashpots that would not be steady by it.
    const ContactMemory aged{ContactMemory::inside, 1e6, 0.0, {}, {}};
    const bool lasts = n % 2 && pair.contact.can_last(pair.grid().relative, aged, false);
    if (lasts) pair.memory = old;
    pair.may_begin = lasts;
    lasted += lasts;
    const auto any = [&](double scale) {
      return scale * Vector3{uniform(random), uniform(random), uniform(random)};
    };
    pair.spin[0] = any(100.0), pair.spin[1] = any(100.0);
    const double start = pair.energy_of_spin();
    // In the first step of a lasting contact the spring has been stretched by the step before.
    if (lasts) {
      const Vector3 in_plane{0.0, pair.rolling_velocity().y, pair.rolling_velocity().z};
      pair.memory.rolling.stretch = -dt * in_plane;
    }
    double balance = 0.0;
    for (int k = 0; k < 20; k++) {
      const double held = pull * dt * p.rolling_friction;
      pair.step();
      ASSERT_EQ(pair.lasted, lasts);
      const Vector3& impulse = pair.memory.rolling.impulse;
      EXPECT_LE(norm(impulse), held * (1.0 + force_error));
      if (lasts) {
        // See SpinningPairIsBrakedByTheCoulombTorque.
        const double now = pair.energy - dot(impulse, impulse) * pair.answer() / 8.0;
        if (k > 0) {
          EXPECT_NEAR(now, balance, 64 * eps * k * start);
        }
        balance = now;
      } else {
        EXPECT_GE(pair.followed.rolling.friction, -64 * eps * start);
        EXPECT_GE(pair.followed.rolling.damped, 0.0);
        slid += pair.followed.rolling.friction > 64 * eps * start;
        EXPECT_NEAR(pair.energy, k > 0 ? balance : pair.energy, 64 * eps * (k + 1) * start);
        balance = pair.energy;
      }
    }
  }
  EXPECT_GT(lasted, 100);
  EXPECT_GT(slid, 500);
  EXPECT_LT(slid, 20 * (1000 - lasted));
}

}  // namespace cohesion::event_stepping
