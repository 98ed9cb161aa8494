// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_MODEL_ENERGY_TALLY_H
#define COHESION_MODEL_ENERGY_TALLY_H

#include <cstddef>
#include <vector>

#include "contact/sampled_energies.h"
#include "contact_interface.h"
#include "contact_solver/energy_balance.h"
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
  double exponent = 1.0;  ///< p of F ~ x^p of the normal spring
};

/// The energies of the contacts of this process, for compute gran/energy. The models add each
/// contact of a step; what its forces work is known when the step is over and all velocities are.
class ModelEnergyTally {
 public:
  explicit ModelEnergyTally(LAMMPS_NS::LAMMPS* lmp) : lmp_(lmp) {}

  /// Whether an output reads this time level. What contacts store is known only there.
  bool is_read() const { return is_read_; }

  /// Adds the forces of a contact that touches, as the engine's models, those of this package
  /// included, have computed them. of_normal: what its normal motion loses by an energy account;
  /// null: it is sampled.
  void add(const ContactModels::SurfacesIntersectData&, const ContactModels::ForceData& on_i,
           const ContactModels::ForceData& on_j, const OtherModels&,
           const cohesion::contact_solver::ContactEnergies* of_normal);
  /// Adds what it stores, at a time level that an output reads. stored: of its normal motion.
  void store(const ContactModels::SurfacesIntersectData&, const OtherModels&,
             cohesion::contact_solver::StoredEnergies stored);
  void store_sampled(const ContactModels::SurfacesIntersectData&, const OtherModels&,
                     double adhesion);
  /// Adds a contact across a gap.
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
  using Vector3 = cohesion::Vector3;
  using WorkOfForces = cohesion::contact_solver::WorkOfForces;
  using ForcesAtLevel = cohesion::contact_solver::ForcesAtLevel;

  using ContactPowers = cohesion::contact::ContactPowers;

  /// A contact of this step.
  struct Touching {
    int i, j;                                 ///< j < 0: a wall, or a particle of another process
    cohesion::contact::SampledForces forces;  ///< without a normal dashpot: of scheme exact
  };
  struct ForceAndTorque {
    Vector3 force, torque;
  };

  void clear();
  [[gnu::noinline, gnu::cold]] void grow_and_add(
      const ContactModels::SurfacesIntersectData&, const ContactModels::ForceData& on_i,
      const ContactModels::ForceData& on_j, const OtherModels&,
      const cohesion::contact_solver::ContactEnergies* of_normal);
  [[gnu::noinline]] void add_rare(const ContactModels::SurfacesIntersectData&,
                                  const ContactModels::ForceData& on_i,
                                  const ContactModels::ForceData& on_j, const OtherModels&);
  void add_rolling(const ContactModels::SurfacesIntersectData&,
                   const ContactModels::ForceData& on_i, const ContactModels::ForceData& on_j,
                   const Touching&);
  void add_wall(const ContactModels::SurfacesCloseData&, const ContactModels::ForceData& on_i);
  void add_wall(const ContactModels::SurfacesCloseData&, const ContactModels::ForceData& on_i,
                const Touching&);
  void add_engine_forces(double factor);
  bool is_own_pair(const ContactModels::SurfacesCloseData& d) const {
    return !d.is_wall && d.j < particles_;
  }
  double owned_fraction(const ContactModels::SurfacesCloseData&) const;
  template <class MotionOf>
  ContactPowers powers(MotionOf motion_of) const;
  void add_work(const ContactPowers&, double length, const ContactPowers& after_level,
                double after);
  ForcesAtLevel forces_on(int i, const Vector3& weight) const;
  void add_external_work(int i, const ForcesAtLevel&, const cohesion::contact_solver::Passage&);
  void end_unread();
  template <class MakePassage>
  void end_read(MakePassage make_passage, bool starts);
  void add_work_of_walls(double before);
  void add_so_far(double factor, double* entries) const;

  LAMMPS_NS::LAMMPS* lmp_;
  IntegratedParticles mobile_{lmp_};
  int particles_ = 0;               // of this process
  std::vector<Touching> touching_;  // the first contacts_ of them
  std::size_t contacts_ = 0;
  std::vector<Vector3> rolling_torque_;      // against rolling, on each particle
  std::vector<ForceAndTorque> of_contacts_;  // on each particle; unused where no others act
  cohesion::contact_solver::EnergySums sums_;
  cohesion::contact_solver::ParticleWork work_;
  // Of normal springs and adhesion of sampled contacts; as a set-up begins, of others.
  cohesion::contact_solver::StoredEnergies sampled_{}, last_{};
  WorkOfForces normal_dashpot_, tangential_dashpot_, rolling_;
  ContactPowers walls_;         // of walls that move
  double work_of_walls_ = 0.0;  // power of walls that move, by all forces, [energy/time]
  bool is_read_ = true;
  bool others_act_ = true;
  bool begun_ = false;
  double before_[cohesion::energy_tally::ENTRIES] = {};  // what there was when the tally began
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
