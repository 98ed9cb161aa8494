// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "contact/contact_parameters.h"
#include "event_stepping/contact_bodies.h"
#include "event_stepping/contact_memory.h"
#include "event_stepping/lasting_normal.h"
#include "event_stepping/spring_on_grid.h"

namespace cohesion::event_stepping {

/// The square of the frequency of what swings fastest in the closest packing of equal spheres over
/// that of a pair, [1]: along the normals, with springs of friction and of rolling friction.
///
/// In space, twelve contacts, a sphere that swings against all neighbours has 4 times that of a
/// pair along the normals: 2 sum cos^2 = 8 springs on one sphere's mass, 2 on that of a pair.
/// Spheres that all spin alike, each surface sliding twice, have 2 sum sin^2 (5/2)/7 = 40/7 times
/// that of a pair's sliding; spheres that roll against all their neighbours 8 times. In a plane,
/// six contacts and spins across it, the sums of cos^2 and sin^2 are 3 and 6.
///
/// Source: derived here.
struct ClosestPacking {
  double normal, sliding, rolling;

  static ClosestPacking in_space() { return {4.0, 40.0 / 7.0, 8.0}; }
  static ClosestPacking in_plane() { return {3.0, 30.0 / 7.0, 6.0}; }
};

/// A contact that lasts, by one force of the usual form a step: along its normal, and of the
/// springs in its plane.
class OneForce {
 public:
  /// pull [force]: of the adhesion; step [time]; packing: of which spheres may be part.
  OneForce(const contact::ContactParameters& parameters, const contact::LinearSpringDashpot& normal,
           double pull, const ContactBodies& bodies, double step, const ClosestPacking& packing)
      : bodies_(bodies),
        step_(step),
        reduced_mass_(bodies.reduced_mass()),
        normal_(normal, bodies.reduced_mass(), bodies.distance(), pull, step, bodies.is_wall()),
        sliding_(contact::tangential_contact(parameters, normal), step,
                 bodies.inverse_sliding_mass()),
        rolling_(contact::rolling_contact(parameters, normal), step, bodies.inverse_rolling_mass()),
        youth_(2.5 * normal.contact_time() / step),
        minds_others_(!suits_company(normal, step)),
        steady_(is_steady(packing)) {}

  const SpringOnGrid& sliding() const { return sliding_; }
  const SpringOnGrid& rolling() const { return rolling_; }

  /// Whether a contact is in its first 2.5 contact times and was alone when it began to last: how
  /// the pair came together still matters.
  bool is_young(const ContactMemory& memory) const { return memory.age < youth_; }
  /// Whether one force is not good enough beside contacts with an event, and for a young contact
  /// beside any. Of one that does not mind others the dashpot takes so much that it is; it is not
  /// young if it begins to last beside any.
  bool minds_others() const { return minds_others_; }

  /// Whether a contact of one force certainly lasts for the step.
  bool lasts(const RelativeState& grid, const ContactMemory& memory) const {
    return steady_ && force(normal_.at(grid), memory).lasts;
  }
  /// The true radial velocity at the grid point, less that of the half step before.
  double ahead(const RelativeState& grid) const { return normal_.ahead(normal_.at(grid)); }

  /// A contact that has lasted, or can: sets the force times dt that it needs if it goes on, the
  /// springs in the plane of contact, and what was lost since the last grid point, if `losses` is
  /// not null. `alone`: whether a young one that begins to last is, of both its bodies. False: it
  /// does not certainly last for this step, and needs end_lasting().
  template <int SIZE>
  [[gnu::always_inline]] bool advance_lasting(const PairMotion& grid, ContactMemory& memory,
                                              Action& action, ContactLosses* losses,
                                              bool alone = true) const {
    const LastingNormal::Sample now = normal_.at(grid.relative);
    const bool lasted = memory.phase == ContactMemory::lasting;
    const LastingNormal::Force normal = force(now, memory);
    const double ahead = memory.ahead;
    action = {(reduced_mass_ * normal.change * now.inverse) * grid.relative.separation, {}, {}};
    ContactMemory before;
    if (losses) {
      before = memory;
      if (lasted)
        losses->normal_damping = is_young(memory) ? normal_.damped_alone(now) : normal_.damped(now);
    }
    memory.phase = ContactMemory::lasting;
    memory.age += 1.0;
    if (!lasted && !alone) memory.age = std::max(memory.age, youth_);
    memory.ahead = ContactMemory::none;
    if constexpr (SIZE >= ContactMemory::with_friction) {
      const Touch touch(bodies_, grid.relative.separation, now.inverse);
      const double repulsion = normal_.repulsion(normal.change);
      // The half of a step that its first one is to do begins with the true velocity.
      const double limiting = lasted ? repulsion : normal_.repulsion(2.0 * (normal.change - ahead));
      SpringOnGrid::Losses of_sliding, of_rolling;
      bool slides = false, rolls = false;  // the sliders
      const Vector3 across =
          grid.relative.velocity - (now.radial * now.inverse) * grid.relative.separation;
      touch.add_sliding_impulse(
          sliding_.advance_lasting(
              touch.plane(), touch.sliding_velocity_across(across, grid.spin_i, grid.spin_j),
              limiting, lasted, memory.sliding, slides, losses ? &of_sliding : nullptr),
          action);
      memory.ahead = slides ? ContactMemory::in_sliding : ContactMemory::none;
      if constexpr (SIZE >= ContactMemory::with_rolling) {
        touch.add_rolling_impulse(
            rolling_.advance_lasting(touch.plane(),
                                     touch.rolling_velocity(grid.spin_i, grid.spin_j), limiting,
                                     lasted, memory.rolling, rolls, losses ? &of_rolling : nullptr),
            action);
        if (rolls) memory.ahead += ContactMemory::in_rolling;
      }
      if (losses) {
        if (lasted && is_young(before))
          add_lost_alone<SIZE>(grid, before, memory, of_sliding, of_rolling);
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
    const ContactMemory now = at_grid_point<SIZE>(grid, memory);
    if constexpr (SIZE >= ContactMemory::with_friction) {
      const double last = normal_.repulsion(2.0 * normal_.ahead(normal_.at(grid.relative)));
      const Touch touch(bodies_, grid.relative.separation);
      SpringOnGrid::Losses lost;
      sliding_.end_lasting(touch.sliding_velocity(grid.relative.velocity, grid.spin_i, grid.spin_j),
                           memory.slipped(ContactMemory::in_sliding), last, now.sliding.impulse,
                           memory.sliding, losses ? &lost : nullptr);
      if (losses) losses->friction += lost.friction;
      if constexpr (SIZE >= ContactMemory::with_rolling) {
        lost = {};
        rolling_.end_lasting(touch.rolling_velocity(grid.spin_i, grid.spin_j),
                             memory.slipped(ContactMemory::in_rolling), last, now.rolling.impulse,
                             memory.rolling, losses ? &lost : nullptr);
        if (losses) losses->rolling += lost.friction;
      }
    }
    memory.phase = ContactMemory::leaving;
    memory.ahead = ContactMemory::none;
  }

  /// What an energy tally takes for what is remembered after advance_lasting(), so that half of
  /// each spring's impulse leads to the true motion at the grid point. Among others that is half of
  /// the impulse of the step; for a young contact, on which nothing else acts, it is known.
  template <int SIZE>
  ContactMemory at_grid_point(const PairMotion& grid, const ContactMemory& memory) const {
    ContactMemory now = memory;
    if (memory.phase != ContactMemory::lasting || !is_young(memory)) return now;
    if constexpr (SIZE >= ContactMemory::with_friction) {
      const Touch touch(bodies_, grid.relative.separation);
      now.sliding.impulse = sliding_.twice_owed(
          touch.sliding_velocity(grid.relative.velocity, grid.spin_i, grid.spin_j),
          memory.slipped(ContactMemory::in_sliding), memory.sliding);
      if constexpr (SIZE >= ContactMemory::with_rolling)
        now.rolling.impulse =
            rolling_.twice_owed(touch.rolling_velocity(grid.spin_i, grid.spin_j),
                                memory.slipped(ContactMemory::in_rolling), memory.rolling);
    }
    return now;
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

  /// A contact that had an event in the step before, and a young one that minds others, begin from
  /// the true velocity: at the grid point before it may have been apart. All others from where they
  /// were, as those of one force beside them do.
  [[gnu::always_inline]] LastingNormal::Force force(const LastingNormal::Sample& now,
                                                    const ContactMemory& memory) const {
    const bool known_by_grid =
        memory.lasted() || (memory.age >= 1.0 && !(minds_others_ && is_young(memory)));
    return known_by_grid ? normal_.force(now) : normal_.first_force(now, memory.ahead);
  }
  /// Whether going on by one force beside others, whatever happens to these, errs by less than a
  /// fiftieth of what the dashpot takes: a dense gas loses less by 0.4 (dt/t_c)^3/(1 - e^2) of
  /// that; and one force takes its dashpot's velocity from the half step before, so that of two
  /// contacts of one particle it errs by a dt, a = eta/(2 mu).
  ///
  /// Source: the first measured, the second derived; docs/lammps-package/gran_hamaker_many.md, What
  /// damped contacts leave out.
  static bool suits_company(const contact::LinearSpringDashpot& normal, double step) {
    constexpr double small = 1.0 / 50.0;
    const double e = normal.restitution(), part = step / normal.contact_time();
    const double damped = 0.5 * normal.damping() / normal.reduced_mass() * step;
    return 0.4 * part * part * part < small * (1.0 - e * e) && damped < small;
  }

  /// Adds what a young contact lost more since the last grid point than its springs say.
  template <int SIZE>
  void add_lost_alone(const PairMotion& grid, const ContactMemory& before,
                      const ContactMemory& after, SpringOnGrid::Losses& of_sliding,
                      SpringOnGrid::Losses& of_rolling) const {
    const ContactMemory now = at_grid_point<SIZE>(grid, after);
    const Touch touch(bodies_, grid.relative.separation);
    const auto add = [&](const SpringOnGrid& spring, const Vector3& rate,
                         SpringOnGrid::Memory ContactMemory::* of, ContactMemory::Slips which,
                         SpringOnGrid::Losses& to) {
      const SpringOnGrid::Memory then{touch.plane().turned_into((before.*of).stretch),
                                      touch.plane().turned_into((before.*of).impulse)};
      spring.add_lost_alone(rate, then, before.slipped(which), (after.*of).impulse,
                            (now.*of).impulse, to);
    };
    if constexpr (SIZE >= ContactMemory::with_friction)
      add(sliding_, touch.sliding_velocity(grid.relative.velocity, grid.spin_i, grid.spin_j),
          &ContactMemory::sliding, ContactMemory::in_sliding, of_sliding);
    if constexpr (SIZE >= ContactMemory::with_rolling)
      add(rolling_, touch.rolling_velocity(grid.spin_i, grid.spin_j), &ContactMemory::rolling,
          ContactMemory::in_rolling, of_rolling);
  }

  /// Whether springs and dashpots of one force, which take the velocity of half a step before, stay
  /// steady where each sphere has many of them: (w dt)^2 of each swing must stay below 4.
  ///
  /// Source: derived here; the limits are in docs/theory/exact_contacts.md, Contacts that LAMMPS
  /// resolves in addition.
  bool is_steady(const ClosestPacking& packing) const {
    const GridSpring& spring = normal_.constants();
    const double normal =
        (spring.stiffness + 2.0 * spring.damping / step_) * step_ * step_ * bodies_.inverse_mass();
    return packing.normal * normal < 4.0 && packing.sliding * sliding_.frequency_squared() +
                                                    packing.rolling * rolling_.frequency_squared() <
                                                4.0;
  }

  ContactBodies bodies_;
  double step_;
  double reduced_mass_;
  LastingNormal normal_;
  SpringOnGrid sliding_;
  SpringOnGrid rolling_;
  double youth_;  // steps
  bool minds_others_;
  bool steady_;
};

}  // namespace cohesion::event_stepping
