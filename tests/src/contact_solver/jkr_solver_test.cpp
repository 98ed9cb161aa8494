// SPDX-License-Identifier: BSD-3-Clause
#include "contact_solver/jkr_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "constants.h"
#include "contact_solver/spheres.h"
#include "sphere.h"

namespace cohesion::contact_solver {
namespace {

/// Two spheres of glass that adhere: diameter [length], E* [force/length^2], w [energy/length^2].
struct Pair {
  double diameter, modulus, work, restitution;

  double mass() const { return 0.5 * 2650.0 * sphere_volume(0.5 * diameter); }
  double radius() const { return 0.25 * diameter; }
  contact::JkrSpringDashpot law() const {
    const auto hertz =
        contact::HertzSpringDashpot::from_restitution(modulus, radius(), restitution, mass());
    return {hertz, radius(), work};
  }
};

/// Radius of contact by bisection of the formula alone, and what follows from it.
struct Reference {
  const Pair& p;
  double k = 4.0 * p.modulus / (3.0 * p.radius());
  double smallest = std::cbrt(pi * p.work * p.radius() * p.radius() / (8.0 * p.modulus));
  double lowest = overlap(smallest);
  double damping() const {
    const double lost = -std::log(p.restitution);
    return std::sqrt(5.0 * p.mass() * k * p.radius()) * lost / std::hypot(pi, lost);
  }
  double overlap(double a) const {
    return a * a / p.radius() - std::sqrt(2.0 * pi * p.work * a / p.modulus);
  }
  double at(double x) const {
    double low = smallest, high = 2.0 * smallest;
    while (overlap(high) < x) high *= 2.0;
    for (int i = 0; i < 60; i++) {
      const double middle = 0.5 * (low + high);
      (overlap(middle) < x ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }
  double force(double a) const {
    return k * a * a * a - std::sqrt(8.0 * pi * p.work * p.modulus) * std::pow(a, 1.5);
  }
  /// The speed at which two part that touch at `speed`; 0: they do not. In the radius of contact,
  /// of which everything is a smooth function: x' = v, a' = v/(dx/da).
  double rebound(double speed, double per_contact) const {
    const double c = damping(), mu = p.mass();
    const double time =
        2.94 * std::pow(1.25 * mu / (k * std::pow(p.radius(), 1.5)), 0.4) * std::pow(speed, -0.2);
    double x = 0.0, v = speed;
    const auto pull = [&](double place, double rate) {
      const double a = at(std::max(place, lowest));
      return -(force(a) + c * std::sqrt(a) * rate) / mu;
    };
    for (double t = 0.0; t < 30.0 * time;) {
      const double h = std::max(1e-3, std::min(1.0, 50.0 * (x - lowest) / std::abs(v * time))) *
                       time / per_contact;
      const double v1 = pull(x, v), x2 = v + 0.5 * h * v1, v2 = pull(x + 0.5 * h * v, x2);
      const double x3 = v + 0.5 * h * v2, v3 = pull(x + 0.5 * h * x2, x3);
      const double x4 = v + h * v3, v4 = pull(x + h * x3, x4);
      const double next = x + h / 6.0 * (v + 2.0 * x2 + 2.0 * x3 + x4);
      const double rate = v + h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
      if (next <= lowest) return -rate;
      if (v < 0.0 && rate >= 0.0) return 0.0;
      x = next;
      v = rate;
      t += h;
    }
    return 0.0;
  }
};

/// The speed at which a head-on pair on an engine's grid parts; 0: it sticks.
double rebound(const JkrSolver& solver, const Pair& p, double speed, double phase, double time) {
  double distance = p.diameter + speed * solver.step() * (1.0 + phase), rate = -speed;
  ContactState state;
  bool was = false;
  for (int n = 0; n < time / solver.step(); n++) {
    rate += solver.step() * solver.advance({distance, rate, 0.0}, 0.0, solver.step(), state).force /
            p.mass();
    distance += solver.step() * rate;
    was = was || state.in_range();
    if (was && state.phase == ContactState::outside) return rate;
  }
  return 0.0;
}

}  // namespace

TEST(JkrSolver, SticksBelowTheSpeedOfTheConvergedIntegration) {
  // Of other sizes, moduli and works of adhesion the motion is the same in units of its own.
  for (const double restitution : {0.5, 0.7, 0.9, 0.99}) {
    const Pair p{1e-4, 5e8, 0.05, restitution};
    const Reference reference{p};
    double low = 1e-3, high = 1.0;
    while (high - low > 1e-6 * high) {
      const double middle = 0.5 * (low + high);
      (reference.rebound(middle, 2000.0) > 0.0 ? high : low) = middle;
    }
    const double time =
        contact::HertzSpringDashpot::from_restitution(p.modulus, p.radius(), 1.0, p.mass())
            .contact_time(high);
    const auto parts = [&](double part, double factor, int phase) {
      const JkrSolver solver(p.law(), {}, p.diameter, time / part);
      return rebound(solver, p, factor * high, (phase + 0.37) / 8.0, 30.0 * time) > 0.0;
    };
    for (int phase = 0; phase < 8; phase++) {
      EXPECT_FALSE(parts(20.0, 0.999, phase)) << restitution << " " << phase;
      EXPECT_TRUE(parts(20.0, 1.001, phase)) << restitution << " " << phase;
      if (restitution < 0.7) continue;
      EXPECT_FALSE(parts(10.0, 0.998, phase)) << restitution << " " << phase;
      EXPECT_TRUE(parts(10.0, 1.002, phase)) << restitution << " " << phase;
    }
  }
}

TEST(JkrSolver, ElasticSpheresLoseTheWorkOfThorntonAndNing) {
  const Pair p{1e-4, 5e8, 0.05, 1.0};
  const double lost =
      7.0922 * std::cbrt(std::pow(p.work, 5.0) * std::pow(p.radius(), 4.0) / p.modulus / p.modulus);
  const double sticking = std::sqrt(2.0 * lost / p.mass());
  const double time =
      contact::HertzSpringDashpot::from_restitution(p.modulus, p.radius(), 1.0, p.mass())
          .contact_time(sticking);
  // At t_c/20 the energy of the discrete orbit closes, the neck is torn by the energy.
  const JkrSolver solver(p.law(), {}, p.diameter, time / 20.0);
  for (const double factor : {1.001, 1.5, 3.0, 10.0})
    for (int phase = 0; phase < 8; phase++) {
      const double back = rebound(solver, p, factor * sticking, phase / 8.0, 30.0 * time);
      EXPECT_NEAR(back, sticking * std::sqrt(factor * factor - 1.0), 1e-3 * factor * sticking)
          << factor;
    }
  EXPECT_EQ(rebound(solver, p, 0.999 * sticking, 0.3, 30.0 * time), 0.0);
}

TEST(JkrSolver, ASlowLoadPullsOffAtThreeHalvesOfPiWR) {
  const Pair p{1e-4, 5e8, 0.05, 0.5};
  const double pull_off = 1.5 * pi * p.work * p.radius();
  const double time =
      contact::HertzSpringDashpot::from_restitution(p.modulus, p.radius(), 1.0, p.mass())
          .contact_time(0.05);
  for (const double part : {10.0, 20.0, 50.0}) {
    const JkrSolver solver(p.law(), {}, p.diameter, time / part);
    // Where there is no force; the contact is seen there first.
    double x = 0.0, high = p.diameter;
    for (int k = 0; k < 100; k++) {
      const double middle = 0.5 * (x + high);
      (p.law().at(middle).force > 0.0 ? high : x) = middle;
    }
    double distance = p.diameter - x, rate = 0.0, load = 0.0;
    ContactState state{ContactState::unknown};
    const int steps = static_cast<int>(3000.0 * part);
    for (int n = 0; n < steps; n++) {
      const double last = load;
      load = 1.1 * pull_off * n / steps;
      const double force =
          solver.advance({distance, rate, 0.0}, last / p.mass(), solver.step(), state).force;
      rate += solver.step() * (force + load) / p.mass();
      distance += solver.step() * rate;
      if (!state.in_range()) break;
    }
    EXPECT_FALSE(state.in_range()) << part;
    // The contact opens by about its own overlap meanwhile: the load grows by the lag of the ramp.
    EXPECT_NEAR(load, pull_off, 5e-3 * pull_off) << part;
  }
}

TEST(JkrSolver, FrictionHoldsAContactThatIsPulledBeyondTouch) {
  // A ball on a plane is pulled up with 0.9 of the pull-off force, so that it rests beyond touch,
  // and along with half of what friction bears. It does not roll: it stays.
  contact::ContactParameters p;
  contact::set_hertz(p, 5e6, 0.25);
  p.restitution = 0.5;
  p.friction = 0.3;
  p.rolling_friction = 10.0;
  p.work_of_adhesion = 0.1;
  const double pull_off = 1.5 * pi * p.work_of_adhesion * thesis::radius;
  Spheres<JkrSolver, ContactHistory::with_rolling> box(p, {}, 1e-5);
  box.add(thesis::particle(), {0.0, 0.0, thesis::radius - 1e-7}, {});
  box.add_wall({{}, {0.0, 0.0, 1.0}, {}});
  box.recorded = false;
  double highest = 0.0;
  const int steps = 20000;
  for (int n = 0; n < steps; n++) {
    const double part = std::min(1.0, 2.0 * n / steps);
    // Friction bears 0.3 of 2 - 0.9 pull-off forces.
    box.gravity = (part * pull_off / thesis::mass) * Vector3{0.5 * 0.3 * 1.1, 0.0, 0.9};
    box.step();
    highest = std::max(highest, box.spheres[0].x.z);
  }
  EXPECT_GT(highest, thesis::radius);
  EXPECT_TRUE(box.any_in_range());
  EXPECT_LT(norm(box.spheres[0].v), 1e-8);
  EXPECT_LT(std::abs(box.spheres[0].x.x), 1e-6);
}

}  // namespace cohesion::contact_solver
