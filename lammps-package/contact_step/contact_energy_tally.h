// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CONTACT_ENERGY_TALLY_H
#define COHESION_CONTACT_ENERGY_TALLY_H

#include <cstddef>
#include <memory>
#include <vector>

#include "contact_solver/energy_sums.h"

namespace LAMMPS_NS {

/// Energies that contacts store at the time level and have lost before it, of one process. It sums
/// up losses as long as it has readers, who subtract the sums of the time before. What is
/// stored is evaluated at the time levels that an output reads and in steps that a later run may
/// continue from.
class ContactEnergyTally : public cohesion::contact_solver::EnergySums {
 public:
  using Reader = std::shared_ptr<const void>;

  /// What a reader holds as long as the tally is to be active.
  [[nodiscard]] Reader add_reader() const { return readers_; }
  bool has_readers() const { return readers_.use_count() > 1; }
  bool is_active() const { return active_; }
  /// Whether stored energies are evaluated in this step.
  bool is_read() const { return read_; }

  /// Sets whether it is active in this step. `read`: by an output, or by a later run.
  void update_readers(bool may_be_continued, bool read) {
    active_ = may_be_continued || has_readers();
    read_ = may_be_continued || (active_ && read);
  }
  /// Begins a new time level: losses after the last one are losses before this one.
  void begin_step(int particles) {
    if (!active_) return;
    EnergySums::begin_step();
    friction_.assign(particles, {});
  }
  /// Adds what a contact loses, and in a step that is read what it stores, `fraction` of it.
  void add(double fraction, const cohesion::contact_solver::ContactEnergies& energies) {
    if (read_) store(fraction, energies.stored);
    lose(fraction, energies);
  }
  /// Adds an impulse of sliding friction on particle j of this process, or on i by the reverse.
  [[gnu::always_inline]] void add_friction(std::ptrdiff_t j, const cohesion::Vector3& impulse) {
    friction_[j] += impulse;
  }
  [[gnu::always_inline]] void subtract_friction(std::ptrdiff_t i,
                                                const cohesion::Vector3& impulse) {
    friction_[i] -= impulse;
  }
  /// The sum of those, [momentum].
  const cohesion::Vector3& friction_on(int i) const { return friction_[i]; }

 private:
  bool active_ = false, read_ = false;
  std::vector<cohesion::Vector3> friction_;  // on each particle, [momentum]
  Reader readers_ = std::make_shared<char>();
};

}  // namespace LAMMPS_NS

#endif
