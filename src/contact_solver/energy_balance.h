// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact_solver/energy_sums.h"
#include "energy_tally.h"
#include "vector3.h"

namespace cohesion::contact_solver {

/// Mean velocities of a particle around a time level: of the time `length` in which the forces of
/// the time level act, and of the half step after it, of duration `after`, [time].
struct Passage {
  Vector3 velocity, spin;              ///< [length/time], [1/time]
  Vector3 velocity_after, spin_after;  ///< unused if `after` is 0
  double length, after;

  /// Of a step of two halves, without those after the time level: for steps without output.
  static Passage without_output(const Vector3& velocity, const Vector3& spin, double half) {
    return {velocity, spin, {}, {}, 2.0 * half, 0.0};
  }
  /// Of a step of two halves: `kick` and `turn` are the changes of velocity and spin in each.
  static Passage whole(const Vector3& velocity, const Vector3& kick, const Vector3& spin,
                       const Vector3& turn, double half) {
    return {velocity, spin, velocity + kick, spin + turn, 2.0 * half, half};
  }
  /// Of the half step after the time level alone, where a run goes on from the last one with new
  /// forces.
  static Passage second_half(const Vector3& velocity, const Vector3& kick, const Vector3& spin,
                             const Vector3& turn, double half) {
    return {velocity + kick, spin + turn, velocity + kick, spin + turn, half, half};
  }
  /// Of the first step of a run, whose first velocity is that of the time level: the work is that
  /// of the mean velocity.
  static Passage start(const Vector3& velocity, const Vector3& kick, const Vector3& spin,
                       const Vector3& turn, double half) {
    return second_half(velocity, 0.5 * kick, spin, 0.5 * turn, half);
  }
};

/// The work of forces of one kind, [energy]. That of the forces of a time level includes the half
/// step after it, whose share is evaluated only at steps with output.
class WorkOfForces {
 public:
  /// Before the time level.
  double so_far() const { return all_ - later_; }
  /// After it, by the forces of it.
  double later() const { return later_; }

  void begin_step() { later_ = 0.0; }
  /// The forces of this time level are worked out again.
  void begin_again() { restore_later(0.0); }
  void restore_later(double work) {
    all_ += work - later_;
    later_ = work;
  }

  void add(const Vector3& force, const Vector3& torque, const Passage& p) {
    all_ += p.length * (dot(force, p.velocity) + dot(torque, p.spin));
    if (p.after > 0.0)
      later_ += p.after * (dot(force, p.velocity_after) + dot(torque, p.spin_after));
  }
  /// Of something that moves as prescribed.
  void add(double before, double after) {
    all_ += before + after;
    later_ += after;
  }

 private:
  double all_ = 0.0, later_ = 0.0;
};

/// Forces and torques on a particle at a time level.
struct ForcesAtLevel {
  Vector3 all, of_contacts, weight;
  Vector3 friction;  ///< sliding friction, part of those of contacts
  Vector3 torque, of_contacts_torque;
};

/// The work of forces on the particles of a process, and the difference between both kinetic
/// energies.
///
/// Energy accounts (energy_account.h) balance with the kinetic energy 1/2 m v_(n-1/2) v_(n+1/2).
/// The velocity of the time level is the mean of both: its kinetic energy is larger by
/// dt^2 F^2/(8 m). The contacts' forces store that much less.
class ParticleWork {
 public:
  /// Work of other forces but gravity, and of walls; work of friction and rolling friction on all
  /// that they act on.
  WorkOfForces external, friction;

  void begin_step() {
    external.begin_step();
    friction.begin_step();
    motion_ = 0.0;
  }
  /// The time level again, where a run is set up: all forces are worked out again.
  void begin_again() {
    external.begin_again();
    friction.begin_again();
    motion_ = 0.0;
  }
  /// Adds the work of other forces than those of contacts and gravity on a particle that moves
  /// freely.
  void add_external_work(const ForcesAtLevel& f, const Passage& passage) {
    external.add(f.all - f.of_contacts - f.weight, f.torque - f.of_contacts_torque, passage);
  }
  /// Adds the difference between both kinetic energies of such a particle: nothing in the first
  /// step of a run that continues no other, nor without contacts. `half`: of a step, [time].
  void store_motion(const ForcesAtLevel& f, double inverse_mass, double inverse_inertia,
                    double half) {
    motion_ -= 0.5 * half * half *
               (inverse_mass * dot(2.0 * f.all - f.of_contacts, f.of_contacts) +
                inverse_inertia * dot(2.0 * f.torque - f.of_contacts_torque, f.of_contacts_torque));
  }
  /// Excess of 1/2 m v_(n-1/2) v_(n+1/2) over the kinetic energy of the time level, of all.
  double motion() const { return motion_; }

 private:
  double motion_ = 0.0;
};

/// Adds losses and work up to the time level to the entries of compute gran/energy.
inline void add_so_far(const EnergySums& sums, const ParticleWork& work, double factor,
                       double* entries) {
  const ContactLosses& lost = sums.lost();
  entries[energy_tally::NORMAL_DAMPING] += factor * lost.normal_damping;
  entries[energy_tally::TANGENTIAL_DAMPING] += factor * lost.tangential_damping;
  // What friction removes from the motion goes into springs, dashpots and sliding.
  entries[energy_tally::FRICTION] -=
      factor * (work.friction.so_far() + sums.stored().tangential_spring +
                sums.stored().rolling_spring + lost.tangential_damping + lost.rolling);
  entries[energy_tally::ROLLING] += factor * lost.rolling;
  entries[energy_tally::EXTERNAL_WORK] += factor * work.external.so_far();
  entries[energy_tally::SPRING] += factor * sums.exchanged();
}

/// Adds stored energies.
inline void add_stored(const EnergySums& sums, const ParticleWork& work, double* entries) {
  const StoredEnergies& stored = sums.stored();
  entries[energy_tally::SPRING] += stored.spring + stored.load + work.motion();
  entries[energy_tally::TANGENTIAL_SPRING] += stored.tangential_spring;
  entries[energy_tally::ADHESION] += stored.adhesion;
  entries[energy_tally::ROLLING_SPRING] += stored.rolling_spring;
}

}  // namespace cohesion::contact_solver
