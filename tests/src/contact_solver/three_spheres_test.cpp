// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "constants.h"
#include "contact_solver/exact_contact.h"
#include "contact_solver/spheres.h"

namespace cohesion::contact_solver {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double core = 2.0 * thesis::radius;
const double contact_time = pi * std::sqrt(thesis::reduced_mass / 800.0);  // elastic
constexpr double speed = 0.1;

using Elastic = Spheres<ContactSolver, ContactHistory::normal_only>;

/// Until all are apart, after the first `at_least` [time].
template <class Any>
void let_part(Any& spheres, double at_least) {
  const int first = static_cast<int>(at_least / spheres.dt());
  for (int n = 0; n < 100 * first; n++) {
    spheres.step();
    if (n > first && spheres.are_apart()) return;
  }
  FAIL() << "still in contact";
}

/// Three spheres on a line: the outer ones hit the middle one at speeds 1 and 0.7 of `speed`, the
/// second contact `later` after the first.
struct OnALine {
  double gap[2];

  explicit OnALine(double later)
      : gap{0.5 * speed * contact_time, 0.5 * speed * contact_time + later * speed} {}
  std::array<double, 3> velocities() const { return {speed, 0.0, -0.7 * speed}; }

  /// In steps of dt that begin `wait` earlier.
  Elastic spheres(double dt, double wait) const {
    Elastic s(thesis::elastic(), {}, dt);
    const auto v = velocities();
    s.add(thesis::particle(), {-core - gap[0] - wait * v[0], 0.0, 0.0}, {v[0], 0.0, 0.0});
    s.add(thesis::particle(), {}, {});
    s.add(thesis::particle(), {core + gap[1] - wait * v[2], 0.0, 0.0}, {v[2], 0.0, 0.0});
    return s;
  }

  struct Outcome {
    double middle;     ///< velocity of the middle sphere at the end
    double exchanged;  ///< integral of (f_A f_B' - f_A' f_B)/m over time, [energy/time^2]
  };
  /// By the rule of Runge and Kutta. The first contact ends with the energy `moved` less, the
  /// second one with it more.
  Outcome integrated(double moved) const {
    using State = std::array<double, 6>;  // overlaps, velocities
    const double dt = contact_time / 5000.0, mass = thesis::mass;
    const auto force = [](double overlap) { return 800.0 * std::max(overlap, 0.0); };
    const auto rate = [&](const State& s) -> State {
      const double a = force(s[0]), b = force(s[1]);
      return {s[2] - s[3], s[3] - s[4], -a / mass, (a - b) / mass, b / mass, 0.0};
    };
    const auto along = [](State s, double time, const State& r) {
      for (std::size_t k = 0; k < s.size(); k++) s[k] += time * r[k];
      return s;
    };
    const auto part = [](double& left, double& right, double gain) {
      const double parts = right - left;
      const double more = std::sqrt(parts * parts + 2.0 * gain / thesis::reduced_mass) - parts;
      right += 0.5 * more;
      left -= 0.5 * more;
    };
    const auto v = velocities();
    State s{-gap[0], -gap[1], v[0], v[1], v[2], 0.0};
    Outcome found{};
    double a = 0.0, b = 0.0, first = moved;
    for (int n = 0; n < 20000 || s[0] > 0.0 || s[1] > 0.0; n++) {
      const State k1 = rate(s), k2 = rate(along(s, 0.5 * dt, k1)),
                  k3 = rate(along(s, 0.5 * dt, k2)), k4 = rate(along(s, dt, k3));
      s = along(along(along(along(s, dt / 6.0, k1), dt / 3.0, k2), dt / 3.0, k3), dt / 6.0, k4);
      const double next_a = force(s[0]), next_b = force(s[1]);
      found.exchanged += (a * (next_b - b) - (next_a - a) * b) / mass;
      if (a > 0.0 && next_a == 0.0) {
        part(s[2], s[3], -first);
        first = 0.0;  // the same two meet once more
      }
      if (b > 0.0 && next_b == 0.0) part(s[3], s[4], moved);
      a = next_a;
      b = next_b;
    }
    found.middle = s[3];
    return found;
  }
};

}  // namespace

TEST(ThreeSpheres, AContactExchangesWithAnotherTheEnergyOfForcesThatActOneStepLate) {
  // The first contact ends while the second begins. Without the exchange dt^2/8 (f b' - f' b) it
  // would end with that energy less and the second one with that more. It is of second order in the
  // time T in which both last: one force falls and the other grows meanwhile. All else that is of
  // second order in the step acts through the motion of the middle sphere, to the third order of w0
  // T < 1. So the middle sphere is wrong by less than a tenth of what the exchange is worth; a
  // factor of 0.1 for 1/8 would leave a fifth.
  for (const double later : {0.7, 0.8}) {
    const OnALine line(later * contact_time);
    const OnALine::Outcome exact = line.integrated(0.0);
    for (const double part : {40.0, 60.0}) {
      const double dt = contact_time / part;
      const double without =
          line.integrated(0.125 * dt * dt * exact.exchanged).middle - exact.middle;
      ASSERT_GT(std::abs(without), 1e-6 * speed);
      for (const bool short_path : {false, true})
        for (int phase = 0; phase < 8; phase++) {
          Elastic s = line.spheres(dt, dt * (phase + 0.37) / 8.0);
          s.short_path = short_path;
          let_part(s, 4.0 * contact_time);
          EXPECT_NEAR(s.spheres[1].v.x, exact.middle, 0.1 * std::abs(without))
              << later << " " << part << " " << phase;
        }
    }
  }
}

TEST(ThreeSpheres, SimultaneousImpactsAreOfSecondOrder) {
  // Each contact meets the force of the other one step late, in the mean half a step off: the
  // middle sphere errs by (w0 dt)^2/4 of the speed in each of the two contacts, at the most.
  for (const double later : {0.0, 0.3}) {
    const OnALine line(later * contact_time);
    const OnALine::Outcome exact = line.integrated(0.0);
    double errors[3] = {};
    const double parts[] = {8.0, 16.0, 32.0};
    for (int k = 0; k < 3; k++) {
      for (int phase = 0; phase < 8; phase++) {
        const double dt = contact_time / parts[k];
        Elastic s = line.spheres(dt, dt * (phase + 0.37) / 8.0);
        let_part(s, 4.0 * contact_time);
        errors[k] = std::max(errors[k], std::abs(s.spheres[1].v.x - exact.middle) / speed);
      }
      EXPECT_LT(errors[k], 0.5 * std::pow(pi / parts[k], 2)) << later << " " << parts[k];
    }
    // Halves of a step quarter it, but for the next order, an eighth of its coarser share.
    EXPECT_LT(errors[1], errors[0] / 3.5);
    EXPECT_LT(errors[2], errors[1] / 3.75);
  }
}

TEST(ThreeSpheres, ElasticOnesOnALineKeepTheirEnergyToRounding) {
  // The accounts of both contacts are closed, and their exchange is the same with two signs.
  for (const double part : {4.0, 10.0, 50.0})
    for (int phase = 0; phase < 8; phase++) {
      const double dt = contact_time / part;
      Elastic s = OnALine(0.1 * phase * contact_time).spheres(dt, dt * (phase + 0.37) / 8.0);
      s.short_path = phase % 2;
      const double before = s.kinetic_energy();
      let_part(s, 4.0 * contact_time);
      // Rounding of distances over a step, in each step of two contacts.
      EXPECT_NEAR(s.kinetic_energy() / before, 1.0,
                  4.0 * (2.0 * part + 10.0) * eps * core / dt / speed)
          << part << " " << phase;
    }
}

TEST(ThreeSpheres, ElasticOnesAtAnyAngleKeepTheirEnergyToTheTurningOfAStep) {
  // One hits two that are about to meet. Lines of centres turn by u dt/D in a step, and forces of
  // other contacts act one step late across them: second order in both.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int both = 0;
  for (int n = 0; n < 100; n++) {
    const double angle = 1.5 + 0.4 * uniform(random), later = 0.4 * uniform(random) * contact_time;
    const Vector3 d{std::cos(angle), std::sin(angle), 0.0};
    for (const double part : {4.0, 8.0, 20.0}) {
      const double dt = contact_time / part;
      Elastic s(thesis::elastic(), {}, dt);
      s.add(thesis::particle(), {}, {0.3 * speed, 0.0, 0.0});
      s.add(thesis::particle(), {core + 0.5 * speed * contact_time, 0.0, 0.0},
            {-0.2 * speed, 0.0, 0.0});
      s.add(thesis::particle(),
            core * d + (contact_time + later) * (speed * d + Vector3{0.3 * speed, 0.0, 0.0}),
            -speed * d);
      const double before = s.kinetic_energy();
      let_part(s, 8.0 * contact_time);
      // Contacts of 0 with 1 and with 2 begin within less than a contact time.
      both += norm(s.contacts[0].normal_impulse) > 0.0 && norm(s.contacts[1].normal_impulse) > 0.0;
      const double turned = 2.0 * speed * dt / core;
      EXPECT_NEAR(s.kinetic_energy() / before, 1.0, turned * pi / part) << n << " " << part;
    }
  }
  EXPECT_EQ(both, 300);
}

TEST(ThreeSpheres, ADampedTripleBalancesItsEnergyToTheSecondOrder) {
  // A contact knows of two others one step late, and so its dissipation, (w0 dt)^2/4 of it each.
  // While they touch, velocities of a time level follow from the forces of each contact by itself:
  // the same share of the whole energy.
  for (const double friction : {0.0, 0.3})
    for (const double part : {5.0, 10.0, 50.0})
      for (int phase = 0; phase < 8; phase++) {
        contact::ContactParameters p = thesis::contact();
        p.friction = friction;
        const double dt = contact_time / part;
        Spheres<ContactSolver, ContactHistory::with_friction> s(p, {}, dt);
        const double wait = dt * (phase + 0.37) / 8.0 + 0.2 * contact_time;
        s.add(thesis::particle(), {}, {0.02, 0.0, 0.0}, {30.0, -20.0, 10.0});
        s.add(thesis::particle(), {core + 0.04 * wait, 0.0, 0.0}, {-0.02, 0.01, 0.0});
        s.add(thesis::particle(), {0.5 * core, 0.87 * core + speed * wait, 0.0},
              {0.02, -speed, 0.01});
        s.step();
        const double before = s.energy;
        double worst = 0.0;
        for (int n = 0; n < 6.0 * part; n++) {
          s.step();
          worst = std::max(worst, std::abs(s.energy - before));
        }
        EXPECT_TRUE(s.are_apart());
        const double late = 0.25 * std::pow(pi / part, 2), turned = 2.0 * speed * dt / core;
        EXPECT_LT(worst, (late + turned) * before) << friction << " " << part << " " << phase;
        EXPECT_NEAR(s.energy, before, 2.0 * late * s.lost + turned * before)
            << friction << " " << part << " " << phase;
      }
}

}  // namespace cohesion::contact_solver
