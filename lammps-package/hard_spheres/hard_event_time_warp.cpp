// SPDX-License-Identifier: GPL-2.0-only
#include "hard_spheres/hard_event_time_warp.h"

#include <algorithm>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::hard_sphere;

// Events of all processes in a window, per particle, and their least number. With larger windows
// processes roll back more events, and saved states fill the caches. With smaller ones they wait
// for each other more often.
static constexpr double EVENTS_PER_WINDOW = 0.05, LEAST_EVENTS_PER_WINDOW = 100.0;
static constexpr int WINDOWS_OF_FIRST_STEP = 16;

HardEventTimeWarp::HardEventTimeWarp(LAMMPS* lammps, TimeWarp& simulation)
    : Pointers(lammps), simulation_(simulation), border_(world), own_count_(0), event_rate_(-1.0) {}

HardEventTimeWarp::BodyMessage HardEventTimeWarp::body_message(int body, int slot,
                                                               bool relocated) const {
  const HardSphere& b = simulation_.bodies[body];
  return {slot, relocated, b.speed_increment, simulation_.flights[body], b.event_state};
}

void HardEventTimeWarp::set_remote_particles(
    const std::vector<BorderExchange::ParticleRequest>& remote) {
  own_count_ = atom->nlocal;
  owners_.clear();
  for (const BorderExchange::ParticleRequest& request : remote) owners_.push_back(request.owner);
  border_.set_requests(remote, own_count_);
}

bool HardEventTimeWarp::is_shared(int own) const {
  return comm->nprocs > 1 && !border_.receivers(own).empty();
}

void HardEventTimeWarp::exchange_flights() {
  if (comm->nprocs == 1) return;
  for (int i = 0; i < own_count_; i++) simulation_.bodies[i].shared = is_shared(i);
  std::vector<std::vector<BodyMessage> > out(border_.peers().size()), in;
  for (int p = 0; p < static_cast<int>(out.size()); p++)
    for (const int i : border_.sent_particles(p)) out[p].push_back(body_message(i, 0, false));
  border_.exchange(out, in);
  for (int p = 0; p < static_cast<int>(in.size()); p++)
    for (int slot = 0; slot < static_cast<int>(in[p].size()); slot++) {
      const int body = border_.received_particle(p, slot);
      static_cast<FreeFlight&>(simulation_.flights[body]) = in[p][slot].flight;
      simulation_.bodies[body].event_state = in[p][slot].event_state;
      simulation_.bodies[body].speed_increment = in[p][slot].speed_increment;
    }
}

void HardEventTimeWarp::exchange_changes(std::vector<ChangedBody>& changed) {
  std::vector<std::vector<BodyMessage> > out(border_.peers().size()), in;
  for (const ChangedBody& own : changed)
    for (const BorderExchange::Receiver& receiver : border_.receivers(own.body))
      out[receiver.peer].push_back(body_message(own.body, receiver.slot, own.relocated));
  border_.exchange(out, in);
  for (int p = 0; p < static_cast<int>(in.size()); p++)
    for (const BodyMessage& remote : in[p]) {
      const int body = border_.received_particle(p, remote.slot);
      simulation_.bodies[body].speed_increment = remote.speed_increment;
      simulation_.change_flight(body, remote.flight, remote.event_state, remote.relocated);
      changed.push_back({body, remote.relocated});
    }
}

void HardEventTimeWarp::run_step() {
  const double start = simulation_.start(), dt = simulation_.end() - start;
  const double events_per_window =
      std::max(EVENTS_PER_WINDOW * static_cast<double>(atom->natoms), LEAST_EVENTS_PER_WINDOW);
  const int windows = event_rate_ < 0.0
                          ? WINDOWS_OF_FIRST_STEP
                          : 1 + static_cast<int>(event_rate_ * dt / events_per_window);
  double from = start;
  for (int n = 1; n <= windows && simulation_.overrun().first < 0; n++) {
    const double until = n == windows ? simulation_.end() : start + n * dt / windows;
    run_window(from, until);
    from = until;
  }
  double mine = 0.0, all = 0.0;
  for (const Event& event : simulation_.events) mine += event.i < own_count_;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  event_rate_ = dt > 0.0 ? all / dt : -1.0;
}

/// Repeats the window until no process has to roll back.
void HardEventTimeWarp::run_window(double from, double until) {
  simulation_.begin_window(from);
  for (int round = 0;; round++) {
    simulation_.run_window(until);
    exchange_messages();
    const VirtualTime rollback = simulation_.rollback_time();
    struct {
      double time;
      int causal_depth;
    } mine{rollback.time, rollback.causal_depth}, gvt{never, 0};
    MPI_Allreduce(&mine, &gvt, 1, MPI_DOUBLE_INT, MPI_MINLOC, world);
    if (gvt.time == never) break;
    if (round > simulation_.rules.event_limit)
      error->all(FLERR,
                 "pair_style hard/squarewell: in step {} the processes do not agree on the events "
                 "after {} exchanges: particles are pressed together. Use a smaller time step or "
                 "keyword rest or contact_time",
                 update->ntimestep, round);
    simulation_.roll_back_and_accept({gvt.time, gvt.causal_depth});
  }
  simulation_.end_window();
}

/// Sends the messages about own bodies that have changed since the last round. Each receiver omits
/// events with one of its own particles, which it executes itself.
void HardEventTimeWarp::exchange_messages() {
  messages_out_.resize(border_.peers().size());
  for (std::vector<RoutedMessage>& out : messages_out_) out.clear();
  std::vector<EventMessage> messages;
  for (const int body : simulation_.take_changed_bodies()) {
    simulation_.collect_messages(body, messages);
    for (const BorderExchange::Receiver& receiver : border_.receivers(body)) {
      std::vector<RoutedMessage>& out = messages_out_[receiver.peer];
      if (messages.empty()) out.push_back({receiver.slot, -1, true, {}});
      for (const EventMessage& message : messages) {
        const int owner =
            message.partner < own_count_ ? comm->me : owners_[message.partner - own_count_];
        out.push_back({receiver.slot, owner, false, message});
      }
    }
  }
  border_.exchange(messages_out_, messages_in_);
  for (int p = 0; p < static_cast<int>(messages_in_.size()); p++) {
    std::vector<EventMessage>* received = nullptr;
    int current_slot = -1;  // the messages of a body are contiguous
    for (const RoutedMessage& routed : messages_in_[p]) {
      if (routed.slot != current_slot)
        received = &simulation_.begin_receiving(border_.received_particle(p, routed.slot));
      current_slot = routed.slot;
      if (!routed.clears && routed.owner_of_partner != comm->me)
        received->push_back(routed.message);
    }
  }
}
