// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/adhesion.h"
#include "contact/hertz_spring_dashpot.h"
#include "contact_solver/integrated_contact.h"

namespace cohesion::advice {

/// Approach speed below which two with Hertz's contact stick, [length/time]: bisected, each impact
/// integrated in steps of 1/2000 of the contact time. 0: they never stick; infinite: they always do.
inline double escape_velocity(const contact::HertzSpringDashpot& law,
                              const contact::Adhesion& adhesion) {
  const double mass = law.reduced_mass();
  const double gained = 2.0 * adhesion.approach_energy() / mass;
  const double paid = 2.0 * adhesion.well_energy() / mass;
  if (!(paid + adhesion.force > 0.0) || !law.is_damped()) return 0.0;
  const auto escapes = [&](double speed) {
    const double touch = std::sqrt(speed * speed + gained);
    const double time = law.contact_time(touch);
    const contact_solver::IntegratedContact<contact::HertzSpringDashpot> contact(
        law, adhesion.force, time / 1000.0);
    contact_solver::Overlap s{0.0, touch};
    contact_solver::NormalRecord record;
    contact.advance(s, 10.0 * time, 0.0, record);
    return s.x == 0.0 && s.v * s.v > paid;
  };
  // The speed that the adhesion itself gives, and what the spring of a pressed contact does.
  double low = 0.0, high = std::sqrt(paid + gained);
  const double k = law.coefficient();
  high = std::max(high, std::sqrt(adhesion.force / mass * std::pow(adhesion.force / k, 2.0 / 3.0)));
  constexpr double far = 1e6;
  const double limit = far * high;
  while (high < limit && !escapes(high)) {
    low = high;
    high *= 2.0;
  }
  if (high >= limit) return std::numeric_limits<double>::infinity();
  while (high - low > 1e-5 * high) {
    const double middle = 0.5 * (low + high);
    (escapes(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace cohesion::advice
