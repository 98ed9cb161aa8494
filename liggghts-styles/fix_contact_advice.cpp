// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_contact_advice.h"

#include <mpi.h>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "integrated_particles.h"
#include "unturned_spheres.h"

namespace LIGGGHTS {
namespace Cohesion {

void FixContactAdvice::ask(const std::shared_ptr<ContactAdvice>& advice) {
  for (const auto& asked : asked_)
    if (asked.lock() == advice) return;
  asked_.push_back(advice);
}

void FixContactAdvice::advise_if_due(bool setup) {
  if (asked_.empty() || !watch_.due(setup)) return;
  for (const auto& asked : asked_)
    if (const auto advice = asked.lock()) advice->give(watch_.now());
}

/// A warning that was given is not given again.
void FixContactAdvice::warn_of_unturned_once() {
  if (warned_of_unturned_) return;
  std::vector<bool> has_friction(atom->ntypes + 1, false);
  for (const auto& asked : asked_)
    if (const auto advice = asked.lock())
      for (int type = 1; type <= atom->ntypes; type++)
        has_friction[type] = has_friction[type] || advice->has_friction(type);
  warned_of_unturned_ = LAMMPS_NS::warn_of_unturned(lmp, MobileParticles(modify), has_friction);
}

int FixContactAdvice::setmask() {
  using namespace LAMMPS_NS::FixConst;
  return PRE_EXCHANGE | PRE_FORCE | POST_RUN;
}

void FixContactAdvice::pre_exchange() {
  for (const auto& warning : late_) {
    if (warning->given) continue;
    const int here = warning->due;
    int anywhere = 0;
    MPI_Allreduce(&here, &anywhere, 1, MPI_INT, MPI_MAX, world);
    if (!anywhere) continue;
    warning->given = true;
    if (comm->me == 0) error->warning(FLERR, warning->text.c_str());
  }
}

std::shared_ptr<LateWarning> FixContactAdvice::late_warning(const std::string& text) {
  for (const auto& warning : late_)
    if (warning->text == text) return warning;
  late_.push_back(std::make_shared<LateWarning>(LateWarning{text}));
  return late_.back();
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
