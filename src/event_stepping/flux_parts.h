// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "event_stepping/cohesive_contact.h"
#include "momentum_flux.h"

namespace cohesion::event_stepping {

/// The part of `on_j`, all of the impulse of a step on j [momentum], that spring, dashpot and
/// friction give; the rest is adhesion. `separation`: on the grid.
///
/// Spring and dashpot act along the line of centres on the grid, which is the mean one of the step
/// up to (angle turned in it)^2: so much of the repulsion may be found in the wrong part; nothing,
/// where nothing attracts.
template <class Contact>
Vector3 impulse_by_contact(const Contact& c, const Vector3& separation, const PairStep& step,
                           const FrictionStep& sliding, const Vector3& on_j) {
  if (!c.attracts()) return on_j;
  return step.normal.repulsion_impulse / norm(separation) * separation + sliding.spring.impulse;
}

/// Momentum flux of contacts (momentum_flux.h) by what carries it.
struct FluxParts {
  /// Spring, dashpot and friction; the force between surfaces apart, or that glues them.
  enum Part { contact, adhesion, parts };
  std::array<MomentumFlux, parts> of{};

  /// One step of a pair that stands at `separation` on the grid: `share` of it. `on_j` is all of
  /// the impulse on j [momentum], friction included, `by_contact` what is not adhesion's.
  void add(double share, const Vector3& separation, const Vector3& on_j,
           const Vector3& by_contact) {
    add(contact, share, momentum_flux(separation, by_contact));
    add(adhesion, share, momentum_flux(separation, on_j - by_contact));
  }

 private:
  void add(Part part, double share, const MomentumFlux& flux) {
    for (std::size_t k = 0; k < flux.size(); k++) of[part][k] += share * flux[k];
  }
};

}  // namespace cohesion::event_stepping
