// SPDX-License-Identifier: GPL-2.0-or-later
// Fixes and computes, named to every instance of the engine.
//
// LIGGGHTS calls LAMMPS::post_create() whenever it has made its lists of styles: at the start and
// after `clear`. It does so through the dynamic linker, so the definition here, linked or preloaded
// in front of libliggghts, comes first. It does the engine's own work, then adds the styles.

#include <dlfcn.h>
#include <mpi.h>
// The engine's headers want mpi.h before them.
#include <map>
#include <string>

#include "cohesion_version.h"
#include "common/compute_shear_profile.h"
#include "common/engine_api.h"
#include "common/fix_agglomerates.h"
#include "common/fix_deform_shear.h"
#include "common/fix_drive.h"
#include "common/fix_gas_coupling.h"
#include "common/message.h"
#include "compute_gran_energy.h"
#include "domain.h"
#include "fix_accelerations.h"
#include "fix_contact_advice.h"
#include "fix_energy_tally.h"
#include "fix_partner_ids.h"
#include "fix_restart_contacts.h"
#include "lammps.h"
#include "modify.h"
#include "unknown_models.h"

using namespace LAMMPS_NS;

namespace LIGGGHTS {
namespace Cohesion {

namespace {

using Fixes = std::map<std::string, Fix* (*)(LAMMPS*, int, char**)>;
using Computes = std::map<std::string, Compute* (*)(LAMMPS*, int, int, char**)>;

/// The engine's tables of styles; an explicit instantiation may name its private members. There may
/// be one in the program only: not in a header.
Fixes* fixes_of(Modify& modify);
Computes* computes_of(Modify& modify);
template <auto fixes, auto computes>
struct TablesOfStyles {
  friend Fixes* fixes_of(Modify& modify) { return modify.*fixes; }
  friend Computes* computes_of(Modify& modify) { return modify.*computes; }
};
template struct TablesOfStyles<&Modify::fix_map, &Modify::compute_map>;

template <class Style>
Fix* make_fix(LAMMPS* lmp, int narg, char** arg) {
  return new Style(lmp, narg, arg);
}
template <class Style>
Compute* make_compute(LAMMPS* lmp, int, int narg, char** arg) {
  return new Style(lmp, narg, arg);
}

/// Once for an engine, which `clear` makes anew, by rank 0 alone: the others have a screen, too,
/// but what they write there comes when they end, into a line of rank 0.
void print_version(LAMMPS* lmp) {
  static const LAMMPS* reported = nullptr;
  if (reported == lmp) return;
  reported = lmp;
  engine_api::tell(lmp, "Cohesion " COHESION_VERSION "\n");
}

/// Registers the fixes and computes of this package with an engine that has been created or
/// cleared.
void register_styles(LAMMPS* lmp) {
  print_version(lmp);
  name_unknown_models();
  Fixes& fixes = *fixes_of(*lmp->modify);
  fixes["agglomerates"] = &make_fix<FixAgglomerates>;
  fixes["deform/shear"] = &make_fix<FixDeformShear>;
  fixes["drive"] = &make_fix<FixDrive>;
  fixes["gas/coupling"] = &make_fix<FixGasCoupling>;
  fixes[FixContactAdvice::STYLE] = &make_fix<FixContactAdvice>;
  fixes[FixEnergyTally::STYLE] = &make_fix<FixEnergyTally>;
  fixes[FixPartnerIds::STYLE] = &make_fix<FixPartnerIds>;
  fixes[FixRestartContacts::STYLE] = &make_fix<FixRestartContacts>;
  fixes[FixAccelerations::STYLE] = &make_fix<FixAccelerations>;
  Computes& computes = *computes_of(*lmp->modify);
  computes["gran/energy"] = &make_compute<ComputeGranularEnergy>;
  computes["shear/profile"] = &make_compute<ComputeShearProfile>;

  // LIGGGHTS leaves the periods of a tilted box at zero: what leaves it would be lost. They are 1
  // in the coordinates of the box.
  for (int k = 0; k < 3; k++) {
    lmp->domain->prd_lamda[k] = 1.0;
    lmp->domain->prd_half_lamda[k] = 0.5;
  }
}

}  // namespace
}  // namespace Cohesion
}  // namespace LIGGGHTS

__attribute__((visibility("default"))) void LAMMPS::post_create() {
  using PostCreate = void (*)(LAMMPS*);
  // The mangled name is that of this very function.
  static const auto engine_own =
      reinterpret_cast<PostCreate>(dlsym(RTLD_NEXT, "_ZN9LAMMPS_NS6LAMMPS11post_createEv"));
  if (!engine_own)
    stop(this, FLERR, "the library of the cohesion package must come before libliggghts");
  engine_own(this);
  LIGGGHTS::Cohesion::register_styles(this);
}
