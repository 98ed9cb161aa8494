// SPDX-License-Identifier: BSD-3-Clause
#include "event_stepping/many_spheres.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "constants.h"

namespace cohesion::event_stepping {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double core = 2.0 * thesis::radius;
const double w0 = std::sqrt(800.0 / thesis::reduced_mass);
const double contact_time = pi / w0;  // of the elastic contact

/// Places of a face-centred cubic lattice of cells^3 cubes, of four places each.
std::vector<Vector3> lattice(int cells, double edge) {
  std::vector<Vector3> places;
  for (int x = 0; x < 2 * cells; x++)
    for (int y = 0; y < 2 * cells; y++)
      for (int z = 0; z < 2 * cells; z++)
        if ((x + y + z) % 2 == 0)
          places.push_back((0.5 * edge) * Vector3{1.0 * x, 1.0 * y, 1.0 * z});
  return places;
}

/// Normally distributed numbers times `size`, of sum zero.
std::vector<Vector3> spread(int number, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, size);
  std::vector<Vector3> a(number);
  Vector3 mean{};
  for (Vector3& one : a) {
    one = {normal(random), normal(random), normal(random)};
    mean += (1.0 / number) * one;
  }
  for (Vector3& one : a) one -= mean;
  return a;
}

struct Gas {
  double energy, momentum;
};
/// An elastic gas at volume fraction 0.5: change of energy over it, and momentum over the sum of
/// |m v|, after `collisions` per sphere.
Gas gas(double hamaker, double part, double collisions) {
  const int cells = 4, number = 4 * cells * cells * cells;
  const double side = std::cbrt(number * sphere_volume(thesis::radius) / 0.5), speed = 0.1;
  const contact::Adhesion a = hamaker > 0.0 ? thesis::adhesion(hamaker) : contact::Adhesion{};
  ManySpheres spheres(thesis::elastic(), a, contact_time / part, side);
  const auto places = lattice(cells, side / cells);
  const auto v = spread(number, speed, 1);
  for (int i = 0; i < number; i++) spheres.add(places[i], v[i]);
  spheres.step();
  const auto start = spheres.sums();
  while (2.0 * static_cast<double>(spheres.collisions) < collisions * number) spheres.step();
  const auto end = spheres.sums();
  // Some contacts are of one force, most are followed.
  EXPECT_GT(spheres.followed, spheres.lasting);
  return {end.energy / start.energy - 1.0,
          norm(end.momentum - start.momentum) / (number * thesis::mass * speed)};
}

/// 32 of them, that touch, about the origin.
std::vector<Vector3> block() {
  const double edge = std::sqrt(2.0) * core;
  std::vector<Vector3> places = lattice(2, edge);
  for (Vector3& x : places) x -= (0.75 * edge) * Vector3{1.0, 1.0, 1.0};
  return places;
}
ManySpheres cluster(const contact::ContactParameters& p, double part) {
  return {p, thesis::adhesion(2e-18), contact_time / part, 0.0};
}

/// The block, overlapping a little, moves towards its centre: no momentum, and no angular momentum.
void press_together(ManySpheres& spheres) {
  const auto places = block();
  const auto off = spread(static_cast<int>(places.size()), 1e-7, 3);
  for (std::size_t i = 0; i < places.size(); i++) {
    const Vector3 x = (1.0 - 5e-4) * places[i] + off[i];
    spheres.add(x, -1.0 * x);
  }
  spheres.step();
}

}  // namespace

TEST(ManySpheres, AnElasticGasKeepsItsEnergy) {
  // The published bounds are for twice the collisions. Only contacts of one particle at the same
  // time err, half of what the others do before and half after, at random.
  for (const double hamaker : {0.0, 2e-18}) {
    const Gas fine = gas(hamaker, 10.0, 40.0);
    EXPECT_LT(std::abs(fine.energy), 2e-4) << hamaker;
    const Gas coarse = gas(hamaker, 4.0, 40.0);
    EXPECT_LT(std::abs(coarse.energy), 1e-2) << hamaker;
    // Some thousand steps at t_c/10, in each a rounding of every velocity, at random, and of as
    // many spheres.
    EXPECT_LT(fine.momentum, 100 * eps);
    EXPECT_LT(coarse.momentum, 100 * eps);
  }
}

TEST(ManySpheres, AFreeClusterKeepsItsAngularMomentum) {
  enum Kind { elastic, rough, rough_and_damped };  // which minds no others
  for (const Kind kind : {elastic, rough, rough_and_damped})
    for (const bool apart : {false, true})
      for (const double part : {10.0, 7.0, 4.0}) {
        contact::ContactParameters p =
            kind == rough_and_damped ? thesis::contact() : thesis::elastic();
        if (kind != elastic) {
          p.friction = 0.3;
          p.rolling_friction = 0.05;
        }
        ManySpheres spheres = cluster(p, part);
        const auto places = block();
        const int number = static_cast<int>(places.size());
        const auto v = spread(number, 3e-3, 2);
        double scale = 0.0;
        for (int i = 0; i < number; i++) {
          // Bound from the start, or on its way together; and turning.
          const Vector3 x = (1.0 + (apart ? 2e-3 : -5e-4)) * places[i];
          const Vector3 u = v[i] + cross({0.0, 2.0, 5.0}, x) - (apart ? 20.0 : 0.0) * x;
          spheres.add(x, u);
          scale += thesis::mass * norm(x) * norm(u);
        }
        spheres.step();
        const auto start = spheres.sums();
        ASSERT_GT(norm(start.angular_momentum), 0.1 * scale);
        const int steps = static_cast<int>(100.0 * part);
        for (int n = 0; n < steps; n++) spheres.step();
        const auto end = spheres.sums();
        if (!apart) {
          EXPECT_GT(2 * spheres.contacts(), 6 * number);
        }
        if (kind != elastic && part == 4.0) {
          EXPECT_EQ(spheres.lasting, 0);  // would not be steady
        } else {
          EXPECT_GT(spheres.lasting, 10 * number);
        }
        EXPECT_GT(spheres.followed, (kind == rough_and_damped ? 1 : 10) * number);
        // Each step rounds positions, and velocities by some contacts each, at random.
        EXPECT_LT(norm(end.angular_momentum - start.angular_momentum) / scale,
                  4.0 * std::sqrt(steps) * eps);
        EXPECT_LT(norm(end.momentum - start.momentum) / (number * thesis::mass * 3e-3),
                  4.0 * std::sqrt(steps) * eps);
      }
}

TEST(ManySpheres, ADampedClusterUnderAdhesionComesToRest) {
  for (const double part : {10.0, 7.0, 4.0}) {
    contact::ContactParameters p;
    p.stiffness = 800.0;
    p.restitution = 0.8;
    ManySpheres spheres = cluster(p, part);
    press_together(spheres);
    const int number = spheres.size();
    const double start = spheres.sums().kinetic;
    const auto most = [&] {
      double kinetic = 0.0;
      for (int n = 0; n < static_cast<int>(400.0 * part); n++) {
        spheres.step();
        if (n % 10 == 0) kinetic = std::max(kinetic, spheres.sums().kinetic);
      }
      return kinetic;
    };
    double last = most();
    const long contacts = spheres.contacts(), followed = spheres.followed;
    EXPECT_GT(2 * contacts, 6 * number);
    for (int k = 0; k < 4; k++) {
      const double now = most();
      EXPECT_LT(now, 0.1 * last) << part;
      last = now;
    }
    EXPECT_LT(last, 1e-10 * start);
    // Nothing jumps: what holds goes on to hold.
    EXPECT_EQ(spheres.contacts(), contacts);
    EXPECT_EQ(spheres.followed, followed);
  }
}

TEST(ManySpheres, AStronglyDampedClusterComesToRest) {
  // The dashpots of up to twelve contacts act on one sphere at the same time.
  for (const double restitution : {0.5, 0.3, 0.1})
    for (const double part : {10.0, 7.0, 4.0}) {
      contact::ContactParameters p;
      p.stiffness = 800.0;
      p.restitution = restitution;
      ManySpheres spheres = cluster(p, part);
      press_together(spheres);
      const double start = spheres.sums().kinetic;
      for (int n = 0; n < static_cast<int>(500.0 * part); n++) spheres.step();
      EXPECT_LT(spheres.sums().kinetic, 1e-8 * start) << restitution << " t_c/" << part;
    }
}

TEST(ManySpheres, AFrictionalClusterAtRestMovesNoMore) {
  // Springs in the plane of contact go on to hold; nothing moves on the grid. The true motion at
  // grid points is known as of contacts that swing freely: under a load from outside, here of
  // friction, the normal springs owe (w dt)/sin(w dt) of half an impulse, friction half. What is
  // left is below that part of the impulse of friction in twelve contacts that bear 2 F_ad.
  for (const double part : {10.0, 7.0, 4.0}) {
    contact::ContactParameters p;
    p.stiffness = 800.0;
    p.restitution = 0.8;
    p.friction = 0.3;
    ManySpheres spheres = cluster(p, part);
    press_together(spheres);
    const int number = spheres.size();
    const double start = spheres.sums().kinetic;
    for (int n = 0; n < static_cast<int>(1000.0 * part); n++) spheres.step();
    double grid = 0.0;
    for (int i = 0; i < number; i++) grid += 0.5 * thesis::mass * dot(spheres.v(i), spheres.v(i));
    EXPECT_LT(grid, 1e-10 * start) << part;
    const double phase = pi / part, dt = contact_time / part;
    const double left = (phase / std::sin(phase) - 1.0) * 0.5 * dt / thesis::mass * 12.0 * 0.3 *
                        2.0 * thesis::adhesion(2e-18).force;
    EXPECT_LT(spheres.sums().kinetic, 0.5 * number * thesis::mass * left * left) << part;
  }
}

/// Spheres that all spin alike across a close packing: what swings fastest in the plane of contact;
/// every surface slides against those of all neighbours, and none slips. `fastest`: (w dt)^2 of it
/// over that of a pair. By one force it would grow where that is above 4.
///
/// The dashpots leave exp(-2 a t) of the kinetic energy of the start: nothing. Followed, the true
/// motion never has more than at the start. By leapfrog velocities at half steps have up to
/// 1/(1 - (w dt)^2/4) of it, and true ones, which friction's last impulse is taken for, by
/// v + (v - v_before)/2, up to 1 + 3/4 (w dt)^2 times that.
void expect_steady_spin(ManySpheres& spheres, const contact::ContactParameters& p, double part,
                        double fastest, bool one_force) {
  const double start = spheres.sums().kinetic;
  double most = 0.0;
  for (int n = 0; n < static_cast<int>(100.0 * part); n++) {
    spheres.step();
    most = std::max(most, spheres.sums().kinetic);
  }
  const Body body = ManySpheres::body();
  const SpringOnGrid spring(
      contact::tangential_contact(p, contact::normal_contact(p, thesis::reduced_mass)),
      contact_time / part, ContactBodies(body, body).inverse_sliding_mass());
  const double square = fastest * spring.frequency_squared();
  EXPECT_EQ(spheres.lasting > 0, one_force);
  EXPECT_LT(most, start * (one_force ? (1.0 + 0.75 * square) / (1.0 - 0.25 * square) : 1.0));
  EXPECT_LT(spheres.sums().kinetic, start * (one_force ? eps : 1.0));
}

struct Spinning {
  double ratio, part;
  bool one_force;
};
contact::ContactParameters without_slip(const Spinning& c) {
  contact::ContactParameters p = thesis::contact();
  p.friction = 1e3;
  p.tangential_ratio = c.ratio;
  return p;
}

TEST(ManySpheres, SpheresThatSpinAlikeInAClosePackingStaySteady) {
  // Twelve neighbours: by one force it grows from t_c/3.6 on with K_t = 2/7 K, from t_c/6.8 on with
  // K_t = K.
  const double edge = std::sqrt(2.0) * core * (1.0 - 1e-3);
  for (const Spinning& c :
       {Spinning{2.0 / 7.0, 4.0, true}, Spinning{2.0 / 7.0, 5.0, true},
        Spinning{2.0 / 7.0, 8.0, true}, Spinning{1.0, 6.0, false}, Spinning{1.0, 7.0, false},
        Spinning{1.0, 7.5, true}, Spinning{1.0, 10.0, true}}) {
    SCOPED_TRACE(c.ratio);
    SCOPED_TRACE(c.part);
    const contact::ContactParameters p = without_slip(c);
    ManySpheres spheres(p, {}, contact_time / c.part, 3.0 * edge);
    for (const Vector3& x : lattice(3, edge)) spheres.add(x, {}, {0.0, 0.0, 0.1});
    expect_steady_spin(spheres, p, c.part, 40.0 / 7.0, c.one_force);
  }
}

TEST(ManySpheres, SpheresThatSpinAlikeInAPlaneStaySteady) {
  // Six neighbours: from t_c/3.1 on with K_t = 2/7 K, from t_c/5.8 on with K_t = K.
  const double a = core * (1.0 - 1e-3), b = std::sqrt(3.0) * a;
  for (const Spinning& c :
       {Spinning{2.0 / 7.0, 4.0, true}, Spinning{2.0 / 7.0, 5.0, true}, Spinning{1.0, 5.5, false},
        Spinning{1.0, 6.5, true}, Spinning{1.0, 7.0, true}, Spinning{1.0, 10.0, true}}) {
    SCOPED_TRACE(c.ratio);
    SCOPED_TRACE(c.part);
    const contact::ContactParameters p = without_slip(c);
    ManySpheres spheres(p, {}, contact_time / c.part, {6.0 * a, 4.0 * b, 0.0},
                        ClosestPacking::in_plane());
    for (int x = 0; x < 6; x++)
      for (int y = 0; y < 4; y++)
        for (const double half : {0.0, 0.5})
          spheres.add({(x + half) * a, (y + half) * b, 0.0}, {}, {0.0, 0.0, 0.1});
    expect_steady_spin(spheres, p, c.part, 30.0 / 7.0, c.one_force);
  }
}

TEST(ManySpheres, ARowOfThreeErrsBySecondOrderInTheStep) {
  // The middle one of three is in two contacts at once: one sphere meets two that touch. The same
  // two springs by leapfrog at t_c/20000, which errs by (w0 dt)^2/24 = 1e-9.
  const double speed = 0.1, k = 800.0 / thesis::mass;
  const std::array<double, 3> expected = [&] {
    std::array<double, 3> x{-core, 0.0, core}, v{speed, 0.0, 0.0};
    const double dt = contact_time / 20000.0;
    for (int n = 0; n < 100000; n++) {
      for (int i = 0; i < 3; i++) x[i] += 0.5 * dt * v[i];
      const double left = k * std::max(core - (x[1] - x[0]), 0.0);
      const double right = k * std::max(core - (x[2] - x[1]), 0.0);
      v[0] -= dt * left;
      v[1] += dt * (left - right);
      v[2] += dt * right;
      for (int i = 0; i < 3; i++) x[i] += 0.5 * dt * v[i];
    }
    return v;
  }();
  ASSERT_LT(expected[0], 0.0);
  ASSERT_GT(expected[1], 0.02 * speed);
  ASSERT_GT(expected[2], 0.9 * speed);
  // The others' part of a step is half done before the contact's own and half after: its error is
  // (w0 dt)^2/12 or less of what the others do in each unit of time 1/w0, and an impact takes pi.
  const auto error = [&](double part) {
    double worst = 0.0;
    for (int phase = 0; phase < 8; phase++) {
      const double dt = contact_time / part;
      ManySpheres spheres(thesis::elastic(), {}, dt, 0.0);
      spheres.add({-core - (phase + 0.37) / 8.0 * dt * speed, 0.0, 0.0}, {speed, 0.0, 0.0});
      spheres.add({0.0, 0.0, 0.0}, {});
      spheres.add({core, 0.0, 0.0}, {});
      for (int n = 0; n < static_cast<int>(5.0 * part); n++) spheres.step();
      EXPECT_EQ(spheres.contacts(), 0);
      for (int i = 0; i < 3; i++) worst = std::max(worst, std::abs(spheres.v(i).x - expected[i]));
    }
    return worst / speed;
  };
  const double coarse = error(10.0), fine = error(20.0), finest = error(40.0);
  EXPECT_LT(coarse, pi * std::pow(pi / 10.0, 2) / 12.0);
  EXPECT_GT(coarse / fine, 3.0);
  EXPECT_GT(fine / finest, 3.0);
}

}  // namespace cohesion::event_stepping
