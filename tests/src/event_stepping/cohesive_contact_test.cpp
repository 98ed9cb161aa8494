// SPDX-License-Identifier: BSD-3-Clause
#include "event_stepping/cohesive_contact.h"

#include <gtest/gtest.h>

#include <random>

#include "event_stepping/pair_run.h"

namespace cohesion::event_stepping {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double pi = 3.14159265358979323846;

/// Two spheres with spin on a grid, as an engine moves them.
struct Spheres {
  Body body[2];
  Vector3 x[2], v[2], spin[2];
  Vector3 memory{};
  bool inside = false;
  double lost = 0.0, normal_impulse = 0.0, least_loss = 0.0;
  Vector3 tangential_impulse{};
  double stored = 0.0;

  void step(const CohesiveContact<SpherePair>& contact) {
    const RelativeState grid{x[1] - x[0], v[1] - v[0]};
    const PairStep normal = contact.advance(grid, inside);
    FrictionStep friction;
    if (normal.normal.contact_time > 0.0) {
      friction = contact.friction({grid, spin[0], spin[1]}, {}, normal, memory);
    }
    const Vector3 impulse =
        contact.reduced_mass() * normal.change.velocity + friction.spring.impulse;
    x[0] -= contact.share_i() * normal.change.separation;
    x[1] += contact.share_j() * normal.change.separation;
    v[0] -= body[0].inverse_mass * impulse;
    v[1] += body[1].inverse_mass * impulse;
    spin[0] += inverse_inertia(body[0]) * friction.torque_i;
    spin[1] += inverse_inertia(body[1]) * friction.torque_j;
    memory = friction.memory;
    inside = normal.inside;
    normal_impulse += normal.normal.repulsion_impulse;
    tangential_impulse += friction.spring.impulse;
    lost += normal.normal.dissipated + friction.spring.damped + friction.spring.friction;
    least_loss = std::min({least_loss, friction.spring.friction, friction.spring.damped});
    stored = contact.spring_energy(normal) + contact.adhesion_energy(normal) +
             contact.friction_energy(friction.spring.displacement);
  }
  void fly(double dt) {
    for (int k = 0; k < 2; k++) x[k] += dt * v[k];
  }

  Vector3 momentum() const {
    return (1.0 / body[0].inverse_mass) * v[0] + (1.0 / body[1].inverse_mass) * v[1];
  }
  Vector3 angular_momentum() const {
    Vector3 sum;
    for (int k = 0; k < 2; k++)
      sum += (1.0 / body[k].inverse_mass) * cross(x[k], v[k]) +
             (1.0 / inverse_inertia(body[k])) * spin[k];
    return sum;
  }
  double kinetic() const {
    double sum = 0.0;
    for (int k = 0; k < 2; k++)
      sum += 0.5 / body[k].inverse_mass * dot(v[k], v[k]) +
             0.5 / inverse_inertia(body[k]) * dot(spin[k], spin[k]);
    return sum;
  }
};

/// Thesis particles that meet at `speed` and `angle` to the normal, half a step of flight before.
Spheres oblique(double speed, double angle, double dt) {
  const Body particle{thesis::radius, 1.0 / thesis::mass};
  const Vector3 v{-speed * std::cos(angle), speed * std::sin(angle), 0.0};
  Spheres s{{particle, particle}, {}, {}, {}};
  s.x[1] = Vector3{2.0 * thesis::radius, 0.0, 0.0} - 0.5 * dt * v;
  s.v[1] = v;
  return s;
}

void follow(Spheres& s, const CohesiveContact<SpherePair>& contact, double dt, int steps) {
  for (int n = 0; n < steps; n++) {
    s.step(contact);
    s.fly(dt);
  }
}

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
double decades(std::mt19937& random, double low, double high) {
  return std::exp(uniform(random, std::log(low), std::log(high)));
}

}  // namespace

TEST(CohesiveContact, SharesKeepTheMomentum) {
  const Body light{0.5e-3, 1.0 / 1e-9}, heavy{50e-3, 1.0 / 1e-3};
  const CohesiveContact<SpherePair> c(thesis::contact(), thesis::adhesion(5e-19), light, heavy,
                                      {1e-6, 1e-6});
  EXPECT_NEAR(c.share_i() + c.share_j(), 1.0, 2 * eps);
  EXPECT_NEAR(c.share_i() / light.inverse_mass / (c.share_j() / heavy.inverse_mass), 1.0, 4 * eps);
  const CohesiveContact<PlanePair> wall(thesis::contact(), {}, light, {0.0, 0.0}, {1e-6, 1e-6});
  EXPECT_NEAR(wall.share_i(), 1.0, 2 * eps);
  EXPECT_EQ(wall.share_j(), 0.0);
}

TEST(CohesiveContact, FrictionKeepsMomentumAndAngularMomentum) {
  std::mt19937 random(7);
  for (int n = 0; n < 50; n++) {
    contact::ContactParameters p = thesis::contact();
    p.friction = uniform(random, 0.05, 1.0);
    const double dt = thesis::contact_time / uniform(random, 2.0, 30.0);
    const Body i{0.5e-3, 1.0 / thesis::mass}, j{0.8e-3, 1.0 / (4.1 * thesis::mass)};
    const CohesiveContact<SpherePair> contact(p, thesis::adhesion(2e-18), i, j,
                                              {0.5 * dt, 0.5 * dt});
    Spheres s{{i, j}, {}, {}, {}};
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
    follow(s, contact, dt, steps);
    // A few roundings of the largest momentum, also at the distance that flight leads to, per step.
    EXPECT_LT(norm(s.momentum() - momentum), 16 * eps * steps * 5.0 * speed);
    EXPECT_LT(norm(s.angular_momentum() - turning),
              16 * eps * steps * 5.0 * speed * (arm + 0.5 * steps * dt));
  }
}

TEST(CohesiveContact, AloneItDoesWhatStepAndFrictionDo) {
  contact::ContactParameters p = thesis::contact();
  p.friction = 0.3;
  const Body i{0.5e-3, 1.0 / thesis::mass}, j{0.8e-3, 1.0 / (4.1 * thesis::mass)};
  const double dt = thesis::contact_time / 20;
  const CohesiveContact<SpherePair> contact(p, thesis::adhesion(5e-19), i, j, {0.5 * dt, 0.5 * dt});
  const PairMotion grid{
      {{1.3e-3 - 2e-6, 0.0, 0.0}, {-0.02, 0.01, 0.005}}, {3.0, -4.0, 5.0}, {1.0, 7.0, -2.0}};
  const Vector3 memory{0.0, 2e-7, -1e-7};
  const PairStep normal = contact.advance(grid.relative, true);
  const FrictionStep sliding = contact.friction(grid, {}, normal, memory);
  const PairMotion change = contact.alone<true>(grid, normal, memory);
  const Vector3 velocity =
      normal.change.velocity + (1.0 / contact.reduced_mass()) * sliding.spring.impulse;
  // One rounding of 1/mass and one of the sum.
  EXPECT_LE(norm(change.relative.velocity - velocity), 4 * eps * norm(velocity));
  EXPECT_EQ(norm(change.relative.separation - normal.change.separation), 0.0);
  EXPECT_EQ(norm(change.spin_i - inverse_inertia(i) * sliding.torque_i), 0.0);
  EXPECT_EQ(norm(change.spin_j - inverse_inertia(j) * sliding.torque_j), 0.0);
  EXPECT_GT(norm(change.spin_i), 0.0);
  const PairMotion frictionless = contact.alone<false>(grid, normal, memory);
  EXPECT_EQ(norm(frictionless.relative.velocity - normal.change.velocity), 0.0);
  EXPECT_EQ(norm(frictionless.spin_i), 0.0);
}

TEST(BesideWall, OnlyWhatMovesTheCentreAwayFromTheWallIsSeen) {
  const Vector3 normal{0.6, -0.48, 0.64}, along{0.8, 0.36, -0.48}, aside{0.0, 0.8, 0.6};
  const PairMotion others{{0.02 * normal + 0.3 * along - 0.4 * aside, {1.0, -2.0, 3.0}},
                          {4.0, 5.0, -6.0},
                          {-7.0, 8.0, 9.0}};
  // Whatever the distance is, and on whichever side the wall.
  for (double distance : {1.3, -1e-3}) {
    const PairMotion seen = beside_wall(others, distance * normal);
    // Products of three rounded components; the scale is that of what is taken away.
    EXPECT_NEAR(norm(seen.relative.separation - 0.02 * normal), 0.0, 10 * eps * 0.5);
    // Velocities and spins stay: friction acts on them.
    EXPECT_EQ(norm(seen.relative.velocity - others.relative.velocity), 0.0);
    EXPECT_EQ(norm(seen.spin_i - others.spin_i), 0.0);
    EXPECT_EQ(norm(seen.spin_j - others.spin_j), 0.0);
  }
}

TEST(CohesiveContact, FrictionBalancesTheEnergy) {
  // Kinetic energy plus all losses. Not exact: normal motion and friction of a step are added
  // rather than composed, of first order in the step: the pair turns by u_t t_c/R = 0.013 in
  // contact, the step's part dt/t_c of that, times the tangential share of the energy, sin^2 <
  // 0.52. And friction changes the angular momentum at an overlap x, where the centrifugal energy
  // is followed to first order in x/R only: 1.5 (x/R)^2 of the tangential energy, for any step.
  // Measured, at most: 2.3e-5 of the energy at t_c/10, 6.7e-6 at t_c/100.
  for (const double friction : {0.05, 0.3, 5.0}) {
    contact::ContactParameters p = thesis::contact();
    p.friction = friction;
    double errors[2];
    int k = 0;
    for (const double part : {10.0, 100.0}) {
      const double dt = thesis::contact_time / part;
      const Body particle{thesis::radius, 1.0 / thesis::mass};
      const CohesiveContact<SpherePair> contact(p, {}, particle, particle, {0.5 * dt, 0.5 * dt});
      Spheres s = oblique(0.2, 0.8, dt);
      const double before = s.kinetic();
      follow(s, contact, dt, static_cast<int>(2.0 * part));
      EXPECT_FALSE(s.inside);
      EXPECT_GT(s.lost, 0.0);
      EXPECT_GE(s.least_loss, -1e-15 * before) << friction;
      errors[k++] = std::abs(s.kinetic() + s.lost - before) / before;
    }
    const double overlap = 0.2 * std::cos(0.8) / 33957.0 / (2.0 * thesis::radius);
    const double centrifugal = 1.5 * overlap * overlap * 0.52;
    EXPECT_LT(errors[0], 0.013 * 0.52 / 10.0 + centrifugal);
    EXPECT_LT(errors[1], 0.013 * 0.52 / 100.0 + centrifugal);
  }
}

TEST(CohesiveContact, SlidingImpactsObeyTheHardSphereLaw) {
  // Walton: tangential impulse mu_f times the normal one, which is mu (1 + e) v_n.
  const double angle = 80.0 * pi / 180.0, speed = 0.01, friction = 0.1;
  for (const double part : {4.0, 50.0}) {
    contact::ContactParameters p = thesis::contact();
    p.friction = friction;
    const double dt = thesis::contact_time / part;
    const Body particle{thesis::radius, 1.0 / thesis::mass};
    const CohesiveContact<SpherePair> contact(p, {}, particle, particle, {0.5 * dt, 0.5 * dt});
    Spheres s = oblique(speed, angle, dt);
    follow(s, contact, dt, static_cast<int>(2.0 * part));
    ASSERT_FALSE(s.inside);
    const double normal = thesis::reduced_mass * (1.0 + contact.normal_contact().restitution()) *
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

TEST(CohesiveContact, StickingImpactsReverseTheSurfaceVelocity) {
  // K_t/K = 2/7, no damping, no slip: the tangential spring swings half a period in contact,
  // Walton's tangential restitution is 1: J_t = -2 m_t u_t with m_t = 2 mu/7.
  const double angle = 0.4, speed = 0.01, dt = thesis::contact_time / 500.0;
  contact::ContactParameters p = thesis::elastic();
  p.friction = 1e3;
  const Body particle{thesis::radius, 1.0 / thesis::mass};
  const CohesiveContact<SpherePair> contact(p, {}, particle, particle, {0.5 * dt, 0.5 * dt});
  Spheres s = oblique(speed, angle, dt);
  const double before = s.kinetic();
  follow(s, contact, dt, 1000);
  ASSERT_FALSE(s.inside);
  const double expected = 2.0 * (2.0 / 7.0) * thesis::reduced_mass * speed * std::sin(angle);
  // The contact turns by u_t t_c/R = 4e-4; the midpoint rule's phase error, pi (w dt)^2/12 = 1e-5,
  // enters squared.
  const double turned = speed * thesis::contact_time / (2.0 * thesis::radius);
  EXPECT_NEAR(norm(s.tangential_impulse) / expected, 1.0, 3.0 * turned);
  EXPECT_NEAR(s.kinetic() / before, 1.0, 3.0 * turned);
}

TEST(CohesiveContact, SurvivesExtremeParametersWithItsEnergyBalanced) {
  std::mt19937 random(20240607);
  int unresolved = 0, deep = 0, left = 0, touched = 0;
  for (int n = 0; n < 2000; n++) {
    contact::ContactParameters p;
    p.stiffness = decades(random, 10.0, 1e7);
    const int kind = static_cast<int>(random() % 5);
    p.restitution = kind == 0 ? 0.0 : kind == 1 ? 1.0 : uniform(random, 0.0, 1.0);
    const double r_i = decades(random, 1e-5, 1e-2), r_j = r_i * decades(random, 1.0, 100.0);
    const double m_i = 2500.0 * sphere_volume(r_i), m_j = m_i * decades(random, 1.0, 1e6);
    const double range = decades(random, 1e-10, 1e-7);
    const double hamaker = random() % 4 == 0 ? 0.0 : decades(random, 1e-21, 1e-16);
    const double force = hamaker * r_i * r_j / (r_i + r_j) / (6.0 * range * range);
    const contact::Adhesion a =
        force > 0.0 ? contact::Adhesion{force, range, force * range} : contact::Adhesion{};
    const double R = r_i + r_j;
    const double mu = reduced_mass(m_i, m_j);
    const auto law = contact::normal_contact(p, mu);
    const double w0 = std::sqrt(p.stiffness / mu);
    const double longest = p.restitution > 0.1 ? 0.5 * law.contact_time() : 0.5 * pi / w0;
    const double dt = longest * (random() % 3 == 0 ? 1.0 : decades(random, 1e-3, 1.0));
    const double speed = decades(random, 1e-9, 100.0);
    const double angle = random() % 4 == 0 ? 0.0 : uniform(random, 0.0, 0.5 * pi);
    const bool overlapped = random() % 3 == 0;
    const double x = overlapped ? uniform(random, 0.0, 0.1) * r_i : -a.cutoff;
    const Vector3 v{-speed * std::cos(angle), speed * std::sin(angle), 0.0};
    PairRun<SpherePair> run(
        p, a, {r_i, 1.0 / m_i}, {r_j, 1.0 / m_j}, dt,
        {Vector3{R - x, 0.0, 0.0} - (overlapped ? 0.0 : uniform(random, 0.0, 3.0) * dt) * v, v});
    run.set_inside(overlapped, x);

    // What the motion keeps: energy with the centrifugal part as the scheme follows it, linear in
    // the overlap.
    const double momentum = norm(run.angular_momentum());
    const auto balance = [&] {
      double residue = 0.0;
      if (run.last().inside) {
        const double o = run.last().overlap_at_end / R;
        residue = 0.5 * mu * momentum * momentum / (R * R) * o * o * (3.0 - 2.0 * o) /
                  ((1.0 - o) * (1.0 - o));
      }
      return run.energy() - residue;
    };
    const double start = balance();
    double largest = std::abs(run.kinetic()) + std::abs(run.stored());
    double deepest = std::max(x, 0.0), tolerance = 0.0;
    const int steps = 80;
    for (int k = 0; k < steps; k++) {
      const double from = run.distance();
      run.step();
      ASSERT_TRUE(std::isfinite(run.energy()) && std::isfinite(run.distance())) << n;
      deepest = std::max(deepest, run.last().overlap_at_end);
      largest = std::max(largest, run.kinetic() + std::abs(run.stored()));
      // Rounding of distance and half-step flight, at adhesion plus the spring's force if it holds
      // all of the energy, and of the energies.
      const double way = std::max(from, run.distance()) + dt * norm(run.state().velocity);
      tolerance +=
          4.0 * eps * (way * (a.force + std::sqrt(2.0 * p.stiffness * largest)) + 4.0 * largest);
    }
    unresolved += run.unresolved() > 0;
    touched += deepest > 0.0;
    left += !run.last().inside;
    // The largest overlap lies between grid points: below v/w0 deeper.
    if (deepest + speed / w0 > 0.3 * R) {  // no contact of two spheres any more
      deep++;
      continue;
    }
    // The centrifugal energy at the edge, where straight flight takes over.
    tolerance += 4.0 * mu * speed * speed * a.cutoff * a.cutoff / (R * R);
    const double error = std::abs(balance() - start);
    EXPECT_LE(error, tolerance) << n << " K " << p.stiffness << " e " << p.restitution << " r "
                                << r_i << " " << r_j << " range " << a.cutoff << " A " << hamaker
                                << " dt w0 " << dt * w0 << " speed " << speed << " angle " << angle
                                << " overlapped " << overlapped << " largest " << largest
                                << " unresolved " << run.unresolved();
  }
  EXPECT_EQ(unresolved, 0);
  // The sweep is about something.
  EXPECT_GT(touched, 1500);
  EXPECT_GT(left, 500);
  EXPECT_LT(left, 1900);
  EXPECT_LT(deep, 500);
}

}  // namespace cohesion::event_stepping
