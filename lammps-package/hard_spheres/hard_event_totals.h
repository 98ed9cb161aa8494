// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_HARD_EVENT_TOTALS_H
#define COHESION_HARD_EVENT_TOTALS_H

#include <array>
#include <cmath>

#include "hard_sphere/bodies.h"

namespace LAMMPS_NS {

/// Sums over the events of this process by kind, which computes hard/events and hard/stress report.
struct HardEventTotals {
  static constexpr int kinds = static_cast<int>(cohesion::hard_sphere::kind_names.size());
  enum Quantity { count, energy_change, impulse, virial, quantities };
  using ByKind = std::array<std::array<double, kinds>, quantities>;

  std::array<ByKind, 2> sums{};                      ///< of pairs, of walls
  std::array<cohesion::MomentumFlux, kinds> flux{};  ///< of pairs: Event::momentum_flux()
  bool flux_wanted = false;
  double elastic = 0.0;        ///< collisions made elastic against inelastic collapse
  double at_rest = 0.0;        ///< collisions to which the rule of rest gave speed
  double given_at_rest = 0.0;  ///< kinetic energy that it gave them, [energy]
  double most_events = 0.0;    ///< most events of one particle in one step

  void add(const cohesion::hard_sphere::Event& event, bool wall) {
    const auto kind = static_cast<std::size_t>(event.impact.kind);
    ByKind& by = sums[wall];
    by[count][kind] += 1.0;
    by[energy_change][kind] += event.impact.energy_change;
    by[impulse][kind] += std::abs(event.impact.normal);
    by[virial][kind] += event.impact.normal * event.distance;
    elastic += event.elastic;
    at_rest += event.impact.given_at_rest > 0.0;
    given_at_rest += event.impact.given_at_rest;
    if (!flux_wanted || wall) return;
    const auto of_event = event.momentum_flux();
    for (std::size_t k = 0; k < of_event.size(); k++) flux[kind][k] += of_event[k];
  }
};

}  // namespace LAMMPS_NS

#endif
