// SPDX-License-Identifier: GPL-2.0-or-later
#include <mpi.h>
// The engine's headers want mpi.h before them.
#include <cmath>
#include <map>
#include <set>

#include "atom.h"
#include "cohesive_pairs.h"
#include "common/message.h"
#include "force.h"
#include "neigh_list.h"
#include "pair_gran.h"

using namespace LAMMPS_NS;

namespace LIGGGHTS {
namespace Cohesion {

namespace {

std::map<const IContactHistorySetup*, const CohesivePairs*>& known() {
  static std::map<const IContactHistorySetup*, const CohesivePairs*> styles;
  return styles;
}

std::set<std::string>& model_names() {
  static std::set<std::string> names;
  return names;
}

double gap(const Atom* atom, int i, int j) {
  const double *a = atom->x[i], *b = atom->x[j];
  const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return std::sqrt(x * x + y * y + z * z) - (atom->radius[i] + atom->radius[j]);
}

}  // namespace

void note_cohesion_model(const std::string& name) { model_names().insert(name); }

std::string cohesion_models() {
  std::string all;
  for (const std::string& name : model_names()) all += (all.empty() ? "" : ", ") + name;
  return all;
}

bool is_cohesion_model(const std::string& name) { return model_names().count(name) > 0; }

CohesivePairs::CohesivePairs(LAMMPS* lmp, IContactHistorySetup* owner, bool wall)
    : lmp_(lmp), owner_(owner), pair_(wall ? nullptr : static_cast<PairGran*>(owner)) {
  known()[owner_] = this;
}

CohesivePairs::~CohesivePairs() {
  const auto mine = known().find(owner_);
  if (mine != known().end() && mine->second == this) known().erase(mine);
}

const CohesivePairs* CohesivePairs::of(const IContactHistorySetup* owner) {
  const auto found = known().find(owner);
  return found == known().end() ? nullptr : found->second;
}

bool pairs_are_exact(LAMMPS* lmp) {
  const auto* const pair = dynamic_cast<PairGran*>(lmp->force->pair_match("gran", 1));
  const CohesivePairs* const pairs = pair ? CohesivePairs::of(pair) : nullptr;
  return pairs && pairs->is_exact();
}

void CohesivePairs::append_bound(std::vector<std::array<int, 2> >& pairs) const {
  if (!pair_) return;
  const NeighList* const list = pair_->list;
  const NeighList* const memory = pair_->listgranhistory;
  const int* const type = lmp_->atom->type;
  const double* const radius = lmp_->atom->radius;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = list->firstneigh[i][jj] & NEIGHMASK;
      const double* const history = memory ? memory->firstdouble[i] + pair_->dnum() * jj : nullptr;
      if (binds(type[i], type[j], radius[i], radius[j], gap(lmp_->atom, i, j), history))
        pairs.push_back({i, j});
    }
  }
}

}  // namespace Cohesion
}  // namespace LIGGGHTS

std::vector<const BoundPairs*> LAMMPS_NS::bound_pairs(LAMMPS* lmp, const std::string& where) {
  using LIGGGHTS::Cohesion::CohesivePairs;
  const auto* const pair = dynamic_cast<PairGran*>(lmp->force->pair_match("gran", 1));
  const CohesivePairs* const pairs = pair ? CohesivePairs::of(pair) : nullptr;
  if (!pairs)
    stop(lmp, FLERR, where,
         ": no pair_style says which pairs are bound; use 'pair_style gran' with one of the "
         "cohesion models ",
         LIGGGHTS::Cohesion::cohesion_models());
  return {pairs};
}
