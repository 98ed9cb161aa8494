// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact_solver/pair_motion.h"

namespace cohesion::contact_solver {

/// Energies of the contacts of a process: what they store at the time level, and what they have
/// lost before it.
class EnergySums {
 public:
  void begin_step() {
    add_to(lost_, 1.0, lost_later_);
    lost_later_ = {};
    stored_ = {};
  }
  /// The time level again, where a run is set up: all stored energies are worked out again.
  void begin_again() { stored_ = {}; }

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

  const StoredEnergies& stored() const { return stored_; }
  /// Before the time level.
  const ContactLosses& lost() const { return lost_; }
  /// After it.
  const ContactLosses& lost_later() const { return lost_later_; }
  double exchanged() const { return exchanged_; }
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
  double exchanged_ = 0.0;  // part of stored.load (ContactEnergies)
  ContactLosses lost_{}, lost_later_{};
};

}  // namespace cohesion::contact_solver
