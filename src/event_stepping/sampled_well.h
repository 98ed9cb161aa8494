// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/adhesion.h"
#include "event_stepping/sampled_pair.h"
#include "square_well/impulses.h"

namespace cohesion::event_stepping {

/// The square well as the scheme to compare with: a pair that is found beyond the edge, as its flag
/// has it, gets its impulse there and then, from the velocities on the grid, spread over the step.
/// First order in the step; a passage that begins and ends between two grid points is missed.
///
/// Sphere and sphere, or sphere and plane with the separation from the centre to the foot of the
/// normal.
///
/// Source: M. Weber, thesis, section 6.2.4.2.
class SampledWell {
 public:
  /// No force; `cutoff` the gap at the edge, `tail_energy` the depth.
  using Attraction = contact::Adhesion;
  static constexpr bool acts_within_step = false;

  SampledWell(const contact::LinearSpringDashpot& spring, const contact::Adhesion& well,
              double contact_distance, double /*step*/)
      : spring_(spring),
        contact_distance_(contact_distance),
        range_(well.cutoff),
        depth_(well.tail_energy),
        inverse_mass_(1.0 / spring.reduced_mass()) {}

  double range() const { return range_; }

  bool within_reach(const RelativeState& grid, const StepWindow&) const {
    return norm(grid.separation) <= contact_distance_ + range_;
  }

  PairStep advance(const RelativeState& grid, const StepWindow& window, bool inside) const {
    PairStep step;
    const double distance = norm(grid.separation);
    const Vector3 normal = (1.0 / distance) * grid.separation;
    const double time = window.length();
    const double overlap = contact_distance_ - distance;
    const double rate = -dot(normal, grid.velocity);
    const double repulsion = sampled_repulsion(spring_, overlap, rate, time, step.normal);
    const double impulse = edge(-overlap, rate, inside);
    step.change.velocity = ((time * repulsion + impulse) * inverse_mass_) * normal;
    step.overlap_at_end = overlap;
    step.inside = inside;
    return step;
  }

  double spring_energy(double overlap) const {
    return overlap > 0.0 ? 0.5 * spring_.stiffness() * overlap * overlap : 0.0;
  }
  double adhesion_energy(double /*overlap*/) const { return -depth_; }

 private:
  /// The impulse of the edge [momentum], positive repels.
  double edge(double gap, double approach, bool& inside) const {
    if (!inside && gap < range_ && approach > 0.0) {
      inside = true;
      return square_well::approach_impulse(approach, depth_, inverse_mass_);
    }
    if (!inside || gap < range_ || approach >= 0.0) return 0.0;
    inside = !square_well::escapes(approach, depth_, inverse_mass_);
    return inside ? square_well::capture_impulse(approach, inverse_mass_)
                  : square_well::escape_impulse(approach, depth_, inverse_mass_);
  }

  contact::LinearSpringDashpot spring_;
  double contact_distance_;
  double range_;
  double depth_;
  double inverse_mass_;
};

}  // namespace cohesion::event_stepping
