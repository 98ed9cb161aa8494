// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_SAMPLED_ENERGY_TALLY_H
#define COHESION_SAMPLED_ENERGY_TALLY_H

#include <vector>

#include "contact/sampled_work.h"
#include "contact_interface.h"
#include "integrated_particles.h"
#include "lammps.h"
#include "lmptype.h"

namespace LIGGGHTS {
namespace Cohesion {

/// Energy of an attraction, as its law has it.
class AttractionEnergy {
 public:
  virtual ~AttractionEnergy() = default;
  /// Of two types and radii at `gap` [length]; rj infinite: beside a wall. inside: what the model
  /// remembers of the contact. [energy]
  virtual double energy(int itype, int jtype, double ri, double rj, double gap,
                        bool inside) const = 0;
};

/// Where the engine's other models keep what a contact remembers.
struct HistoryPlaces {
  int displacement = -1;  ///< of the tangential spring; negative: none
  int rolling = -1;       ///< torque of the rolling spring; negative: none
};

/// A contact at the grid point, as the engine's models, ours included, have computed it.
cohesion::contact::ContactSample contact_of(const ContactModels::SurfacesIntersectData&,
                                            const ContactModels::ForceData& on_i,
                                            const ContactModels::ForceData& on_j, double exponent,
                                            const HistoryPlaces&);

/// What sampled contacts store and have taken, for compute gran/energy. The models write down each
/// contact of a step; when the step is over and all velocities are known, its energies are computed
/// (contact/sampled_work.h).
class SampledEnergyTally {
 public:
  explicit SampledEnergyTally(LAMMPS_NS::LAMMPS* lmp) : lmp_(lmp) {}

  /// A contact as a model sees it, and whose attraction acts in it.
  struct Entry {
    cohesion::contact::ContactSample contact;
    const AttractionEnergy* law;  ///< null: none acts
    bool inside;
  };
  void write(const ContactModels::SurfacesCloseData&, const Entry&);

  /// At the end of a step; at the set-up of a run, of the half step before the first.
  void end_step(bool set_up);

  double spring = 0.0, tangential_spring = 0.0, adhesion = 0.0, rolling_spring = 0.0;
  double external_work() const { return external_work_; }
  double normal_damping() const { return lost_.normal_damping; }
  double tangential_damping() const { return lost_.tangential_damping; }
  /// Lost in sliding, and with springs whose contact ended: what no other entry has.
  double friction() const {
    return lost_.tangential - lost_.tangential_damping - (tangential_spring - at_begin_);
  }
  /// Lost in rolling: what its spring does not have.
  double rolling() const { return lost_.rolling - (rolling_spring - rolling_at_begin_); }

 private:
  struct Record {
    Entry entry;
    cohesion::contact::Motion before;
    int i, j;  // j negative: a wall
    int itype, jtype;
    double ri, rj;
    double owned_fraction;  // 0.5 of a pair that another rank, or an image of itself, has as well
  };
  cohesion::contact::Moving moving(int particle) const;
  void work_out(const Record&, const MobileParticles&, bool set_up, cohesion::contact::Losses&,
                double& external);
  double work_of_fixes(const MobileParticles&) const;

  LAMMPS_NS::LAMMPS* lmp_;
  std::vector<Record> records_;
  std::vector<cohesion::Vector3> force_, torque_;  // of contacts, on each particle of this rank
  cohesion::contact::Losses lost_, last_;          // last: per time, of the last step
  double external_work_ = 0.0, last_external_ = 0.0;
  double at_begin_ = 0.0, rolling_at_begin_ = 0.0;
  double last_half_ = 0.0;
  LAMMPS_NS::bigint last_step_ = -1;
  bool begun_ = false;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
