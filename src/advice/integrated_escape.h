// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/adhesion.h"
#include "contact/area_attraction.h"
#include "contact/hertz_spring_dashpot.h"
#include "contact/jkr_spring_dashpot.h"
#include "contact_solver/integrated_contact.h"

/// Approach speeds below which two stick whose contact has no closed form: bisected, each impact
/// integrated in steps of 1/2000 of the contact time.
namespace cohesion::advice {

namespace detail {

/// The rate [length/time] at which a contact that touches at `speed` parts; 0: it does not.
template <class Law>
double parting_speed(const Law& law, double attraction, double speed, double contact_time) {
  const contact_solver::IntegratedContact<Law> contact(law, attraction, contact_time / 1000.0);
  contact_solver::Overlap s{0.0, speed};
  contact_solver::NormalRecord record;
  const double time = 10.0 * contact_time;
  return contact.advance(s, time, 0.0, record) < time ? -s.v : 0.0;
}

/// The least speed at which `escapes`, from a first guess > 0; infinite: there is none.
template <class Escapes>
double least_speed(const Escapes& escapes, double guess) {
  double low = 0.0, high = guess;
  while (!escapes(high)) {
    if (high > 1e6 * guess) return std::numeric_limits<double>::infinity();
    low = high;
    high *= 2.0;
  }
  while (high - low > 1e-5 * high) {
    const double middle = 0.5 * (low + high);
    (escapes(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace detail

/// Of Hertz's contact with an adhesion, [length/time]; 0: they never stick.
inline double escape_velocity(const contact::HertzSpringDashpot& law,
                              const contact::Adhesion& adhesion) {
  const double mass = law.reduced_mass();
  const double gained = 2.0 * adhesion.approach_energy() / mass;
  const double paid = 2.0 * adhesion.well_energy() / mass;
  if (!(paid + adhesion.force > 0.0) || !law.is_damped()) return 0.0;
  // The speed that the adhesion itself gives, or the spring of a pressed contact.
  const double pressed = std::pow(adhesion.force / law.coefficient(), 2.0 / 3.0);
  return detail::least_speed(
      [&](double speed) {
        const double touch = std::sqrt(speed * speed + gained);
        const double parts =
            detail::parting_speed(law, adhesion.force, touch, law.contact_time(touch));
        return parts > 0.0 && parts * parts > paid;
      },
      std::max(std::sqrt(paid + gained), std::sqrt(adhesion.force / mass * pressed)));
}

/// Of Hertz's contact with an attraction in proportion to the area of contact, [length/time]; 0:
/// they never stick.
inline double escape_velocity(const contact::HertzWithAreaAttraction& law) {
  if (!(law.well_energy() > 0.0) || !law.is_damped()) return 0.0;
  return detail::least_speed(
      [&](double speed) {
        return detail::parting_speed(law, 0.0, speed, law.hertz().contact_time(speed)) > 0.0;
      },
      std::sqrt(2.0 * law.well_energy() / law.reduced_mass()));
}

/// Of JKR's contact, [length/time]. hertz: the same without adhesion.
inline double escape_velocity(const contact::JkrSpringDashpot& law,
                              const contact::HertzSpringDashpot& hertz) {
  const double lost = law.at(law.lowest_overlap()).energy - law.touch_energy();
  const double elastic = std::sqrt(2.0 * lost / law.reduced_mass());
  return detail::least_speed(
      [&](double speed) {
        return detail::parting_speed(law, 0.0, speed, hertz.contact_time(speed)) > 0.0;
      },
      elastic);
}

}  // namespace cohesion::advice
