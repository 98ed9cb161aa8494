// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/contact_parameters.h"
#include "event_stepping/contact_bodies.h"
#include "event_stepping/contact_memory.h"
#include "event_stepping/lasting_normal.h"
#include "event_stepping/spring_on_grid.h"

namespace cohesion::event_stepping {

/// A contact that lasts, by one force of the usual form a step: along its normal, and of the
/// springs in its plane. How a pair came together does not matter any more.
class OneForce {
 public:
  /// pull [force]: of the adhesion; step [time].
  OneForce(const contact::ContactParameters& parameters, const contact::LinearSpringDashpot& normal,
           double pull, const ContactBodies& bodies, double step)
      : bodies_(bodies),
        step_(step),
        reduced_mass_(bodies.reduced_mass()),
        normal_(normal, bodies.reduced_mass(), bodies.distance(), pull, step, bodies.is_wall()),
        sliding_(contact::tangential_contact(parameters, normal), step,
                 bodies.inverse_sliding_mass()),
        rolling_(contact::rolling_contact(parameters, normal), step, bodies.inverse_rolling_mass()),
        steady_(is_steady()) {}

  const SpringOnGrid& sliding() const { return sliding_; }
  const SpringOnGrid& rolling() const { return rolling_; }

  /// Whether a contact of one force certainly lasts for the step.
  bool lasts(const RelativeState& grid) const {
    return steady_ && normal_.force(normal_.at(grid)).lasts;
  }
  /// The true radial velocity at the grid point, less that of the half step before.
  double ahead(const RelativeState& grid) const { return normal_.ahead(normal_.at(grid)); }

  /// A contact that has lasted, or can: sets the force times dt that it needs if it goes on, the
  /// springs in the plane of contact, and what was lost since the last grid point, if `losses` is
  /// not null. False: it does not certainly last for this step, and needs end_lasting().
  template <int SIZE>
  [[gnu::always_inline]] bool advance_lasting(const PairMotion& grid, ContactMemory& memory,
                                              Action& action, ContactLosses* losses) const {
    const LastingNormal::Sample now = normal_.at(grid.relative);
    const LastingNormal::Force normal = normal_.force(now);
    const bool lasted = memory.phase == ContactMemory::lasting;
    action = {(reduced_mass_ * normal.change * now.inverse) * grid.relative.separation, {}, {}};
    if (losses && lasted) losses->normal_damping = normal_.damped(now);
    memory.phase = ContactMemory::lasting;
    memory.age += 1.0;
    if constexpr (SIZE >= ContactMemory::with_friction) {
      const Touch touch(bodies_, grid.relative.separation, now.inverse);
      const double repulsion = normal_.repulsion(normal.change);
      // The half of a step that its first one is to do begins with the true velocity.
      const double limiting =
          lasted ? repulsion : normal_.repulsion(2.0 * (normal.change - memory.ahead));
      SpringOnGrid::Losses of_sliding, of_rolling;
      const Vector3 across =
          grid.relative.velocity - (now.radial * now.inverse) * grid.relative.separation;
      const Vector3 slides = touch.sliding_velocity_across(across, grid.spin_i, grid.spin_j);
      touch.add_sliding_impulse(
          sliding_.advance_lasting(touch.plane(), slides, limiting, lasted, memory.sliding,
                                   losses ? &of_sliding : nullptr),
          action);
      if constexpr (SIZE >= ContactMemory::with_rolling) {
        const Vector3 rolls = touch.rolling_velocity(grid.spin_i, grid.spin_j);
        touch.add_rolling_impulse(
            rolling_.advance_lasting(touch.plane(), rolls, limiting, lasted, memory.rolling,
                                     losses ? &of_rolling : nullptr),
            action);
      }
      if (losses) {
        losses->tangential_damping = of_sliding.damped;
        losses->friction = of_sliding.friction;
        losses->rolling = of_rolling.damped + of_rolling.friction;
      }
    }
    return steady_ && normal.lasts;
  }

  /// After advance_lasting(): the contact is followed from this grid point on. Adds to `losses`
  /// unless it is null.
  template <int SIZE>
  void end_lasting(const PairMotion& grid, ContactMemory& memory, ContactLosses* losses) const {
    memory.phase = ContactMemory::leaving;
    if constexpr (SIZE >= ContactMemory::with_friction) {
      const LastingNormal::Sample now = normal_.at(grid.relative);
      const double repulsion = normal_.repulsion(normal_.force(now).change);
      const double last = normal_.repulsion(2.0 * normal_.ahead(now));
      const Touch touch(bodies_, grid.relative.separation, now.inverse);
      SpringOnGrid::Losses lost;
      sliding_.end_lasting(touch.sliding_velocity(grid.relative.velocity, grid.spin_i, grid.spin_j),
                           repulsion, last, memory.sliding, losses ? &lost : nullptr);
      if (losses) losses->friction += lost.friction;
      if constexpr (SIZE >= ContactMemory::with_rolling) {
        lost = {};
        rolling_.end_lasting(touch.rolling_velocity(grid.spin_i, grid.spin_j), repulsion, last,
                             memory.rolling, losses ? &lost : nullptr);
        if (losses) losses->rolling += lost.friction;
      }
    }
  }

  /// What advance_lasting() has set for a contact that lasted already, again.
  template <int SIZE>
  Action lasting_action(const PairMotion& grid, const ContactMemory& memory) const {
    const Vector3& s = grid.relative.separation;
    const LastingNormal::Sample now = normal_.at(grid.relative);
    Action action{(reduced_mass_ * normal_.force(now).change * now.inverse) * s, {}, {}};
    if constexpr (SIZE >= ContactMemory::with_friction)
      Touch(bodies_, s).add_sliding_impulse(memory.sliding.impulse, action);
    if constexpr (SIZE >= ContactMemory::with_rolling)
      Touch(bodies_, s).add_rolling_impulse(memory.rolling.impulse, action);
    return action;
  }

 private:
  using Touch = ContactBodies::Touch;

  /// Whether springs and dashpots of one force, which take the velocity of half a step before, stay
  /// steady where each sphere has many of them.
  ///
  /// Each spring adds to w^2 of its sphere, and (w dt)^2 must stay below 4. In the closest packing,
  /// twelve contacts, the fastest swing against all neighbours has 4 times the w^2 of a pair along
  /// the normals: 2 sum cos^2 = 8 springs on one sphere's mass, 2 on that of a pair. Spheres that
  /// all spin alike, each surface sliding twice, have 2 sum sin^2 (5/2)/7 = 40/7 times that of a
  /// pair's sliding; spheres that roll against all their neighbours 8 times.
  ///
  /// Source: derived here; the limits are in docs/lammps-package/pair_gran_hamaker.md, What the
  /// scheme is for.
  bool is_steady() const {
    const GridSpring& spring = normal_.constants();
    const double normal =
        (spring.stiffness + 2.0 * spring.damping / step_) * step_ * step_ * bodies_.inverse_mass();
    return 4.0 * normal < 4.0 &&
           40.0 / 7.0 * sliding_.frequency_squared() + 8.0 * rolling_.frequency_squared() < 4.0;
  }

  ContactBodies bodies_;
  double step_;
  double reduced_mass_;
  LastingNormal normal_;
  SpringOnGrid sliding_;
  SpringOnGrid rolling_;
  bool steady_;
};

}  // namespace cohesion::event_stepping
