// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "advice/power_law_spring.h"
#include "advice/softness.h"
#include "constants.h"
#include "contact/adhesive_contact.h"
#include "contact/linear_spring_dashpot.h"
#include "contact/stiffness_scaling.h"
#include "sphere.h"
#include "validation.h"

/// The contact of two equal grains: of the material, and of springs soft enough to be computed.
/// Any consistent set of units.
namespace cohesion::powder {

/// What grains are made of.
struct Elastic {
  double young;    ///< E, [force/length^2]
  double poisson;  ///< nu, [1]
};

/// Hertz's contact of two equal spheres, force 4/3 E* sqrt(R*) x^(3/2), 1/E* = 2 (1 - nu^2)/E,
/// R* = d/4, as springs at the overlap of d/1000 (power_law_spring.h). Throws InvalidParameter
/// unless E > 0 and 0 <= nu <= 0.5. Source: K. L. Johnson, Contact mechanics (1985), ch. 4.
inline advice::ContactSprings hertz(const Elastic& material, double diameter) {
  require_positive("Young's modulus", material.young);
  require(material.poisson >= 0.0 && material.poisson <= 0.5, "Poisson's ratio", material.poisson,
          "must lie between 0 and 0.5");
  const double modulus =
      material.young / (2.0 * (1.0 - material.poisson) * (1.0 + material.poisson));
  const double overlap = 1e-3 * diameter;
  advice::ContactSprings springs{4.0 / 3.0 * modulus * std::sqrt(0.25 * diameter * overlap), 0.0};
  springs.exponent = 1.5;
  springs.overlap = overlap;
  return springs;
}

/// How long Hertz's elastic contact of an impact at `speed` takes, 2.9432 x_max/v, [time]: Johnson,
/// eq. 11.24. mass: of one of the two [mass].
inline double hertz_contact_time(const Elastic& material, double diameter, double mass,
                                 double speed) {
  require_positive("impact speed", speed);
  return 2.9432 * advice::largest_overlap(hertz(material, diameter), 0.5 * mass, 0.0, speed) /
         speed;
}

/// K of the linear spring that an impact at `speed` presses as far, [force/length], while the
/// force `pull_off` [force] holds.
inline double linear_stiffness(const Elastic& material, double diameter, double mass, double speed,
                               double pull_off = 0.0) {
  require_positive("impact speed", speed);
  return advice::linear_springs(hertz(material, diameter), 0.5 * mass, pull_off, speed).stiffness;
}

/// That of the fastest impact that sticks: at the escape velocity which it gives, with what the
/// adhesion adds on the way to touch. Of one without loss, or without adhesion, at `speed`.
inline double sticking_stiffness(const Elastic& material, double diameter, double mass,
                                 double restitution, const contact::Adhesion& adhesion,
                                 double speed) {
  double stiffness = linear_stiffness(material, diameter, mass, speed, adhesion.force);
  if (adhesion.force == 0.0 || restitution == 1.0) return stiffness;
  // The velocity hardly moves the stiffness: a few rounds are enough for round-off.
  for (int round = 0; round < 60; round++) {
    const contact::AdhesiveContact contact(
        contact::LinearSpringDashpot::from_restitution(stiffness, restitution, 0.5 * mass),
        adhesion);
    stiffness = linear_stiffness(material, diameter, mass,
                                 contact.entry_speed(contact.escape_velocity()), adhesion.force);
  }
  return stiffness;
}

/// The Hamaker constant whose smooth spheres with the cut-off H_cut pull as the surface energy
/// gamma [energy/length^2] of each surface does, F_ad = 4 pi gamma R*: A = 24 pi gamma H_cut^2,
/// [energy]. Source of F_ad: B. V. Derjaguin, V. M. Muller, Y. P. Toporov, J. Colloid Interface
/// Sci. 53 (1975) 314.
inline double hamaker_of_surface_energy(double surface_energy, double surface_cutoff) {
  require_non_negative("surface energy", surface_energy);
  require_positive("surface cut-off H_cut", surface_cutoff);
  return 24.0 * pi * surface_energy * surface_cutoff * surface_cutoff;
}

/// The Hamaker constant whose smooth spheres of the reduced radius R* [length] pull with this force
/// at the cut-off H_cut, A = 6 F H_cut^2/R*, [energy].
inline double hamaker_of_pull_off(double force, double reduced_radius, double surface_cutoff) {
  require_positive("surface cut-off H_cut", surface_cutoff);
  return 6.0 * force * surface_cutoff * surface_cutoff / reduced_radius;
}

/// What a spring has to bear without an overlap beyond a share of the diameter.
struct Load {
  double speed;     ///< of impacts, [length/time]
  double pressure;  ///< of the bed above, [force/length^2]
};

/// Two grains, or a grain and a wall, as a spring has to bear them.
struct Pressed {
  double diameter;      ///< of the smaller one, [length]
  double reduced_mass;  ///< [mass]
};

/// The softest spring, [force/length], that keeps overlaps below `overlap` over the diameter [1]:
/// of an impact at the speed of the load with the restitution e, to which the adhesion adds, of a
/// pair at rest that the adhesion holds, and under the pressure of the bed, which puts the force
/// p d^2 on a contact. adhesion_at(K): the contact::Adhesion that the run has with the stiffness K.
/// The overlap falls no faster than 1/K, so that no round overshoots.
template <class AdhesionAt>
double softest_stiffness(const Pressed& pressed, double restitution, const AdhesionAt& adhesion_at,
                         const Load& load, double overlap) {
  require_positive("overlap", overlap);
  using contact::LinearSpringDashpot;
  const double most = overlap * pressed.diameter, mass = pressed.reduced_mass;
  double stiffness = std::max(
      LinearSpringDashpot::from_maximum_overlap(most, load.speed, restitution, mass).stiffness(),
      load.pressure * pressed.diameter * pressed.diameter / most);
  for (int round = 0; round < 100; round++) {
    const contact::AdhesiveContact contact(
        LinearSpringDashpot::from_restitution(stiffness, restitution, mass),
        adhesion_at(stiffness));
    const double x = std::max(contact.static_overlap(),
                              contact.maximum_overlap(contact.entry_speed(load.speed)));
    if (x <= most * (1.0 + 1e-12)) break;
    stiffness *= x / most;
  }
  return stiffness;
}

/// Numbers of a pair of grains with one spring.
struct PairNumbers {
  double stiffness;        ///< K, [force/length]
  double contact_time;     ///< t_c, [time]
  double escape_velocity;  ///< [length/time]
  double pull_off;         ///< F_ad, [force]
};

/// Of a spring with this adhesion. mass: of one grain.
inline PairNumbers pair_numbers(double stiffness, double restitution, double mass,
                                const contact::Adhesion& adhesion) {
  const auto spring =
      contact::LinearSpringDashpot::from_restitution(stiffness, restitution, 0.5 * mass);
  return {stiffness, spring.contact_time(),
          contact::AdhesiveContact(spring, adhesion).escape_velocity(), adhesion.force};
}

}  // namespace cohesion::powder
