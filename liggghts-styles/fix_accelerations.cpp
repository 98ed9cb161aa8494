// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_accelerations.h"

#include <mpi.h>
// The engine's headers want mpi.h before them.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "atom.h"
#include "comm.h"
#include "common/message.h"
#include "liggghts_api.h"
#include "memory.h"
#include "modify.h"
#include "update.h"

namespace LIGGGHTS {
namespace Cohesion {

using namespace LAMMPS_NS;

// Of restart files; first there was the step, which is above 0.
static constexpr double LAYOUT = -6.0;

static double squared(const double* a) { return a[0] * a[0] + a[1] * a[1] + a[2] * a[2]; }

FixAccelerations::FixAccelerations(LAMMPS* engine, int count, char** words)
    : Fix(engine, count, words) {
  comm_forward = 3;
  restart_global = 1;
  create_attribute = 1;  // of particles that are inserted
  grow_arrays(atom->nmax);
  for (int i = 0; i < atom->nlocal; i++) set_arrays(i);
  atom->add_callback(engine_api::GROW);
}

FixAccelerations::~FixAccelerations() {
  atom->delete_callback(id, engine_api::GROW);
  memory->destroy(acceleration_);
  memory->destroy(excluded_);
}

int FixAccelerations::setmask() { return FixConst::INITIAL_INTEGRATE | FixConst::PRE_FORCE; }

void FixAccelerations::init() {
  const std::string bodies = rigid_bodies(*modify);
  if (!bodies.empty())
    LAMMPS_NS::stop(lmp, FLERR,
                    "cohesion, scheme exact: resolves spheres that move each by itself, and ",
                    bodies, " moves bodies of several: use 'scheme sampled'");
}

std::string FixAccelerations::rigid_bodies(const Modify& modify) {
  for (int k = 0; k < modify.nfix; k++)
    for (const char* const bodies : {"multisphere", "rigid"})
      if (std::strncmp(modify.fix[k]->style, bodies, std::strlen(bodies)) == 0)
        return std::string("fix ") + modify.fix[k]->style + " " + modify.fix[k]->id;
  return "";
}

/// Forces of a run that is set up are those of before or act on where all is.
void FixAccelerations::setup_pre_force(int) {
  const int all = atom->nlocal + atom->nghost;
  for (int i = 0; i < all; i++) set_arrays(i);
  largest_squared_ = 0.0;
  last_step_ = forces_step_;
  forces_step_ = update->dt;
  begin_step();
}

void FixAccelerations::initial_integrate(int) {
  clock_ += 1.0;
  double largest = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    const double* const f = atom->f[0] + 3 * i;
    double* const to = acceleration_[0] + 3 * i;
    const double inverse_mass = 1.0 / atom->rmass[i];
    for (int k = 0; k < 3; k++)
      to[k] = (any_excluded_ ? f[k] - excluded_scale_ * excluded_[i][k] : f[k]) * inverse_mass;
    largest = std::max(largest, squared(to));
  }
  largest_squared_ = largest;
}

/// A force f has given f dt/2, and gives f dt'/2 now. That of an impulse becomes f dt/dt'. Fixes
/// that hold particles have set forces on them to 0.
void FixAccelerations::reset_dt() {
  const double ratio = forces_step_ / update->dt, more = ratio - excluded_scale_;
  excluded_scale_ = ratio;
  if (!any_excluded_) return;
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < 3; k++)
      if (atom->f[i][k] != 0.0) atom->f[i][k] += more * excluded_[i][k];
}

void FixAccelerations::pre_force(int) {
  forces_step_ = update->dt;
  comm->forward_comm_fix(this);
  begin_step();
}

void FixAccelerations::begin_step() {
  if (any_excluded_)
    for (int i = 0; i < atom->nlocal; i++) std::fill_n(excluded_[i], 3, 0.0);
  any_excluded_ = false;
  excluded_scale_ = 1.0;
  // Not to be a last digit less.
  largest_ = (1.0 + 1e-12) * std::sqrt(largest_squared_);
}

void FixAccelerations::grow_arrays(int most) {
  memory->grow(acceleration_, most, 3, "others:acceleration");
  memory->grow(excluded_, most, 3, "others:excluded");
}

void FixAccelerations::copy_arrays(int i, int j, int) {
  std::copy_n(acceleration_[i], 3, acceleration_[j]);
  std::copy_n(excluded_[i], 3, excluded_[j]);
}

void FixAccelerations::set_arrays(int i) {
  std::fill_n(acceleration_[i], 3, 0.0);
  std::fill_n(excluded_[i], 3, 0.0);
}

/// What was excluded is in the acceleration by then.
int FixAccelerations::pack_exchange(int i, double* buffer) {
  std::copy_n(acceleration_[i], 3, buffer);
  return 3;
}

int FixAccelerations::unpack_exchange(int i, double* buffer) {
  set_arrays(i);
  std::copy_n(buffer, 3, acceleration_[i]);
  largest_squared_ = std::max(largest_squared_, squared(buffer));
  return 3;
}

int FixAccelerations::pack_comm(int count, int* list, double* buffer, int, int*) {
  for (int k = 0; k < count; k++) std::copy_n(acceleration_[0] + 3 * list[k], 3, buffer + 3 * k);
  return comm_forward;
}

void FixAccelerations::unpack_comm(int count, int first, double* buffer) {
  std::copy_n(buffer, 3 * count, acceleration_[0] + 3 * first);
  double largest = largest_squared_;
  for (int k = 0; k < count; k++) largest = std::max(largest, squared(buffer + 3 * k));
  largest_squared_ = largest;
}

void FixAccelerations::write_restart(FILE* file) {
  if (comm->me != 0) return;
  const double values[] = {LAYOUT, forces_step_, clock_};
  const int size = sizeof(values);
  fwrite(&size, sizeof(int), 1, file);
  fwrite(values, size, 1, file);
}

void FixAccelerations::restart(char* buffer) {
  double layout = 0.0;
  std::memcpy(&layout, buffer, sizeof(double));
  if (layout != LAYOUT)
    LAMMPS_NS::stop(
        lmp, FLERR,
        "cohesion, scheme exact: another version of the package wrote the restart file; use "
        "'write_data' with that version and 'read_data' with this one");
  std::memcpy(&forces_step_, buffer + sizeof(double), sizeof(double));
  std::memcpy(&clock_, buffer + 2 * sizeof(double), sizeof(double));
}

double FixAccelerations::memory_usage() { return 6.0 * sizeof(double) * atom->nmax; }

}  // namespace Cohesion
}  // namespace LIGGGHTS
