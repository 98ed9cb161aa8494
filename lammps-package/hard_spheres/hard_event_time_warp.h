// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_HARD_EVENT_TIME_WARP_H
#define COHESION_HARD_EVENT_TIME_WARP_H

#include <vector>

#include "hard_sphere/time_warp.h"
#include "hard_spheres/border_exchange.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// Executes the events of a step on several processes (src/hard_sphere/time_warp.h): exchanges
/// messages about bodies between their owners and the processes with remote copies, and reduces the
/// global virtual time.
///
/// The bodies of the simulation are the own particles, then the remote ones.
class HardEventTimeWarp : protected Pointers {
 public:
  HardEventTimeWarp(class LAMMPS*, cohesion::hard_sphere::TimeWarp&);

  /// A body whose flight, spin or velocity increment the engine has changed since the last step.
  /// `relocated`: as in EventSimulation::change_flight().
  struct ChangedBody {
    int body;
    bool relocated;
  };

  /// Collective: sets the remote particles of this process, in the order of their bodies.
  void set_remote_particles(const std::vector<BorderExchange::ParticleRequest>& remote);
  /// Whether other processes have a remote copy of an own particle.
  bool is_shared(int own) const;
  /// Collective: copies the flights of all remote bodies from their owners, and marks the own
  /// bodies that are shared.
  void exchange_flights();
  /// Collective: applies the changes of remote bodies that their owners have entered in `changed`,
  /// and adds these bodies to `changed`.
  void exchange_changes(std::vector<ChangedBody>& changed);
  /// Collective: executes the events of a step. Ends early if a body exceeds the limit of events
  /// (EventSimulation::overrun()).
  void run_step();

 private:
  struct BodyMessage {
    int slot;
    bool relocated;
    double speed_increment;
    cohesion::hard_sphere::FreeFlight flight;
    cohesion::hard_sphere::EventState event_state;
  };
  struct RoutedMessage {
    int slot;
    int owner_of_partner;
    bool clears;  // the body has no messages in this window any more
    cohesion::hard_sphere::EventMessage message;
  };

  BodyMessage body_message(int body, int slot, bool relocated) const;
  void run_window(double from, double until);
  void exchange_messages();

  cohesion::hard_sphere::TimeWarp& simulation_;
  BorderExchange border_;
  int own_count_;
  std::vector<int> owners_;  // of the remote particles
  double event_rate_;        // of all processes in the last step, [1/time]; below 0: no step yet
  std::vector<std::vector<RoutedMessage> > messages_out_, messages_in_;  // by peer; keep memory
};

}  // namespace LAMMPS_NS

#endif
