// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "constants.h"
#include "event_stepping/pair_run.h"

namespace cohesion::event_stepping {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
double decades(std::mt19937& random, double low, double high) {
  return std::exp(uniform(random, std::log(low), std::log(high)));
}

}  // namespace

TEST(SpherePair, SurvivesExtremeParametersWithItsEnergyBalanced) {
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
