// SPDX-License-Identifier: GPL-2.0-only
#include "hard_event_time_warp.h"

#include <algorithm>

#include "atom.h"
#include "error.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::hard_sphere;

// Events of a window per particle. How often a window is repeated goes with the length of the
// chains of events that cross from one process to another and back: two to three times here.
static constexpr double EVENTS_OF_A_WINDOW = 0.25;

HardEventTimeWarp::HardEventTimeWarp(LAMMPS* lammps, EventSimulation& simulation)
    : Pointers(lammps), simulation_(simulation), border_(world), own_(0) {}

void HardEventTimeWarp::plan(const std::vector<BorderExchange::Request>& remote) {
  own_ = atom->nlocal;
  owners_.clear();
  for (const BorderExchange::Request& request : remote) owners_.push_back(request.owner);
  border_.plan(remote, own_);
}

void HardEventTimeWarp::load_borders() {
  std::vector<std::vector<Flight> > out(border_.peers().size());
  std::vector<std::vector<Flight> > in;
  for (int p = 0; p < static_cast<int>(out.size()); p++)
    for (const int i : border_.followed_by(p)) out[p].push_back(simulation_.bodies[i].flight);
  border_.exchange(out, in);
  for (int p = 0; p < static_cast<int>(in.size()); p++)
    for (int slot = 0; slot < static_cast<int>(in[p].size()); slot++)
      simulation_.bodies[border_.local(p, slot)].flight = in[p][slot];
}

void HardEventTimeWarp::run_step(long expected_events) {
  const double dt = update->dt;
  for (int n = 0; n < static_cast<int>(simulation_.candidates.size()); n++)
    if (with_remote_body(simulation_.candidates[n])) simulation_.predict(n);
  simulation_.order_queue();
  const double of_a_window = EVENTS_OF_A_WINDOW * static_cast<double>(atom->natoms);
  const int windows = 1 + static_cast<int>(static_cast<double>(expected_events) / of_a_window);
  for (int n = 1; n <= windows && simulation_.overrun() < 0; n++)
    run_window(n == windows ? dt : n * dt / windows);
}

/// Runs the window until no process has received another update than it has assumed. `from` is the
/// global virtual time.
void HardEventTimeWarp::run_window(double until) {
  simulation_.begin_window();
  simulation_.run(until);
  double from = 0.0;
  for (int round = 0;; round++) {
    const std::vector<RemoteUpdate> incoming = exchange_updates(from);
    const double differs = simulation_.first_difference(from, incoming);
    MPI_Allreduce(&differs, &from, 1, MPI_DOUBLE, MPI_MIN, world);
    if (from == never) break;
    if (round > simulation_.rules.limit)
      error->all(FLERR,
                 "pair_style hard/square_well: in step {} the processes do not agree on the events "
                 "after {} exchanges: particles are pressed together. Use a smaller time step or "
                 "keyword rest or contact_time",
                 update->ntimestep, round);
    if (differs < never) simulation_.rollback_and_run(differs, incoming, until);
  }
}

/// Sends the updates of own particles from a time on to those who simulate them, but not the ones
/// of events with a partner that the receiver owns: it has executed these itself. Returns those
/// that came, in order.
std::vector<RemoteUpdate> HardEventTimeWarp::exchange_updates(double from) {
  std::vector<std::vector<RemoteUpdate> > out(border_.peers().size()), in;
  for (const RemoteUpdate& own : simulation_.outgoing) {
    if (own.body >= own_ || own.key.time < from) continue;
    const int owner = own.partner >= own_ ? owners_[own.partner - own_] : -1;
    for (const BorderExchange::Follower& follower : border_.followers(own.body)) {
      if (border_.peers()[follower.peer] == owner) continue;
      out[follower.peer].push_back(own);
      out[follower.peer].back().body = follower.slot;
    }
  }
  border_.exchange(out, in);
  std::vector<RemoteUpdate> all;
  for (int p = 0; p < static_cast<int>(in.size()); p++)
    for (RemoteUpdate remote : in[p]) {
      remote.body = border_.local(p, remote.body);
      all.push_back(remote);
    }
  std::stable_sort(all.begin(), all.end(),
                   [](const RemoteUpdate& a, const RemoteUpdate& b) { return a.key < b.key; });
  return all;
}
