// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_MODEL_ENERGY_TALLY_H
#define COHESION_MODEL_ENERGY_TALLY_H

#include <vector>

#include "contact/sampled_energies.h"
#include "contact_interface.h"
#include "contact_solver/energy_sums.h"
#include "energy_tally.h"
#include "integrated_particles.h"
#include "lammps.h"

namespace LIGGGHTS {
namespace Cohesion {

/// What of the engine's other models a contact has.
struct OtherModels {
  int displacement = -1;  ///< where the contact keeps that of the tangential spring; negative: none
  int rolling = -1;       ///< where it keeps the torque of the rolling spring; negative: none
  bool rolls = false;     ///< whether there is rolling friction
};

/// The energies of the contacts of this process, for compute gran/energy. The models add each
/// contact of a step; what its forces work is known when the step is over and all velocities are.
class ModelEnergyTally {
 public:
  explicit ModelEnergyTally(LAMMPS_NS::LAMMPS* lmp) : lmp_(lmp) {}

  /// Whether an output reads this time level. What contacts store is known only there.
  bool is_read() const { return is_read_; }

  /// Adds a contact of which spring and dashpot are sampled, with the energy of its adhesion.
  void add_sampled(const ContactModels::SurfacesCloseData&, const cohesion::contact::ContactSample&,
                   double adhesion);
  /// Adds a contact with an energy account: what its normal motion stores and loses. The rest is of
  /// friction and rolling friction.
  void add_exact(const ContactModels::SurfacesCloseData&, const cohesion::contact::ContactSample&,
                 const cohesion::contact_solver::ContactEnergies& of_normal);

  /// The same of contacts that touch, as the engine's models, those of this package included, have
  /// computed them.
  void add_sampled(const ContactModels::SurfacesIntersectData&,
                   const ContactModels::ForceData& on_i, const ContactModels::ForceData& on_j,
                   double exponent, const OtherModels&, double adhesion);
  void add_exact(const ContactModels::SurfacesIntersectData&, const ContactModels::ForceData& on_i,
                 const ContactModels::ForceData& on_j, const OtherModels&,
                 const cohesion::contact_solver::ContactEnergies& of_normal);

  /// Before and after the engine has computed all pairs, which add their forces in between.
  void begin_pairs() { add_engine_forces(-1.0); }
  void end_pairs() { add_engine_forces(1.0); }

  /// Before the forces of a step, or of the set-up of a run, which is always read.
  void begin_step(bool is_read);
  void begin_set_up();
  void end_step();
  /// starts: energy accounts begin anew; known: the tally has the energies of the time level from
  /// the last step, of contacts that repeat their force.
  void end_set_up(bool starts, bool known);

  void add_to(double* entries) const;

  /// What a later run needs to go on.
  static constexpr int TOTALS = 5;
  void store_totals(double* values) const;
  void restore_totals(const double* values);

 private:
  /// What contacts do to a particle.
  struct OnParticle {
    cohesion::Vector3 force, torque;            // all of it
    cohesion::Vector3 friction;                 // of the tangential spring, dashpot and slider
    cohesion::Vector3 dashpot, dashpot_torque;  // of the tangential dashpot
  };
  using WorkOfForces = cohesion::contact_solver::WorkOfForces;

  void clear();
  void add_of_sampled(const ContactModels::SurfacesCloseData&,
                      const cohesion::contact::ContactSample&, double adhesion);
  void add_of_exact(const ContactModels::SurfacesCloseData&,
                    const cohesion::contact::ContactSample&,
                    const cohesion::contact_solver::ContactEnergies& of_normal);
  void add_forces(const ContactModels::SurfacesCloseData&, const cohesion::contact::ContactSample&);
  void add_rolling(const ContactModels::SurfacesCloseData&,
                   const cohesion::contact::ContactSample&);
  void add_normal_dashpot(const ContactModels::SurfacesCloseData&,
                          const cohesion::Vector3& dashpot);
  void add_wall(const ContactModels::SurfacesCloseData&, const cohesion::contact::ContactSample&,
                const cohesion::Vector3& dashpot);
  void add_engine_forces(double factor);
  bool is_own_pair(const ContactModels::SurfacesCloseData& d) const {
    return !d.is_wall && d.j < lmp_->atom->nlocal;
  }
  double owned_fraction(const ContactModels::SurfacesCloseData&) const;
  template <class MakePassage>
  void end(MakePassage make_passage, double before, bool starts);
  void add_so_far(double factor, double* entries) const;

  LAMMPS_NS::LAMMPS* lmp_;
  std::vector<OnParticle> on_;
  std::vector<cohesion::Vector3> rolling_torque_;        // against rolling, on each particle
  std::vector<cohesion::Vector3> normal_dashpot_force_;  // of sampled contacts, on each particle
  cohesion::contact_solver::EnergySums sums_;
  // Of normal springs and adhesion of sampled contacts; as a set-up begins, of others.
  cohesion::contact_solver::StoredEnergies sampled_{}, last_{};
  WorkOfForces normal_dashpot_, tangential_dashpot_, rolling_;
  // Power of walls that move, by the same kinds of forces and by all of them, [energy/time].
  double wall_all_ = 0.0, wall_friction_ = 0.0, wall_normal_dashpot_ = 0.0,
         wall_tangential_dashpot_ = 0.0;
  bool is_read_ = true;
  bool begun_ = false;
  double before_[cohesion::energy_tally::ENTRIES] = {};  // what there was when the tally began
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
