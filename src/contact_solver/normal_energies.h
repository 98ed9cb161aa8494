// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact_solver/contact_state.h"
#include "contact_solver/pair_motion.h"

namespace cohesion::contact_solver {

/// A step of a solver (ContactSolver::advance()), of which the energies are asked for.
struct SolvedStep {
  const StaggeredMotion& at;
  double external;             ///< that advance() was given, [length/time^2]
  bool first;                  ///< in the first step of a run, whose account begins
  const ContactState& before;  ///< the state that advance() was given
  const ContactState& after;   ///< and that it left
  double force;                ///< [force]
  double dissipated;           ///< ContactStep::dissipated, [energy]

  /// The acceleration by other forces in the last step: a persistent contact knows them from its
  /// own motion.
  double used() const { return after.is_outside() ? external : after.external_before; }
};

/// Sets what the normal motion of a contact has lost and exchanged.
template <class Solver>
void set_normal_losses(const Solver& solver, const SolvedStep& step, ContactEnergies& energies) {
  energies.before.normal_damping = solver.dissipated(step.at, step.before);
  energies.after.normal_damping = step.dissipated;
  if (!step.first) energies.exchanged = solver.exchanged(step.used(), step.before);
}

/// The same of a contact that was persistent in the last step and is so in this one: sets the
/// losses before and after the time level and the exchanged energy, all of the normal motion.
[[gnu::always_inline]] inline void set_persistent_losses(const PersistentStep& step,
                                                         ContactEnergies& energies) {
  energies.before.normal_damping = step.dissipated;
  energies.after.normal_damping = 0.0;
  energies.exchanged = step.exchanged;
}

/// Sets what the normal motion of a contact stores at a time level.
template <class Solver>
void set_normal_stored(const Solver& solver, const SolvedStep& step, double contact_distance,
                       ContactEnergies& energies) {
  StoredEnergies& stored = energies.stored;
  // As resolve() does: a pair that came into range within the last step has stored
  // nothing yet.
  const bool found_in_range =
      step.before.phase == ContactState::unknown &&
      step.at.stands_within(solver.entry_distance(), step.first ? 0.0 : solver.step());
  if (step.before.in_range() || found_in_range) {
    stored.spring = solver.spring_energy(contact_distance - step.at.distance);
    stored.adhesion = solver.adhesion_energy(contact_distance - step.at.distance);
  }
  if (!step.first)
    stored.load = solver.account_energy(step.at, step.used(), step.force, step.before);
}

}  // namespace cohesion::contact_solver
