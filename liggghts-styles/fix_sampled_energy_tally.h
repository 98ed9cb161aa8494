// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_FIX_SAMPLED_ENERGY_TALLY_H
#define COHESION_FIX_SAMPLED_ENERGY_TALLY_H

#include <memory>

#include "fix.h"
#include "sampled_energy_tally.h"

namespace LIGGGHTS {
namespace Cohesion {

/// Ends the tally of the contacts after each step. Hidden (hidden_fix.h); there is one as long as
/// there is a compute gran/energy.
class FixSampledEnergyTally : public LAMMPS_NS::Fix {
 public:
  static constexpr const char* STYLE = "cohesion_energy_tally";

  FixSampledEnergyTally(LAMMPS_NS::LAMMPS* engine, int count, char** words);

  int setmask() override;
  void init() override;
  void setup(int) override;
  void end_of_step() override { tally_->end_step(false); }
  void post_run() override;

  const std::shared_ptr<SampledEnergyTally>& tally() const { return tally_; }
  /// The tally in use, null when there is none.
  static std::shared_ptr<SampledEnergyTally> tally_of(LAMMPS_NS::LAMMPS* lmp);
  /// Set-up goes through the fixes in their order: behind the walls, which make their forces there.
  static void to_the_end(LAMMPS_NS::LAMMPS* lmp);

 private:
  std::shared_ptr<SampledEnergyTally> tally_;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
