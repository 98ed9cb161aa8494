// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_HIDDEN_FIX_H
#define COHESION_HIDDEN_FIX_H

#include "fix.h"
#include "lammps.h"
#include "modify.h"

namespace LIGGGHTS {
namespace Cohesion {

/// The fix of class F of this engine, null when there is none. No script names it: it is how the
/// models get to act when a run is set up and at the end of a step. F::STYLE is its id, too.
template <class F>
F* find_hidden_fix(LAMMPS_NS::LAMMPS* lmp) {
  const int place = lmp->modify->find_fix(F::STYLE);
  return place < 0 ? nullptr : static_cast<F*>(lmp->modify->fix[place]);
}

/// The same, made when there is none. The engine must know F (register_styles.cpp).
template <class F>
F& hidden_fix(LAMMPS_NS::LAMMPS* lmp) {
  if (F* const there = find_hidden_fix<F>(lmp)) return *there;
  char* const style = const_cast<char*>(F::STYLE);
  char* words[] = {style, const_cast<char*>("all"), style};
  lmp->modify->add_fix(3, words);
  return *find_hidden_fix<F>(lmp);
}

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
