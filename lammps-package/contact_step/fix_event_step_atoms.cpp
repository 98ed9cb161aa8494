// SPDX-License-Identifier: GPL-2.0-only
// The part of FixEventStep that keeps numbers of particles: for their ghosts, for the process they
// go to, and for restart files.
#include <algorithm>
#include <tuple>

#include "atom.h"
#include "comm.h"
#include "engine_api.h"
#include "fix_event_step.h"
#include "memory.h"
#include "restart_format.h"

using namespace LAMMPS_NS;

/// Sends to ghosts the marks of their owners.
void FixEventStep::forward_marks() { forward_flagged(marks, nullptr, 0); }

/// Brings `each` values of particles with a followed contact to their ghosts; ghosts whose owners
/// have none get 0.
void FixEventStep::forward_to_ghosts(NumbersOf values, int each) {
  for (int i : followed_ghosts) std::fill_n((this->*values)(i), each, 0.0);
  forward_flagged(followed, values, each);
}

/// Gives ghosts the flags of their owners, and those that are flagged `each` of their values.
void FixEventStep::forward_flagged(std::vector<char>& flags, NumbersOf values, int each) {
  std::fill(flags.begin() + atom->nlocal, flags.end(), 0);
  forwarded_flags = flags.data();
  forwarded_values = values;
  values_each = each;
  engine_api::forward_comm(comm, this, 1 + each);
}

// One more than the largest flag.
static constexpr int FLAGS = 4;

/// Packs, of the particles that are flagged, their places in the list with the flag, and their
/// values; -1 after the last one, where the list does not end with it. A ghost that is passed on
/// has what its owner sent.
int FixEventStep::pack_forward_comm(int n, int* list, double* buf, int, int*) {
  double* end = buf;
  for (int k = 0; k < n; k++) {
    if (!forwarded_flags[list[k]]) continue;
    *end++ = FLAGS * k + forwarded_flags[list[k]];
    if (values_each > 0) end = std::copy_n((this->*forwarded_values)(list[k]), values_each, end);
  }
  if (end - buf < (1 + values_each) * n) *end++ = -1.0;
  return static_cast<int>(end - buf);
}

void FixEventStep::unpack_forward_comm(int n, int first, double* buf) {
  for (int k = 0; k < n && *buf >= 0.0; k++) {
    const int flagged = static_cast<int>(*buf++);
    const int i = first + flagged / FLAGS;
    forwarded_flags[i] = static_cast<char>(flagged % FLAGS);
    // One that no contact of this process has may be passed on.
    if (values_each > 0 && shares[i].motion < 0) add_motion(i);
    if (values_each > 0) std::copy_n(buf, values_each, (this->*forwarded_values)(i));
    buf += values_each;
  }
}

void FixEventStep::grow_arrays(int nmax) {
  shares.resize(nmax);
  sudden_forces.resize(nmax);
  if (last.has_room()) last.grow(nmax);
  other_forces.grow(nmax);
  memory->grow(inverse_mass, nmax, "event_step:inverse_mass");
}

void FixEventStep::copy_arrays(int i, int j, int) {
  other_forces.copy(i, j);
  if (last.has_room()) last.copy(i, j);
}

void FixEventStep::set_arrays(int i) {
  other_forces.clear(i);
  if (last.has_room()) last.clear(i);
}

int FixEventStep::pack_exchange(int i, double* buf) {
  const int taken = other_forces.pack(i, buf);
  return last.has_room() ? taken + last.pack(i, buf + taken) : taken;
}

int FixEventStep::unpack_exchange(int i, double* buf) {
  const int taken = other_forces.unpack(i, buf);
  return last.has_room() ? taken + last.unpack(i, buf + taken) : taken;
}

// Numbers of a restart file in front of the tally's: its layout, the step, and whether the tally
// is not known.
static constexpr int LAYOUT = 3, HEAD = 3;
static constexpr int OF_RESTART =
    HEAD + static_cast<int>(std::tuple_size_v<ContactEnergyTally::Totals>);

void FixEventStep::write_restart(FILE* fp) {
  const ContactEnergyTally::Totals mine = energy_tally.totals();
  double values[OF_RESTART] = {RESTART_MARK + LAYOUT, forces_dt,
                               tally_unknown && !running ? 1.0 : 0.0};
  MPI_Reduce(mine.data(), values + HEAD, static_cast<int>(mine.size()), MPI_DOUBLE, MPI_SUM, 0,
             world);
  if (comm->me != 0) return;
  constexpr int size = sizeof(values);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(values, size, 1, fp);
}

void FixEventStep::restart(char* buf) {
  const auto* values = reinterpret_cast<const double*>(buf);
  require_layout(lmp, values[0], "scheme event", LAYOUT);
  forces_dt = values[1];
  tally_unknown = values[2] != 0.0;
  if (forces_dt > 0.0) last.grow(atom->nmax);
  if (comm->me != 0) return;
  ContactEnergyTally::Totals all;
  std::copy_n(values + HEAD, all.size(), all.begin());
  energy_tally.restore_totals(all);
}

int FixEventStep::pack_restart(int i, double* buf) {
  // The engine's own forces may have stayed behind when particles changed rank.
  if (!running && last.has_room()) return last.pack_restart(i, buf);
  buf[0] = last.size_restart();
  std::fill_n(buf + 1, last.size(), 0.0);  // before the first run
  if (running) save_last(i, buf + 1);
  return last.size_restart();
}

void FixEventStep::unpack_restart(int i, int nth) {
  if (last.has_room()) last.unpack_restart(i, atom->extra[i], nth);
}

int FixEventStep::maxsize_restart() { return last.size_restart(); }
int FixEventStep::size_restart(int) { return last.size_restart(); }

double FixEventStep::memory_usage() {
  return (sizeof(double) + sizeof(Share)) * atom->nmax + sizeof(FollowedMotion) * motions.size() +
         impulses.bytes() + static_cast<double>(marks.capacity() + followed.capacity()) +
         static_cast<double>(sizeof(int)) * followed_ghosts.capacity() +
         sizeof(double) * (known_masses.capacity() + known_radii.capacity()) +
         sizeof(cohesion::Vector3) * sudden_forces.capacity() +
         sizeof(int) * suddenly_pushed.capacity() + other_forces.bytes() + last.bytes() +
         energy_tally.bytes();
}
