// SPDX-License-Identifier: GPL-2.0-only
#ifdef FIX_CLASS
// clang-format off
FixStyle(wall/hard/squarewell,FixWallHardSquareWell);
FixStyle(wall/hard/square_well,FormerFixWallHardSquareWell);
// clang-format on
#else

#ifndef LMP_FIX_WALL_HARD_SQUARE_WELL_H
#define LMP_FIX_WALL_HARD_SQUARE_WELL_H

#include <string>
#include <vector>

#include "common/former_style.h"
#include "fix.h"
#include "hard_spheres/fix_hard_events.h"
#include "input/hard_contact_from_script.h"

namespace LAMMPS_NS {

/// fix wall/hard/squarewell: walls in the event-driven simulation of pair_style hard/squarewell.
/// FixHardEvents runs it; this fix stores the parameters of the script. Doc:
/// docs/lammps-package/pair_hard_squarewell.md
class FixWallHardSquareWell : public Fix, public HardWallSource {
 public:
  FixWallHardSquareWell(class LAMMPS*, int, char**);

  int setmask() override;
  void init() override;
  void initial_integrate(int) override;

  int number_of_walls() const override { return static_cast<int>(walls_.size()); }
  cohesion::hard_sphere::HardWall wall(int w, double when) const override;

  void write_restart(FILE*) override;
  void restart(char*) override;

 private:
  void read(int, char**);
  const HardContact& pair_contact(int type) const;
  double ratio(int type) const;
  cohesion::hard_sphere::ImpactLaw impact_law(int type) const;

  std::string message_prefix_;  // begins all messages
  HardContact contact_;
  std::vector<cohesion::contact_solver::Wall> walls_;
  cohesion::contact_solver::WallMotion motion_;
  cohesion::contact_solver::WallCourse course_;
  bool warned_;  // of particles that overlap the walls or are behind them
};

inline constexpr char former_wall_hard_square_well[] = "wall/hard/square_well";
using FormerFixWallHardSquareWell =
    FormerStyle<FixWallHardSquareWell, former_wall_hard_square_well>;

}  // namespace LAMMPS_NS

#endif
#endif
