// SPDX-License-Identifier: GPL-2.0-only
#include "gravity.h"

#include <algorithm>

#include "atom.h"
#include "fix.h"
#include "modify.h"
#include "utils.h"

using namespace LAMMPS_NS;

std::vector<double> LAMMPS_NS::weights(LAMMPS* lmp) {
  const int count = 3 * lmp->atom->nlocal;
  std::vector<double> weight(count, 0.0);
  double* const f = count > 0 ? lmp->atom->f[0] : nullptr;
  std::swap_ranges(weight.begin(), weight.end(), f);
  for (int k = 0; k < lmp->modify->nfix; k++) {
    Fix* const fix = lmp->modify->fix[k];
    if (utils::strmatch(fix->style, "^gravity")) fix->post_force(0);
  }
  std::swap_ranges(weight.begin(), weight.end(), f);
  return weight;
}
