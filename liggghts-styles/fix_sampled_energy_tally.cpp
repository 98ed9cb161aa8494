// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_sampled_energy_tally.h"

#include <mpi.h>

#include <cstdlib>
#include <cstring>
#include <string>

#include "cohesive_pairs.h"
#include "energy_tally_of_runs.h"
#include "error.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "hidden_fix.h"
#include "modify.h"
#include "pair_gran.h"

namespace LIGGGHTS {
namespace Cohesion {

using namespace LAMMPS_NS;

namespace {

/// Whether a contact model of this owner writes into the tally.
bool has_our_cohesion(const IContactHistorySetup& owner) {
  return CohesivePairs::of(&owner) != nullptr;
}

std::string has_none() {
  return " has none of the cohesion models " + cohesion_models() +
         ", which keep the tally; without attraction, use one with a strength of 0";
}

[[noreturn]] void reject(LAMMPS* lmp, const std::string& why) {
  lmp->error->all(FLERR, ("compute gran/energy: " + why).c_str());
  std::abort();  // not reached
}

}  // namespace

FixSampledEnergyTally::FixSampledEnergyTally(LAMMPS* engine, int count, char** words)
    : Fix(engine, count, words), tally_(std::make_shared<SampledEnergyTally>(engine)) {
  nevery = 1;
}

int FixSampledEnergyTally::setmask() { return FixConst::END_OF_STEP; }

std::shared_ptr<SampledEnergyTally> FixSampledEnergyTally::tally_of(LAMMPS* lmp) {
  const FixSampledEnergyTally* const fix = find_hidden_fix<FixSampledEnergyTally>(lmp);
  return fix ? fix->tally_ : nullptr;
}

void FixSampledEnergyTally::to_the_end(LAMMPS* lmp) {
  const int place = lmp->modify->find_fix(STYLE);
  if (place < 0 || place == lmp->modify->nfix - 1) return;
  const auto tally = static_cast<FixSampledEnergyTally*>(lmp->modify->fix[place])->tally_;
  lmp->modify->delete_fix(STYLE);
  hidden_fix<FixSampledEnergyTally>(lmp).tally_ = tally;
}

void FixSampledEnergyTally::setup(int) {
  tally_->end_step(true);
  for_each_energy_tally(modify, [](EnergyTallyCompute& compute) { compute.begin_run(); });
}

void FixSampledEnergyTally::post_run() {
  for_each_energy_tally(modify, [](EnergyTallyCompute& compute) { compute.end_run(); });
}

void FixSampledEnergyTally::init() {
  auto* const pair = dynamic_cast<PairGran*>(force->pair);
  if (!pair || !has_our_cohesion(*pair)) reject(lmp, std::string("pair_style gran") + has_none());
  for (int k = 0; k < modify->nfix; k++) {
    Fix* const fix = modify->fix[k];
    if (std::strncmp(fix->style, "wall/gran", 9) == 0 &&
        !has_our_cohesion(static_cast<FixWallGran&>(*fix)))
      reject(lmp, std::string("fix wall/gran ") + fix->id + has_none());
    if (std::strncmp(fix->style, "multisphere", 11) == 0 ||
        std::strncmp(fix->style, "rigid", 5) == 0)
      reject(lmp,
             std::string("fix ") + fix->style +
                 " moves bodies of several spheres, whose energy is not that of their spheres");
  }
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
