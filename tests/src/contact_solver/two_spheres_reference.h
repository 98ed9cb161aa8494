// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/contact_parameters.h"
#include "contact_solver/pair_motion.h"

namespace cohesion::contact_solver {

/// Two spheres in contact by the equations of the model, written out and integrated by Runge and
/// Kutta's rule of fourth order: an independent reference for small steps. Spring and dashpot along
/// the line of centres; across it a spring of stretch s, dashpot and slider in series,
///
///   F = -K_t s - eta_t s'    s' the velocity u of the surfaces, or |F| = mu_f max(K x + eta x', 0)
///
/// s turns with the line of centres. Lever arms divide the distance in proportion to the radii.
class TwoSpheresReference {
 public:
  struct State {
    Vector3 separation, velocity, spin_i{}, spin_j{}, stretch{};
  };

  TwoSpheresReference(const contact::ContactParameters& p, const Body& i, const Body& j)
      : i_(i),
        j_(j),
        reduced_mass_(1.0 / (i.inverse_mass + j.inverse_mass)),
        normal_(contact::normal_contact(p, reduced_mass_)),
        tangential_(contact::tangential_contact(p, normal_)) {}

  /// Through a contact that begins at `start`, in steps of `dt`, to its end: the last step is cut
  /// where the distance is that of touch.
  State through_contact(State start, double dt) const {
    State before = start, now = start;
    double step = dt;
    for (int n = 0; n < 1000000; n++) {
      before = now;
      now = after(before, dt);
      slip(now);
      if (norm(now.separation) >= i_.radius + j_.radius) break;
    }
    for (int k = 0; k < 5; k++) {  // Newton's rule
      const double distance = norm(now.separation);
      const double rate = dot(now.separation, now.velocity) / distance;
      step -= (distance - i_.radius - j_.radius) / rate;
      now = after(before, step);
    }
    return now;
  }

 private:
  double limit(double repulsion) const { return tangential_.friction * std::max(repulsion, 0.0); }
  /// Without a dashpot the spring is as long as the Coulomb force lets it be.
  void slip(State& s) const {
    if (tangential_.damping > 0.0) return;
    const double overlap = i_.radius + j_.radius - norm(s.separation);
    const double most = limit(normal_.stiffness() * overlap) / tangential_.stiffness;
    if (norm(s.stretch) > most) s.stretch = (most / norm(s.stretch)) * s.stretch;
  }
  State rate(const State& s) const {
    const double distance = norm(s.separation);
    const Vector3 n = (1.0 / distance) * s.separation;
    const double along = dot(n, s.velocity), overlap = i_.radius + j_.radius - distance;
    const double repulsion = normal_.stiffness() * overlap - normal_.damping() * along;
    const double lever_i = i_.radius / (i_.radius + j_.radius) * distance;
    const double lever_j = distance - lever_i;
    const Vector3 across = s.velocity - along * n;
    const Vector3 u = across - cross(lever_i * s.spin_i + lever_j * s.spin_j, n);
    Vector3 force = -tangential_.stiffness * s.stretch - tangential_.damping * u;
    const double most = limit(repulsion);
    Vector3 stretching = u;
    if (norm(force) > most) {
      force = (most / norm(force)) * force;
      if (tangential_.damping > 0.0)
        stretching = (-1.0 / tangential_.damping) * (force + tangential_.stiffness * s.stretch);
    }
    const Vector3 turn = cross(n, force);
    const Vector3 turning = (1.0 / distance) * across;  // n'
    return {s.velocity, (1.0 / reduced_mass_) * (repulsion * n + force),
            (-lever_i * inverse_inertia(i_)) * turn, (-lever_j * inverse_inertia(j_)) * turn,
            stretching - dot(turning, s.stretch) * n};
  }
  static State sum(const State& a, double factor, const State& b) {
    return {a.separation + factor * b.separation, a.velocity + factor * b.velocity,
            a.spin_i + factor * b.spin_i, a.spin_j + factor * b.spin_j,
            a.stretch + factor * b.stretch};
  }
  State after(const State& s, double dt) const {
    const State a = rate(s), b = rate(sum(s, 0.5 * dt, a)), c = rate(sum(s, 0.5 * dt, b)),
                d = rate(sum(s, dt, c));
    return sum(sum(sum(sum(s, dt / 6.0, a), dt / 3.0, b), dt / 3.0, c), dt / 6.0, d);
  }

  Body i_, j_;
  double reduced_mass_;
  contact::LinearSpringDashpot normal_;
  contact::TangentialParameters tangential_;
};

}  // namespace cohesion::contact_solver
