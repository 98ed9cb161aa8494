// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hamaker/forms.h"
#include "sampled_contact/sampled_pair.h"
#include "sphere.h"

namespace cohesion::sampled_contact {

using namespace contact_solver;

/// A Hamaker attraction in the scheme to compare with: the force at a time level acts for the whole
/// step. First order in the step; it misses whatever lies between two time levels, since a gap of
/// H_cut is crossed in less than a step unless dt < H_cut/v.
///
/// Sphere and sphere, or sphere and plane with the separation from the centre to the foot of the
/// normal.
///
/// Source: M. Weber, thesis, section 6.2.
class SampledHamaker : public SampledPair {
 public:
  struct Attraction {
    hamaker::AnyLaw law;
    PairGeometry geometry;
  };
  static constexpr bool pushes_at_edge = false;

  SampledHamaker(const contact::NormalLaw& repulsion, const Attraction& attraction,
                 double contact_distance)
      : SampledPair(repulsion, contact_distance, range_of(attraction)), attraction_(attraction) {}

  /// Gap at which a pair comes into range, [length].
  double entry_range() const { return range(); }

  PairStep advance(const Vector3& separation, const Vector3& velocity, const StepWindow& window,
                   bool) const {
    PairStep step;
    const double time = window.length();
    const SampledMotion now = sample(separation, velocity, time, step.record);
    step.force = now.repulsion - attraction(now.overlap, true);
    step.velocity_change = (time * step.force / reduced_mass()) * now.normal;
    step.inside = -now.overlap < range();
    return step;
  }

  /// [force]
  double attraction(double overlap, bool /*inside*/) const {
    return std::visit([&](const auto& law) { return law.force(-overlap, attraction_.geometry); },
                      attraction_.law);
  }
  double adhesion_energy(double overlap) const {
    return std::visit([&](const auto& law) { return law.energy(-overlap, attraction_.geometry); },
                      attraction_.law);
  }

 private:
  static double range_of(const Attraction& attraction) {
    return std::visit(
        [&](const auto& law) {
          return law.adhesion_force(attraction.geometry) > 0.0 ? law.outer_cutoff() : 0.0;
        },
        attraction.law);
  }

  Attraction attraction_;
};

}  // namespace cohesion::sampled_contact
