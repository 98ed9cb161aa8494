// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_FIX_ACCELERATIONS_H
#define COHESION_FIX_ACCELERATIONS_H

#include <string>

#include "atom.h"
#include "fix.h"
#include "modify.h"
#include "vector3.h"

namespace LIGGGHTS {
namespace Cohesion {

/// How the forces of the step before accelerated each particle, ghosts included: what contacts of
/// the scheme exact know of the others of their particles. Impulses that were over within it are
/// left out. Hidden (hidden_fix.h).
class FixAccelerations : public LAMMPS_NS::Fix {
 public:
  static constexpr const char* STYLE = "cohesion_others";

  FixAccelerations(LAMMPS_NS::LAMMPS* engine, int count, char** words);
  ~FixAccelerations() override;

  int setmask() override;
  void init() override;
  void setup_pre_force(int) override;
  void initial_integrate(int) override;
  void pre_force(int) override;
  void reset_dt() override;

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double*) override;
  int unpack_exchange(int, double*) override;
  int pack_comm(int, int*, double*, int, int*) override;
  void unpack_comm(int, int, double*) override;
  void write_restart(FILE*) override;
  void restart(char*) override;
  double memory_usage() override;

  /// "fix STYLE ID" of the first fix that moves rigid bodies of several particles; empty: there is
  /// none.
  static std::string rigid_bodies(const LAMMPS_NS::Modify& modify);

  /// Of particle or ghost i; nothing while a run is set up, [length/time^2].
  cohesion::Vector3 acceleration(int i) const { return cohesion::vector(acceleration_[0] + 3 * i); }
  /// No acceleration of a particle or ghost of this rank is larger, [length/time^2].
  double largest() const { return largest_; }
  /// Excludes a force on particle i in this step that the next step does not have, [force].
  void exclude(int i, const cohesion::Vector3& excluded) {
    if (i >= atom->nlocal) return;
    any_excluded_ = true;
    excluded_[i][0] += excluded.x;
    excluded_[i][1] += excluded.y;
    excluded_[i][2] += excluded.z;
  }
  /// While a run is set up, the step of the forces before these, also from a restart file; 0: there
  /// were none, [time].
  double last_step() const { return last_step_; }
  /// Number of the step, which the script's `reset_timestep` leaves alone: what contacts know their
  /// last step by.
  double clock() const { return clock_; }

 private:
  void begin_step();

  double** acceleration_ = nullptr;
  double** excluded_ = nullptr;  // per particle, from the forces of a step to the next
  bool any_excluded_ = false;    // in this step, by this rank; else all of it is 0
  double largest_squared_ = 0.0, largest_ = 0.0;
  double excluded_scale_ = 1.0;  // of those in the engine's forces, after reset_dt()
  double last_step_ = 0.0;
  double forces_step_ = 0.0;  // that the forces as they are were worked out for
  double clock_ = 0.0;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
