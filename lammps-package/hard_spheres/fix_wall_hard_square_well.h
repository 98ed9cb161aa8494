// SPDX-License-Identifier: GPL-2.0-only
#ifdef FIX_CLASS
// clang-format off
FixStyle(wall/hard/square_well,FixWallHardSquareWell);
// clang-format on
#else

#ifndef LMP_FIX_WALL_HARD_SQUARE_WELL_H
#define LMP_FIX_WALL_HARD_SQUARE_WELL_H

#include <string>
#include <vector>

#include "fix.h"
#include "fix_hard_events.h"
#include "hard_contact_from_script.h"

namespace LAMMPS_NS {

/// fix wall/hard/square_well: walls that take part in the event-driven simulation of pair_style
/// hard/square_well. FixHardEvents runs it; this fix holds what the script says and which particles
/// are in the wells of the walls. Doc: docs/lammps-package/fix_wall_hard_square_well.md
class FixWallHardSquareWell : public Fix, public HardWalls {
 public:
  FixWallHardSquareWell(class LAMMPS*, int, char**);
  ~FixWallHardSquareWell() override;

  int setmask() override;
  void init() override;

  const std::vector<cohesion::event_stepping::Wall>& hard_walls() const override { return walls_; }
  bool acts_on(int i) const override;
  cohesion::hard_sphere::MovingWall over_step(int w) const override;
  bool still() const override { return motion_.still(); }
  cohesion::hard_sphere::Law law_of_type(int type) const override;
  cohesion::hard_sphere::Surfaces surfaces_of(int i) const override;
  double& inside(int i, int w) override { return inside_[i][w]; }

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double*) override;
  int unpack_exchange(int, double*) override;
  void write_restart(FILE*) override;
  void restart(char*) override;
  int pack_restart(int, double*) override;
  void unpack_restart(int, int) override;
  int maxsize_restart() override;
  int size_restart(int) override;
  double memory_usage() override;

 private:
  void read(int, char**);
  int size() const { return static_cast<int>(walls_.size()); }
  const HardContact& pair_contact(int type) const;
  double ratio(int type) const;

  std::string where_;  // in front of messages
  HardContact contact_;
  std::vector<cohesion::event_stepping::Wall> walls_;
  cohesion::event_stepping::WallMotion motion_;
  bigint time_origin_;
  double** inside_;  // per atom and wall; -1: not known yet
};

}  // namespace LAMMPS_NS

#endif
#endif
