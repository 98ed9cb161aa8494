// SPDX-License-Identifier: GPL-2.0-only
#include "engine/special_pairs.h"

#include "atom.h"
#include "common/message.h"
#include "error.h"
#include "force.h"
#include "pair_hybrid.h"

using namespace LAMMPS_NS;

const double* LAMMPS_NS::special_factors(const LAMMPS* lmp, const Pair* pair) {
  struct Hybrid : PairHybrid {
    static const double* factors(PairHybrid* hybrid, const Pair* member) {
      for (int m = 0; m < hybrid->*&Hybrid::nstyles; m++)
        if ((hybrid->*&Hybrid::styles)[m] == member) return (hybrid->*&Hybrid::special_lj)[m];
      return nullptr;
    }
  };
  auto* const hybrid = dynamic_cast<PairHybrid*>(lmp->force->pair);
  const double* const of_style = hybrid ? Hybrid::factors(hybrid, pair) : nullptr;
  return of_style ? of_style : lmp->force->special_lj;
}

void LAMMPS_NS::require_whole_special_factors(const LAMMPS* lmp, const Pair* pair,
                                              const std::string& where, bool by_list) {
  if (lmp->atom->molecular == 0) return;
  const Force* const force = lmp->force;
  const double* const factors = special_factors(lmp, pair);
  for (int bonds = 1; bonds <= 3; bonds++) {
    const double factor = factors[bonds];
    const std::string which = message(where, ": special_bonds, or pair_modify special, gives 1-",
                                      bonds + 1, " neighbours the factor ", factor);
    if (factor != 0.0 && factor != 1.0)
      stop(lmp, FLERR, which, ": a contact acts or does not, so it must be 0 or 1");
    const bool listed = force->special_lj[bonds] != 0.0 || force->special_coul[bonds] != 0.0 ||
                        force->kspace != nullptr;
    if (by_list && listed != (factor == 1.0))
      stop(lmp, FLERR, which,
           listed ? " here, and other styles another one"
                  : " here, and the neighbour list leaves them out",
           ": give the same factor in 'special_bonds lj/coul' for all styles");
  }
}
