// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact_solver/pair_motion.h"
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

/// What acts on a particle at a time level.
struct ForcesAtLevel {
  Vector3 all, of_contacts, weight;
  Vector3 friction;  ///< sliding friction, part of those of contacts
  Vector3 torque, of_contacts_torque;
};

/// Energies of the contacts of a process, for compute gran/energy: what they store at the time
/// level, what they have lost before it, and the work of other forces.
///
/// The accounts of contacts (energy_account.h) are beside the kinetic energy 1/2 m v_(n-1/2)
/// v_(n+1/2). The velocity of the time level is the mean of both: its kinetic energy is larger by
/// dt^2 F^2/(8 m), which is what the contacts' forces store less.
class EnergySums {
 public:
  void begin_step() {
    add_to(lost_, 1.0, lost_later_);
    lost_later_ = {};
    external.begin_step();
    friction.begin_step();
    stored_ = {};
    motion_ = 0.0;
  }
  /// The time level again, where a run is set up: all forces and stored energies are worked out
  /// again.
  void begin_again() {
    external.begin_again();
    friction.begin_again();
    stored_ = {};
    motion_ = 0.0;
  }

  /// Adds what a contact stores, `fraction` of it.
  void store(double fraction, const StoredEnergies& stored) {
    stored_.tangential_spring += fraction * stored.tangential_spring;
    stored_.rolling_spring += fraction * stored.rolling_spring;
    stored_.load += fraction * stored.load;
    store_normal(fraction, stored);
  }
  /// Where a run goes on from the forces of the last one, what springs in the plane of contact
  /// store is known: the energies of normal springs and adhesion are set to 0 and added again.
  void reset_normal() { stored_.spring = stored_.adhesion = 0.0; }
  void store_normal(double fraction, const StoredEnergies& stored) {
    stored_.spring += fraction * stored.spring;
    stored_.adhesion += fraction * stored.adhesion;
  }
  /// Sets those to what they were at another time, and the load.
  void restore_normal(const StoredEnergies& stored) {
    stored_.spring = stored.spring;
    stored_.adhesion = stored.adhesion;
    stored_.load = stored.load;
  }
  /// Adds what a contact has lost and exchanged, `fraction` of it.
  void lose(double fraction, const ContactEnergies& energies) {
    exchanged_ += fraction * energies.exchanged;
    add_to(lost_, fraction, energies.before);
    add_to(lost_later_, fraction, energies.after);
  }
  /// The same of a persistent contact.
  [[gnu::always_inline]] void lose_persistent(double fraction, const ContactEnergies& energies) {
    const ContactLosses& lost = energies.before;
    lost_.normal_damping += fraction * lost.normal_damping;
    lost_.tangential_damping += fraction * lost.tangential_damping;
    // Zeros that the compiler knows, as without rolling friction, cost nothing.
    if (lost.rolling != 0.0) lost_.rolling += fraction * lost.rolling;
    if (energies.exchanged != 0.0) exchanged_ += fraction * energies.exchanged;
    const double later = energies.after.normal_damping;
    if (later != 0.0) lost_later_.normal_damping += fraction * later;
  }
  /// The same of its normal motion alone.
  void lose_normal(double fraction, const ContactEnergies& energies) {
    exchanged_ += fraction * energies.exchanged;
    lost_.normal_damping += fraction * energies.before.normal_damping;
    lost_later_.normal_damping += fraction * energies.after.normal_damping;
  }
  void lose(const ContactLosses& lost) { add_to(lost_, 1.0, lost); }

  /// Adds the work of other forces than those of contacts and gravity on a particle that moves
  /// freely.
  void add_external_work(const ForcesAtLevel& f, const Passage& passage) {
    external.add(f.all - f.of_contacts - f.weight, f.torque - f.of_contacts_torque, passage);
  }
  /// Adds what is stored beside the kinetic energy of such a particle: nothing in the first step of
  /// a run that continues no other, nor without contacts. `half`: of a step, [time].
  void store_motion(const ForcesAtLevel& f, double inverse_mass, double inverse_inertia,
                    double half) {
    motion_ -= 0.5 * half * half *
               (inverse_mass * dot(2.0 * f.all - f.of_contacts, f.of_contacts) +
                inverse_inertia * dot(2.0 * f.torque - f.of_contacts_torque, f.of_contacts_torque));
  }

  /// Work of other forces but gravity, and of walls; work of friction and rolling friction on all
  /// that they act on.
  WorkOfForces external, friction;

  /// Adds what there was so far to the entries of compute gran/energy.
  void add_so_far(double factor, double* entries) const {
    entries[energy_tally::NORMAL_DAMPING] += factor * lost_.normal_damping;
    entries[energy_tally::TANGENTIAL_DAMPING] += factor * lost_.tangential_damping;
    // What friction removes from the motion goes into springs, dashpots and sliding.
    entries[energy_tally::FRICTION] -=
        factor * (friction.so_far() + stored_.tangential_spring + stored_.rolling_spring +
                  lost_.tangential_damping + lost_.rolling);
    entries[energy_tally::ROLLING] += factor * lost_.rolling;
    entries[energy_tally::EXTERNAL_WORK] += factor * external.so_far();
    entries[energy_tally::SPRING] += factor * exchanged_;
  }
  /// Adds what is stored.
  void add_stored(double* entries) const {
    entries[energy_tally::SPRING] += stored_.spring + stored_.load + motion_;
    entries[energy_tally::TANGENTIAL_SPRING] += stored_.tangential_spring;
    entries[energy_tally::ADHESION] += stored_.adhesion;
    entries[energy_tally::ROLLING_SPRING] += stored_.rolling_spring;
  }

  const StoredEnergies& stored() const { return stored_; }
  /// After the time level.
  const ContactLosses& lost_later() const { return lost_later_; }
  double exchanged() const { return exchanged_; }
  double motion() const { return motion_; }
  /// What a later run needs to go on.
  void restore(const StoredEnergies& stored, const ContactLosses& lost_later, double exchanged) {
    stored_ = stored;
    lost_later_ = lost_later;
    exchanged_ = exchanged;
  }

 private:
  static void add_to(ContactLosses& to, double factor, const ContactLosses& lost) {
    to.normal_damping += factor * lost.normal_damping;
    to.tangential_damping += factor * lost.tangential_damping;
    to.rolling += factor * lost.rolling;
  }

  StoredEnergies stored_{};
  double motion_ = 0.0;     // what 1/2 m v_(n-1/2) v_(n+1/2) of all is more than the kinetic energy
  double exchanged_ = 0.0;  // part of stored.load (ContactEnergies)
  ContactLosses lost_{}, lost_later_{};
};

}  // namespace cohesion::contact_solver
