// SPDX-License-Identifier: GPL-2.0-only
#include "outputs/compute_gran_energy.h"

#include <algorithm>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "contact_solver/pair_motion.h"
#include "contact_step/fix_contact_step.h"
#include "domain.h"
#include "energy_tally.h"
#include "engine/gravity.h"
#include "error.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::energy_tally;
using cohesion::Vector3;

ComputeGranEnergy::ComputeGranEnergy(LAMMPS* lammps, int narg, char** arg)
    : Compute(lammps, narg, arg), step(FixContactStep::of(lammps)), before() {
  if (narg != 3) error->all(FLERR, "compute gran/energy takes no further arguments");
  if (igroup != 0)
    error->all(FLERR, "compute gran/energy balances all particles; its group must be 'all'");
  scalar_flag = vector_flag = timeflag = 1;
  extscalar = extvector = 1;
  size_vector = ENTRIES;
  vector = new double[ENTRIES];
  reader = step->energy_tally.add_reader();
  step->energy_tally.sums().add_so_far(-1.0, before);
}

ComputeGranEnergy::~ComputeGranEnergy() { delete[] vector; }

void ComputeGranEnergy::init() {
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag)
    error->all(FLERR, "compute gran/energy balances spheres; use 'atom_style sphere'");
  require_fixed_box(lmp, std::string("compute ") + id + " gran/energy");
}

void ComputeGranEnergy::compute_vector() {
  invoked_vector = update->ntimestep;
  require_read(lmp, std::string("compute ") + id + " gran/energy",
               !step->is_running() || step->energy_tally.is_read());
  work_out();
  tally.update(lmp, std::string("compute ") + id + " gran/energy", vector);
}

void ComputeGranEnergy::begin_run() {
  if (step->last_tally_unknown() && comm->me == 0)
    error->warning(
        FLERR,
        "compute {} gran/energy: the last run ended early, with a step of which energies "
        "are not known: the first line has no energies of springs in the plane of "
        "contact, and entry 10 has that error from then on; "
        "define the compute before a run that may end early, and end it by fix halt, not by a "
        "timer",
        id);
  work_out();
  tally.begin_run(lmp, std::string("compute ") + id + " gran/energy", vector);
}

void ComputeGranEnergy::end_run() {
  work_out();
  tally.end_run(vector);
}

/// All entries but what is missing.
void ComputeGranEnergy::work_out() {
  particles.check(lmp, std::string("compute ") + id + " gran/energy");
  double mine[ENTRIES];
  std::copy_n(before, static_cast<int>(ENTRIES), mine);
  step->energy_tally.sums().add_so_far(1.0, mine);
  const std::vector<double> weight = weights(lmp);
  for (int i = 0; i < atom->nlocal; i++) {
    const auto body = step->body(i);
    if (body.inverse_mass == 0.0) continue;
    const double inverse_inertia = cohesion::contact_solver::inverse_inertia(body);
    double place[3];
    domain->unmap(atom->x[i], atom->image[i], place);
    add_body(mine, 1.0 / body.inverse_mass, 1.0 / inverse_inertia, cohesion::vector(atom->v[i]),
             cohesion::vector(atom->omega[i]), cohesion::vector(&weight[3 * i]),
             cohesion::vector(place));
  }
  step->energy_tally.sums().add_stored(mine);
  MPI_Allreduce(mine, vector, ENTRIES, MPI_DOUBLE, MPI_SUM, world);
}

/// Kinetic and stored energy.
double ComputeGranEnergy::compute_scalar() {
  if (invoked_vector != update->ntimestep) compute_vector();
  invoked_scalar = update->ntimestep;
  return scalar = stored(vector);
}
