// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef FIX_CLASS
// clang-format off
FixStyle(drive,FixDrive);
// clang-format on
#else

#ifndef LMP_FIX_DRIVE_H
#define LMP_FIX_DRIVE_H

#include <string>

#include "common/engine_api.h"
#include "driving/drive.h"

namespace LAMMPS_NS {

/// fix ID group drive N temperature T ...: keeps the granular temperature of a gas whose collisions
/// take its motion, and books what that takes. Doc: docs/lammps-package/fix_drive.md
class FixDrive : public engine_api::StyleFix {
 public:
  FixDrive(class LAMMPS*, int, char**);

  int setmask() override;
  void init() override;
  void setup(int) override;
  void end_of_step() override;
  void post_run() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  void write_restart(FILE*) override;
  void restart(char*) override;

 private:
  void read_keywords(int, char**);
  cohesion::Vector3 beyond_flow(int) const;
  cohesion::Vector3 random_numbers(int) const;
  double mass_of(int) const;
  cohesion::driving::Sums::Values sums() const;
  void count_time(double temperature);
  void apply(const cohesion::driving::VelocityChange&);

  std::string where;
  double temperature = 0.0;
  bool kicks = false;  // by random accelerations; else by scaling
  int seed = 0;

  struct DriveState {
    double energy = 0.0;     // put in so far, [mass velocity^2]
    double before = 0.0;     // granular temperature before the last action
    double over_time = 0.0;  // granular temperature integrated over time
    double idle = 0.0;       // actions that found nothing to do
    double now = 0.0;        // granular temperature at `step`
    double step = 0.0;       // up to which over_time is known
  } state;
  bool is_restarted = false;
};

}  // namespace LAMMPS_NS

#endif
#endif
