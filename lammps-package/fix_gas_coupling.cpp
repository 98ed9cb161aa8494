// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_gas_coupling.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "atom.h"
#include "comm.h"
#include "drag/particle_drag.h"
#include "engine_api.h"
#include "error.h"
#include "memory.h"
#include "message.h"
#include "modify.h"
#include "sphere.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using cohesion::drag::GasOnParticle;

FixGasCoupling::FixGasCoupling(LAMMPS* lammps, int narg, char** arg)
    : Fix(lammps, narg, arg), rows(nullptr) {
  if (narg != 3) error->all(FLERR, "fix gas/coupling takes no values: 'fix ID group gas/coupling'");
  peratom_flag = 1;
  size_peratom_cols = GasOnParticle::size;
  peratom_freq = 1;
  vector_flag = 1;
  size_vector = 6;
  extvector = 1;
  global_freq = 1;
  restart_peratom = 1;
  create_attribute = 1;

  std::fill_n(impulse, 6, 0.0);
  std::fill_n(force, 6, 0.0);
  FixGasCoupling::grow_arrays(atom->nmax);
  atom->add_callback(engine_api::GROW);
  atom->add_callback(engine_api::RESTART);
  for (int i = 0; i < atom->nlocal; i++) FixGasCoupling::set_arrays(i);
}

FixGasCoupling::~FixGasCoupling() {
  atom->delete_callback(id, engine_api::GROW);
  atom->delete_callback(id, engine_api::RESTART);
  memory->destroy(rows);
}

int FixGasCoupling::setmask() { return POST_FORCE; }

void FixGasCoupling::init() {
  if (!atom->radius_flag || !atom->rmass_flag)
    error->all(FLERR,
               "fix gas/coupling acts on spheres and needs an atom style with radii and "
               "masses, for instance 'atom_style sphere'");
  // The drag of a step depends on all other forces of that step, so they must be there already.
  // Fixes that keep particles in a plane add none.
  const auto adds_forces = [this](int ifix) {
    const std::string name = modify->fix[ifix]->style;
    return (modify->fmask[ifix] & POST_FORCE) && name != "enforce2d" && name != "planeforce";
  };
  bool behind = false;
  for (int ifix = 0; ifix < modify->nfix; ifix++) {
    if (behind && comm->me == 0 && adds_forces(ifix))
      error->warning(FLERR, message("fix ", id, " gas/coupling stands before fix ",
                                    modify->fix[ifix]->id, " ", modify->fix[ifix]->style,
                                    ", whose forces it cannot see; define fix gas/coupling last")
                                .c_str());
    if (modify->fix[ifix] == this) behind = true;
  }
}

// A set-up puts the forces of the step around here on, which a previous run has recorded:
// velocities have then had half of them.
void FixGasCoupling::setup(int) { put_on_forces(true); }

void FixGasCoupling::post_force(int) { put_on_forces(false); }

void FixGasCoupling::put_on_forces(bool setting_up) {
  const double dt = update->dt;
  std::fill_n(force, 6, 0.0);
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    GasOnParticle& felt = gas(i);
    const cohesion::drag::ParticleDrag drag(felt.drag_coefficient, atom->rmass[i], dt);
    const double volume = cohesion::sphere_volume(atom->radius[i]);
    for (int k = 0; k < 3; k++) {
      const double pressure = cohesion::drag::pressure_force(volume, felt.pressure_gradient[k]);
      const double others = atom->f[i][k] + pressure;
      const double slip = felt.velocity[k] - atom->v[i][k];
      const double drag_force =
          setting_up ? drag.force_about(slip, others) : drag.force(slip, others);
      atom->f[i][k] = others + drag_force;
      force[k] += drag_force;
      force[3 + k] += pressure;
      if (!setting_up) felt.drag_impulse[k] += drag_force * dt;
    }
  }
  if (!setting_up)
    for (int k = 0; k < 6; k++) impulse[k] += force[k] * dt;
}

/// "gas": double** [atoms], each row a GasOnParticle. "gas_impulse": double[6], the impulse of drag
/// and of pressure on this rank's particles, summed over the steps until the caller resets it.
void* FixGasCoupling::extract(const char* name, int& dimension) {
  dimension = strcmp(name, "gas") == 0 ? 2 : 1;
  if (dimension == 2) return rows;
  return strcmp(name, "gas_impulse") == 0 ? impulse : nullptr;
}

/// Force of drag (1-3) and of the pressure gradient (4-6) on all particles.
double FixGasCoupling::compute_vector(int n) {
  double all = 0.0;
  MPI_Allreduce(&force[n], &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* ---------------------------------------------------------------------- */

void FixGasCoupling::grow_arrays(int nmax) {
  memory->grow(rows, nmax, GasOnParticle::size, "gas/coupling:rows");
  array_atom = rows;
}

void FixGasCoupling::set_arrays(int i) { std::fill_n(rows[i], GasOnParticle::size, 0.0); }

void FixGasCoupling::copy_arrays(int i, int j, int) {
  std::copy_n(rows[i], GasOnParticle::size, rows[j]);
}

int FixGasCoupling::pack_exchange(int i, double* buf) {
  std::copy_n(rows[i], GasOnParticle::size, buf);
  return GasOnParticle::size;
}

int FixGasCoupling::unpack_exchange(int i, double* buf) {
  std::copy_n(buf, GasOnParticle::size, rows[i]);
  return GasOnParticle::size;
}

int FixGasCoupling::pack_restart(int i, double* buf) {
  buf[0] = GasOnParticle::size + 1;  // LAMMPS finds the next fix's values by this
  std::copy_n(rows[i], GasOnParticle::size, buf + 1);
  return GasOnParticle::size + 1;
}

void FixGasCoupling::unpack_restart(int i, int nth) {
  const double* values = atom->extra[i];
  for (int k = 0; k < nth; k++) values += static_cast<int>(*values);
  std::copy_n(values + 1, GasOnParticle::size, rows[i]);
}

int FixGasCoupling::size_restart(int) { return GasOnParticle::size + 1; }
int FixGasCoupling::maxsize_restart() { return GasOnParticle::size + 1; }

double FixGasCoupling::memory_usage() {
  return static_cast<double>(atom->nmax) * GasOnParticle::size * sizeof(double);
}
