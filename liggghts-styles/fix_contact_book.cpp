// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_contact_book.h"

#include <mpi.h>

#include <cstdlib>
#include <cstring>
#include <string>

#include "cohesive_pairs.h"
#include "energy_companions.h"
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

/// Whether a contact model writes into the book.
bool has_our_cohesion(const IContactHistorySetup& owner) {
  return CohesivePairs::of(&owner) != nullptr;
}

std::string has_none() {
  return " has none of the cohesion models " + cohesion_models() +
         ", which keep the book; without attraction, use one with a strength of 0";
}

[[noreturn]] void refuse(LAMMPS* lmp, const std::string& why) {
  lmp->error->all(FLERR, ("compute gran/energy: " + why).c_str());
  std::abort();  // not reached
}

}  // namespace

FixContactBook::FixContactBook(LAMMPS* engine, int count, char** words)
    : Fix(engine, count, words), book_(std::make_shared<ContactBook>(engine)) {
  nevery = 1;
}

int FixContactBook::setmask() { return FixConst::END_OF_STEP; }

std::shared_ptr<ContactBook> FixContactBook::book_of(LAMMPS* lmp) {
  const FixContactBook* const fix = find_hidden_fix<FixContactBook>(lmp);
  return fix ? fix->book_ : nullptr;
}

void FixContactBook::to_the_end(LAMMPS* lmp) {
  const int place = lmp->modify->find_fix(STYLE);
  if (place < 0 || place == lmp->modify->nfix - 1) return;
  const auto book = static_cast<FixContactBook*>(lmp->modify->fix[place])->book_;
  lmp->modify->delete_fix(STYLE);
  hidden_fix<FixContactBook>(lmp).book_ = book;
}

void FixContactBook::setup(int) {
  book_->close_step(true);
  for_each_energy_book(modify, [](EnergyBookKeeper& keeper) { keeper.begin_run(); });
}

void FixContactBook::post_run() {
  for_each_energy_book(modify, [](EnergyBookKeeper& keeper) { keeper.end_run(); });
}

void FixContactBook::init() {
  auto* const pair = dynamic_cast<PairGran*>(force->pair);
  if (!pair || !has_our_cohesion(*pair)) refuse(lmp, std::string("pair_style gran") + has_none());
  for (int k = 0; k < modify->nfix; k++) {
    Fix* const fix = modify->fix[k];
    if (std::strncmp(fix->style, "wall/gran", 9) == 0 &&
        !has_our_cohesion(static_cast<FixWallGran&>(*fix)))
      refuse(lmp, std::string("fix wall/gran ") + fix->id + has_none());
    if (std::strncmp(fix->style, "multisphere", 11) == 0 ||
        std::strncmp(fix->style, "rigid", 5) == 0)
      refuse(lmp,
             std::string("fix ") + fix->style +
                 " moves bodies of several spheres, whose energy is not that of their spheres");
  }
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
