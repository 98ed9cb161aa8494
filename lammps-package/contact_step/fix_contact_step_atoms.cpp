// SPDX-License-Identifier: GPL-2.0-only
// The part of FixContactStep that stores numbers per particle, and sends them to ghosts, to other
// ranks and to restart files.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>

#include "atom.h"
#include "comm.h"
#include "common/box_shear.h"
#include "common/engine_api.h"
#include "contact_step/fix_contact_step.h"
#include "domain.h"
#include "engine/mobile_particles.h"
#include "input/restart_format.h"
#include "memory.h"
#include "neighbor.h"
#include "shear/flight.h"
#include "update.h"

using namespace LAMMPS_NS;

/// Updates longest_flight over all ranks, and all masses and radii.
void FixContactStep::update_particles() {
  const int all = atom->nlocal + atom->nghost;
  double fastest = fastest_of(atom, domain, number_of_movers(lmp));
  // Both ranks that compute a pair must use the same bound.
  if (comm->nprocs > 1) MPI_Allreduce(MPI_IN_PLACE, &fastest, 1, MPI_DOUBLE, MPI_MAX, world);
  longest_flight = cohesion::shear::longest_flight(fastest, rate_of_shear(domain).amount,
                                                   neighbor->cutneighmax, 0.5 * update->dt);
  update_masses(all);
  update_radii(all);
}

/// Masses may change in any step (fix adapt); the comparison costs next to nothing. Groups are
/// those of the last rebuild of the neighbour list, when ghosts receive theirs, except dynamic
/// ones.
void FixContactStep::update_masses(int all) {
  const double* const mass = atom->rmass;
  if (any_dynamic_group) return update_masses_by_owners(all);
  if (neighbor->ago == 0 || known_masses.empty()) {
    for (int i = 0; i < all; i++) inverse_mass[i] = mobile->inverse_mass(atom->mask[i], mass[i]);
  } else {
    if (std::memcmp(known_masses.data(), mass, all * sizeof(double)) == 0) return;
    for (int i = 0; i < all; i++)
      if (inverse_mass[i] != 0.0) inverse_mass[i] = 1.0 / mass[i];
  }
  known_masses.assign(mass, mass + all);
}

/// The same with dynamic groups, of which only owners know whether they move their particles.
void FixContactStep::update_masses_by_owners(int all) {
  std::vector<char> moves(all, 0);
  for (int i = 0; i < atom->nlocal; i++) moves[i] = mobile->inverse_mass(atom->mask[i], 1.0) != 0.0;
  forward_flagged(moves, nullptr, 0);
  for (int i = 0; i < all; i++) inverse_mass[i] = moves[i] ? 1.0 / atom->rmass[i] : 0.0;
}

bool FixContactStep::is_led(int i) const { return mobile->is_led(atom->mask[i]); }

void FixContactStep::update_radii(int all) {
  const double* const radius = atom->radius;
  if (neighbor->ago != 0 && known_radii.size() == static_cast<std::size_t>(all) &&
      std::memcmp(known_radii.data(), radius, all * sizeof(double)) == 0)
    return;
  known_radii.assign(radius, radius + all);
  radii_version++;
}

/// Sends the accelerations of particles to their ghosts, and finds the largest.
void FixContactStep::forward_accelerations() {
  const int all = atom->nlocal + atom->nghost;
  const auto square = [this](int i) {
    const cohesion::Vector3 a = cohesion::vector(accelerations.of(i));
    return dot(a, a);
  };
  double largest = 0.0;
  flagged.resize(all);
  for (int i = 0; i < atom->nlocal; i++) {
    const double now = square(i);
    flagged[i] = now != 0.0;
    largest = std::max(largest, now);
  }
  if (atom->nghost > 0 || comm->nprocs > 1) {
    forward_flagged(flagged, accelerations.of(0), accelerations.size());
    for (int i = atom->nlocal; i < all; i++) {
      if (flagged[i])
        largest = std::max(largest, square(i));
      else
        accelerations.clear(i);
    }
  }
  largest_acceleration = std::sqrt(largest);
}

/// Sends flags to ghosts, and `each` values of every flagged particle.
void FixContactStep::forward_flagged(std::vector<char>& flags, double* values, int each) {
  std::fill(flags.begin() + atom->nlocal, flags.end(), 0);
  forwarded_flags = flags.data();
  forwarded_values = values;
  values_each = each;
  engine_api::forward_comm(comm, this, 1 + each);
}

/// Packs indices and values of the flagged particles, and -1 after the last one unless the list
/// ends with it. Ghosts that are passed on have the values of their owner.
int FixContactStep::pack_forward_comm(int n, int* list, double* buf, int, int*) {
  double* end = buf;
  for (int k = 0; k < n; k++) {
    if (!forwarded_flags[list[k]]) continue;
    *end++ = k;
    end = std::copy_n(forwarded_values + values_each * list[k], values_each, end);
  }
  if (end - buf < (1 + values_each) * n) *end++ = -1.0;
  return static_cast<int>(end - buf);
}

void FixContactStep::unpack_forward_comm(int n, int first, double* buf) {
  for (int k = 0; k < n && *buf >= 0.0; k++) {
    const int i = first + static_cast<int>(*buf++);
    forwarded_flags[i] = 1;
    std::copy_n(buf, values_each, forwarded_values + values_each * i);
    buf += values_each;
  }
}

void FixContactStep::grow_arrays(int nmax) {
  impulsive_forces.resize(nmax);
  if (last.has_room()) last.grow(nmax);
  accelerations.grow(nmax);
  memory->grow(inverse_mass, nmax, "contact_step:inverse_mass");
}

void FixContactStep::copy_arrays(int i, int j, int) {
  accelerations.copy(i, j);
  if (last.has_room()) last.copy(i, j);
}

void FixContactStep::set_arrays(int i) {
  accelerations.clear(i);
  if (last.has_room()) last.clear(i);
}

int FixContactStep::pack_exchange(int i, double* buf) {
  const int taken = accelerations.pack(i, buf);
  return last.has_room() ? taken + last.pack(i, buf + taken) : taken;
}

int FixContactStep::unpack_exchange(int i, double* buf) {
  const int taken = accelerations.unpack(i, buf);
  return last.has_room() ? taken + last.unpack(i, buf + taken) : taken;
}

// Numbers of a restart file before the totals of the energy balance: layout, step, and whether
// these totals are unknown.
static constexpr int LAYOUT = 6, HEAD = 3;
static constexpr int OF_RESTART =
    HEAD + static_cast<int>(std::tuple_size_v<FixContactStep::Totals>);

void FixContactStep::write_restart(FILE* fp) {
  if (!running) {  // as init() does; the pair styles and walls may be others than in the last run
    find_styles();
    follow_renumbering();
  }
  const Totals mine = totals();
  double values[OF_RESTART] = {RESTART_MARK + LAYOUT, forces_dt,
                               tally_unknown && !running ? 1.0 : 0.0};
  MPI_Reduce(mine.data(), values + HEAD, static_cast<int>(mine.size()), MPI_DOUBLE, MPI_SUM, 0,
             world);
  if (comm->me != 0) return;
  constexpr int size = sizeof(values);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(values, size, 1, fp);
}

void FixContactStep::restart(char* buf) {
  const auto* values = reinterpret_cast<const double*>(buf);
  require_layout(lmp, values[0], "scheme exact", LAYOUT);
  forces_dt = values[1];
  tally_unknown = values[2] != 0.0;
  if (forces_dt > 0.0) last.grow(atom->nmax);
  if (comm->me != 0) return;
  Totals all;
  std::copy_n(values + HEAD, all.size(), all.begin());
  restore_totals(all);
}

int FixContactStep::pack_restart(int i, double* buf) {
  // The engine does not send forces with particles that change rank; `last` is sent.
  if (!running && last.has_room()) return last.pack_restart(i, buf);
  buf[0] = last.size_restart();
  std::fill_n(buf + 1, last.size(), 0.0);  // zeros before the first run
  if (running) save_last(i, buf + 1);
  return last.size_restart();
}

void FixContactStep::unpack_restart(int i, int nth) {
  if (last.has_room()) last.unpack_restart(i, atom->extra[i], nth);
}

int FixContactStep::maxsize_restart() { return last.size_restart(); }
int FixContactStep::size_restart(int) { return last.size_restart(); }

double FixContactStep::memory_usage() {
  return sizeof(double) * atom->nmax + impulses.bytes() + static_cast<double>(flagged.capacity()) +
         sizeof(double) * (known_masses.capacity() + known_radii.capacity()) +
         sizeof(cohesion::Vector3) * impulsive_forces.capacity() +
         sizeof(int) * impulsive_particles.capacity() + accelerations.bytes() + last.bytes();
}
