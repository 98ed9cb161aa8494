// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/adhesion.h"
#include "sampled_contact/sampled_repulsion.h"
#include "square_well/impulses.h"

namespace cohesion::sampled_contact {

using namespace contact_solver;

/// Impulse of the edge of a well on a pair found at `gap` [length] with the normal speed of
/// approach `approach` [speed], [momentum]; positive repels. `inside`: whether the pair is in its
/// well; a pair on the other side of the edge that moves on gets its event, once. range: gap at the
/// edge [length]; inverse_mass: 1/mu [1/mass].
///
/// Source: M. Weber, thesis, section 6.2.4.2.
inline double sampled_edge_impulse(double depth, double range, double inverse_mass, double gap,
                                   double approach, bool& inside) {
  if (!inside && gap < range && approach > 0.0) {
    inside = true;
    return square_well::approach_impulse(approach, depth, inverse_mass);
  }
  if (!inside || gap < range || approach >= 0.0) return 0.0;
  inside = !square_well::escapes(approach, depth, inverse_mass);
  return inside ? square_well::capture_impulse(approach, inverse_mass)
                : square_well::escape_impulse(approach, depth, inverse_mass);
}

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
  static constexpr bool pushes_at_edge = true;

  SampledWell(const contact::NormalLaw& repulsion, const contact::Adhesion& well,
              double contact_distance, double /*step*/)
      : repulsion_(repulsion),
        contact_distance_(contact_distance),
        range_(well.cutoff),
        depth_(well.tail_energy),
        inverse_mass_(1.0 / repulsion_.reduced_mass()) {}

  double range() const { return range_; }
  /// Gap at which a pair comes into range, [length].
  double entry_range() const { return range_; }

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
    const double repulsion = repulsion_.force(overlap, rate, time, step.normal);
    const double impulse =
        sampled_edge_impulse(depth_, range_, inverse_mass_, -overlap, rate, inside);
    step.force = repulsion + impulse / time;
    step.velocity_change = ((time * repulsion + impulse) * inverse_mass_) * normal;
    step.inside = inside;
    return step;
  }

  /// Its edge gives impulses, and nothing in contact.
  static constexpr double attraction(double /*overlap*/, bool /*inside*/) { return 0.0; }
  double spring_energy(double overlap) const { return repulsion_.energy(overlap); }
  double adhesion_energy(double /*overlap*/) const { return -depth_; }

 private:
  SampledRepulsion repulsion_;
  double contact_distance_;
  double range_;
  double depth_;
  double inverse_mass_;
};

}  // namespace cohesion::sampled_contact
