// SPDX-License-Identifier: GPL-2.0-only
#include "outputs/compute_gran_energy.h"

#include <vector>

#include "atom.h"
#include "comm.h"
#include "contact_solver/energy_balance.h"
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
    : EnergyTallyCompute(lammps, narg, arg), step(FixContactStep::of(lammps)), before() {
  reader = step->energy_tally.add_reader();
  add_so_far(step->energy_tally, step->work(), -1.0, before);
}

void ComputeGranEnergy::init() {
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag)
    error->all(FLERR, "compute gran/energy balances spheres; use 'atom_style sphere'");
  EnergyTallyCompute::init();
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
  EnergyTallyCompute::begin_run();
}

bool ComputeGranEnergy::is_read() { return !step->is_running() || step->energy_tally.is_read(); }

void ComputeGranEnergy::add_to(double* entries) {
  for (int k = 0; k < ENTRIES; k++) entries[k] += before[k];
  add_so_far(step->energy_tally, step->work(), 1.0, entries);
  const std::vector<double> weight = weights(lmp);
  for (int i = 0; i < atom->nlocal; i++) {
    const auto body = step->body(i);
    if (body.inverse_mass == 0.0) continue;
    const double inverse_inertia = cohesion::contact_solver::inverse_inertia(body);
    double place[3];
    domain->unmap(atom->x[i], atom->image[i], place);
    add_body(entries, 1.0 / body.inverse_mass, 1.0 / inverse_inertia, cohesion::vector(atom->v[i]),
             cohesion::vector(atom->omega[i]), cohesion::vector(&weight[3 * i]),
             cohesion::vector(place));
  }
  add_stored(step->energy_tally, step->work(), entries);
}
