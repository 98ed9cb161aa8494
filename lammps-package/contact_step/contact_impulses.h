// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CONTACT_IMPULSES_H
#define COHESION_CONTACT_IMPULSES_H

#include <vector>

#include "atom.h"
#include "contact_solver/contact_history.h"
#include "pointers.h"
#include "vector3.h"

namespace LAMMPS_NS {

/// Adds the impulses and angular impulses of the contacts of a step to the forces and torques of
/// the engine. If an output needs the contacts' share of these, it is the difference between
/// begin_contacts() and end_contacts(), plus the later calls of push().
class ContactImpulses : protected Pointers {
 public:
  using ContactHistory = cohesion::contact_solver::ContactHistory;

  explicit ContactImpulses(LAMMPS* lammps) : Pointers(lammps) {}

  /// Begins a step. `kick` [1/time]: the force that represents a unit impulse; `known`: whether an
  /// output needs the contacts' share of the engine's forces and torques.
  void begin_step(double kick, bool known);
  /// Stores no share until the next step begins; no contact acts in between.
  void disable() { known_ = false; }

  /// Between these two calls only contacts add to the engine's forces.
  void begin_contacts();
  void end_contacts();

  /// Force that represents a unit impulse in this step, [1/time].
  double kick() const { return kick_; }
  /// Adds an impulse and an angular impulse on particle i.
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

  // Between begin_contacts() and end_contacts() the engine's values at begin_contacts(), empty if
  // all were 0; after end_contacts() the contacts' share.
  Numbers forces_, torques_;
  double kick_ = 0.0;
  bool known_ = false;
  bool ended_ = false;  // and an output needs the share
};

}  // namespace LAMMPS_NS

#endif
