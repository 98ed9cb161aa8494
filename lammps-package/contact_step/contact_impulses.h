// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CONTACT_IMPULSES_H
#define COHESION_CONTACT_IMPULSES_H

#include <vector>

#include "atom.h"
#include "contact_solver/contact_history.h"
#include "pointers.h"
#include "vector3.h"

namespace LAMMPS_NS {

/// What the contacts of a step do to the particles of this process: impulses and angular impulses,
/// which reach the engine as forces and torques. Where somebody asks which part of the engine's
/// forces is theirs, it is what came to be between begin_contacts() and end_contacts(), and what
/// push() adds after that: nothing needs to be added up twice.
class ContactImpulses : protected Pointers {
 public:
  using ContactHistory = cohesion::contact_solver::ContactHistory;

  explicit ContactImpulses(LAMMPS* lammps) : Pointers(lammps) {}

  /// A step in which an impulse 1 is the force `kick` [1/time]; known: whether somebody asks which
  /// part of the engine's forces and torques is of contacts.
  void begin_step(double kick, bool known);
  /// Keeps no account until the next step begins, in which no contact acts.
  void disable() { known_ = false; }

  /// Between these two nothing but contacts adds to the engine's forces.
  void begin_contacts();
  void end_contacts();

  /// Force that gives a particle the impulse 1 in this step, [1/time].
  double kick() const { return kick_; }
  /// On particle i.
  template <int SIZE>
  [[gnu::always_inline]] void push(int i, const cohesion::Vector3& pushed,
                                   const cohesion::Vector3& turned) {
    add(atom->f[0] + 3 * i, pushed);
    if (SIZE >= ContactHistory::with_friction) add(atom->torque[0] + 3 * i, turned);
    if (!ended_) return;
    add(&forces_[3 * i], pushed);
    if (SIZE >= ContactHistory::with_friction) add(&torques_[3 * i], turned);
  }

  /// The force and torque of contacts on particle i, after end_contacts().
  cohesion::Vector3 force(int i) const { return cohesion::vector(&forces_[3 * i]); }
  cohesion::Vector3 torque(int i) const { return cohesion::vector(&torques_[3 * i]); }
  /// The force of all but contacts on particle i, once the engine has all forces of the step; 0
  /// where nobody asks.
  cohesion::Vector3 other_force(int i) const {
    return known_ ? cohesion::vector(atom->f[i]) - force(i) : cohesion::Vector3{};
  }
  double bytes() const {
    return static_cast<double>(sizeof(double)) *
           static_cast<double>(forces_.capacity() + torques_.capacity());
  }

 private:
  void add(double* to, const cohesion::Vector3& a) const {
    to[0] += kick_ * a.x;
    to[1] += kick_ * a.y;
    to[2] += kick_ * a.z;
  }

  using Numbers = std::vector<double>;  // three of each particle
  static void store_other(Numbers& before, const double* const* now, int particles);
  static void subtract_other(Numbers& before, const double* const* now, int particles);

  // After end_contacts() those of contacts; between begin_contacts() and end_contacts() the
  // engine's at begin_contacts(), or none where those were 0.
  Numbers forces_, torques_;
  double kick_ = 0.0;
  bool known_ = false;
  bool ended_ = false;  // and known to somebody
};

}  // namespace LAMMPS_NS

#endif
