// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CONTACT_ENERGY_TALLY_H
#define COHESION_CONTACT_ENERGY_TALLY_H

#include <array>
#include <memory>

#include "event_stepping/pair_motion.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// Energies that contacts store at the time level and have lost before it, and the true motion
/// there, of one process. It is active while somebody reads it, who subtracts what was there
/// before, and in steps that a later run may continue from.
class ContactEnergyTally : protected Pointers {
 public:
  using Reader = std::shared_ptr<const void>;
  /// All [energy].
  struct Sums {
    cohesion::event_stepping::StoredEnergies stored{};
    cohesion::event_stepping::ContactLosses lost{};  ///< so far
    double external_work = 0.0;  ///< of other forces but gravity, and moving walls; so far
  };

  explicit ContactEnergyTally(LAMMPS*);
  ~ContactEnergyTally() override;
  ContactEnergyTally(const ContactEnergyTally&) = delete;
  ContactEnergyTally& operator=(const ContactEnergyTally&) = delete;

  /// What a reader holds as long as the tally is to be active.
  [[nodiscard]] Reader add_reader() const { return readers_; }
  bool has_readers() const { return readers_.use_count() > 1; }
  bool is_active() const { return active_; }
  const Sums& sums() const { return now_; }

  /// Sets whether it is active in this step.
  void update_readers();
  /// Begins a new time level: losses after the last one are losses before this one.
  void begin_step();
  /// Adds what a contact stores, `fraction` of it.
  void store(double fraction, const cohesion::event_stepping::StoredEnergies&);
  /// Where a run goes on from the forces of the last one, what springs in the plane of contact
  /// store is known: the energies of normal springs and adhesion are set to 0 and added again.
  void reset_normal();
  void store_normal(double fraction, const cohesion::event_stepping::StoredEnergies&);
  /// Adds what a contact loses, `fraction` of it, of which `later` is after the time level.
  void add_losses(double fraction, const cohesion::event_stepping::ContactLosses&, double later);
  /// Adds work of other forces in the step around the time level.
  void add_work(double done);

  /// Per atom and ghost: pending corrections of all contacts, three numbers from the staggered to
  /// the true velocity and three of the spin.
  double** pending() const { return pending_; }
  /// Ends the step of a particle: `pushed` and `turned` are the impulse and angular impulse of
  /// contacts that are in the engine's velocities by then.
  void end_step(int i, const cohesion::event_stepping::Body&, const cohesion::Vector3& pushed,
                const cohesion::Vector3& turned);
  /// The true motion of a particle after end_step().
  cohesion::Vector3 true_velocity(int i) const;
  cohesion::Vector3 true_spin(int i) const;

  /// What a later run needs to go on: of a particle, six numbers; of all particles, seven.
  static constexpr int OF_PARTICLE = 6;
  using Totals = std::array<double, 7>;
  void save_motion(int i, double* values) const;
  void restore_motion(int i, const double* values);
  Totals totals() const;
  void restore_totals(const Totals&);

  double bytes() const;

 private:
  bool active_ = false;
  Sums now_, later_;  // later_: after the time level
  int room_ = 0;      // of both arrays, in particles
  double** pending_ = nullptr;
  double** to_truth_ = nullptr;  // from the engine's velocity and spin at the end of the step
  Reader readers_;
};

}  // namespace LAMMPS_NS

#endif
