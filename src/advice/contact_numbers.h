// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "advice/closest_packing.h"
#include "constants.h"
#include "contact/adhesive_contact.h"
#include "contact_solver/damped_oscillator.h"
#include "contact_solver/linear_contact.h"
#include "validation.h"

namespace cohesion::advice {

/// One type pair of a simulation, any consistent set of units. A wall is a partner of infinite
/// radius and mass.
struct PairParameters {
  double radius_i, radius_j;   ///< [length]
  double mass_i, mass_j;       ///< [mass]
  double stiffness;            ///< K, [force/length]
  double damping;              ///< eta, [mass/time]
  contact::Adhesion adhesion;  ///< F_ad, H_cut, E_tail
  double speed;                ///< v, [length/time]: typical approach speed, far from each other
  double dt;                   ///< [time]
  double gravity;              ///< g, [length/time^2]
  double tangential_stiffness = 0.0;  ///< K_t, [force/length]; 0 without friction
  double rolling_stiffness = 0.0;     ///< K_r, [force/length]; 0 without rolling friction
  double tangential_damping = 0.0;    ///< eta_t, [mass/time]
  double rolling_damping = 0.0;       ///< eta_r, [mass/time]
  bool is_linear = true;              ///< else the springs stand for Hertz's of an impact
};

/// The numbers of one type pair that decide whether a simulation can be right.
///
///   steps per contact     pi/(w dt), w the larger of w0 and w_t: t_c/dt of the undamped spring,
///                         never above t_c/dt; w_t is the fastest that tangential and rolling
///                         spring swing together, of solid spheres: see tangential_frequency()
///   steps in the cut-off  H_cut/(u dt), u = sqrt(v^2 + 2 W/mu) the speed at first touch
///   Bond number           F_ad/(m g), m the smaller mass
///   overlaps              over d, the smaller diameter
///
/// Stability of leapfrog with the dashpot taken at the half step before, as the engines do: the
/// roots of r^2 - (2 - h^2 - 2 zeta h) r + (1 - 2 zeta h), h = w0 dt, stay in the unit circle for
///
///   w0 dt < 2 (sqrt(1 + zeta^2) - zeta)
///
/// which is the well-known w0 dt < 2 without dashpot.
///
/// Source: derived here. The numbers are explained in docs/lammps-package/time_step_check.md.
class ContactNumbers {
 public:
  /// Throws InvalidParameter where AdhesiveContact does, and unless radii and masses are positive
  /// (infinite for one partner, the wall), dt > 0, v >= 0 and g >= 0.
  explicit ContactNumbers(const PairParameters& p)
      : p_(p),
        contact_({p.stiffness, p.damping, pair_mass(p)}, p.adhesion),
        w0_(std::sqrt(p.stiffness / pair_mass(p))),
        zeta_(0.5 * p.damping / (w0_ * pair_mass(p))) {
    require_partner("radius", p.radius_i);
    require_partner("radius", p.radius_j);
    diameter_ = 2.0 * std::min(p.radius_i, p.radius_j);
    require_positive("smaller diameter", diameter_);
    require_positive("time step", p.dt);
    require_non_negative("approach speed", p.speed);
    require_non_negative("gravity", p.gravity);
    entry_speed_ = contact_.entry_speed(p.speed);
  }

  const PairParameters& parameters() const { return p_; }
  const contact::AdhesiveContact& contact() const { return contact_; }

  /// w: the larger of w0 = sqrt(K/mu) and w_t, [1/time].
  double frequency() const { return std::max(w0_, tangential_frequency()); }
  /// w_t, [1/time]. Sliding u = v - (R_i w_i + R_j w_j) x n is held by K_t, rolling
  /// R (w_i - w_j) by K_r, R = R_i R_j/(R_i + R_j). w_t^2 is the larger root of
  ///
  ///   (K_t/m_t - w^2) (K_r/m_r - w^2) = K_t K_r c^2
  ///
  /// with 1/m_t = 7/(2 mu), 1/m_r = R^2 (1/I_i + 1/I_j) and c = R (R_i/I_i - R_j/I_j), what an
  /// impulse on the one motion changes of the other. Without rolling friction w_t^2 = 7 K_t/(2 mu);
  /// with it, at a wall, 5.55 K_t/mu for K_r = K_t.
  double tangential_frequency() const {
    const double turn_i = 1.0 / (p_.mass_i * p_.radius_i), turn_j = 1.0 / (p_.mass_j * p_.radius_j);
    const double slide = p_.tangential_stiffness * inverse_sliding_mass();
    const double roll = p_.rolling_stiffness * inverse_rolling_mass();
    const double across = 2.5 * reduced_radius() * (turn_i - turn_j);
    const double mean = 0.5 * (slide + roll);
    return std::sqrt(mean +
                     std::sqrt(0.25 * (slide - roll) * (slide - roll) +
                               p_.tangential_stiffness * p_.rolling_stiffness * across * across));
  }
  /// t_c, [time]; infinite at and beyond critical damping.
  double contact_time() const { return contact_.spring().contact_time(); }
  double steps_per_contact() const { return pi / frequency() / p_.dt; }
  /// The same of the normal spring alone.
  double steps_per_normal_contact() const { return pi / w0_ / p_.dt; }
  /// Largest stable step of leapfrog, [time].
  double stable_step() const { return 2.0 / (std::hypot(1.0, zeta_) + zeta_) / w0_; }
  /// Largest step [time] in which the discrete springs and dashpots of the exact scheme stay steady
  /// in this packing.
  double steady_step(const ClosestPacking& packing) const {
    double low = 0.0, high = pi / w0_;
    for (int k = 0; k < 50; k++) {
      const double dt = 0.5 * (low + high);
      const auto phase = [&](double stiffness, double damping, double inverse_mass,
                             bool may_be_taut = false) {
        contact_solver::DiscreteConstants spring{stiffness, damping};
        if (p_.is_linear)
          spring = contact_solver::discrete_constants(stiffness, damping, 1.0 / inverse_mass, dt);
        if (may_be_taut)
          spring.stiffness =
              contact_solver::LinearContact::taut_stiffness(stiffness, spring.stiffness);
        return squared_phase(spring, dt, inverse_mass);
      };
      // At its largest overlap, Hertz's spring has dF/dx = 3/2 F/x and the dashpot c, where 4/5 F/x
      // and 4/5 c stand for them (power_law_spring.h). In a packing under tension all linear
      // contacts with adhesion may be taut.
      const double tangent = p_.is_linear ? 1.0 : 1.875, dashpot = p_.is_linear ? 1.0 : 1.25;
      const bool steady = packing.is_steady(
          phase(tangent * p_.stiffness, dashpot * p_.damping, 1.0 / pair_mass(p_),
                p_.is_linear && p_.adhesion.force > 0.0),
          phase(p_.tangential_stiffness, p_.tangential_damping, inverse_sliding_mass()),
          phase(p_.rolling_stiffness, p_.rolling_damping, inverse_rolling_mass()));
      (steady ? low : high) = dt;
    }
    return low;
  }

  /// u, [length/time].
  double entry_speed() const { return entry_speed_; }
  /// Infinite when the pair does not move.
  double steps_in_cutoff() const {
    if (entry_speed_ == 0.0) return std::numeric_limits<double>::infinity();
    return p_.adhesion.cutoff / entry_speed_ / p_.dt;
  }

  /// Fraction of the escape velocity of a square well that a sampled force leaves open. The dashpot
  /// sets in and ends at its full force, on the grid: up to a step of it, 2 zeta w0 dt of the
  /// speed, is too much or too little. So far e is off, and v_esc = sqrt(2 W/mu (1/e^2 - 1)) by
  /// 1/(1 - e^2) times that fraction: dt/t_c for zeta -> 0.
  double sampled_escape_error() const {
    const double step = w0_ * p_.dt;
    if (zeta_ == 0.0) return step / pi;
    const double q_squared = (1.0 - zeta_) * (1.0 + zeta_);
    const double lost =
        q_squared > 0.0 ? -std::expm1(-2.0 * pi * zeta_ / std::sqrt(q_squared)) : 1.0;
    return 2.0 * zeta_ * step / lost;
  }

  /// Fraction of the speed of an impact that rounded places may add or take away, whatever the
  /// force: each of the pi/(w0 dt) steps shifts the pair by up to half a spacing of numbers as
  /// large as the distance of the centres, and a shift s changes the speed of the swing by up to w0
  /// s. A speed that is taken from two places a step apart, `speeds_of_places` times in a contact,
  /// is off by up to a spacing over the step. Far from the origin places are rounded more.
  double rounding_error(double speeds_of_places) const {
    if (entry_speed_ == 0.0) return 0.0;
    const double sum = p_.radius_i + p_.radius_j;
    const double place = std::isfinite(sum) ? sum : 0.5 * diameter_;
    return (0.5 * pi + speeds_of_places) * std::numeric_limits<double>::epsilon() * place /
           (entry_speed_ * p_.dt);
  }

  double static_overlap_over_diameter() const { return contact_.static_overlap() / diameter_; }
  double impact_overlap_over_diameter() const {
    return contact_.maximum_overlap(entry_speed_) / diameter_;
  }

  /// Infinite without gravity, zero without adhesion.
  double bond_number() const {
    if (p_.adhesion.force == 0.0) return 0.0;
    if (p_.gravity == 0.0) return std::numeric_limits<double>::infinity();
    return p_.adhesion.force / (std::min(p_.mass_i, p_.mass_j) * p_.gravity);
  }
  /// [length/time]
  double escape_velocity() const { return contact_.escape_velocity(); }
  /// W, [energy].
  double well_energy() const { return p_.adhesion.well_energy(); }
  /// F_ad^2/(2 K), [energy]: what the spring's softness adds to the adhesion.
  double spring_adhesion_energy() const { return contact_.spring_adhesion_energy(); }

 private:
  static void require_partner(const char* name, double value) {
    require(!std::isnan(value) && value > 0.0, name, value,
            "must be greater than zero, infinite for a wall");
  }

  double reduced_radius() const { return 1.0 / (1.0 / p_.radius_i + 1.0 / p_.radius_j); }
  /// 1/m_t and 1/m_r, [1/mass].
  double inverse_sliding_mass() const { return 3.5 / pair_mass(p_); }
  double inverse_rolling_mass() const {
    const double radius = reduced_radius();
    return 2.5 * radius * radius *
           (1.0 / (p_.mass_i * p_.radius_i * p_.radius_i) +
            1.0 / (p_.mass_j * p_.radius_j * p_.radius_j));
  }

  static double pair_mass(const PairParameters& p) {
    require_partner("mass", p.mass_i);
    require_partner("mass", p.mass_j);
    // 1/infinity = 0: a wall leaves the mass of the particle; two walls leave nothing to move.
    const double inverse = 1.0 / p.mass_i + 1.0 / p.mass_j;
    require(inverse > 0.0, "reduced mass", p.mass_i, "must be finite: one partner must move");
    return 1.0 / inverse;
  }

  PairParameters p_;
  contact::AdhesiveContact contact_;
  double w0_;
  double zeta_;
  double diameter_;
  double entry_speed_;
};

}  // namespace cohesion::advice
