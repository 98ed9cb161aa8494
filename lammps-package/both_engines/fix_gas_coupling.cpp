// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_gas_coupling.h"

#include <algorithm>
#include <limits>
#include <set>
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
  const std::string fixes = unseen_fixes();
  if (!fixes.empty() && comm->me == 0)
    error->warning(FLERR, message("fix ", id, " gas/coupling stands before ", fixes,
                                  ", whose forces it does not see; define fix gas/coupling behind")
                              .c_str());
}

/// Returns a list, in words, of the fixes that add forces after this one. The drag of a step
/// depends on all other forces of that step, so they must be there already. Those that hold
/// particles or keep them in a plane take forces away, the gas's too; those of heat put on none.
std::string FixGasCoupling::unseen_fixes() const {
  const std::set<std::string> allowed{
      "enforce2d", "planeforce",  "lineforce", "freeze",
      "setforce",  "store/force", "heat/gran", "heat/gran/conduction"};
  std::string found;
  const int self = modify->find_fix(id);
  for (int k = self + 1; k < modify->nfix; k++) {
    const Fix* const fix = modify->fix[k];
    if ((modify->fmask[k] & POST_FORCE) && allowed.count(fix->style) == 0)
      found += message(found.empty() ? "fix " : ", fix ", fix->id, " ", fix->style);
  }
  return found;
}

/// Returns which components of the force of which particles fixes setforce behind this one set:
/// neither gravity nor gas acts along them. The fixes are let act on a force that nobody sets.
std::vector<bool> FixGasCoupling::components_set_afterwards() {
  constexpr double untouched = std::numeric_limits<double>::min();
  std::vector<double> forces(3 * atom->nlocal, untouched);
  double* const f = forces.empty() ? nullptr : atom->f[0];
  std::swap_ranges(forces.begin(), forces.end(), f);
  for (int k = modify->find_fix(id) + 1; k < modify->nfix; k++)
    if (std::string(modify->fix[k]->style) == "setforce") modify->fix[k]->post_force(0);
  std::swap_ranges(forces.begin(), forces.end(), f);
  std::vector<bool> set(forces.size());
  std::transform(forces.begin(), forces.end(), set.begin(),
                 [](double value) { return value != untouched; });
  return set;
}

void FixGasCoupling::find_gravity() {
  std::fill_n(gravity, 3, std::numeric_limits<double>::max());
  std::fill_n(gravity + 3, 3, std::numeric_limits<double>::lowest());
  const std::vector<bool> set = components_set_afterwards();
  for (const auto& [i, given] : engine_api::gravity_of_mobile(lmp, groupbit)) {
    const double acceleration[3] = {given.x, given.y, given.z};
    for (int k = 0; k < 3; k++) {
      if (set[3 * i + k]) continue;
      gravity[k] = std::min(gravity[k], acceleration[k]);
      gravity[3 + k] = std::max(gravity[3 + k], acceleration[k]);
    }
  }
}

// A set-up applies the forces of the step around it, which a previous run has recorded: velocities
// have then had half of them.
void FixGasCoupling::setup(int) { apply_forces(true); }

void FixGasCoupling::post_force(int) { apply_forces(false); }

void FixGasCoupling::apply_forces(bool setting_up) {
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
/// "gravity": double[6], of the accelerations that fixes gravity give to the particles of this rank
/// and the group that forces move, along axes on which no fix setforce behind it sets the force:
/// the lowest of each component, then the highest. "unseen_fixes": char*, fixes that put on forces
/// after this one; null: none.
void* FixGasCoupling::extract(const char* name, int& dimension) {
  const std::string asked = name;
  dimension = asked == "gas" ? 2 : 1;
  if (asked == "gas") return rows;
  if (asked == "gas_impulse") return impulse;
  if (asked == "gravity") {
    find_gravity();
    return gravity;
  }
  if (asked == "unseen_fixes") {
    unseen = unseen_fixes();
    return unseen.empty() ? nullptr : &unseen[0];
  }
  return nullptr;
}

/// Returns the force of drag (1-3) and of the pressure gradient (4-6) on all particles, [force].
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
