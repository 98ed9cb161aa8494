// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_energy_tally.h"

#include <mpi.h>

#include <cstdlib>
#include <cstring>
#include <string>

#include "cohesive_pairs.h"
#include "comm.h"
#include "common/energy_tally_of_runs.h"
#include "common/message.h"
#include "common/other_forces.h"
#include "error.h"
#include "fix_accelerations.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "hidden_fix.h"
#include "modify.h"
#include "output.h"
#include "pair_gran.h"
#include "update.h"

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
  LAMMPS_NS::stop(lmp, FLERR, "compute gran/energy: ", why);
  std::abort();  // not reached
}

}  // namespace

FixEnergyTally::FixEnergyTally(LAMMPS* engine, int count, char** words)
    : Fix(engine, count, words), tally_(std::make_shared<ModelEnergyTally>(engine)) {
  nevery = 1;
  restart_global = 1;
}

int FixEnergyTally::setmask() { return FixConst::PRE_FORCE | FixConst::END_OF_STEP; }

std::shared_ptr<ModelEnergyTally> FixEnergyTally::tally_of(LAMMPS* lmp) {
  const FixEnergyTally* const fix = find_hidden_fix<FixEnergyTally>(lmp);
  return fix ? fix->tally_ : nullptr;
}

void FixEnergyTally::to_the_end(LAMMPS* lmp) {
  const int place = lmp->modify->find_fix(STYLE);
  if (place < 0 || place == lmp->modify->nfix - 1) return;
  const auto* const before = static_cast<FixEnergyTally*>(lmp->modify->fix[place]);
  const auto tally = before->tally_;
  const double last_clock = before->last_clock_;
  const BoxSides box = before->box_;
  lmp->modify->delete_fix(STYLE);
  auto& now = hidden_fix<FixEnergyTally>(lmp);
  now.tally_ = tally;
  now.last_clock_ = last_clock;
  now.box_ = box;
}

/// By the clock of contacts of scheme exact; 0: there are none.
double FixEnergyTally::clock() const {
  const FixAccelerations* const others = find_hidden_fix<FixAccelerations>(lmp);
  return others ? others->clock() : 0.0;
}

/// Whether anything but contacts and gravity exerts forces.
bool FixEnergyTally::other_styles_act() const {
  return other_forces_act(lmp, [](const Fix& fix) {
    const auto is = [&](const char* start) {
      return std::strncmp(fix.style, start, std::strlen(start)) == 0;
    };
    return is("cohesion_") || is("gravity") || is("wall/gran") || is("mesh/surface") ||
           is("neighlist/mesh") || is("contacthistory");
  });
}

/// Contacts of scheme exact go on with the forces of the last run, unless there were none or the
/// step is another.
void FixEnergyTally::setup(int) {
  const FixAccelerations* const others = find_hidden_fix<FixAccelerations>(lmp);
  const bool starts = others && others->last_step() != update->dt;
  const bool known = last_clock_ == clock();
  if (others && !starts && !known && comm->me == 0)
    error->warning(FLERR,
                   "compute gran/energy: the last step has no energy tally: what contacts of "
                   "scheme exact store under a load is not known, and entry 10 has that error from "
                   "now on; define the compute before the run that this one continues");
  // No contact is exact where the pairs are sampled; what they store the set-up has computed.
  tally_->end_set_up(starts, known && pairs_are_exact(lmp) && !box_.changed(domain));
  last_clock_ = clock();
  for_each_energy_tally(modify, [](EnergyTallyCompute& compute) { compute.begin_run(); });
}

void FixEnergyTally::pre_force(int) {
  const bigint now = update->ntimestep;
  // A later run may continue from the last step, or from a restart file.
  const bool may_be_continued = now == update->laststep || now == output->next;
  tally_->begin_step(may_be_continued || reads_energy_tally(modify, now));
}

void FixEnergyTally::end_of_step() {
  tally_->end_step();
  if (tally_->is_read()) last_clock_ = clock();
}

void FixEnergyTally::write_restart(FILE* file) {
  double mine[ModelEnergyTally::TOTALS], values[1 + ModelEnergyTally::TOTALS] = {last_clock_};
  tally_->store_totals(mine);
  MPI_Reduce(mine, values + 1, ModelEnergyTally::TOTALS, MPI_DOUBLE, MPI_SUM, 0, world);
  if (comm->me != 0) return;
  const int size = sizeof(values);
  fwrite(&size, sizeof(int), 1, file);
  fwrite(values, size, 1, file);
}

void FixEnergyTally::restart(char* buffer) {
  double values[1 + ModelEnergyTally::TOTALS];
  std::memcpy(values, buffer, sizeof(values));
  last_clock_ = values[0];
  if (comm->me == 0) tally_->restore_totals(values + 1);
}

void FixEnergyTally::post_run() {
  box_.store(domain);
  for_each_energy_tally(modify, [](EnergyTallyCompute& compute) { compute.end_run(); });
}

void FixEnergyTally::init() {
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
