// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_MOBILE_PARTICLES_H
#define COHESION_MOBILE_PARTICLES_H

#include <cstring>

#include "common/held_spheres.h"
#include "common/unturned_spheres.h"
#include "fix.h"
#include "fix_nh_sphere.h"
#include "fix_nve_sphere.h"
#include "lammps.h"
#include "modify.h"
#include "utils.h"

namespace LAMMPS_NS {

/// Which particles an impulse can move: those that a fix integrates, unless fix freeze holds them,
/// fix setforce, lineforce or planeforce sets their whole force, or fix move or nve/noforce leads
/// them. The others are infinitely heavy to what meets them.
class MobileParticles {
 public:
  static bool integrates(const Fix* fix) {
    return fix->time_integrate && !utils::strmatch(fix->style, "^move");
  }

  /// nve/sphere, nvt/sphere, npt/sphere or nph/sphere with the keyword disc.
  static bool turns_discs(const Fix* fix) {
    if (const auto* const nve = dynamic_cast<const FixNVESphere*>(fix))
      return Turning<FixNVESphere>::factor(*nve) == disc;
    const auto* const nh = dynamic_cast<const FixNHSphere*>(fix);
    return nh && Turning<FixNHSphere>::factor(*nh) == disc;
  }

  void look_up(const LAMMPS* lmp) {
    const Modify* const modify = lmp->modify;
    mobile_ = forced_ = frozen_ = discs_ = turned_ = led_ = 0;
    held_ = HeldGroups(lmp);
    for (int i = 0; i < modify->nfix; i++) {
      Fix* const fix = modify->fix[i];
      if (strcmp(fix->style, "freeze") == 0) frozen_ |= fix->groupbit;
      if (integrates(fix)) mobile_ |= fix->groupbit;
      if (integrates(fix) && strcmp(fix->style, "nve/noforce") != 0) forced_ |= fix->groupbit;
      if (fix->time_integrate) led_ |= fix->groupbit;
      if (fix->time_integrate && !only_translates(fix)) turned_ |= fix->groupbit;
      if (turns_discs(fix)) discs_ |= fix->groupbit;
    }
  }

  double inverse_mass(int mask, double mass) const {
    return (mask & forced_) && !(mask & frozen_) && !held_.hold(mask) ? 1.0 / mass : 0.0;
  }

  /// Those that forces which fixes set hold, or lead.
  const HeldGroups& held() const { return held_; }
  /// Bits of the groups that fixes turn.
  int turned_groups() const { return turned_; }
  /// Whether a fix would turn a particle that is held in its place.
  bool is_held_but_turned(int mask) const { return (mask & turned_) && held_.hold(mask); }

  /// Whether forces change the velocity of a particle that moves: nve/noforce leaves it as it is.
  bool feels_forces(int mask) const { return mask & forced_; }

  /// Whether any fix moves a particle, whatever forces do.
  bool is_led(int mask) const { return mask & led_; }

  /// Whether a particle moves and nothing turns it.
  bool is_not_turned(int mask) const {
    return (mask & mobile_) && !(mask & frozen_) && !(mask & turned_) && !held_.hold(mask);
  }

  /// Moment of inertia over mass and square of the radius: as a fix turns the particle.
  double inertia_factor(int mask) const { return (mask & discs_) ? disc : sphere; }

 private:
  static constexpr double sphere = 0.4, disc = 0.5;

  /// The factor is protected there.
  template <class Mover>
  struct Turning : Mover {
    static double factor(const Mover& fix) { return fix.*(&Turning::inertia); }
  };

  int mobile_ = 0;
  int forced_ = 0;
  int frozen_ = 0;
  int discs_ = 0;
  int turned_ = 0;
  int led_ = 0;
  HeldGroups held_;
};

}  // namespace LAMMPS_NS

#endif
