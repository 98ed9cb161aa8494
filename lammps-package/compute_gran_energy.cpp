// SPDX-License-Identifier: GPL-2.0-only
#include "compute_gran_energy.h"

#include <algorithm>
#include <numeric>

#include "atom.h"
#include "error.h"
#include "event_stepping/cohesive_contact.h"
#include "fix_event_step.h"
#include "update.h"

using namespace LAMMPS_NS;

namespace {

/// Entries of the vector, in its order.
enum Entry {
  KINETIC,
  ROTATIONAL,
  SPRING,
  TANGENTIAL_SPRING,
  ADHESION,
  NORMAL_DAMPING,
  TANGENTIAL_DAMPING,
  FRICTION,
  EXTERNAL_WORK,
  RESIDUAL,
  ENTRIES
};

}  // namespace

ComputeGranEnergy::ComputeGranEnergy(LAMMPS* lammps, int narg, char** arg)
    : Compute(lammps, narg, arg), step(FixEventStep::of(lammps)), opened(false), balance(0.0) {
  if (narg != 3) error->all(FLERR, "compute gran/energy takes no further arguments");
  if (igroup != 0)
    error->all(FLERR, "compute gran/energy balances all particles; its group must be 'all'");
  scalar_flag = vector_flag = 1;
  extscalar = extvector = 1;
  size_vector = ENTRIES;
  vector = new double[ENTRIES];
  step->keep_book();
}

ComputeGranEnergy::~ComputeGranEnergy() { delete[] vector; }

void ComputeGranEnergy::init() {
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag)
    error->all(FLERR, "compute gran/energy balances spheres; use 'atom_style sphere'");
}

void ComputeGranEnergy::compute_vector() {
  invoked_vector = update->ntimestep;
  double mine[ENTRIES] = {};
  // The motion of the step ends with the velocities the next half kick leads to.
  for (int i = 0; i < atom->nlocal; i++) {
    const auto body = step->body(i);
    if (body.inverse_mass == 0.0) continue;
    const double kick = step->half_kick() * body.inverse_mass;
    const double twist = step->half_kick() * cohesion::event_stepping::inverse_inertia(body);
    for (int k = 0; k < 3; k++) {
      const double v = atom->v[i][k] + kick * atom->f[i][k];
      const double omega = atom->omega[i][k] + twist * atom->torque[i][k];
      mine[KINETIC] += 0.5 / body.inverse_mass * v * v;
      mine[ROTATIONAL] += 0.5 / cohesion::event_stepping::inverse_inertia(body) * omega * omega;
    }
  }
  const FixEventStep::Book& book = step->book;
  mine[SPRING] = book.spring;
  mine[TANGENTIAL_SPRING] = book.tangential_spring;
  mine[ADHESION] = book.adhesion;
  mine[NORMAL_DAMPING] = book.normal_damping;
  mine[TANGENTIAL_DAMPING] = book.tangential_damping;
  mine[FRICTION] = book.friction;
  mine[EXTERNAL_WORK] = book.external_work;
  MPI_Allreduce(mine, vector, ENTRIES, MPI_DOUBLE, MPI_SUM, world);

  const double total = std::accumulate(vector, vector + EXTERNAL_WORK, 0.0) - vector[EXTERNAL_WORK];
  if (!opened) balance = total;
  opened = true;
  vector[RESIDUAL] = total - balance;
}

/// Kinetic and stored energy.
double ComputeGranEnergy::compute_scalar() {
  if (invoked_vector != update->ntimestep) compute_vector();
  invoked_scalar = update->ntimestep;
  return scalar = std::accumulate(vector, vector + NORMAL_DAMPING, 0.0);
}
