// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "event_stepping/damped_oscillator.h"
#include "event_stepping/grid_point.h"

namespace cohesion::event_stepping {

/// The work of the forces f_n n_n of one pair on the grid. From one grid point to the next it is
///
///   1/2 (f_n n_n + f_(n+1) n_(n+1)) . (r_(n+1) - r_n)
///
/// and the kinetic energy of all particles, less dt^2 F^2/(8 m) of the force F on each, changes by
/// the sum of this over all pairs, whatever they do at once. An elastic pair has to get back to 0
/// when it parts: then a gas keeps its energy, although each contact knows of others only what they
/// did a step before. What is left of the work when a pair has left its range goes into the speed
/// at which it flies on.
///
/// Source: derived here; docs/theory/exact_contacts.md, Several contacts of a particle.
class PairWork {
 public:
  /// contact_distance [length]; spring, attraction [force]: of a contact that lasts, on the grid;
  /// step [time].
  PairWork(double contact_distance, double reduced_mass, const GridSpring& spring,
           double attraction, double step)
      : contact_distance_(contact_distance),
        reduced_mass_(reduced_mass),
        spring_(spring),
        attraction_(attraction),
        step_(step) {}

  /// All up to this grid point but that of its own force, [energy].
  double before(const GridPoint& at, const GridMemory& memory) const {
    if (memory.phase == GridMemory::lasting)
      return memory.work - stored(at) - of_force(lasting_force(at), at);
    if (memory.force == 0.0) return memory.work;
    const double speed_squared = at.radial * at.radial + at.sideways * at.sideways;
    const double along = at.distance * at.radial - step_ * speed_squared;
    const double distance = std::hypot(at.distance - step_ * at.radial, step_ * at.sideways);
    return memory.work + 0.5 * step_ * memory.force * along / distance;
  }
  /// What the force of this grid point does on the way here, [energy].
  double of_force(double force, const GridPoint& at) const {
    return 0.5 * step_ * force * at.radial;
  }
  /// The same in the first step of a run, whose velocities are those of the grid point: what the
  /// other half of the way, to the next one, would count too much. `flown` [length/time]: the mean
  /// rate on it.
  double of_first_force(double force, const GridPoint& at, double flown) const {
    return -0.25 * step_ * force * (flown - at.radial);
  }

  /// The energy whose decrease is the work of contacts that last, of turning pairs, too.
  double stored(const GridPoint& at) const {
    const double overlap = contact_distance_ - at.distance, across = step_ * at.sideways;
    return overlap * (0.5 * spring_.stiffness * overlap - attraction_) -
           0.25 * lasting_force(at) * across * across / at.distance;
  }

  /// Sets the force with which a pair that has done `work` flies on at the speed that its energy
  /// leaves it. False, where that does not suffice, so that it stands still, or where the pair
  /// comes back and its force stays: it has to settle later.
  bool settle(const GridPoint& at, double others, double work, double& force) const {
    const double speed = at.radial + 0.5 * step_ * others;
    if (!(speed > 0.0)) return false;
    const double left = speed * speed - 2.0 * work / reduced_mass_;
    force = reduced_mass_ * (std::sqrt(std::max(left, 0.0)) - speed) / step_;
    return left >= 0.0;
  }

 private:
  double lasting_force(const GridPoint& at) const {
    return spring_.stiffness * (contact_distance_ - at.distance) - spring_.damping * at.radial -
           attraction_;
  }

  double contact_distance_;
  double reduced_mass_;
  GridSpring spring_;
  double attraction_;
  double step_;
};

}  // namespace cohesion::event_stepping
