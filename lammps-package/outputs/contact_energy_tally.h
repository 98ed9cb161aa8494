// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CONTACT_ENERGY_TALLY_H
#define COHESION_CONTACT_ENERGY_TALLY_H

#include <array>
#include <memory>
#include <vector>

#include "contact_solver/pair_motion.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// Energies that contacts store at the time level and have lost before it, of one process. It is
/// active while somebody reads it, who subtracts what was there before, and in steps that a later
/// run may continue from.
class ContactEnergyTally : protected Pointers {
 public:
  using Reader = std::shared_ptr<const void>;
  /// All [energy].
  struct Sums {
    cohesion::contact_solver::StoredEnergies stored{};
    cohesion::contact_solver::ContactLosses lost{};  ///< so far
    double external_work = 0.0;  ///< of other forces but gravity, and moving walls; so far
    double friction_work = 0.0;  ///< of friction and rolling friction on the particles; so far
    double exchanged = 0.0;      ///< part of stored.load (ContactEnergies); so far
  };

  explicit ContactEnergyTally(LAMMPS*);

  /// What a reader holds as long as the tally is to be active.
  [[nodiscard]] Reader add_reader() const { return readers_; }
  bool has_readers() const { return readers_.use_count() > 1; }
  bool is_active() const { return active_; }
  const Sums& sums() const { return now_; }

  /// Sets whether it is active in this step.
  void update_readers();
  /// Begins a new time level: losses after the last one are losses before this one.
  void begin_step();
  /// Adds what a contact stores and has exchanged, `fraction` of it.
  void store(double fraction, const cohesion::contact_solver::ContactEnergies&);
  /// Where a run goes on from the forces of the last one, what springs in the plane of contact
  /// store is known: the energies of normal springs and adhesion are set to 0 and added again.
  void reset_normal();
  void store_normal(double fraction, const cohesion::contact_solver::StoredEnergies&);
  /// Adds what a contact loses, `fraction` of it, of which `later` is after the time level.
  void add_losses(double fraction, const cohesion::contact_solver::ContactLosses&, double later);
  /// Adds work of other forces, or of friction, in the step around the time level.
  void add_work(double done);
  void add_friction_work(double done);
  /// Adds a force of sliding friction on particle i of this process.
  void add_friction(int i, const cohesion::Vector3& on_it) { friction_[i] += on_it; }

  /// What acts on a particle at a time level.
  struct Forces {
    cohesion::Vector3 all, of_contacts, weight;
    cohesion::Vector3 torque, of_contacts_torque;
  };
  /// Ends the step of particle i, of which `half` [time] is half: adds the work of its forces. The
  /// engine has v_n and spins of the time level. starts: the first step of a run, half of one.
  void end_step(int i, const cohesion::contact_solver::Body&, const Forces&, double half,
                bool starts);

  /// What a later run needs to go on.
  using Totals = std::array<double, 10>;
  Totals totals() const;
  void restore_totals(const Totals&);

 private:
  bool active_ = false;
  Sums now_, later_;                         // later_: after the time level
  std::vector<cohesion::Vector3> friction_;  // on each particle, [force]
  Reader readers_;
};

}  // namespace LAMMPS_NS

#endif
