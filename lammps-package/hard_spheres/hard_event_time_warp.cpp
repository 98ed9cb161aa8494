// SPDX-License-Identifier: GPL-2.0-only
#include "hard_event_time_warp.h"

#include <algorithm>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::hard_sphere;

// Events of a window, of all processes, per particle, and at least. The more, the more of what is
// worked out ahead is undone, and the less of what is kept for that stays in a cache; the fewer,
// the more often processes wait for each other.
static constexpr double EVENTS_OF_A_WINDOW = 0.05, LEAST_EVENTS = 100.0;
static constexpr int WINDOWS_OF_FIRST_STEP = 16;

HardEventTimeWarp::HardEventTimeWarp(LAMMPS* lammps, TimeWarp& simulation)
    : Pointers(lammps), simulation_(simulation), border_(world), own_(0), events_per_time_(-1.0) {}

HardEventTimeWarp::SharedBody HardEventTimeWarp::share(int body, int slot, bool moved) const {
  const Body& b = simulation_.bodies[body];
  return {slot, moved, b.kick, simulation_.flights[body], b.course};
}

void HardEventTimeWarp::plan(const std::vector<BorderExchange::Request>& remote) {
  own_ = atom->nlocal;
  owners_.clear();
  for (const BorderExchange::Request& request : remote) owners_.push_back(request.owner);
  border_.plan(remote, own_);
}

bool HardEventTimeWarp::is_shared(int own) const {
  return comm->nprocs > 1 && !border_.followers(own).empty();
}

void HardEventTimeWarp::share_flights() {
  if (comm->nprocs == 1) return;
  for (int i = 0; i < own_; i++) simulation_.bodies[i].shared = is_shared(i);
  std::vector<std::vector<SharedBody> > out(border_.peers().size()), in;
  for (int p = 0; p < static_cast<int>(out.size()); p++)
    for (const int i : border_.followed_by(p)) out[p].push_back(share(i, 0, false));
  border_.exchange(out, in);
  for (int p = 0; p < static_cast<int>(in.size()); p++)
    for (int slot = 0; slot < static_cast<int>(in[p].size()); slot++) {
      const int body = border_.local(p, slot);
      static_cast<FreeFlight&>(simulation_.flights[body]) = in[p][slot].flight;
      simulation_.bodies[body].course = in[p][slot].course;
      simulation_.bodies[body].kick = in[p][slot].kick;
    }
}

void HardEventTimeWarp::share_changes(std::vector<ChangedBody>& changed) {
  std::vector<std::vector<SharedBody> > out(border_.peers().size()), in;
  for (const ChangedBody& own : changed)
    for (const BorderExchange::Follower& follower : border_.followers(own.body))
      out[follower.peer].push_back(share(own.body, follower.slot, own.moved));
  border_.exchange(out, in);
  for (int p = 0; p < static_cast<int>(in.size()); p++)
    for (const SharedBody& remote : in[p]) {
      const int body = border_.local(p, remote.slot);
      simulation_.bodies[body].kick = remote.kick;
      simulation_.change_flight(body, remote.flight, remote.course, remote.moved);
      changed.push_back({body, remote.moved});
    }
}

void HardEventTimeWarp::run_step() {
  const double start = simulation_.start(), dt = simulation_.end() - start;
  const double of_a_window =
      std::max(EVENTS_OF_A_WINDOW * static_cast<double>(atom->natoms), LEAST_EVENTS);
  const int windows = events_per_time_ < 0.0
                          ? WINDOWS_OF_FIRST_STEP
                          : 1 + static_cast<int>(events_per_time_ * dt / of_a_window);
  double from = start;
  for (int n = 1; n <= windows && simulation_.overrun().first < 0; n++) {
    const double until = n == windows ? simulation_.end() : start + n * dt / windows;
    run_window(from, until);
    from = until;
  }
  double mine = 0.0, all = 0.0;
  for (const Event& event : simulation_.events) mine += event.i < own_;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  events_per_time_ = dt > 0.0 ? all / dt : -1.0;
}

/// Runs the window until no process is told other updates than it has assumed.
void HardEventTimeWarp::run_window(double from, double until) {
  simulation_.begin_window(from);
  for (int round = 0;; round++) {
    simulation_.run_window(until);
    exchange_updates();
    const TimeWarp::Difference mine = simulation_.first_difference();
    struct {
      double time;
      int depth;
    } differs{mine.time, mine.depth}, first{never, 0};
    MPI_Allreduce(&differs, &first, 1, MPI_DOUBLE_INT, MPI_MINLOC, world);
    if (first.time == never) break;
    if (round > simulation_.rules.limit)
      error->all(FLERR,
                 "pair_style hard/square_well: in step {} the processes do not agree on the events "
                 "after {} exchanges: particles are pressed together. Use a smaller time step or "
                 "keyword rest or contact_time",
                 update->ntimestep, round);
    simulation_.assume_what_was_told({first.time, first.depth});
  }
  simulation_.end_window();
}

/// Tells those who have own particles as remote ones what these do now, where that has changed;
/// each receiver leaves out the events with a particle of its own, which it executes itself.
void HardEventTimeWarp::exchange_updates() {
  updates_out_.resize(border_.peers().size());
  for (std::vector<SharedUpdate>& out : updates_out_) out.clear();
  std::vector<RemoteUpdate> updates;
  for (const int body : simulation_.take_changed_bodies()) {
    simulation_.find_updates(body, updates);
    for (const BorderExchange::Follower& follower : border_.followers(body)) {
      std::vector<SharedUpdate>& out = updates_out_[follower.peer];
      if (updates.empty()) out.push_back({follower.slot, -1, true, {}});
      for (const RemoteUpdate& one : updates) {
        const int owner = one.partner < own_ ? comm->me : owners_[one.partner - own_];
        out.push_back({follower.slot, owner, false, one});
      }
    }
  }
  border_.exchange(updates_out_, updates_in_);
  for (int p = 0; p < static_cast<int>(updates_in_.size()); p++) {
    std::vector<RemoteUpdate>* told = nullptr;
    int of_slot = -1;  // the updates of a body follow each other
    for (const SharedUpdate& shared : updates_in_[p]) {
      if (shared.slot != of_slot) told = &simulation_.tell(border_.local(p, shared.slot));
      of_slot = shared.slot;
      if (!shared.none && shared.owner_of_partner != comm->me) told->push_back(shared.update);
    }
  }
}
