// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef FIX_CLASS
// clang-format off
FixStyle(deform/shear,FixDeformShear);
// clang-format on
#else

#ifndef LMP_FIX_DEFORM_SHEAR_H
#define LMP_FIX_DEFORM_SHEAR_H

#include <string>

#include "common/engine_api.h"
#include "shear/nonaffine_displacements.h"
#include "shear/sheared_box.h"

namespace LAMMPS_NS {

/// fix ID all deform/shear rate R ...: simple shear with Lees-Edwards images, flow along x,
/// gradient along y, in the engine's tilted box. Doc: docs/lammps-package/fix_deform_shear.md
///
/// The engine's fix deform tilts the box at the end of a step, so that the particles of step n + 1
/// meet the box of step n, and those of the first step of a run the box of the step itself: a run
/// that is split has one step without shear. When the box flips, it puts particles back into the
/// box that left through a sheared face since the list was made, and leaves them their velocity.
/// Here the box is tilted when the particles have moved, to where it is at that time, and particles
/// that are put back change their velocity whenever it happens.
class FixDeformShear : public engine_api::BoxFix {
 public:
  FixDeformShear(class LAMMPS*, int, char**);

  int setmask() override;
  void init() override;
  void setup_pre_exchange() override;
  void setup_post_neighbor() override { post_neighbor(); }
  void setup(int) override;
  void post_integrate() override;
  void pre_exchange() override;
  void post_neighbor() override;
  void end_of_step() override;
  void post_run() override;
  void write_restart(FILE*) override;
  void restart(char*) override;
  double compute_scalar() override;
  double compute_vector(int) override;
  double memory_usage() override;

 private:
  void read_keywords(int, char**);
  void require_compatible_setup() const;
  void find_rate();
  double rate_now();
  void add_profile();
  void tilt_box(double);
  bool list_may_miss_a_pair() const;

  double constant_rate = 0.0;
  std::string rate_name;  // of a variable; empty: the rate is the number
  int rate_variable = -1;
  bool profile = true;  // whether to add the linear profile to the velocities when shear begins
  bool nonaffine_rebuild = true;  // whether the nonaffine displacements decide when lists are made

  struct ShearState {
    cohesion::shear::BoxStrain strain;
    double next_rate;  // from the end of the step on
    double start_tilt, ly, lx;
    int begun;
  } state = {};
  double lengths = 0.0;  // whole box lengths that the tilt was counted back by
  double tilt_after_flip = 0.0;
  int flipped_lengths = 0;  // by the flip that is due; 0: none is

  // Of the own particles since the list was made.
  cohesion::shear::NonaffineDisplacements displacements;
  bigint list_step = -1;
  int engine_delay = 0, engine_every = 0;  // of neigh_modify, while checks_suspended
  bool checks_suspended = false;  // the engine's checks of the list, which this fix makes instead
};

}  // namespace LAMMPS_NS

#endif
#endif
