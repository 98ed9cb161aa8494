// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>
#include <variant>

#include "advice/equal_escape.h"
#include "advice/sampled_escape.h"
#include "contact/linear_spring_dashpot.h"
#include "hamaker/forms.h"
#include "sphere.h"

/// Hamaker attractions and square wells of equal head-on escape velocity, each through the scheme
/// that it will be used with. `step` is the time step [time] of scheme sampled; none: scheme exact,
/// which is the same at any step.
namespace cohesion::advice {

/// Two spheres, or a sphere and a wall, without their cohesion.
struct HeadOnPair {
  contact::LinearSpringDashpot spring;
  PairGeometry geometry;
  double contact_distance;  ///< r_i + r_j, beside a wall r_i, [length]
};

/// A Hamaker attraction but for its constant.
struct HamakerKind {
  const hamaker::Form* form;
  double surface_cutoff;         ///< H_cut, [length]
  double outer_cutoff;           ///< H_out, [length]
  double asperity_radius;        ///< [length]; 0: smooth
  double asperity_height = 0.0;  ///< [length]; 0: the radius

  /// Throws InvalidParameter as hamaker::require_valid.
  hamaker::AnyLaw law(double hamaker_constant) const {
    return form->law(
        {hamaker_constant, surface_cutoff, outer_cutoff, asperity_radius, asperity_height},
        asperity_radius > 0.0);
  }
};

inline contact::Adhesion adhesion_of(const HeadOnPair& pair, const hamaker::AnyLaw& law) {
  return std::visit([&](const auto& l) { return contact::adhesion_of(l, pair.geometry); }, law);
}

/// The escape velocities of a Hamaker attraction. Of a law solved exactly all three are the same.
inline SampledEscape hamaker_escape(const HeadOnPair& pair, const hamaker::AnyLaw& law,
                                    std::optional<double> step) {
  require_sticking(pair.spring);
  if (step) return sampled_escape(pair.spring, {law, pair.geometry}, pair.contact_distance, *step);
  const double v = contact::AdhesiveContact(pair.spring, adhesion_of(pair, law)).escape_velocity();
  return {v, v, v};
}

/// The escape velocities of a square well of depth D [energy]. `width` [length]: the gap at the
/// edge (square_well::width).
inline SampledEscape well_escape(const HeadOnPair& pair, double depth, double width,
                                 std::optional<double> step) {
  require_sticking(pair.spring);
  if (step)
    return sampled_escape(pair.spring, contact::Adhesion{0.0, width, depth}, pair.contact_distance,
                          *step);
  const double v = escape_velocity_of_depth(pair.spring, depth);
  return {v, v, v};
}

/// Depth D [energy] of the well whose mean escape velocity is `speed` [length/time].
///
/// A sampled contact without force in the gap is linear: all speeds of its escape go with sqrt(D).
inline double depth_of(const HeadOnPair& pair, double speed, double width,
                       std::optional<double> step) {
  const double depth = depth_of_escape_velocity(pair.spring, speed);
  if (!step || speed == 0.0) return depth;
  const double ratio = speed / well_escape(pair, depth, width, step).mean;
  return depth * ratio * ratio;
}

/// Hamaker constant A [energy] whose mean escape velocity is `speed` [length/time]; with scheme
/// sampled to a few times sampling_error. Throws InvalidParameter when it is not found.
inline double hamaker_constant_of(const HeadOnPair& pair, double speed, const HamakerKind& kind,
                                  std::optional<double> step) {
  if (speed == 0.0) return 0.0;
  const contact::Adhesion unit = adhesion_of(pair, kind.law(1.0));
  if (!step) return adhesion_of_escape_velocity(pair.spring, unit, speed);
  // The ratio of sampled to exact velocity hardly depends on A: aim where it would be right.
  double aim = speed;
  for (int i = 0; i < 20; i++) {
    const double found = adhesion_of_escape_velocity(pair.spring, unit, aim);
    const double mean = hamaker_escape(pair, kind.law(found), step).mean;
    // The mean is known to sampling_error of the exact velocity, which is `aim`.
    if (std::abs(mean - speed) < 2.0 * sampling_error * aim) return found;
    aim *= speed / mean;
  }
  require(false, "escape velocity", speed,
          "the Hamaker constant that has it as its mean was not found in 20 tries, to 0.2 % of the "
          "exact one: take a shorter time step");
  return 0.0;
}

}  // namespace cohesion::advice
