// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_HARD_EVENT_AGREEMENT_H
#define COHESION_HARD_EVENT_AGREEMENT_H

#include <vector>

#include "border_exchange.h"
#include "hard_sphere/event_simulation.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// How processes agree on the events of a step.
///
/// Each follows its own particles and those of others that these may meet. It carries out the
/// events it knows of, tells the owners' news to those who follow a particle, and does again what
/// comes after the first difference, until nothing differs. Bodies of the order are the own
/// particles, then the followed ones.
class HardEventAgreement : protected Pointers {
 public:
  HardEventAgreement(class LAMMPS*, cohesion::hard_sphere::EventSimulation&);

  /// Collective: with a new list of neighbours, the particles of others that this process follows,
  /// in the order of their bodies.
  void plan(const std::vector<BorderExchange::Request>& followed);
  /// Collective: the flights of the followed particles, as they are on their own processes.
  void load_borders();
  /// Collective: carries out the events of a step; `expected_events`: about how many there are, on
  /// all processes. Ends early when there is no end of events (EventSimulation::overrun).
  void follow(long expected_events);

 private:
  bool shared(const cohesion::hard_sphere::CandidatePair& candidate) const {
    return candidate.i >= own_ || candidate.j >= own_;
  }
  void follow_stretch(double until);
  std::vector<cohesion::hard_sphere::News> exchange_news(double from);

  cohesion::hard_sphere::EventSimulation& simulation_;
  BorderExchange border_;
  int own_;                  // particles of this process
  std::vector<int> owners_;  // of the followed
};

}  // namespace LAMMPS_NS

#endif
