// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "advice/contact_report.h"
#include "contact/contact_parameters.h"

/// The time step to plan a run of scheme exact with. Any consistent set of units.
namespace cohesion::advice {

/// Such contacts of two equal spheres. In Hertz's contact the dashpots of both engines act with
/// friction, the stronger one: that of LIGGGHTS has gamma_t/gamma_n = sqrt(K_t/K_n).
inline AdvisedContact contact_of_equals(contact::ContactParameters p, double radius, double mass,
                                        const contact::Adhesion& adhesion) {
  if (p.is_hertz())
    p.tangential_damping_ratio =
        std::max(p.tangential_damping_ratio, std::sqrt(p.tangential_ratio));
  const LightestParticle sphere{radius, mass};
  return {"", sphere, sphere, springs_of(p, 0.5 * radius, 0.5 * mass), adhesion};
}

/// The largest step [time] that does not stop a run whose spheres have several such contacts. The
/// engines judge Hertz's contact by the fastest sphere: of a gas or bed whose impacts have `speed`,
/// that is up to twice as fast. A hundredth is left to the rounding of scripts.
inline double planned_steady_step(const AdvisedContact& c, double speed) {
  const RunNumbers run{2.0 * speed, 0.0, 1.0};
  return 0.99 * detail::steady_step(numbers(c, run), false);
}

}  // namespace cohesion::advice
