// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "contact_solver/contact_solver.h"
#include "contact_solver/pair_in_plane.h"

namespace cohesion::contact_solver {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// What a step does to a sphere beside a plane, under an acceleration `others` away from it.
struct BesidePlane {
  ContactSolver contact;
  double mass;
  double others;
  double distance, radial;
  ContactState state{};
  ContactStep last{};

  void step() {
    const double dt = contact.step();
    distance += dt * radial;
    const StaggeredMotion at{distance, radial, 0.0};
    last = contact.advance(at, others, dt, state);
    radial += dt * (last.force / mass + others);
  }
  /// Height over touch at which what moves it now would turn, where it flies freely.
  double height() const {
    const double now = radial - 0.5 * contact.step() * (last.force / mass + others);
    return distance - thesis::radius + now * now / (-2.0 * others);
  }
};

/// A sphere between two planes that pull at it with `part` of F_ad each, and the largest
/// oscillation along the normal in the last steps over the first.
double oscillation_between_planes(double part, double steps_per_contact, int steps) {
  const double mass = thesis::mass, stiffness = 2.0 * thesis::contact().stiffness;
  const contact::LinearSpringDashpot law(stiffness, 0.0, mass);
  const contact::Adhesion adhesion = thesis::adhesion(1e-18);
  const double dt = law.contact_time() / steps_per_contact;
  const ContactSolver contact(law, adhesion, thesis::radius, dt);
  const double overlap = (1.0 - part) * adhesion.force / stiffness;
  const double force = -part * adhesion.force, start = 1e-3 * overlap;
  ContactState states[2];
  double forces[2] = {force, force}, largest = 0.0, place = start, speed = 0.0;
  for (int n = 0; n < steps; n++) {
    double next[2];
    for (int side : {0, 1}) {
      const double outward = side == 0 ? 1.0 : -1.0;
      const StaggeredMotion at{thesis::radius - overlap + outward * place, outward * speed, 0.0};
      next[side] =
          contact.advance(at, -forces[1 - side] / mass, n == 0 ? 0.5 * dt : dt, states[side]).force;
    }
    for (int side : {0, 1}) forces[side] = next[side];
    speed += (n == 0 ? 0.5 : 1.0) * dt * (forces[0] - forces[1]) / mass;
    place += dt * speed;
    if (n >= steps - 10) largest = std::max(largest, std::abs(place));
  }
  return largest / start;
}

/// The load over F_ad at which the last of `count` spheres in a row parts that hangs from a plane,
/// when the load on the last one grows by F_ad in 4000 contact times.
double strength_of_row(int count, double restitution, double steps_per_contact) {
  const double mass = thesis::mass, stiffness = thesis::contact().stiffness;
  const contact::Adhesion adhesion = thesis::adhesion(7.49e-19);
  const auto pair =
      contact::LinearSpringDashpot::from_restitution(stiffness, restitution, 0.5 * mass);
  const auto wall = contact::LinearSpringDashpot::from_restitution(stiffness, restitution, mass);
  const double dt = pair.contact_time() / steps_per_contact, at_rest = adhesion.force / stiffness;
  const ContactSolver above(wall, adhesion, thesis::radius, dt);
  const ContactSolver between(pair, adhesion, 2.0 * thesis::radius, dt);
  std::vector<double> place(count), speed(count, 0.0), force(count, 0.0), last(count, 0.0);
  std::vector<ContactState> states(count);
  for (int k = 0; k < count; k++)
    place[k] = thesis::radius - at_rest + k * (2.0 * thesis::radius - at_rest);
  const double rate = adhesion.force / (4000.0 * pair.contact_time());
  for (long n = 0; n * dt * rate < 1.2 * adhesion.force; n++) {
    const double load = n * dt * rate;
    const double velocity_step = n == 0 ? 0.5 * dt : dt;
    std::vector<double> all(count, 0.0);  // of the last step, on each sphere
    for (int k = 0; k < count; k++)
      all[k] = last[k] - (k + 1 < count ? last[k + 1] : 0.0) +
               (k + 1 == count && n > 0 ? (n - 1) * dt * rate : 0.0);
    for (int k = 0; k < count; k++) {
      const bool first = k == 0;
      const StaggeredMotion at{first ? place[0] : place[k] - place[k - 1],
                               first ? speed[0] : speed[k] - speed[k - 1], 0.0};
      const ContactSolver& contact = first ? above : between;
      // By all forces of the last step, as the engines have it.
      const double by_all = all[k] / mass - (first ? 0.0 : all[k - 1] / mass);
      const double external = n == 0 ? 0.0 : contact.external(by_all, at, states[k]);
      force[k] = contact.advance(at, external, velocity_step, states[k]).force;
    }
    for (int k = 0; k < count; k++) {
      const double on_it =
          force[k] - (k + 1 < count ? force[k + 1] : 0.0) + (k + 1 == count ? load : 0.0);
      speed[k] += velocity_step * on_it / mass;
    }
    for (int k = 0; k < count; k++) place[k] += dt * speed[k];
    last = force;
    if (!states[count - 1].in_range() && n > 1) return load / adhesion.force;
    for (int k = 0; k + 1 < count; k++)
      if (!states[k].in_range() && n > 1) return load / adhesion.force;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

TEST(ContactUnderLoad, TwoContactsUnderTensionAreSteady) {
  for (const double part : {0.0, 0.5, 0.8, 0.99})
    for (const double steps : {3.0, 4.0, 10.0}) {
      // An elastic contact keeps its oscillation. Positions are rounded by eps distance, and an
      // error of the velocity grows with time at the most.
      const double rounding = 1e4 * eps * thesis::radius / (1e-3 * (1.0 - part) * 3e-7);
      EXPECT_LT(oscillation_between_planes(part, steps, 2000), 1.2 + rounding)
          << part << " " << steps;
    }
}

TEST(ContactUnderLoad, ARowOfSpheresPartsAtTheAdhesionForceAtAnySteadyStep) {
  // The load grows by 1/4000 of F_ad in a contact time, and the last contact needs some ten.
  for (const auto& [restitution, least] :
       {std::pair{0.99, 4.0}, {0.9, 4.0}, {0.5, 5.0}, {0.3, 6.0}})
    for (const double steps : {least, 10.0, 20.0})
      for (const int count : {1, 2, 8, 16})
        EXPECT_NEAR(strength_of_row(count, restitution, steps), 1.0, 0.01)
            << restitution << " " << steps << " " << count;
}

TEST(ContactUnderLoad, ElasticBouncesUnderWeightKeepTheirHeight) {
  const double mass = thesis::mass, stiffness = 2.0 * thesis::contact().stiffness;
  const contact::LinearSpringDashpot law(stiffness, 0.0, mass);
  const double gravity = 9.81, height = 2e-5;
  for (const double part : {2.0, 4.0, 10.0, 50.0}) {
    const double dt = law.contact_time() / part;
    BesidePlane sphere{{law, {}, thesis::radius, dt},
                       mass,
                       -gravity,
                       thesis::radius + height,
                       -0.5 * gravity * dt};
    int bounces = 0;
    double reached = 0.0;
    for (bool was = false; bounces < 500;) {
      sphere.step();
      if (was && !sphere.state.in_range()) bounces++;
      was = sphere.state.in_range();
      if (bounces == 499 && sphere.state.phase == ContactState::outside) reached = sphere.height();
    }
    // Each bounce rounds place and speed, two to each of some steps, by eps of distance over dt.
    const double steps = 500.0 * (part + 2.0 * std::sqrt(2.0 * height / gravity) / dt);
    const double speed = std::sqrt(2.0 * gravity * height);
    EXPECT_NEAR(reached / height, 1.0, std::sqrt(steps) * 8.0 * eps * thesis::radius / dt / speed)
        << part;
  }
}

TEST(ContactUnderLoad, ALoadAtRestPressesItsSpringOnTheGrid) {
  const contact::LinearSpringDashpot law(1600.0, 1.6e-3, thesis::mass);
  for (const double part : {4.0, 10.0, 50.0}) {
    BesidePlane sphere{{law, {}, thesis::radius, law.contact_time() / part},
                       thesis::mass,
                       -9.81,
                       thesis::radius * (1.0 - 1e-9),
                       0.0};
    for (int n = 0; n < 800.0 * part; n++) sphere.step();
    const double overlap = thesis::radius - sphere.distance;
    // Of the distance, eps is rounded off.
    EXPECT_NEAR(overlap, thesis::mass * 9.81 / discrete_stiffness(sphere.contact),
                4.0 * eps * thesis::radius + 1e-9 * overlap)
        << part;
    EXPECT_EQ(sphere.state.phase, ContactState::persistent);
  }
}

TEST(ContactUnderLoad, ASlowLoadPartsAContactAtTheAdhesionForceAtAnyStep) {
  // A sphere on a plane, from its rest without a load; this grows by F_ad in 2000 contact times.
  const contact::Adhesion adhesion = thesis::adhesion(7.49e-19);
  const double mass = thesis::mass, rate = 1.0 / 2000.0;
  for (const double stiffness : {800.0, 8e4})
    for (const double restitution : {0.99, 0.9, 0.5, 0.3})
      for (const double part : {4.0, 10.0, 20.0, 50.0}) {
        const auto law =
            contact::LinearSpringDashpot::from_restitution(stiffness, restitution, mass);
        const double dt = law.contact_time() / part;
        BesidePlane sphere{{law, adhesion, thesis::radius, dt},
                           mass,
                           0.0,
                           thesis::radius - adhesion.force / stiffness,
                           0.0};
        sphere.state.phase = ContactState::touching;
        double load = 0.0;
        for (int n = 0; load < 1.1 && sphere.state.in_range(); n++) {
          load = rate * n / part;
          sphere.others = load * adhesion.force / mass;
          sphere.step();
        }
        // Half of the hundredth is for what it swings by, the rest for the lag of the load and of
        // its knowledge: (6 H_cut mass k^2/F_ad)^(1/3) < 0.003, k = rate/t_c.
        EXPECT_NEAR(load, 1.0, 0.01) << stiffness << " " << restitution << " " << part;
      }
}

}  // namespace cohesion::contact_solver
