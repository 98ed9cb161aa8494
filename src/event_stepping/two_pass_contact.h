// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "contact/contact_parameters.h"
#include "event_stepping/contact_bodies.h"
#include "event_stepping/contact_memory.h"
#include "event_stepping/followed_step.h"
#include "event_stepping/kick_bound.h"
#include "event_stepping/one_force.h"
#include "event_stepping/plane_pair.h"
#include "event_stepping/sphere_pair.h"
#include "event_stepping/well_pair.h"

namespace cohesion::event_stepping {

/// One contact among others, in a predictor and a corrector, with grid points as exact samples of
/// the motion: positions x_n are the true ones at t_n, velocities of a half step are
/// (x_(n+1) - x_n)/dt.
///
/// A contact that lasts needs one force of the usual form with the constants of GridSpring. A step
/// with an event is followed in closed form from the true velocities at t_n, and so is, where it
/// minds others (OneForce), a contact beside such a one and a young one that is not alone: in a
/// predictor by itself, in a corrector with half of what the others of both particles do
/// before it and half after. Of what the contact does in the step, D to the separation and V to its
/// rate, the force at t_n does D; what V is more than D/dt is remembered and leads to the true
/// velocity at t_(n+1). What is so remembered is owed: the grid gets it with the next force.
/// Friction, whose force changes little within a step, does half of its impulse at t_n and half at
/// t_(n+1).
///
/// All forces are central, or act at the point of contact, at grid points: momentum and angular
/// momentum are kept to rounding.
///
/// Pair: SpherePair, PlanePair, WellPair, WellEdge, BridgePair or BridgePlane. SIZE: what is
/// remembered, and so whether there is friction, and rolling friction. Source: derived here
/// (one_force.h, sphere_pair.h).
template <class Pair>
class TwoPassContact {
 public:
  using Attraction = typename Pair::Attraction;
  static constexpr bool on_grid = true;

  /// step [time]; packing: of which the bodies may be part.
  TwoPassContact(const contact::ContactParameters& parameters, const Attraction& attraction,
                 const Body& i, const Body& j, double step,
                 const ClosestPacking& packing = ClosestPacking::in_space())
      : bodies_(i, j),
        step_(step),
        inverse_mass_(bodies_.inverse_mass()),
        reduced_mass_(bodies_.reduced_mass()),
        contact_distance_(bodies_.distance()),
        normal_contact_(contact::normal_contact(parameters, reduced_mass_)),
        pair_(normal_contact_, attraction, contact_distance_, step),
        one_force_(parameters, normal_contact_, attraction.force, bodies_, step, packing),
        kick_bound_(normal_contact_, inverse_mass_, contact_distance_, attraction.force,
                    pair_.adhesion_energy(0.0), step),
        pull_(attraction.force) {}

  bool is_between(const Body& i, const Body& j) const { return bodies_.are(i, j); }
  const ContactBodies& bodies() const { return bodies_; }
  const OneForce& one_force() const { return one_force_; }
  const contact::LinearSpringDashpot& normal_contact() const { return normal_contact_; }
  /// Gap up to which the pair attracts in this scheme, [length].
  double range() const { return pair_.range(); }
  /// Whether there is any adhesion; at a well as wide as the contact it has no range.
  bool attracts() const { return pair_.range() > 0.0 || pair_.adhesion_energy(0.0) < 0.0; }

  /// `flown` [length]: what a pair can fly in a step more than its velocity on the grid says.
  bool within_reach(const RelativeState& grid, double flown) const {
    const double range = contact_distance_ + pair_.range() + flown;
    const double square = dot(grid.separation, grid.separation);
    const double closing = -step_ * dot(grid.separation, grid.velocity);
    const double reach = range + std::max(closing, 0.0) / range;
    if (square > reach * reach) return false;
    // No part of a straight flight is nearer than its part along the line of centres.
    const double distance = std::sqrt(square);
    return distance * (distance - range) <= std::max(closing, 0.0);
  }

  /// Whether a pair of which nothing is remembered stands within the gap `range` [length], and has
  /// not fallen into it: then it was outside `before` [time]. One that flies there is mostly known,
  /// within_reach() a step before; not where the step has become longer since.
  bool stands_within(const RelativeState& grid, double range, double before) const {
    const double edge = contact_distance_ + range;
    return norm(grid.separation) < edge && norm(grid.separation - before * grid.velocity) < edge;
  }

  /// Whether a pair that is in its well and owes nothing certainly meets neither contact nor edge
  /// in this step: nothing acts on it. `flown`: as above.
  bool is_idle(const RelativeState& grid, const ContactMemory& memory, double flown) const {
    if constexpr (std::is_base_of_v<WellPair, Pair>) {
      const auto owes = [](const ContactMemory::Spring& s) {
        return dot(s.impulse, s.impulse) > 0.0;
      };
      return memory.phase == ContactMemory::inside && memory.ahead == 0.0 &&
             !owes(memory.sliding) && !owes(memory.rolling) &&
             pair_.is_clear_by(step_ * norm(grid.velocity) + flown, grid.separation);
    } else {
      return false;
    }
  }

  /// Of its one force: is_young() and minds_others().
  bool is_young(const ContactMemory& memory) const { return one_force_.is_young(memory); }
  bool minds_others() const { return one_force_.minds_others(); }
  /// Whether a contact may be of one force from now on, and certainly lasts for the step. `alone`:
  /// a young one that minds others may; where a sphere or wall moves as it is told, only if its
  /// velocity does not change, and of walls only at flat ones. Not before it is known how it began.
  bool can_last(const RelativeState& grid, const ContactMemory& memory, bool alone) const {
    if (memory.phase != ContactMemory::inside || memory.age < 0.0) return false;
    if (is_young(memory) && minds_others() && !alone) return false;
    return one_force_.lasts(grid, memory);
  }

  /// No less than what a followed contact, by itself, makes of its relative velocity in a step
  /// (KickBound).
  double most_kick(const FollowedStart& start) const { return kick_bound_.of(start); }

  /// What leads from the motion on the grid to the true one at this grid point.
  template <int SIZE>
  Action owed(const RelativeState& grid, const ContactMemory& memory) const {
    return owed<SIZE>(grid.separation, ahead(grid, memory), memory);
  }
  template <int SIZE>
  [[gnu::always_inline]] Action owed(const Vector3& separation, double ahead,
                                     const ContactMemory& memory) const {
    Action owed;
    if (ahead != 0.0) owed.impulse = (ahead * reduced_mass_ / norm(separation)) * separation;
    if constexpr (SIZE >= ContactMemory::with_friction)
      Touch(bodies_, separation).add_sliding_impulse(0.5 * memory.sliding.impulse, owed);
    if constexpr (SIZE >= ContactMemory::with_rolling)
      Touch(bodies_, separation).add_rolling_impulse(0.5 * memory.rolling.impulse, owed);
    return owed;
  }

  /// What `action`, of a lasting contact, changes of the true motion in the step: what followed
  /// contacts of the same particles have to know of it. `owed`: before the step; `memory`: after
  /// it.
  template <int SIZE>
  PairMotion lasting_change(const PairMotion& grid, const Action& action, const Action& owed,
                            const ContactMemory& memory) const {
    RelativeState next = grid.relative;
    next.velocity += inverse_mass_ * action.impulse;
    next.separation += step_ * normal_part(grid.relative.separation, next.velocity);
    const Action later = this->owed<SIZE>(next, memory);
    PairMotion change;
    change.relative.separation = (step_ * inverse_mass_) * (action.impulse - owed.impulse);
    change.relative.velocity = inverse_mass_ * (action.impulse - owed.impulse + later.impulse);
    change.spin_i =
        bodies_.inverse_inertia_i() * (action.torque_i - owed.torque_i + later.torque_i);
    change.spin_j =
        bodies_.inverse_inertia_j() * (action.torque_j - owed.torque_j + later.torque_j);
    return change;
  }

  /// Where a step begins of a contact that the grid knows as `grid`; `truth`: what all that is owed
  /// has led to.
  template <int SIZE>
  [[gnu::always_inline]] FollowedStart start(const PairMotion& grid, const PairMotion& truth,
                                             const ContactMemory& memory) const {
    FollowedStart start{truth, {}, {}, ahead(grid.relative, memory)};
    if constexpr (SIZE >= ContactMemory::with_friction) {
      const Stretches now = stretch(grid, memory);
      start.sliding = now.sliding;
      start.rolling = now.rolling;
    }
    return start;
  }

  /// The predictor of a contact that certainly lasts for the step: what follow() says it changes by
  /// itself, to second order in its turning, and nothing that only the corrector is to know. False:
  /// it is not certain, or the contact rolls.
  template <int SIZE>
  bool predict_lasting(const FollowedStart& start, PairMotion& change) const {
    if constexpr (!std::is_same_v<Pair, SpherePair> || SIZE >= ContactMemory::with_rolling) {
      return false;
    } else {
      const RelativeState& at = start.truth.relative;
      RelativeState end = at;
      double overlap;
      NormalRecord normal;
      if (!pair_.advance_lasting(end, step_, overlap, normal)) return false;
      change.relative = {end.separation - at.separation - step_ * at.velocity,
                         end.velocity - at.velocity};
      if constexpr (SIZE >= ContactMemory::with_friction) {
        const Touch touch(bodies_, 0.5 * (at.separation + end.separation));
        const Vector3 slides = touch.sliding_velocity(at.velocity + 0.5 * change.relative.velocity,
                                                      start.truth.spin_i, start.truth.spin_j);
        const Vector3 impulse = one_force_.sliding().impulse(touch.plane().part_in(start.sliding),
                                                             slides, normal.repulsion_impulse);
        add_sliding(touch, impulse, change);
      }
      return true;
    }
  }

  /// A step of any kind. `others`: D, V and spins of all other contacts of both particles (none in
  /// the predictor); `rolled`: what the contact's own rolling spring did in the predictor.
  template <int SIZE>
  [[gnu::always_inline]] FollowedStep<SIZE> follow(const FollowedStart& start,
                                                   const PairMotion& others,
                                                   const PairSpins& rolled, bool in_range) const {
    const PairMotion& truth = start.truth;
    const Vector3 &s = truth.relative.separation, &v = truth.relative.velocity;
    const double half = 0.5 * step_;
    const Vector3& by_others = others.relative.velocity;
    // What the others do to the place beyond what a constant force would.
    const Vector3 shift = others.relative.separation - half * by_others;
    // Along the normal the others are a load within the step, which a contact carries or not at
    // any step; across it they act half before the step and half after it.
    const Vector3 along = (dot(by_others, s) / dot(s, s)) * s, load = (1.0 / step_) * along;
    const RelativeState middle{s + normal_part(s, half * v + 0.5 * shift),
                               v + 0.5 * (by_others - along)};
    FollowedStep<SIZE> f{};
    if (!in_range && !within_reach(middle, along)) {
      f.normal.interacts = false;
      return f;
    }
    f.normal = pair_.advance(middle, {half, half}, in_range, load);
    if (!f.normal.interacts) return f;
    const RelativeState& did = f.normal.change;
    f.change.relative = {did.separation + half * did.velocity, did.velocity};
    if constexpr (SIZE >= ContactMemory::with_friction) {
      if (f.normal.normal.contact_time == 0.0) return f;
      const Touch touch(bodies_, middle.separation + did.separation);
      const Vector3 spin_i = truth.spin_i + 0.5 * others.spin_i;
      const Vector3 spin_j = truth.spin_j + 0.5 * others.spin_j;
      const Vector3 slides = touch.sliding_velocity(
          middle.velocity + 0.5 * did.velocity, spin_i + 0.5 * rolled.i, spin_j + 0.5 * rolled.j);
      f.sliding = one_force_.sliding().follow(touch.plane(), start.sliding,
                                              0.5 * touch.plane().part_in(shift), slides, f.normal,
                                              f.sliding_rate);
      const Vector3& impulse = f.sliding.impulse;
      add_sliding(touch, impulse, f.change);
      if constexpr (SIZE >= ContactMemory::with_rolling) {
        const Vector3 rolls =
            touch.rolling_velocity(spin_i + 0.5 * f.change.spin_i, spin_j + 0.5 * f.change.spin_j);
        f.rolling = one_force_.rolling().follow(touch.plane(), start.rolling, {}, rolls, f.normal,
                                                f.rolling_rate);
        const Vector3 turn = bodies_.rolling_radius() * f.rolling.impulse;
        f.turned = {bodies_.inverse_inertia_i() * turn, -bodies_.inverse_inertia_j() * turn};
        f.change.spin_i += f.turned.i;
        f.change.spin_j += f.turned.j;
      }
    }
    return f;
  }

  /// The force times dt that does what `f`, followed with `others`, does; remembers the rest.
  template <int SIZE>
  [[gnu::always_inline]] Action finish(const FollowedStart& start, const PairMotion& others,
                                       const FollowedStep<SIZE>& f, ContactMemory& memory) const {
    if (!f.normal.interacts && memory.phase == ContactMemory::beyond) return {};
    const PairMotion& truth = start.truth;
    const double owed = start.ahead;
    const RelativeState& did = f.normal.change;
    const Vector3& s = truth.relative.separation;
    const double distance = norm(s);
    const Vector3 k = (1.0 / distance) * s;
    Vector3 slid;
    if constexpr (SIZE >= ContactMemory::with_friction) slid = inverse_mass_ * f.sliding.impulse;
    const Vector3 flight =
        step_ * truth.relative.velocity + others.relative.separation + (0.5 * step_) * slid;
    const Vector3 far = s + normal_part(s, flight);
    const Vector3 end = far + did.separation + (0.5 * step_) * did.velocity;
    const double along = dot(far, k);
    const Vector3 across = far - along * k;
    const double square = dot(end, end);
    const double push = std::sqrt(std::max(square - dot(across, across), 0.0)) - along;
    const bool event = eventful(memory, f.normal);
    Action action;
    // Not to carry the rounding of no change into the force.
    if (f.normal.interacts || owed != 0.0)
      if (event || memory.phase != ContactMemory::beyond)
        action.impulse = (reduced_mass_ * (push / step_ + owed)) * k;
    if constexpr (SIZE >= ContactMemory::with_friction) {
      Touch(bodies_, s)
          .add_sliding_impulse(0.5 * (f.sliding.impulse + memory.sliding.impulse), action);
      memory.sliding = left(f.normal, f.sliding, f.sliding_rate);
    }
    if constexpr (SIZE >= ContactMemory::with_rolling) {
      Touch(bodies_, s)
          .add_rolling_impulse(0.5 * (f.rolling.impulse + memory.rolling.impulse), action);
      memory.rolling = left(f.normal, f.rolling, f.rolling_rate);
    }
    if (event || !memory.in_range())
      memory.age = 0.0;
    else if (!memory.lasted())
      memory.age = std::max(memory.age, 0.0) + 1.0;
    memory.ahead = 0.0;
    if ((event || f.normal.inside) && (f.normal.interacts || owed != 0.0)) {
      const double reached = std::sqrt(square);
      const Vector3 k_end = (1.0 / reached) * (far + push * k);
      const Vector3 without = truth.relative.velocity + others.relative.velocity + slid;
      memory.ahead = dot(end, without + did.velocity) / reached - dot(k_end, without) -
                     push / step_ * dot(k_end, k);
    }
    memory.phase = f.normal.inside ? ContactMemory::inside
                   : event         ? ContactMemory::left
                                   : ContactMemory::beyond;
    return action;
  }

  template <int SIZE>
  static ContactLosses losses(const FollowedStep<SIZE>& f) {
    ContactLosses lost;
    lost.normal_damping = f.normal.normal.dissipated;
    if constexpr (SIZE >= ContactMemory::with_friction) {
      lost.tangential_damping = f.sliding.damped;
      lost.friction = f.sliding.friction;
    }
    if constexpr (SIZE >= ContactMemory::with_rolling)
      lost.rolling = f.rolling.damped + f.rolling.friction;
    return lost;
  }

  /// The part of the impulse on j that spring, dashpot and friction give; the rest is adhesion.
  Vector3 by_contact(const PairMotion& grid, const Action& action) const {
    if (!attracts()) return action.impulse;
    const Vector3& s = grid.relative.separation;
    return action.impulse + (step_ * pull_ / norm(s)) * s;
  }
  Vector3 by_contact(const FollowedStart& start, const PairStep& normal,
                     const Action& action) const {
    if (!attracts()) return action.impulse;
    const Vector3& s = start.truth.relative.separation;
    const double attraction =
        normal.normal.repulsion_impulse - reduced_mass_ * dot(normal.change.velocity, s) / norm(s);
    return action.impulse + (attraction / norm(s)) * s;
  }

  /// What is stored at the grid point.
  StoredEnergies stored(const PairMotion& grid, const ContactMemory& memory) const {
    if (!memory.in_range()) return {};
    const double overlap = contact_distance_ - norm(grid.relative.separation);
    const Stretches now = stretch(grid, memory);
    return {pair_.spring_energy(overlap), one_force_.sliding().stored_energy(now.sliding),
            one_force_.rolling().stored_energy(now.rolling), pair_.adhesion_energy(overlap)};
  }

 private:
  using Touch = ContactBodies::Touch;

  static constexpr double rounding = 1e-9;

  struct Stretches {
    Vector3 sliding{}, rolling{};
  };

  /// Of the springs at this grid point, in its plane, [length].
  [[gnu::always_inline]] Stretches stretch(const PairMotion& grid,
                                           const ContactMemory& memory) const {
    Stretches now;
    const Touch touch(bodies_, grid.relative.separation);
    const bool touched = memory.in_range() && memory.age >= 0.0 &&
                         touch.plane().inverse_square * contact_distance_ * contact_distance_ > 1.0;
    if (!touched) return now;
    if (memory.lasted()) return {memory.sliding.stretch, memory.rolling.stretch};
    if (one_force_.sliding().is_present())
      now.sliding =
          touch.plane().turned_into(memory.sliding.stretch) +
          step_ * touch.sliding_velocity(grid.relative.velocity, grid.spin_i, grid.spin_j);
    if (one_force_.rolling().is_present())
      now.rolling = touch.plane().turned_into(memory.rolling.stretch) +
                    step_ * touch.rolling_velocity(grid.spin_i, grid.spin_j);
    return now;
  }

  /// Adds what an impulse in the plane of contact, in the middle of the step, does in it, to a
  /// change that has no spins yet.
  [[gnu::always_inline]] void add_sliding(const Touch& touch, const Vector3& impulse,
                                          PairMotion& change) const {
    change.relative.separation += (0.5 * step_ * inverse_mass_) * impulse;
    change.relative.velocity += inverse_mass_ * impulse;
    Action turning;
    touch.add_sliding_impulse(impulse, turning);
    change.spin_i = bodies_.inverse_inertia_i() * turning.torque_i;
    change.spin_j = bodies_.inverse_inertia_j() * turning.torque_j;
  }

  /// What is remembered of a spring after a followed step: as if it had grown evenly.
  ContactMemory::Spring left(const PairStep& normal, const contact::TangentialStep& step,
                             const Vector3& rate) const {
    if (!(normal.overlap_at_end > 0.0)) return {{}, step.impulse};
    return {step.displacement - step_ * rate, step.impulse};
  }

  double ahead(const RelativeState& grid, const ContactMemory& memory) const {
    if (!memory.lasted()) return memory.ahead;
    return one_force_.ahead(grid);
  }

  /// Whether a pair that is out of its range may come into it in this step, in the middle of which
  /// it is at `middle`; `load_change` [length/time]: of its velocity by the load in the step.
  bool within_reach(const RelativeState& middle, const Vector3& load_change) const {
    const double half = 0.5 * step_;
    const double reach =
        contact_distance_ + pair_.range() + half * norm(middle.velocity) + half * norm(load_change);
    return dot(middle.separation, middle.separation) <= reach * reach;
  }

  /// Whether anything but lasting contact, or flight out of range, happened in a step.
  bool eventful(const ContactMemory& memory, const PairStep& normal) const {
    if (memory.in_range())
      return !normal.inside || normal.normal.contact_time < (1.0 - rounding) * step_;
    return normal.inside || dot(normal.change.velocity, normal.change.velocity) > 0.0;
  }

  /// A sphere meets a wall along the normal, wherever it goes across.
  Vector3 normal_part(const Vector3& separation, const Vector3& a) const {
    if (!bodies_.is_wall()) return a;
    return (dot(a, separation) / dot(separation, separation)) * separation;
  }

  ContactBodies bodies_;
  double step_;
  double inverse_mass_;
  double reduced_mass_;
  double contact_distance_;
  contact::LinearSpringDashpot normal_contact_;
  Pair pair_;
  OneForce one_force_;
  KickBound kick_bound_;
  double pull_;
};

}  // namespace cohesion::event_stepping
