// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact_solver/pair_step.h"
#include "hamaker/forms.h"
#include "sampled_contact/sampled_repulsion.h"
#include "sphere.h"

namespace cohesion::sampled_contact {

using namespace contact_solver;

/// A Hamaker attraction in the scheme to compare with: the force where the pair is on the grid,
/// taken for the whole step. It is of first order in the step, and misses whatever lies between two
/// grid points: a gap of H_cut is crossed in less than a step unless dt < H_cut/v.
///
/// Sphere and sphere, or sphere and plane with the separation from the centre to the foot of the
/// normal.
///
/// Source: M. Weber, thesis, section 6.2.
class SampledHamaker {
 public:
  struct Attraction {
    hamaker::AnyLaw law;
    PairGeometry geometry;
  };
  static constexpr bool pushes_at_edge = false;

  SampledHamaker(const contact::NormalLaw& repulsion, const Attraction& attraction,
                 double contact_distance, double /*step*/)
      : repulsion_(repulsion), attraction_(attraction), contact_distance_(contact_distance) {
    range_ = std::visit(
        [&](const auto& law) {
          return law.adhesion_force(attraction.geometry) > 0.0 ? law.outer_cutoff() : 0.0;
        },
        attraction_.law);
  }

  /// Gap up to which the pair attracts, [length].
  double range() const { return range_; }
  /// Gap at which a pair comes into range, [length].
  double entry_range() const { return range_; }

  bool within_reach(const RelativeState& grid, const StepWindow&) const {
    return norm(grid.separation) <= contact_distance_ + range_;
  }

  PairStep advance(const RelativeState& grid, const StepWindow& window, bool) const {
    PairStep step;
    const double distance = norm(grid.separation);
    const Vector3 normal = (1.0 / distance) * grid.separation;
    const double time = window.length();
    const double overlap = contact_distance_ - distance;
    const double rate = -dot(normal, grid.velocity);
    const double repulsion = repulsion_.force(overlap, rate, time, step.normal);
    step.force = repulsion - attraction(overlap, true);
    step.velocity_change = (time * step.force / repulsion_.reduced_mass()) * normal;
    step.inside = -overlap < range_;
    return step;
  }

  /// [force]
  double attraction(double overlap, bool /*inside*/) const {
    return std::visit([&](const auto& law) { return law.force(-overlap, attraction_.geometry); },
                      attraction_.law);
  }
  double spring_energy(double overlap) const { return repulsion_.energy(overlap); }
  double adhesion_energy(double overlap) const {
    return std::visit([&](const auto& law) { return law.energy(-overlap, attraction_.geometry); },
                      attraction_.law);
  }

 private:
  SampledRepulsion repulsion_;
  Attraction attraction_;
  double contact_distance_;
  double range_;
};

}  // namespace cohesion::sampled_contact
