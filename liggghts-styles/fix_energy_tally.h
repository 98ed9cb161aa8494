// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_FIX_ENERGY_TALLY_H
#define COHESION_FIX_ENERGY_TALLY_H

#include <memory>

#include "common/box_sides.h"
#include "fix.h"
#include "model_energy_tally.h"

namespace LIGGGHTS {
namespace Cohesion {

/// Begins and ends the tally of the contacts in each step. Hidden (hidden_fix.h); there is one as
/// long as there is a compute gran/energy.
class FixEnergyTally : public LAMMPS_NS::Fix {
 public:
  static constexpr const char* STYLE = "cohesion_energy_tally";

  FixEnergyTally(LAMMPS_NS::LAMMPS* engine, int count, char** words);

  int setmask() override;
  void init() override;
  void setup_pre_force(int) override { tally_->begin_set_up(other_styles_act()); }
  void setup(int) override;
  void pre_force(int) override;
  void end_of_step() override;
  void post_run() override;
  void write_restart(FILE*) override;
  void restart(char*) override;

  const std::shared_ptr<ModelEnergyTally>& tally() const { return tally_; }
  /// The tally in use, null when there is none.
  static std::shared_ptr<ModelEnergyTally> tally_of(LAMMPS_NS::LAMMPS* lmp);
  /// Set-up goes through the fixes in their order: behind the walls, which make their forces there.
  static void to_the_end(LAMMPS_NS::LAMMPS* lmp);

 private:
  double clock() const;
  bool other_styles_act() const;

  std::shared_ptr<ModelEnergyTally> tally_;
  LAMMPS_NS::BoxSides box_;   // at the end of the last run
  double last_clock_ = -1.0;  // of the last step that is in the tally; below 0: there was none
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
