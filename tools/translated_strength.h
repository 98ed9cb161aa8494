// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "advice/integrated_escape.h"
#include "contact/jkr_spring_dashpot.h"
#include "powder/grain_contact.h"
#include "script_contact.h"

namespace cohesion::tools {

/// What a translated script keeps of sjkr and sjkr2, for the median grains.
struct Translation {
  bool keeps_velocity = false;  ///< the escape velocity; else the pull-off force
  std::string law = "hamaker";  ///< or jkr
  std::vector<double> cutoffs;  ///< H_cut and H_out, in the units of the script
  double gravity = 0.0;

  hamaker::HamakerParameters hamaker(double constant) const {
    return {constant, cutoffs.at(0), cutoffs.at(1)};
  }
  /// The property that has the strength.
  const char* property() const { return law == "jkr" ? "surfaceEnergy" : "hamakerConstant"; }
};

/// Throws std::runtime_error where sjkr is not in Hertz's contact.
inline void require_translatable(const ScriptContact& c, const Translation& t) {
  if (c.is_hertz() && (t.law != "jkr" || c.model().normal == "hertz")) return;
  c.model().where.fail("'model " + c.model().normal + "' with cohesion " + c.model().cohesion +
                       (c.is_hertz() ? " has no moduli for JKR: write 'model hertz', or use "
                                       "'--law hamaker'"
                                     : " has no pull-off force to keep: write 'model hertz'"));
}

/// The strength with which pairs stick up to `speed`, bisected from `start` > 0. escape: the escape
/// velocity of a strength.
template <class Escape>
double strength_of_escape(const Escape& escape, double start, double speed) {
  double low = start, high = start;
  while (escape(low) > speed) low *= 0.5;
  while (escape(high) < speed) high *= 2.0;
  while (high > low * (1.0 + 1e-6)) {
    const double middle = std::sqrt(low * high);
    (escape(middle) < speed ? low : high) = middle;
  }
  return high;
}

/// The strength of the law of `t` that gives the same pull-off force or escape velocity: Hamaker
/// constant, or surface energy. Throws std::runtime_error where sjkr is not in Hertz's contact.
inline double translated_strength(const ScriptContact& c, const Translation& t) {
  require_translatable(c, t);
  if (c.strength() == 0.0) return 0.0;
  const double radius = c.pair().reduced_radius(), force = c.pull_off_force();
  const bool is_jkr = t.law == "jkr";
  const double of_force = is_jkr ? force / contact::JkrSpringDashpot::pull_off_force(
                                               radius, contact::work_of_adhesion(1.0))
                                 : powder::hamaker_of_pull_off(force, radius, t.cutoffs.at(0));
  if (!t.keeps_velocity) return of_force;
  const double speed = c.escape_velocity();
  if (!(speed > 0.0) || !std::isfinite(speed))
    c.model().where.fail(
        "no finite escape velocity to keep: use a restitution above 0 and below 1");
  return strength_of_escape(
      [&](double strength) {
        return is_jkr ? c.jkr_pair(strength).escape_velocity()
                      : advice::escape_velocity(c.hertz(), c.hamaker_adhesion(t.hamaker(strength)));
      },
      of_force, speed);
}

}  // namespace cohesion::tools
