// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_HARD_EVENT_TIME_WARP_H
#define COHESION_HARD_EVENT_TIME_WARP_H

#include <vector>

#include "border_exchange.h"
#include "hard_sphere/time_warp.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// Runs the events of a step on many processes (src/hard_sphere/time_warp.h): brings updates of
/// particles from their owners to those who have them as remote ones, until all agree.
///
/// The bodies of the simulation are the own particles, then the remote ones.
class HardEventTimeWarp : protected Pointers {
 public:
  HardEventTimeWarp(class LAMMPS*, cohesion::hard_sphere::TimeWarp&);

  /// A body whose flight, or what its events depend on, others have changed. `moved`: as in
  /// EventSimulation::change_flight().
  struct ChangedBody {
    int body;
    bool moved;
  };

  /// Collective: sets the remote particles of this process, in the order of their bodies.
  void plan(const std::vector<BorderExchange::Request>& remote);
  /// Whether other processes have an own particle as a remote one.
  bool is_shared(int own) const;
  /// Collective: gives remote bodies the flights that they have on their own processes, and notes
  /// which own ones are shared.
  void share_flights();
  /// Collective: changes remote bodies as their own processes have changed them, and adds them to
  /// those changed.
  void share_changes(std::vector<ChangedBody>& changed);
  /// Collective: executes the events of a step. Ends early when there is no end of events
  /// (EventSimulation::overrun).
  void run_step();

 private:
  struct SharedBody {
    int slot;
    bool moved;
    double kick;
    cohesion::hard_sphere::FreeFlight flight;
    cohesion::hard_sphere::Course course;
  };
  struct SharedUpdate {
    int slot;
    int owner_of_partner;
    bool none;  // the particle has no updates any more
    cohesion::hard_sphere::RemoteUpdate update;
  };

  SharedBody share(int body, int slot, bool moved) const;
  void run_window(double from, double until);
  void exchange_updates();

  cohesion::hard_sphere::TimeWarp& simulation_;
  BorderExchange border_;
  int own_;                  // number of own particles
  std::vector<int> owners_;  // of the remote particles
  double events_per_time_;   // of all processes, in the last step
  std::vector<std::vector<SharedUpdate> > updates_out_, updates_in_;  // by peer, keep their memory
};

}  // namespace LAMMPS_NS

#endif
