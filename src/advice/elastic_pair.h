// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <variant>

#include "advice/advised_step.h"
#include "advice/contact_advice.h"
#include "advice/integrated_escape.h"
#include "contact/adhesion.h"
#include "contact/contact_parameters.h"
#include "contact/stiffness_scaling.h"

/// Two particles, or a particle and a wall, in Hertz's or JKR's contact: the numbers that a run is
/// planned by. Any consistent set of units.
namespace cohesion::advice {

/// Steps that scheme exact should have in a contact without a closed form, twice those below which
/// it warns (docs/theory/hertz_contacts.md).
inline constexpr double steps_per_integrated_contact = 2.0 * exact_scheme.integrated_for_warning;

/// Numbers of it; speeds are those far away.
class ElasticPair {
 public:
  /// contact: with E*, and w where it is JKR's; R* [length], R beside a wall; mu [mass]; adhesion:
  /// around Hertz's contact, none around JKR's, which has its own. Throws InvalidParameter where
  /// contact::require_valid and the laws do, and unless the contact is Hertz's or JKR's.
  ElasticPair(const contact::ContactParameters& contact, double reduced_radius, double reduced_mass,
              const contact::Adhesion& adhesion = {})
      : contact_(contact), radius_(reduced_radius), mass_(reduced_mass), adhesion_(adhesion) {
    require_positive("reduced modulus E*", contact.modulus);
    contact::require_valid(contact);
    require(!is_jkr() || adhesion.force == 0.0, "adhesion force F_ad", adhesion.force,
            "is not added to JKR's contact, which has its own");
    contact::normal_law(contact_, radius_, mass_);
  }

  bool is_jkr() const { return contact_.work_of_adhesion > 0.0; }
  const contact::ContactParameters& contact() const { return contact_; }
  const contact::Adhesion& adhesion() const { return adhesion_; }

  /// The largest load under which it stays together, [force]: F_ad, or JKR's.
  double pull_off_force() const {
    return is_jkr() ? contact::JkrSpringDashpot::pull_off_force(radius_, contact_.work_of_adhesion)
                    : adhesion_.force;
  }

  /// Approach speed below which it sticks, [length/time]; 0: never, infinite: always.
  double escape_velocity() const {
    if (is_jkr()) return advice::escape_velocity(jkr(), hertz());
    return advice::escape_velocity(hertz(), adhesion_);
  }

  /// Of an elastic impact that comes with `speed`, [time]. Adhesion presses it deeper, where the
  /// contact is stiffer: the time is that of Hertz's impact with the radius a of contact at the
  /// largest overlap,
  ///
  ///   t = 2.9433 sqrt(15 mu/(16 E* a))
  ///
  /// which is Hertz's without adhesion, and holds for a pair that rests, too.
  double contact_time(double speed) const {
    const contact::NormalLaw law = contact::normal_law(contact_, radius_, mass_);
    const double stiffness = contact::point_of(law, largest_overlap(speed)).radius_stiffness;
    return 2.9432750 * std::sqrt(1.875 * mass_ / stiffness);
  }

  /// The time step for scheme exact in either engine, [time]: t_c/20 of an impact with `speed`, or
  /// largest_step() if that is shorter.
  double advised_step(double speed, double gravity = 0.0) const {
    return std::min(contact_time(speed) / steps_per_integrated_contact,
                    largest_step(speed, gravity));
  }
  /// The largest step [time] that is at most t_c/10 and of which neither engine warns,
  /// where spheres have several contacts, none is faster than fastest_over_impact times `speed`,
  /// and the gravity of the run is `gravity` [length/time^2].
  double largest_step(double speed, double gravity = 0.0) const {
    return std::min(contact_time(speed) / exact_scheme.integrated_for_warning,
                    planned_step_without_warning(of_equals(), speed, gravity));
  }

  /// The largest overlap [length] of an impact without dashpot that comes with `speed`.
  double largest_overlap(double speed) const {
    const double touch = touching_speed(speed);
    return overlap_at([&](const contact::LawPoint& p, double x, double touch_energy) {
      return p.energy - touch_energy - adhesion_.force * x - 0.5 * mass_ * touch * touch;
    });
  }

  /// The overlap [length] at which it rests under a load [force].
  double overlap_under(double load) const {
    return overlap_at([&](const contact::LawPoint& p, double, double) {
      return p.force - adhesion_.force - load;
    });
  }

  /// As soft as E* [force/length^2], with the adhesion that keeps of this what is asked
  /// (StiffnessScaling).
  ElasticPair softened(double modulus, contact::Keep keep) const {
    const contact::Material real{contact_.modulus, keep, contact::hertz_power};
    contact::ContactParameters soft = contact_;
    soft.modulus = modulus;
    soft.work_of_adhesion = for_stiffness(modulus, real, contact_.work_of_adhesion);
    const bool scales = is_scaled(real, modulus) && adhesion_.force > 0.0;
    return {soft, radius_, mass_,
            scales ? contact::StiffnessScaling(real, modulus).adhesion(adhesion_) : adhesion_};
  }

 private:
  contact::HertzSpringDashpot hertz() const {
    return contact::HertzSpringDashpot::from_restitution(contact_.modulus, radius_,
                                                         contact_.restitution, mass_);
  }
  contact::JkrSpringDashpot jkr() const {
    return std::get<contact::JkrSpringDashpot>(contact::normal_law(contact_, radius_, mass_));
  }
  /// Two spheres of the same R* and mu.
  AdvisedContact of_equals() const {
    contact::Adhesion adhesion = adhesion_;
    adhesion.force = pull_off_force();
    return contact_of_equals(contact_, 2.0 * radius_, 2.0 * mass_, adhesion);
  }
  double touching_speed(double speed) const {
    return std::sqrt(speed * speed + 2.0 * adhesion_.approach_energy() / mass_);
  }

  /// The overlap at which `excess`, which grows with it, is 0; 0 where it is not below that at
  /// touch.
  template <class Excess>
  double overlap_at(const Excess& excess) const {
    const contact::NormalLaw law = contact::normal_law(contact_, radius_, mass_);
    const double touch_energy = contact::point_of(law, 0.0).energy;
    const auto at = [&](double x) { return excess(contact::point_of(law, x), x, touch_energy); };
    double low = 0.0, high = 1e-9 * radius_;
    while (at(high) < 0.0) {
      low = high;
      high *= 2.0;
    }
    // To the last bits, or so far below 1e-9 that no overlap is of interest.
    for (int k = 0; k < 60; k++) {
      const double middle = 0.5 * (low + high);
      (at(middle) < 0.0 ? low : high) = middle;
    }
    return high;
  }

  contact::ContactParameters contact_;
  double radius_, mass_;
  contact::Adhesion adhesion_;
};

/// Tabor's parameter (R* w^2/(E*^2 z0^3))^(1/3), [1]: above about 5 contacts are JKR's, below about
/// 0.1 Hertz's with an adhesion around them (DMT). z0 [length]: the range of the surface forces.
/// Source: D. Tabor, J. Colloid Interface Sci. 58 (1977) 2.
inline double tabor_parameter(double reduced_modulus, double reduced_radius,
                              double work_of_adhesion, double range) {
  const double strain = work_of_adhesion / reduced_modulus;
  return std::cbrt(reduced_radius * strain * strain / (range * range * range));
}

}  // namespace cohesion::advice
