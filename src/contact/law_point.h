// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::contact {

/// A normal law at one overlap; velocities are rates of approach.
struct LawPoint {
  double force = 0.0;             ///< of the spring, repels > 0, [force]
  double stiffness = 0.0;         ///< how it changes with the overlap, [force/length]
  double energy = 0.0;            ///< stored in the spring, [energy]
  double damping = 0.0;           ///< c of the dashpot's force c v, [mass/time]
  double damping_integral = 0.0;  ///< C, the integral of c over the overlap, [momentum]
  /// 2 E* a of the radius a of contact, of which Mindlin's tangential stiffness is a part,
  /// [force/length].
  double radius_stiffness = 0.0;
};

}  // namespace cohesion::contact
