// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_HARD_EVENT_TOTALS_H
#define COHESION_HARD_EVENT_TOTALS_H

#include <array>
#include <cmath>

#include "hard_sphere/bodies.h"

namespace LAMMPS_NS {

/// Sums over the events of this process by kind, for compute hard/events and compute hard/stress.
struct HardEventTotals {
  static constexpr int kinds = static_cast<int>(cohesion::hard_sphere::event_kind_names.size());
  enum Quantity { count, energy_change, impulse, virial, quantities };
  using ByKind = std::array<std::array<double, kinds>, quantities>;

  std::array<ByKind, 2> sums{};                      ///< of pairs, of walls
  std::array<cohesion::MomentumFlux, kinds> flux{};  ///< of pairs: Event::momentum_flux()
  bool flux_enabled = false;
  double elastic = 0.0;  ///< collisions made elastic by the rules against inelastic collapse
  double rest_rule_collisions =
      0.0;  ///< collisions in which the rule of rest increased the speed of separation
  double rest_rule_energy = 0.0;  ///< kinetic energy added in them, [energy]
  double most_events = 0.0;       ///< largest number of events of one particle in one step

  void add(const cohesion::hard_sphere::Event& event, bool wall) {
    const auto kind = static_cast<std::size_t>(event.impact.kind);
    ByKind& by = sums[wall];
    by[count][kind] += 1.0;
    by[energy_change][kind] += event.impact.energy_change;
    by[impulse][kind] += std::abs(event.impact.normal_impulse);
    by[virial][kind] += event.impact.normal_impulse * event.distance;
    elastic += event.elastic;
    rest_rule_collisions += event.impact.rest_rule_energy > 0.0;
    rest_rule_energy += event.impact.rest_rule_energy;
    if (!flux_enabled || wall) return;
    const auto event_flux = event.momentum_flux();
    for (std::size_t k = 0; k < event_flux.size(); k++) flux[kind][k] += event_flux[k];
  }
};

}  // namespace LAMMPS_NS

#endif
