// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CONTACT_FORCES_H
#define COHESION_CONTACT_FORCES_H

#include "atom.h"
#include "contact_solver/contact_history.h"
#include "contact_solver/pair_motion.h"
#include "contact_step/fix_contact_step.h"

// How contacts of pairs and of walls are computed, and how what they do reaches the particles.
//
// Here, and where the laws of a step are, local variables of a struct type are not `const`: GCC 12
// keeps such in memory, the others in registers, which costs a contact a tenth.

namespace LAMMPS_NS {

using cohesion::vector;
using cohesion::Vector3;

using cohesion::contact_solver::ContactHistory;
using cohesion::contact_solver::ContactState;
using HistorySize = ContactHistory::Size;

/// Contacts of one kind, of one process, in one step. j < 0: a wall.
template <class Contact, int SIZE>
class ContactForces {
 public:
  using Action = cohesion::contact_solver::PairImpulse;
  using ContactEnergies = cohesion::contact_solver::ContactEnergies;
  using FrictionalStep = cohesion::contact_solver::FrictionalStep;
  using PairMotion = cohesion::contact_solver::PairMotion;

  ContactForces(Atom* atom, FixContactStep* step)
      : step_(step),
        forces_(atom->f[0]),
        torques_(atom->torque[0]),
        kick_(step->impulses.kick()),
        nlocal_(atom->nlocal),
        moved_by_forces_(step->moved_by_forces()),
        persistent_(!step->energy_tally.is_active() && !step->starts() &&
                    !step->has_other_length()) {}

  /// Force that stands for an impulse.
  double kick() const { return kick_; }
  /// The fraction of a pair's energies that this process counts: a pair of two processes, or of two
  /// images, is met twice.
  double owned_fraction(int j) const { return j < nlocal_ ? 1.0 : 0.5; }

  /// Computes a contact that was persistent and certainly is so in this step, of which the energy
  /// tally asks nothing: what most contacts of a bed need, and only that. `does`: what it does;
  /// linear: as ExactContact has it. False: nothing is done.
  template <bool linear>
  [[gnu::always_inline]] bool apply_persistent(const Contact& c, int i, int j,
                                               const PairMotion& now, double* values,
                                               FrictionalStep& does) const {
    ContactState::restore_signs(values);
    if (!persistent_) return false;
    if (c.is_idle(now.relative, values, moved_by_forces_)) return true;
    if (!c.template advance_persistent<SIZE, linear>(now, values, does)) return false;
    Vector3 pushed = kick_ * does.action.impulse;
    add(forces_ + 3 * i, -1.0, pushed);
    if (SIZE >= ContactHistory::with_friction) add(torques_ + 3 * i, kick_, does.action.torque_i);
    if (!is_own(j)) return true;
    add(forces_ + 3 * j, 1.0, pushed);
    if (SIZE >= ContactHistory::with_friction) add(torques_ + 3 * j, kick_, does.action.torque_j);
    return true;
  }

  /// Computes any contact; gives what it does. `of_wall`: acceleration of a wall [length/time^2];
  /// `energies`: of which the tally gets what it needs.
  FrictionalStep apply(const Contact& c, int i, int j, const PairMotion& now,
                       const Vector3& of_wall, ContactHistory& history,
                       ContactEnergies* energies) const {
    const Vector3 acceleration = of_wall + step_->relative_acceleration(i, j);
    if constexpr (Contact::is_exact)
      if (step_->has_other_length())
        c.change_step(step_->last_length(), now, acceleration, history);
    const FrictionalStep does =
        c.template advance<SIZE>(now, acceleration, step_->starts(), history, energies);
    push(i, -does.action.impulse, does.action.torque_i);
    if (is_own(j)) push(j, does.action.impulse, does.action.torque_j);
    if (dot(does.at_edge, does.at_edge) > 0.0) exclude(c, i, j, kick_ * does.at_edge);
    if (does.unresolved) step_->count_unresolved(owned_fraction(j));
    if (step_->energy_tally.is_active()) tally(i, j, kick_ * does.friction, *energies);
    return does;
  }

 private:
  bool is_own(int j) const { return j >= 0 && j < nlocal_; }

  [[gnu::always_inline]] static void add(double* to, double factor, const Vector3& a) {
    to[0] += factor * a.x;
    to[1] += factor * a.y;
    to[2] += factor * a.z;
  }
  void push(int i, const Vector3& impulse, const Vector3& turn) const {
    step_->impulses.push<SIZE>(i, impulse, turn);
  }

  /// Excludes a force on j, and its reverse on i, from the accelerations that the next step reads.
  [[gnu::noinline, gnu::cold]] void exclude(const Contact& c, int i, int j, Vector3 on_j) const {
    if (c.bodies().inverse_mass_i() > 0.0) step_->add_impulsive_force(i, -on_j);
    if (is_own(j) && c.bodies().inverse_mass_j() > 0.0) step_->add_impulsive_force(j, on_j);
  }

  void tally(int i, int j, const Vector3& friction, const ContactEnergies& energies) const {
    ContactEnergyTally& tally = step_->energy_tally;
    const double fraction = owned_fraction(j);
    tally.add(fraction, energies);
    if constexpr (SIZE >= ContactHistory::with_friction) {
      tally.add_friction(i, -friction);
      if (is_own(j)) tally.add_friction(j, friction);
    }
  }

  FixContactStep* step_;
  double* forces_;
  double* torques_;
  double kick_;
  int nlocal_;
  double moved_by_forces_;
  bool persistent_;
};

}  // namespace LAMMPS_NS

#endif
