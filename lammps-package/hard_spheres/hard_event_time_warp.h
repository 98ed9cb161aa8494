// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_HARD_EVENT_TIME_WARP_H
#define COHESION_HARD_EVENT_TIME_WARP_H

#include <vector>

#include "border_exchange.h"
#include "hard_sphere/event_simulation.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// Runs the events of a step on many processes: Time Warp in rounds, see EventSimulation for the
/// algorithm and its source.
///
/// Each process simulates its own particles and those of others that these may meet, the remote
/// ones. In each round the owner of a particle sends its updates to those who simulate it too, and
/// each rolls back to the first difference, until there is none. The bodies of the simulation are
/// the own particles, then the remote ones.
class HardEventTimeWarp : protected Pointers {
 public:
  HardEventTimeWarp(class LAMMPS*, cohesion::hard_sphere::EventSimulation&);

  /// Collective, with a new list of neighbours: sets the remote particles of this process, in the
  /// order of their bodies.
  void plan(const std::vector<BorderExchange::Request>& remote);
  /// Collective: sets the flights of the remote particles as they are on their own processes.
  void load_borders();
  /// Collective: executes the events of a step; `expected_events`: about how many there are, on all
  /// processes. Ends early when there is no end of events (EventSimulation::overrun).
  void run_step(long expected_events);

 private:
  bool with_remote_body(const cohesion::hard_sphere::CandidatePair& candidate) const {
    return candidate.i >= own_ || candidate.j >= own_;
  }
  void run_window(double until);
  std::vector<cohesion::hard_sphere::RemoteUpdate> exchange_updates(double from);

  cohesion::hard_sphere::EventSimulation& simulation_;
  BorderExchange border_;
  int own_;                  // number of own particles
  std::vector<int> owners_;  // of the remote particles
};

}  // namespace LAMMPS_NS

#endif
