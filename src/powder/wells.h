// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "advice/equal_escape.h"
#include "contact/adhesion.h"
#include "contact/linear_spring_dashpot.h"
#include "square_well/parameters.h"
#include "validation.h"

/// Square wells in the place of the attraction of grains. Any consistent set of units.
namespace cohesion::powder {

/// r_out/r of wells that nothing speaks against: that of the thesis, which a pair crosses in a few
/// steps and which holds few pairs that do not touch.
inline constexpr double usual_well_ratio = 1.01;

/// Depth D, [energy], of the well that holds a pair up to the speed at which it sticks by the
/// adhesion of its material:
///
///   D = mu v_esc^2/(2 (1/e^2 - 1)),   v_esc of K_m, e, mu and the adhesion
///
/// It does not depend on the springs of the run, nor on the width of the well. K_m: stiffness of
/// the material [force/length]; e: restitution without cohesion [1]; mu: reduced mass [mass].
/// Without adhesion 0. Throws InvalidParameter with one unless 0 < e < 1: without loss no pair
/// sticks. Source: advice/equal_escape.h.
inline double well_depth(double material_stiffness, double restitution, double reduced_mass,
                         const contact::Adhesion& adhesion) {
  if (adhesion.force == 0.0) return 0.0;
  require(restitution > 0.0 && restitution < 1.0, "restitution e", restitution,
          "must lie between 0 and 1 with a square well: without loss no pair sticks, and with all "
          "lost every pair");
  return advice::equal_depth(
      contact::LinearSpringDashpot::from_restitution(material_stiffness, restitution, reduced_mass),
      adhesion);
}

/// D/(w F), [1]: the force F that, pulling from touch on, has done the work D at the edge, a width
/// w away; over the weight of a grain the Bond number of a well.
inline double pull_over_force(double depth, double width, double force) {
  return depth / (width * force);
}

}  // namespace cohesion::powder
