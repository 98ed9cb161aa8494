// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CONTACT_IMPULSES_H
#define COHESION_CONTACT_IMPULSES_H

#include <vector>

#include "atom.h"
#include "pointers.h"
#include "prefetch.h"
#include "vector3.h"

namespace LAMMPS_NS {

/// What the contacts of a step do to the particles of this process: impulses and angular impulses,
/// which reach the engine as forces and torques. Where somebody asks which part of the engine's
/// forces is theirs, it is what came to be between begin_contacts() and end_contacts(), and what
/// push() adds after that: nothing needs to be added up twice.
class ContactImpulses : protected Pointers {
 public:
  explicit ContactImpulses(LAMMPS* lammps) : Pointers(lammps) {}

  /// Of which of the engine's numbers the part of contacts is known, since somebody asks for it.
  enum class Known { nobody, forces, forces_and_torques };
  /// A step in which an impulse 1 is the force `kick` [1/time].
  void begin_step(double kick, Known known);
  /// Keeps no account until the next step begins, in which no contact acts.
  void disable() { known_ = Known::nobody; }

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
    if (SIZE > 3) add(atom->torque[0] + 3 * i, turned);
    if (!ended_) return;
    add(&forces_[3 * i], pushed);
    if (SIZE > 3 && known_ == Known::forces_and_torques) add(&torques_[3 * i], turned);
  }

  /// Whether contacts that act now have to push(), to be told from what is no contact's.
  bool are_told_apart() const { return ended_; }

  /// Soon something is pushed that has torques, or none.
  template <int SIZE>
  void fetch(int i) const {
    cohesion::prefetch_numbers(atom->f[0] + 3 * i, 3);
    if (SIZE > 3) cohesion::prefetch_numbers(atom->torque[0] + 3 * i, 3);
  }

  /// The force and torque of contacts on particle i, after end_contacts().
  cohesion::Vector3 force(int i) const { return cohesion::vector(&forces_[3 * i]); }
  cohesion::Vector3 torque(int i) const { return cohesion::vector(&torques_[3 * i]); }
  /// The force of all but contacts on particle i, once the engine has all forces of the step; 0
  /// where nobody asks.
  cohesion::Vector3 other_force(int i) const {
    return known_ == Known::nobody ? cohesion::Vector3{} : cohesion::vector(atom->f[i]) - force(i);
  }
  /// The same for all particles, three numbers each.
  void save_other_forces(double* forces) const;

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
  Known known_ = Known::nobody;
  bool ended_ = false;  // and known to somebody
};

}  // namespace LAMMPS_NS

#endif
