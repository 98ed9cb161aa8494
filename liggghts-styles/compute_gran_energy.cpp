// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_gran_energy.h"

#include <mpi.h>

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix_energy_tally.h"
#include "gravity_of_fixes.h"
#include "hidden_fix.h"
#include "integrated_particles.h"
#include "update.h"

namespace LIGGGHTS {
namespace Cohesion {

using namespace LAMMPS_NS;
using namespace cohesion::energy_tally;
using cohesion::vector;

ComputeGranularEnergy::ComputeGranularEnergy(LAMMPS* engine, int count, char** words)
    : StyleCompute(engine, count, words) {
  const std::string where = std::string("compute ") + id + " gran/energy";
  if (count != 3)
    stop(lmp, FLERR, where, " takes no further arguments; '", words[3], "' was given");
  if (igroup != 0)
    stop(lmp, FLERR, where, " balances all particles; its group must be 'all', not '", words[1],
         "'");
  if (find_hidden_fix<FixEnergyTally>(lmp))
    stop(lmp, FLERR, where, ": there is one already, and one tally is kept");
  scalar_flag = vector_flag = timeflag = 1;
  extscalar = extvector = 1;
  size_vector = ENTRIES;
  vector = new double[ENTRIES];
  hidden_fix<FixEnergyTally>(lmp);
}

ComputeGranularEnergy::~ComputeGranularEnergy() { delete[] vector; }

void ComputeGranularEnergy::pre_delete(bool) {
  if (find_hidden_fix<FixEnergyTally>(lmp)) modify->delete_fix(FixEnergyTally::STYLE);
}

void ComputeGranularEnergy::init() {
  require_fixed_box(lmp, std::string("compute ") + id + " gran/energy");
}

void ComputeGranularEnergy::compute_vector() {
  invoked_vector = update->ntimestep;
  require_read(lmp, std::string("compute ") + id + " gran/energy",
               hidden_fix<FixEnergyTally>(lmp).tally()->is_read());
  work_out();
  tally_.update(lmp, std::string("compute ") + id + " gran/energy", vector);
}

void ComputeGranularEnergy::begin_run() {
  work_out();
  tally_.begin_run(lmp, std::string("compute ") + id + " gran/energy", vector);
}

void ComputeGranularEnergy::end_run() {
  work_out();
  tally_.end_run(vector);
}

/// All entries but what is missing.
void ComputeGranularEnergy::work_out() {
  particles_.check(lmp, std::string("compute ") + id + " gran/energy");
  double mine[ENTRIES] = {};
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
    add_body(mine, mass, inertia, cohesion::vector(atom->v[i]), cohesion::vector(atom->omega[i]),
             mass * gravity.on(mask), cohesion::vector(place));
  }
  hidden_fix<FixEnergyTally>(lmp).tally()->add_to(mine);
  MPI_Allreduce(mine, vector, ENTRIES, MPI_DOUBLE, MPI_SUM, world);
}

/// Kinetic and stored energy.
double ComputeGranularEnergy::compute_scalar() {
  if (invoked_vector != update->ntimestep) compute_vector();
  invoked_scalar = update->ntimestep;
  return scalar = stored(vector);
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
