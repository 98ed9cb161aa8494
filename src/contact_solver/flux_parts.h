// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "momentum_flux.h"

namespace cohesion::contact_solver {

/// Momentum flux of contacts (momentum_flux.h) by what carries it.
struct FluxParts {
  /// Spring, dashpot and friction; the force between surfaces apart, or that glues them.
  enum Part { contact, adhesion, parts };
  std::array<MomentumFlux, parts> of{};

  /// Adds `fraction` of one step of a pair that has this `separation` at the time level. `on_j` is
  /// all of the impulse on j [momentum], friction included, `by_contact` what is not adhesion's.
  void add(double fraction, const Vector3& separation, const Vector3& on_j,
           const Vector3& by_contact) {
    add(contact, fraction, momentum_flux(separation, by_contact));
    add(adhesion, fraction, momentum_flux(separation, on_j - by_contact));
  }

 private:
  void add(Part part, double fraction, const MomentumFlux& flux) {
    for (std::size_t k = 0; k < flux.size(); k++) of[part][k] += fraction * flux[k];
  }
};

}  // namespace cohesion::contact_solver
