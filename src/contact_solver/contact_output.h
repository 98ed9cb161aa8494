// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "contact_solver/contact_bodies.h"
#include "contact_solver/contact_history.h"
#include "contact_solver/pair_motion.h"

namespace cohesion::contact_solver {

/// A contact of two spheres at a time level, as an output lists it.
struct ContactOutput {
  enum Place { apart, in_range, touching };

  Place place = apart;
  double force = 0.0;     ///< along the normal, positive where it repels, [force]
  double limiting = 0.0;  ///< normal force of Coulomb's friction limit, [force]
  /// On i. In a step that was resolved, the mean of that step, [force] and [force length].
  Vector3 friction{};
  Vector3 rolling_torque{};
  double overlap = 0.0;  ///< negative: the gap, [length]
  double energy = 0.0;   ///< of spring and adhesion, [energy]
};

/// Contact: ExactContact or SampledContact. `separation` of j from i [length]; `step` [time]: with
/// which the forces in the history were computed.
template <class Contact>
ContactOutput output_of(const Contact& contact, const Vector3& separation,
                        const ContactHistory& history, double step) {
  const StoredEnergies energies = contact.stored(separation, history);
  ContactOutput output;
  output.overlap = contact.bodies().distance() - norm(separation);
  output.force = history.normal.force;
  output.energy = energies.potential();
  if (history.normal.in_range()) output.place = ContactOutput::in_range;
  if (!contact.touches(output.overlap, history)) return output;
  output.place = ContactOutput::touching;
  output.limiting = std::max(output.force + contact.friction_load(output.overlap, history), 0.0);
  output.friction = (-1.0 / step) * history.sliding.impulse;
  output.rolling_torque = (contact.bodies().rolling_radius() / step) * history.rolling.impulse;
  return output;
}

/// The forces of a contact at a time level, and the torques on i and j, not impulses: [force] and
/// [force length]. Arguments as for output_of().
template <class Contact>
PairAction forces_of(const Contact& contact, const Vector3& separation,
                     const ContactHistory& history, double step) {
  PairAction forces;
  const ContactBodies::Touch touch(contact.bodies(), separation);
  touch.add_sliding_impulse((1.0 / step) * history.sliding.impulse, forces);
  touch.add_rolling_impulse((1.0 / step) * history.rolling.impulse, forces);
  forces.impulse += (history.normal.force / norm(separation)) * separation;
  return forces;
}

}  // namespace cohesion::contact_solver
