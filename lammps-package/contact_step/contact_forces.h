// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CONTACT_FORCES_H
#define COHESION_CONTACT_FORCES_H

#include "atom.h"
#include "contact_solver/contact_history.h"
#include "contact_solver/pair_motion.h"
#include "contact_step/fix_contact_step.h"

// Computes contacts of pairs and walls, and adds their forces and torques to those of the engine.
//
// Local variables of a struct type are not `const` here and in the contact laws: GCC 12 keeps
// constant ones in memory instead of registers, which makes a contact 10 % slower.

namespace LAMMPS_NS {

using cohesion::vector;
using cohesion::Vector3;

using cohesion::contact_solver::ContactEnergies;
using cohesion::contact_solver::ContactHistory;
using cohesion::contact_solver::ContactState;
using cohesion::contact_solver::FrictionalStep;
using cohesion::contact_solver::PairMotion;
using cohesion::contact_solver::StoredEnergies;

/// The contacts of one style on one rank in one step. j < 0: a wall.
template <class Contact, int SIZE>
class ContactForces {
 public:
  ContactForces(Atom* atom, FixContactStep* step)
      : step_(step),
        forces_(atom->f[0]),
        torques_(atom->torque[0]),
        kick_(step->impulses.kick()),
        nlocal_(atom->nlocal),
        moved_by_forces_(step->moved_by_forces()),
        may_persist_(!step->starts() && !step->has_other_length()) {}

  /// Force that represents a unit impulse in this step, [1/time].
  double kick() const { return kick_; }
  /// The fraction of a pair's energies that this rank counts: a pair across ranks, or across a
  /// periodic face, is computed twice.
  double owned_fraction(int j) const { return j < nlocal_ ? 1.0 : 0.5; }

  /// Whether apply_persistent() can be called in this step.
  bool may_persist() const { return may_persist_; }
  /// The fast path of beds: computes a contact that was persistent and certainly remains so in this
  /// step, without stored energies. `now`, `By`: as in ExactContact; `result`: set to the impulses;
  /// times kick() they are forces; `tallies`: the energy balance is active, and gets the losses.
  /// Returns false, and changes nothing, for any other contact, and in the step in which the engine
  /// has exchanged i and j.
  template <class By, bool tallies, class Motion>
  [[gnu::always_inline]] bool apply_persistent(const Contact& c, std::ptrdiff_t i, std::ptrdiff_t j,
                                               const Motion& now, double* values,
                                               FrictionalStep& result) const {
    if (c.is_idle(now, values, moved_by_forces_)) return true;
    ContactEnergies energies;
    if (!c.template advance_persistent<SIZE, By>(now, values, result,
                                                 tallies ? &energies : nullptr))
      return false;
    if constexpr (tallies) tally_persistent(i, j, result.friction, energies);
    Vector3 pushed = kick_ * result.impulse;
    add(forces_ + 3 * i, -1.0, pushed);
    if (SIZE >= ContactHistory::with_friction) add(torques_ + 3 * i, kick_, result.torque_i);
    if (j >= nlocal_) return true;
    add(forces_ + 3 * j, 1.0, pushed);
    if (SIZE >= ContactHistory::with_friction) add(torques_ + 3 * j, kick_, result.torque_j);
    return true;
  }

  /// Computes any contact, and returns its impulses. `of_wall` [length/time^2]: acceleration of a
  /// wall; `energies`: filled for the energy balance if not null; `with_stored`:
  /// whether stored energies are evaluated, too.
  FrictionalStep apply(const Contact& c, int i, int j, const PairMotion& now,
                       const Vector3& of_wall, ContactHistory& history, ContactEnergies* energies,
                       bool with_stored) const {
    const Vector3 acceleration = of_wall + step_->relative_acceleration(i, j);
    if constexpr (Contact::is_exact)
      if (step_->has_other_length())
        c.change_step(step_->last_length(), now, acceleration, history);
    const FrictionalStep result = c.template advance<SIZE>(now, acceleration, step_->starts(),
                                                           history, energies, with_stored);
    push(i, -result.impulse, result.torque_i);
    if (is_own(j)) push(j, result.impulse, result.torque_j);
    if (dot(result.at_edge, result.at_edge) > 0.0) exclude(c, i, j, kick_ * result.at_edge);
    if (result.unresolved) step_->count_unresolved(owned_fraction(j));
    if (step_->energy_tally.is_active()) tally(i, j, result.friction, *energies);
    return result;
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

  /// Excludes a force on j, and the opposite one on i, from the accelerations that the next step
  /// uses as external ones.
  [[gnu::noinline, gnu::cold]] void exclude(const Contact& c, int i, int j, Vector3 on_j) const {
    if (c.bodies().inverse_mass_i() > 0.0) step_->add_impulsive_force(i, -on_j);
    if (is_own(j) && c.bodies().inverse_mass_j() > 0.0) step_->add_impulsive_force(j, on_j);
  }

  void tally(int i, int j, const Vector3& friction, const ContactEnergies& energies) const {
    step_->energy_tally.add(owned_fraction(j), energies);
    add_friction(i, j, friction);
  }
  [[gnu::always_inline]] void tally_persistent(std::ptrdiff_t i, std::ptrdiff_t j,
                                               const Vector3& friction,
                                               const ContactEnergies& energies) const {
    ContactEnergyTally& tally = step_->energy_tally;
    if (SIZE >= ContactHistory::with_friction) tally.subtract_friction(i, friction);
    if (j >= nlocal_) return tally.lose_persistent(0.5, energies);
    tally.lose_persistent(1.0, energies);
    if (SIZE >= ContactHistory::with_friction) tally.add_friction(j, friction);
  }
  /// Adds an impulse of sliding friction on j, and the reverse on i, to the energy balance.
  [[gnu::always_inline]] void add_friction(int i, int j, const Vector3& friction) const {
    if constexpr (SIZE >= ContactHistory::with_friction) {
      step_->energy_tally.subtract_friction(i, friction);
      if (is_own(j)) step_->energy_tally.add_friction(j, friction);
    }
  }

  FixContactStep* step_;
  double* forces_;
  double* torques_;
  double kick_;
  int nlocal_;
  double moved_by_forces_;
  bool may_persist_;
};

}  // namespace LAMMPS_NS

#endif
