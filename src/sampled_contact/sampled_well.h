// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/adhesion.h"
#include "sampled_contact/sampled_pair.h"
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

/// The square well as the scheme to compare with: a pair that has crossed the edge since the last
/// time level receives the impulse of the edge, from the velocities at the time level, spread over
/// the step. First order in the step; a passage that begins and ends between two time levels is
/// missed.
///
/// Sphere and sphere, or sphere and plane with the separation from the centre to the foot of the
/// normal.
///
/// Source: M. Weber, thesis, section 6.2.4.2.
class SampledWell : public SampledPair {
 public:
  /// No force; `cutoff` the gap at the edge, `tail_energy` the depth.
  using Attraction = contact::Adhesion;
  static constexpr bool pushes_at_edge = true;

  SampledWell(const contact::NormalLaw& repulsion, const contact::Adhesion& well,
              double contact_distance)
      : SampledPair(repulsion, contact_distance, well.cutoff),
        depth_(well.tail_energy),
        inverse_mass_(1.0 / reduced_mass()) {}

  /// Gap at which a pair comes into range, [length].
  double entry_range() const { return range(); }

  PairStep advance(const Vector3& separation, const Vector3& velocity, const StepWindow& window,
                   bool inside) const {
    PairStep step;
    const double time = window.length();
    const SampledMotion now = sample(separation, velocity, time, step.record);
    const double impulse =
        sampled_edge_impulse(depth_, range(), inverse_mass_, -now.overlap, now.rate, inside);
    step.force = now.repulsion + impulse / time;
    step.velocity_change = ((time * now.repulsion + impulse) * inverse_mass_) * now.normal;
    step.inside = inside;
    return step;
  }

  /// Its edge gives impulses, and nothing in contact.
  static constexpr double attraction(double /*overlap*/, bool /*inside*/) { return 0.0; }
  double adhesion_energy(double /*overlap*/) const { return -depth_; }

 private:
  double depth_;
  double inverse_mass_;
};

}  // namespace cohesion::sampled_contact
