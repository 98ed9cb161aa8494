// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CONTACT_SCATTER_H
#define COHESION_CONTACT_SCATTER_H

#include "atom.h"
#include "event_stepping/sampled_contact.h"
#include "event_stepping/two_pass_contact.h"
#include "fix_event_step.h"

// How the impulses of contacts reach the particles, from pairs and walls alike.
//
// Here, and where the laws of a step are, local variables of a struct type are not `const`: GCC 12
// keeps such in memory, the others in registers, which costs a sampled contact a tenth.

namespace LAMMPS_NS {

using cohesion::vector;
using cohesion::Vector3;

inline void add(double* to, double factor, const cohesion::Vector3& a) {
  to[0] += factor * a.x;
  to[1] += factor * a.y;
  to[2] += factor * a.z;
}

/// `history` of a contact: what ContactMemory keeps, of its sizes; a sampled one has the in-range
/// flag in the place of the phase, and the stretch of its springs.
using HistorySize = cohesion::event_stepping::ContactMemory::Size;

/// What contacts do to particles in a step: of one process, and of one kind of contact.
template <class Contact, int SIZE>
class ContactsOfStep {
 public:
  using Action = cohesion::event_stepping::Action;
  using PairMotion = cohesion::event_stepping::PairMotion;

  ContactsOfStep(Atom* atom, FixEventStep* step)
      : step_(step), kick_(step->impulses.kick()), nlocal_(atom->nlocal) {}

  /// Force that stands for an impulse.
  double kick() const { return kick_; }

  /// Force and torque on the particles of this process.
  [[gnu::always_inline]] void apply(int i, int j, const Action& a) const {
    step_->impulses.push<SIZE>(i, -a.impulse, a.torque_i);
    if (j >= 0 && j < nlocal_) step_->impulses.push<SIZE>(j, a.impulse, a.torque_j);
  }
  /// apply() comes soon.
  void fetch(int i, int j) const {
    step_->impulses.fetch<SIZE>(i);
    if (j >= 0 && j < nlocal_) step_->impulses.fetch<SIZE>(j);
  }
  void apply_reversed(int i, int j, const Action& a) const {
    apply(i, j, {-a.impulse, -a.torque_i, -a.torque_j});
  }
  /// Of what apply() was told, the part along the normal acted at an instant of the step.
  [[gnu::noinline, gnu::cold]] void note_sudden(int i, int j, const Contact& c, Vector3 separation,
                                                Vector3 impulse) const {
    if (dot(impulse, impulse) == 0.0) return;
    const double part = dot(impulse, separation) / dot(separation, separation);
    const Vector3 push = (kick_ * part) * separation;
    if (c.bodies().inverse_mass_i() > 0.0) step_->add_sudden_force(i, -push);
    if (j >= 0 && j < nlocal_ && c.bodies().inverse_mass_j() > 0.0)
      step_->add_sudden_force(j, push);
  }

  /// Adds what `a` changes of the motion of i or j to six numbers.
  static void change_i(double* to, const Contact& c, const Action& a) {
    add(to, -c.bodies().inverse_mass_i(), a.impulse);
    if (SIZE > 3) add(to + 3, c.bodies().inverse_inertia_i(), a.torque_i);
  }
  static void change_j(double* to, const Contact& c, const Action& a) {
    add(to, c.bodies().inverse_mass_j(), a.impulse);
    if (SIZE > 3) add(to + 3, c.bodies().inverse_inertia_j(), a.torque_j);
  }
  /// The same of both, to what the contacts of a followed one owe, and to that of the tally.
  void add_owed(int i, int j, const Contact& c, const Action& a) const {
    change_i(step_->owed(i), c, a);
    if (j >= 0) change_j(step_->owed(j), c, a);
  }
  void add_owed_of_tally(int i, int j, const Contact& c, const Action& a) const {
    change_i(step_->energy_tally.owed()[i], c, a);
    if (j >= 0) change_j(step_->energy_tally.owed()[j], c, a);
  }

  /// Adds the most that a followed contact may do to the relative velocity, [length/time].
  void add_kick(int i, int j, const Contact& c, double kick) const {
    step_->add_kick(i, c.bodies().motion_fraction_i() * kick);
    if (j >= 0) step_->add_kick(j, c.bodies().motion_fraction_j() * kick);
  }

  /// Adds D, V and changes of spins to `predicted` of the step.
  void add_predicted(int i, int j, const Contact& c, const PairMotion& change) const {
    add_predicted_i(i, c, change);
    if (j >= 0) add_predicted_j(j, c, change);
  }
  void add_predicted_i(int i, const Contact& c, const PairMotion& change) const {
    add_motion(step_->predicted(i), -c.bodies().motion_fraction_i(), change, change.spin_i);
  }
  void add_predicted_j(int j, const Contact& c, const PairMotion& change) const {
    add_motion(step_->predicted(j), c.bodies().motion_fraction_j(), change, change.spin_j);
  }

  bool is_ghost(int j) const { return j >= nlocal_; }

  /// The fraction of a pair's energies that this process counts: a pair of two processes, or of two
  /// images, is met twice. j < 0: a wall.
  double owned_fraction(int j) const { return j < 0 || j < nlocal_ ? 1.0 : 0.5; }

 private:
  static void add_motion(double* to, double factor, const PairMotion& change,
                         const cohesion::Vector3& spin) {
    add(to, factor, change.relative.separation);
    add(to + 3, factor, change.relative.velocity);
    if (SIZE > 3) add(to + 6, 1.0, spin);
  }

  FixEventStep* step_;
  double kick_;
  int nlocal_;
};

/// Contacts that have lasted and go on to last, where nobody asks what they do: what most contacts
/// of a bed need, and only that, so that memory and motion stay in registers.
template <class Contact, int SIZE>
class LastingForces {
 public:
  LastingForces(Atom* atom, FixEventStep* step)
      : forces_(atom->f[0]),
        torques_(atom->torque[0]),
        kick_(step->impulses.kick()),
        nlocal_(atom->nlocal) {}

  /// False: nothing is done, the contact is to be taken in another way.
  [[gnu::always_inline]] bool apply(const Contact& c, int i, int j,
                                    const cohesion::event_stepping::PairMotion& grid,
                                    double* history) const {
    using namespace cohesion::event_stepping;
    if (history[0] != ContactMemory::lasting) return false;
    ContactMemory memory = ContactMemory::as_stored(history, SIZE);
    memory.phase = ContactMemory::lasting;
    Action action;
    if (!c.one_force().template advance_lasting<SIZE>(grid, memory, action, nullptr)) return false;
    memory.to(history, SIZE);
    const Vector3 pushed = kick_ * action.impulse;
    add(forces_ + 3 * i, -1.0, pushed);
    if (SIZE >= ContactMemory::with_friction) add(torques_ + 3 * i, kick_, action.torque_i);
    if (j >= nlocal_) return true;
    add(forces_ + 3 * j, 1.0, pushed);
    if (SIZE >= ContactMemory::with_friction) add(torques_ + 3 * j, kick_, action.torque_j);
    return true;
  }

 private:
  double* forces_;
  double* torques_;
  double kick_;
  int nlocal_;
};

/// Sampled contacts of which nobody asks what they do, likewise.
template <class Contact, int SIZE>
class SampledForces {
 public:
  SampledForces(Atom* atom, FixEventStep* step)
      : scatter_(atom, step),
        forces_(atom->f),
        torques_(atom->torque),
        kick_(step->impulses.kick()),
        nlocal_(atom->nlocal) {}

  /// Gives whether the contact remembers anything.
  [[gnu::always_inline]] bool apply(const Contact& c, int i, int j,
                                    const cohesion::event_stepping::PairMotion& grid,
                                    double* history) const {
    using namespace cohesion::event_stepping;
    ContactMemory memory = ContactMemory::as_stored(history, SIZE);
    const SampledStep now = c.template compute<SIZE>(grid, memory, nullptr);
    const Action& action = now.action;
    memory.to(history, SIZE);
    add(forces_[i], -kick_, action.impulse);
    if (SIZE >= ContactMemory::with_friction) add(torques_[i], kick_, action.torque_i);
    if (j < nlocal_) {
      add(forces_[j], kick_, action.impulse);
      if (SIZE >= ContactMemory::with_friction) add(torques_[j], kick_, action.torque_j);
    }
    // Behind all else: a call further up costs what it may change.
    if (Contact::pushes_at_edge && now.repulsion == 0.0)
      scatter_.note_sudden(i, j, c, grid.relative.separation, action.impulse);
    return memory.in_range();
  }

 private:
  ContactsOfStep<Contact, SIZE> scatter_;
  double* const* forces_;
  double* const* torques_;
  double kick_;
  int nlocal_;
};

/// A sampled contact acts; gives what it does.
template <int SIZE, class Contact>
cohesion::event_stepping::SampledStep sample(const ContactsOfStep<Contact, SIZE>& scatter,
                                             FixEventStep* step, const Contact& c, int i, int j,
                                             const cohesion::event_stepping::PairMotion& grid,
                                             cohesion::event_stepping::ContactMemory& memory) {
  using namespace cohesion::event_stepping;
  ContactLosses lost;
  SampledStep now =
      c.template compute<SIZE>(grid, memory, step->energy_tally.is_active() ? &lost : nullptr);
  scatter.apply(i, j, now.action);
  if (Contact::pushes_at_edge && now.repulsion == 0.0)
    scatter.note_sudden(i, j, c, grid.relative.separation, now.action.impulse);
  if (step->energy_tally.is_active()) {
    const double fraction = scatter.owned_fraction(j);
    step->energy_tally.store(fraction, c.stored(grid, memory));
    step->energy_tally.add_losses(fraction, {lost.normal_damping, 0.0, 0.0, 0.0}, 0.5);
    step->energy_tally.add_losses(fraction,
                                  {0.0, lost.tangential_damping, lost.friction, lost.rolling}, 0.0);
    const Action half{0.5 * now.action.impulse, 0.5 * now.action.torque_i,
                      0.5 * now.action.torque_j};
    scatter.add_owed_of_tally(i, j, c, half);
  }
  return now;
}

}  // namespace LAMMPS_NS

#endif
