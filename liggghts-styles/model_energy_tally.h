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

  /// Adds a contact that touches, as the engine's models, those of this package included, have
  /// computed it. Sampled: with the energy of its adhesion; exact: with what its normal motion
  /// stores and loses.
  void add_sampled(const ContactModels::SurfacesIntersectData&,
                   const ContactModels::ForceData& on_i, const ContactModels::ForceData& on_j,
                   double exponent, const OtherModels&, double adhesion);
  void add_exact(const ContactModels::SurfacesIntersectData&, const ContactModels::ForceData& on_i,
                 const ContactModels::ForceData& on_j, const OtherModels&,
                 const cohesion::contact_solver::ContactEnergies& of_normal);
  /// The same across a gap.
  void add_sampled(const ContactModels::SurfacesCloseData&, const ContactModels::ForceData& on_i,
                   double adhesion);
  void add_exact(const ContactModels::SurfacesCloseData&, const ContactModels::ForceData& on_i,
                 const cohesion::contact_solver::ContactEnergies& of_normal);

  /// Before and after the engine has computed all pairs, which add their forces in between.
  void begin_pairs() { add_engine_forces(-1.0); }
  void end_pairs() { add_engine_forces(1.0); }

  /// Before the forces of a step, or of the set-up of a run, which is always read. others_act:
  /// whether anything but contacts and gravity exerts forces in this run.
  void begin_step(bool is_read);
  void begin_set_up(bool others_act);
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
  /// What contacts do to a particle, for the work that depends on the velocity after the step.
  struct OnParticle {
    cohesion::Vector3 friction;                 // of the tangential spring, dashpot and slider
    cohesion::Vector3 dashpot, dashpot_torque;  // of the tangential dashpot
    cohesion::Vector3 normal_dashpot;           // of sampled contacts
  };
  struct ForceAndTorque {
    cohesion::Vector3 force, torque;
  };
  using Vector3 = cohesion::Vector3;
  using WorkOfForces = cohesion::contact_solver::WorkOfForces;

  void clear();
  void add_friction(const ContactModels::SurfacesIntersectData&,
                    const ContactModels::ForceData& on_i, const ContactModels::ForceData& on_j,
                    const cohesion::contact::ContactSample&, const OtherModels&,
                    const Vector3& normal_dashpot);
  // Vectors by value: what has an address does not stay in registers.
  void add_rolling(const ContactModels::SurfacesIntersectData&,
                   const ContactModels::ForceData& on_i, const ContactModels::ForceData& on_j,
                   Vector3 normal, Vector3 tangential);
  void add_wall(const ContactModels::SurfacesCloseData&, const ContactModels::ForceData& on_i,
                Vector3 friction = {}, Vector3 tangential_dashpot = {},
                Vector3 normal_dashpot = {});
  void add_engine_forces(double factor);
  bool is_own_pair(const ContactModels::SurfacesCloseData& d) const {
    return !d.is_wall && d.j < particles_;
  }
  double owned_fraction(const ContactModels::SurfacesCloseData&) const;
  void add_work_of_contacts(int i, const cohesion::contact_solver::ForcesAtLevel&, bool moves,
                            bool turns, const cohesion::contact_solver::Passage&);
  void end_without_others();
  template <class MakePassage>
  void end(MakePassage make_passage, bool starts);
  void add_work_of_walls(double before);
  void add_so_far(double factor, double* entries) const;

  LAMMPS_NS::LAMMPS* lmp_;
  IntegratedParticles mobile_{lmp_};
  int particles_ = 0;  // of this process
  std::vector<OnParticle> on_;
  std::vector<Vector3> rolling_torque_;      // against rolling, on each particle
  std::vector<ForceAndTorque> of_contacts_;  // on each particle; unused where no others act
  cohesion::contact_solver::EnergySums sums_;
  // Of normal springs and adhesion of sampled contacts; as a set-up begins, of others.
  cohesion::contact_solver::StoredEnergies sampled_{}, last_{};
  WorkOfForces normal_dashpot_, tangential_dashpot_, rolling_;
  // Power of walls that move, by the same kinds of forces and by all of them, [energy/time].
  double wall_all_ = 0.0, wall_friction_ = 0.0, wall_normal_dashpot_ = 0.0,
         wall_tangential_dashpot_ = 0.0;
  bool is_read_ = true;
  bool others_act_ = true;
  bool begun_ = false;
  double before_[cohesion::energy_tally::ENTRIES] = {};  // what there was when the tally began
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
