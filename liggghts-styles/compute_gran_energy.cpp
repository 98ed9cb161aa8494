// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_gran_energy.h"

#include "atom.h"
#include "domain.h"
#include "fix_energy_tally.h"
#include "gravity_of_fixes.h"
#include "hidden_fix.h"
#include "integrated_particles.h"

namespace LIGGGHTS {
namespace Cohesion {

using namespace LAMMPS_NS;
using namespace cohesion::energy_tally;
using cohesion::vector;

ComputeGranularEnergy::ComputeGranularEnergy(LAMMPS* engine, int count, char** words)
    : EnergyTallyCompute(engine, count, words) {
  if (find_hidden_fix<FixEnergyTally>(lmp))
    stop(lmp, FLERR, where, ": there is one already, and one tally is kept");
  hidden_fix<FixEnergyTally>(lmp);
}

void ComputeGranularEnergy::pre_delete(bool) {
  if (find_hidden_fix<FixEnergyTally>(lmp)) modify->delete_fix(FixEnergyTally::STYLE);
}

bool ComputeGranularEnergy::is_read() { return hidden_fix<FixEnergyTally>(lmp).tally()->is_read(); }

void ComputeGranularEnergy::add_to(double* entries) {
  const IntegratedParticles mobile(lmp);
  const GravityOfFixes gravity(modify);
  for (int i = 0; i < atom->nlocal; i++) {
    const int mask = atom->mask[i];
    if (!mobile.moves(mask)) continue;
    const double mass = atom->rmass[i];
    const double inertia =
        mobile.inertia_factor(domain->dimension) * mass * atom->radius[i] * atom->radius[i];
    double place[3];
    domain->unmap(atom->x[i], atom->image[i], place);
    add_body(entries, mass, inertia, cohesion::vector(atom->v[i]), cohesion::vector(atom->omega[i]),
             mass * gravity.on(mask), cohesion::vector(place));
  }
  hidden_fix<FixEnergyTally>(lmp).tally()->add_to(entries);
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
