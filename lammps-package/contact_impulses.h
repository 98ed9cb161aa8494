// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CONTACT_IMPULSES_H
#define COHESION_CONTACT_IMPULSES_H

#include <vector>

#include "atom.h"
#include "pointers.h"
#include "vector3.h"

namespace LAMMPS_NS {

/// What the contacts of a step do to the particles of this process: impulses and angular impulses,
/// which reach the engine as forces and torques.
class ContactImpulses : protected Pointers {
 public:
  explicit ContactImpulses(LAMMPS* lammps) : Pointers(lammps) {}

  /// A step in which an impulse 1 is the force `kick` [1/time]; `summed`: somebody needs the sums.
  void begin_step(double kick, bool summed);
  /// Nothing acts until the next step begins.
  void rest() { summed_ = false; }

  /// Force that gives a particle the impulse 1 in this step, [1/time].
  double kick() const { return kick_; }
  /// On particle i.
  template <int SIZE>
  [[gnu::always_inline]] void push(int i, const cohesion::Vector3& pushed,
                                   const cohesion::Vector3& turned) {
    if (summed_) {
      impulses_[i] += pushed;
      if (SIZE > 3) turns_[i] += turned;
    }
    if (!handed_over_) return;
    add(atom->f[i], pushed);
    if (SIZE > 3) add(atom->torque[i], turned);
  }
  /// The sums, per particle; hand_over() brings to the engine what was added to them before it.
  std::vector<cohesion::Vector3>& impulses() { return impulses_; }
  std::vector<cohesion::Vector3>& turns() { return turns_; }
  /// What contacts do from now on goes to the engine at once.
  void hand_over(bool what_was_summed);

  /// The force of all but contacts on particle i, once the engine has all forces of the step; 0
  /// where nothing was summed.
  cohesion::Vector3 others(int i) const {
    return summed_ ? cohesion::vector(atom->f[i]) - kick_ * impulses_[i] : cohesion::Vector3{};
  }
  /// The same for all particles, three numbers each.
  void note_others(double* forces) const;

  double bytes() const {
    return static_cast<double>(sizeof(cohesion::Vector3)) *
           static_cast<double>(impulses_.capacity() + turns_.capacity());
  }

 private:
  void add(double* to, const cohesion::Vector3& a) const {
    to[0] += kick_ * a.x;
    to[1] += kick_ * a.y;
    to[2] += kick_ * a.z;
  }

  std::vector<cohesion::Vector3> impulses_, turns_;
  double kick_ = 0.0;
  bool summed_ = false;
  bool handed_over_ = false;
};

}  // namespace LAMMPS_NS

#endif
