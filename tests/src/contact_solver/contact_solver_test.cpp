// SPDX-License-Identifier: BSD-3-Clause
#include "contact_solver/contact_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/adhesive_contact.h"
#include "contact_solver/pair_in_plane.h"

namespace cohesion::contact_solver {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// A head-on pair on an engine's grid, from outside until it is outside again; its final speed.
double rebound(const ContactSolver& contact, double speed, double phase) {
  const double dt = contact.step();
  double distance = core + contact.range() + speed * dt * (2.0 + phase), radial = -speed;
  ContactState state;
  bool touched = false;
  for (int n = 0; n < 3000; n++) {
    distance += dt * radial;
    const StaggeredMotion at{distance, radial, 0.0};
    const ContactStep step = contact.advance(at, 0.0, dt, state);
    radial += dt * step.force / thesis::reduced_mass;
    if (!std::isfinite(radial)) return radial;
    touched = touched || state.in_range();
    if (touched && state.phase == ContactState::outside) return radial;
  }
  return 0.0;
}

}  // namespace

TEST(ContactSolver, RestitutionIsExactForAnyStepAndPhase) {
  for (const double damping : {0.0, 0.79e-3}) {
    const auto law = spring(damping);
    for (const double part : {2.0, 4.0, 10.0, 50.0})
      for (int phase = 0; phase < 8; phase++) {
        const double speed = 0.02, dt = thesis::contact_time / part;
        const ContactSolver contact(law, {}, core, dt);
        const double back = rebound(contact, speed, (phase + 0.37) / 8.0);
        // The distance is rounded by eps core / 2 at each of some part + 5 points, each felt in
        // the velocity over dt at the most.
        EXPECT_NEAR(back, law.restitution() * speed, (part + 5.0) * eps * core / dt)
            << damping << " " << part << " " << phase;
      }
  }
}

TEST(ContactSolver, APairThatIsNewInTheRangeStandsThere) {
  // In the gap at rest within a run: it falls by what is left of the gap, and has fallen in by the
  // whole range where it was outside a step before.
  const contact::Adhesion adhesion{2e-6, 1e-6, 3e-12};
  const double dt = thesis::contact_time / 10.0, gap = 0.25e-6;
  const ContactSolver contact(spring(0.0), adhesion, core, dt);
  const auto is_inside_after = [&](double radial, bool is_new) {
    ContactState state;
    if (is_new) state.phase = ContactState::unknown;
    contact.advance({core + gap, radial, 0.0}, 0.0, dt, state);
    return state.in_range();
  };
  EXPECT_TRUE(is_inside_after(0.0, true));
  EXPECT_FALSE(is_inside_after(0.0, false));

  StaggeredMotion at{core + gap, 0.0, 0.0};
  ContactState state{ContactState::unknown};
  double fastest = 0.0;
  for (int n = 0; n < 300; n++) {
    const ContactStep step = contact.advance(at, 0.0, dt, state);
    at.rate += dt * step.force / thesis::reduced_mass;
    at.distance += dt * at.rate;
    fastest = std::max(fastest, std::abs(at.rate));
    EXPECT_LT(at.distance, core + adhesion.cutoff) << n;
  }
  // At the equilibrium, F/K within the contact: from the gap and into the spring.
  const double stiffness = thesis::contact().stiffness;
  const double energy = adhesion.force * gap + 0.5 * adhesion.force * adhesion.force / stiffness;
  // Grid velocities are means over a step, in which the pull adds F dt/mu to the speed: the fastest
  // of them may be of a step that ends one and a half steps before the touch.
  const double speed = std::sqrt(2.0 * energy / thesis::reduced_mass);
  EXPECT_NEAR(fastest, speed, 1.5 * dt * adhesion.force / thesis::reduced_mass);
}

TEST(ContactSolver, RecursionOnTheGridIsTheClosedForm) {
  const double critical = 2.0 * std::sqrt(thesis::contact().stiffness * thesis::reduced_mass);
  for (const double share : {0.0, 0.1, 1.0, 3.0})
    for (const double part : {2.0, 10.0, 100.0, 1000.0}) {
      const double dt = thesis::contact_time / part, mu = thesis::reduced_mass;
      const DampedOscillator oscillator(thesis::contact().stiffness / mu,
                                        0.5 * share * critical / mu);
      const DiscreteConstants grid = oscillator.on_grid(dt, mu);
      const double w0 = std::sqrt(oscillator.w0_squared());
      const Overlap start{0.0, w0};  // amplitudes of order 1
      double x = oscillator.after(dt, start, 0.0).x, v = x / dt;
      for (int n = 2; n <= 2.0 * part; n++) {
        v -= dt * (grid.stiffness * x + grid.damping * v) / mu;
        x += dt * v;
        // x is rounded by eps and v by eps w0 in each step, and an error of v grows with time at
        // the most; the closed form rounds its argument of 2 pi.
        const double rounding = 10.0 * n * eps * (1.0 + w0 * n * dt);
        EXPECT_NEAR(x, oscillator.after(n * dt, start, 0.0).x, rounding)
            << share << " " << part << " " << n;
      }
    }
}

TEST(ContactSolver, EscapesHeadOnAtTheVelocityOfTheClosedFormForAnyStepAndPhase) {
  const auto law = spring(thesis::contact().damping);
  for (const double hamaker : {1e-19, 7.49e-19, 2e-18}) {
    const contact::Adhesion adhesion = thesis::adhesion(hamaker);
    const double escape = contact::AdhesiveContact(law, adhesion).escape_velocity();
    for (const double part : {4.0, 8.0, 16.0, 50.0})
      for (int phase = 0; phase < 8; phase++)
        for (const double off : {-1e-3, 1e-3}) {
          const ContactSolver contact(law, adhesion, core, thesis::contact_time / part);
          const double back = rebound(contact, escape * (1.0 + off), (phase + 0.37) / 8.0);
          EXPECT_EQ(back > 0.0, off > 0.0) << hamaker << " " << part << " " << phase;
        }
  }
}

TEST(ContactSolver, ExtremesStayFinite) {
  for (const double damping : {0.0, 0.79e-3, 1.0, 1e3})
    for (const double part : {1.0 / 0.9, 4.0, 50.0})
      for (const double cutoff : {0.0, thesis::range})
        for (const double tail : {0.0, 1e-15, 1.0})
          for (const double speed : {0.0, 1e-9, 0.02, 1.0}) {
            const ContactSolver contact(spring(damping), {1e-6, cutoff, tail}, core,
                                        thesis::contact_time / part);
            EXPECT_TRUE(std::isfinite(rebound(contact, speed, 0.3)))
                << damping << " " << part << " " << cutoff << " " << tail << " " << speed;
          }
}

namespace {

/// Two spheres in a plane that meet with a normal and a sideways speed; whether they part again.
/// `turned`: largest change of the angular momentum over r times speed.
bool parts(const ContactSolver& contact, double speed, double sideways, double phase,
           double& turned) {
  const double dt = contact.step(), flight = dt * (2.0 + phase);
  double x = core + contact.range() + speed * flight, y = -sideways * flight;
  double vx = -speed, vy = sideways;
  const double momentum = x * vy - y * vx;
  ContactState state;
  bool touched = false;
  for (int n = 0; n < 40.0 * thesis::contact_time / dt; n++) {
    x += dt * vx;
    y += dt * vy;
    const double r = std::hypot(x, y), nx = x / r, ny = y / r;
    const StaggeredMotion at{r, vx * nx + vy * ny, std::abs(vy * nx - vx * ny)};
    const ContactStep step = contact.advance(at, 0.0, dt, state);
    vx += dt * step.force / thesis::reduced_mass * nx;
    vy += dt * step.force / thesis::reduced_mass * ny;
    turned = std::max(turned,
                      std::abs(x * vy - y * vx - momentum) / (core * std::hypot(speed, sideways)));
    touched = touched || state.in_range();
    if (touched && state.phase == ContactState::outside) return true;
  }
  return false;
}

double escape_speed(const ContactSolver& contact, double slope, double phase, double& turned) {
  double low = 1e-3, high = 0.1;
  for (int k = 0; k < 30; k++) {
    const double middle = std::sqrt(low * high);
    (parts(contact, middle, slope * middle, phase, turned) ? high : low) = middle;
  }
  return high;
}

}  // namespace

TEST(ContactSolver, ObliquePairsEscapeAtTheSameSpeedForAnyStepAndPhase) {
  const auto law = spring(thesis::contact().damping);
  for (const double hamaker : {1e-19, 7.49e-19, 2e-18}) {
    const contact::Adhesion adhesion = thesis::adhesion(hamaker);
    for (const double angle : {30.0, 60.0, 80.0}) {
      const double slope = std::tan(angle * 3.14159265358979 / 180.0);
      double turned = 0.0;
      const double fine =
          escape_speed({law, adhesion, core, thesis::contact_time / 200.0}, slope, 0.4, turned);
      for (const double part : {4.0, 8.0, 16.0, 50.0})
        for (int phase = 0; phase < 8; phase++) {
          const ContactSolver contact(law, adhesion, core, thesis::contact_time / part);
          const double found = escape_speed(contact, slope, phase / 8.0, turned);
          EXPECT_NEAR(found / fine, 1.0, 1e-3) << hamaker << " " << angle << " " << part;
        }
      // A force along the line of the centres turns nothing: rounding of some 40 contact times.
      EXPECT_LT(turned, 8000.0 * eps) << hamaker << " " << angle;
    }
  }
}

TEST(ContactSolver, PersistentAndResolvedContactsGoWhereTheClosedFormDoes) {
  const auto law = spring(thesis::contact().damping);
  const double dt = thesis::contact_time / 10.0, mu = thesis::reduced_mass;
  const contact::Adhesion adhesion = thesis::adhesion(7.49e-19);
  const ContactSolver contact(law, adhesion, core, dt);
  const DampedOscillator oscillator(law.stiffness() / mu, 0.5 * law.damping() / mu);
  const double pull = adhesion.force / mu;
  const double overlap = contact.range() * 1000.0;
  for (const double speed : {-1e-3, 0.0, 1e-3}) {
    const Overlap start{overlap, speed};
    const Overlap middle = oscillator.after(dt, start, pull);
    const double end = oscillator.after(2.0 * dt, start, pull).x;
    const double force = mu * (2.0 * middle.x - start.x - end) / (dt * dt);
    const StaggeredMotion now{core - middle.x, (start.x - middle.x) / dt, 0.0};
    for (const auto phase : {ContactState::persistent, ContactState::entered}) {
      ContactState state;
      state.phase = phase;
      state.last_rate = now.rate;
      state.velocity_offset = -middle.v - now.rate;
      const ContactStep step = contact.advance(now, 0.0, dt, state);
      // Distances are rounded by eps core, and a force is a difference of three over dt^2.
      EXPECT_NEAR(step.force, force, 8.0 * eps * core * mu / (dt * dt)) << speed << " " << phase;
      EXPECT_EQ(state.phase, phase == ContactState::persistent ? ContactState::persistent
                                                               : ContactState::touching);
    }
  }
}

TEST(ContactSolver, TheFirstStepOfARunTakesAPairWhereItIs) {
  const contact::LinearSpringDashpot law = spring(0.0);
  const double dt = thesis::contact_time / 10.0, mu = thesis::reduced_mass;
  const ContactSolver contact(law, thesis::adhesion(7.49e-19), core, dt);
  const double start = 2e-7, speed = 0.01;
  const DampedOscillator oscillator(law.stiffness() / mu, 0.0);
  const double pull = thesis::adhesion(7.49e-19).force / mu;
  ContactState state;
  const ContactStep step = contact.advance({core - start, -speed, 0.0}, 0.0, 0.5 * dt, state);
  const double flown = -speed + 0.5 * dt * step.force / mu;
  EXPECT_NEAR(start - dt * flown, oscillator.after(dt, {start, speed}, pull).x, 4.0 * eps * core);
  EXPECT_EQ(state.phase, ContactState::touching);
  ContactState beyond;
  EXPECT_EQ(contact.advance({core * 1.1, -speed, 0.0}, -9.81, 0.5 * dt, beyond).force, 0.0);
  EXPECT_EQ(beyond.phase, ContactState::outside);
}

}  // namespace cohesion::contact_solver
