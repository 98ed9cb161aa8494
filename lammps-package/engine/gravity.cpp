// SPDX-License-Identifier: GPL-2.0-only
#include "engine/gravity.h"

#include <algorithm>

#include "atom.h"
#include "common/engine_api.h"
#include "compute.h"
#include "engine/mobile_particles.h"
#include "fix.h"
#include "modify.h"
#include "utils.h"

using namespace LAMMPS_NS;

namespace {

/// Saves which computes have been invoked in this step, and restores it at the end of its life: a
/// fix gravity with a variable that is let act clears these flags. Whoever asks for the weights
/// would otherwise not ask in time for the computes of its next step.
class SavedInvokedFlags {
 public:
  explicit SavedInvokedFlags(Modify* modify) : modify_(modify) {
    for (int k = 0; k < modify->ncompute; k++) flags_.push_back(modify->compute[k]->invoked_flag);
  }
  ~SavedInvokedFlags() {
    for (int k = 0; k < modify_->ncompute; k++) modify_->compute[k]->invoked_flag = flags_[k];
  }
  SavedInvokedFlags(const SavedInvokedFlags&) = delete;
  SavedInvokedFlags& operator=(const SavedInvokedFlags&) = delete;

 private:
  Modify* modify_;
  std::vector<int> flags_;
};

}  // namespace

std::vector<double> LAMMPS_NS::weights(LAMMPS* lmp) {
  const SavedInvokedFlags saved(lmp->modify);
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

std::vector<std::pair<int, cohesion::Vector3>> LAMMPS_NS::engine_api::gravity_of_mobile(
    LAMMPS* lmp, int groupbit) {
  const Atom* const atom = lmp->atom;
  const std::vector<double> weight = weights(lmp);
  MobileParticles mobile;
  mobile.look_up(lmp);
  std::vector<std::pair<int, cohesion::Vector3>> found;
  for (int i = 0; i < atom->nlocal; i++) {
    const double per_mass = mobile.inverse_mass(atom->mask[i], atom->rmass[i]);
    if ((atom->mask[i] & groupbit) && per_mass > 0.0 && mobile.feels_forces(atom->mask[i]))
      found.emplace_back(i, per_mass * cohesion::vector(&weight[3 * i]));
  }
  return found;
}
