// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "advice/contact_report.h"
#include "contact/contact_parameters.h"

/// The time step to plan a run of scheme exact with. Any consistent set of units.
namespace cohesion::advice {

/// A contact of two equal spheres. Hertz contacts use the stronger tangential dashpot of the two
/// engines: that of LIGGGHTS, gamma_t/gamma_n = sqrt(K_t/K_n).
inline AdvisedContact contact_of_equals(contact::ContactParameters p, double radius, double mass,
                                        const contact::Adhesion& adhesion) {
  if (p.is_hertz())
    p.tangential_damping_ratio =
        std::max(p.tangential_damping_ratio, std::sqrt(p.tangential_ratio));
  const LightestParticle sphere{radius, mass};
  return {"", sphere, sphere, springs_of(p, 0.5 * radius, 0.5 * mass), adhesion};
}

/// Speed of the fastest sphere of a run over the mean normal speed of its impacts, [1]: that of 2e5
/// spheres of a Maxwellian gas. If each component of the velocity has the standard deviation s, the
/// mean normal speed of impacts is sqrt(pi) s, and the median speed of the fastest sphere 5.30 s.
///
/// Source: derived here; docs/theory/contact_steps.md.
inline constexpr double fastest_over_impact = 3.0;

/// A printed step may exceed the limit by the rounding to four digits, a fraction of at most 5e-4.
inline constexpr double printed_rounding = 1e-3;

/// A run with impacts of a mean normal `speed` [length/time], under `gravity` [length/time^2], as
/// the time-step checks of both engines evaluate it; its time step is 1.
inline RunNumbers planned_run(double speed, double gravity) {
  return {fastest_over_impact * speed, gravity, 1.0};
}

/// The largest step [time] that does not stop a run whose spheres have several such contacts, as
/// long as no sphere is faster than fastest_over_impact times the `speed` of impacts.
inline double planned_steady_step(const AdvisedContact& c, double speed, double gravity) {
  return (1.0 - printed_rounding) *
         detail::steady_step(numbers(c, planned_run(speed, gravity)), false);
}

/// The largest step [time] that neither stops such a run nor causes a warning of few steps in a
/// contact. Contacts of Hertz and JKR.
inline double planned_step_without_warning(const AdvisedContact& c, double speed, double gravity) {
  const double contact_time = numbers(c, planned_run(speed, gravity)).steps_per_normal_contact();
  return std::min(planned_steady_step(c, speed, gravity),
                  (1.0 - printed_rounding) * contact_time / exact_scheme.integrated_for_warning);
}

}  // namespace cohesion::advice
