// SPDX-License-Identifier: GPL-2.0-or-later
#include "common/fix_gas_coupling.h"

#include <algorithm>
#include <limits>
#include <set>
#include <string>

#include "atom.h"
#include "comm.h"
#include "common/engine_api.h"
#include "common/message.h"
#include "common/plausible_sizes.h"
#include "drag/particle_drag.h"
#include "error.h"
#include "liquid/sphere_in_liquid.h"
#include "memory.h"
#include "modify.h"
#include "sphere.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using cohesion::drag::GasOnParticle;
using cohesion::liquid::LiquidOnParticle;

FixGasCoupling::FixGasCoupling(LAMMPS* lammps, int narg, char** arg)
    : Fix(lammps, narg, arg), rows(nullptr), liquid_rows(nullptr) {
  if (narg != 3) stop(lmp, FLERR, "fix gas/coupling takes no values: 'fix ID group gas/coupling'");
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
  memory->destroy(liquid_rows);
}

int FixGasCoupling::setmask() { return POST_FORCE; }

void FixGasCoupling::init() {
  if (!atom->radius_flag || !atom->rmass_flag)
    stop(lmp, FLERR,
         "fix gas/coupling acts on spheres and needs an atom style with radii and "
         "masses, for instance 'atom_style sphere'");
  require_mechanical_units(lmp, message("fix ", id, " gas/coupling"));
  const std::string fixes = unseen_fixes();
  if (!fixes.empty() && comm->me == 0)
    error->warning(FLERR, message("fix ", id, " gas/coupling stands before ", fixes,
                                  ", whose forces it does not see; define fix gas/coupling behind")
                              .c_str());
}

/// Returns a list, in words, of the fixes that add forces after this one. The drag of a step
/// depends on all other forces of that step, so they must be there already. Those that hold
/// particles or keep them in a plane take forces away, the gas's too; those of heat and those that
/// look after contacts put on none.
std::string FixGasCoupling::unseen_fixes() const {
  const std::set<std::string> allowed{
      "enforce2d", "planeforce",           "lineforce",      "freeze", "setforce", "store/force",
      "heat/gran", "heat/gran/conduction", "cohesion_advice"};
  std::string found;
  const int self = modify->find_fix(id);
  for (int k = self + 1; k < modify->nfix; k++) {
    const Fix* const fix = modify->fix[k];
    if ((modify->fmask[k] & POST_FORCE) && allowed.count(fix->style) == 0)
      found += message(found.empty() ? "fix " : ", fix ", fix->id, " ", fix->style);
  }
  return found;
}

/// Returns a list, in words, of the fixes that change the size or the shape of the box.
std::string FixGasCoupling::box_fixes() const {
  std::string found;
  for (int k = 0; k < modify->nfix; k++) {
    const Fix* const fix = modify->fix[k];
    if (engine_api::changes_box(fix))
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
    if (liquid_rows)
      apply_liquid(i, setting_up);
    else
      apply_gas(i, setting_up);
  }
  if (!setting_up)
    for (int k = 0; k < 6; k++) impulse[k] += force[k] * dt;
}

/// Adds what pressure and drag put on a particle in this step, three components each.
inline void FixGasCoupling::add_forces(GasOnParticle& felt, const double* pressure,
                                       const double* drag_force, bool setting_up) {
  for (int k = 0; k < 3; k++) {
    force[k] += drag_force[k];
    force[3 + k] += pressure[k];
  }
  if (setting_up) return;
  const double dt = update->dt;
  for (int k = 0; k < 3; k++) felt.drag_impulse[k] += drag_force[k] * dt;
}

void FixGasCoupling::apply_gas(int i, bool setting_up) {
  GasOnParticle& felt = gas(i);
  const cohesion::drag::ParticleDrag drag(felt.drag_coefficient, atom->rmass[i], update->dt);
  const double volume = cohesion::sphere_volume(atom->radius[i]);
  double* const f = atom->f[i];
  const double* const v = atom->v[i];
  double pressure[3], drag_force[3], all[3];
  for (int k = 0; k < 3; k++) {
    pressure[k] = cohesion::drag::pressure_force(volume, felt.pressure_gradient[k]);
    const double others = f[k] + pressure[k];
    const double slip = felt.velocity[k] - v[k];
    drag_force[k] = setting_up ? drag.force_about(slip, others) : drag.force(slip, others);
    all[k] = others + drag_force[k];
  }
  std::copy_n(all, 3, f);
  add_forces(felt, pressure, drag_force, setting_up);
}

/// With added mass and lift, which count with the drag: all that is not pressure.
void FixGasCoupling::apply_liquid(int i, bool setting_up) {
  const GasOnParticle& felt = gas(i);
  const LiquidOnParticle& beside = liquid(i);
  const cohesion::liquid::SphereInLiquid sphere{felt.drag_coefficient, beside.drag_per_slip,
                                                atom->rmass[i], beside.added_mass,
                                                cohesion::vector(beside.lift)};
  const cohesion::Vector3 gradient = cohesion::vector(felt.pressure_gradient);
  const double volume = cohesion::sphere_volume(atom->radius[i]);
  const cohesion::Vector3 pressure{cohesion::drag::pressure_force(volume, gradient.x),
                                   cohesion::drag::pressure_force(volume, gradient.y),
                                   cohesion::drag::pressure_force(volume, gradient.z)};
  const cohesion::Vector3 others = cohesion::vector(atom->f[i]) + pressure;
  const cohesion::Vector3 slip = cohesion::vector(felt.velocity) - cohesion::vector(atom->v[i]);
  const cohesion::Vector3 moving =
      others + beside.added_mass * cohesion::vector(beside.acceleration);
  const auto mean =
      setting_up ? &cohesion::liquid::acceleration_about : &cohesion::liquid::acceleration;
  const cohesion::Vector3 all = atom->rmass[i] * mean(sphere, slip, moving, update->dt);
  const cohesion::Vector3 exchanged = all - others;
  const double total[] = {all.x, all.y, all.z};
  const double by_pressure[] = {pressure.x, pressure.y, pressure.z};
  const double beside_pressure[] = {exchanged.x, exchanged.y, exchanged.z};
  std::copy_n(total, 3, atom->f[i]);
  add_forces(gas(i), by_pressure, beside_pressure, setting_up);
}

void* FixGasCoupling::extract(const char* name, int& dimension) {
  const std::string asked = name;
  dimension = asked == "gas" || asked == "liquid" ? 2 : 1;
  if (asked == "gas") return rows;
  if (asked == "liquid") {
    use_liquid();
    return liquid_rows;
  }
  if (asked == "no_liquid") {
    memory->destroy(liquid_rows);
    liquid_rows = nullptr;  // LIGGGHTS leaves it where it was
    return nullptr;
  }
  if (asked == "gas_impulse") return impulse;
  if (asked == "gravity") {
    find_gravity();
    return gravity;
  }
  if (asked == "unseen_fixes" || asked == "box_fixes") {
    listed = asked == "box_fixes" ? box_fixes() : unseen_fixes();
    return listed.empty() ? nullptr : &listed[0];
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

/// Makes the rows of the liquid, all zero, unless they are there.
void FixGasCoupling::use_liquid() {
  if (liquid_rows) return;
  // One at least: a rank without particles must hand on what comes to it, too.
  memory->create(liquid_rows, std::max(atom->nmax, 1), LiquidOnParticle::size,
                 "gas/coupling:liquid");
  std::fill_n(liquid_rows[0], std::max(atom->nmax, 1) * LiquidOnParticle::size, 0.0);
}

void FixGasCoupling::grow_arrays(int nmax) {
  memory->grow(rows, nmax, GasOnParticle::size, "gas/coupling:rows");
  if (liquid_rows) memory->grow(liquid_rows, nmax, LiquidOnParticle::size, "gas/coupling:liquid");
  array_atom = rows;
}

void FixGasCoupling::set_arrays(int i) {
  std::fill_n(rows[i], GasOnParticle::size, 0.0);
  if (liquid_rows) std::fill_n(liquid_rows[i], LiquidOnParticle::size, 0.0);
}

void FixGasCoupling::copy_arrays(int i, int j, int) {
  std::copy_n(rows[i], GasOnParticle::size, rows[j]);
  if (liquid_rows) std::copy_n(liquid_rows[i], LiquidOnParticle::size, liquid_rows[j]);
}

/// Numbers that go with a particle.
int FixGasCoupling::row_size() const {
  return GasOnParticle::size + (liquid_rows ? LiquidOnParticle::size : 0);
}

void FixGasCoupling::copy_row(int i, double* to) const {
  to = std::copy_n(rows[i], GasOnParticle::size, to);
  if (liquid_rows) std::copy_n(liquid_rows[i], LiquidOnParticle::size, to);
}

void FixGasCoupling::set_row(int i, const double* from) {
  std::copy_n(from, GasOnParticle::size, rows[i]);
  if (liquid_rows) std::copy_n(from + GasOnParticle::size, LiquidOnParticle::size, liquid_rows[i]);
}

int FixGasCoupling::pack_exchange(int i, double* buf) {
  copy_row(i, buf);
  return row_size();
}

int FixGasCoupling::unpack_exchange(int i, double* buf) {
  set_row(i, buf);
  return row_size();
}

int FixGasCoupling::pack_restart(int i, double* buf) {
  buf[0] = row_size() + 1;  // LAMMPS finds the next fix's values by this
  copy_row(i, buf + 1);
  return row_size() + 1;
}

void FixGasCoupling::unpack_restart(int i, int nth) {
  const double* values = atom->extra[i];
  for (int k = 0; k < nth; k++) values += static_cast<int>(*values);
  if (static_cast<int>(*values) > GasOnParticle::size + 1) use_liquid();
  set_row(i, values + 1);
}

int FixGasCoupling::size_restart(int) { return row_size() + 1; }

/// Before the rows are read nobody knows whether those of the liquid were written.
int FixGasCoupling::maxsize_restart() { return GasOnParticle::size + LiquidOnParticle::size + 1; }

double FixGasCoupling::memory_usage() {
  return static_cast<double>(atom->nmax) * row_size() * sizeof(double);
}
