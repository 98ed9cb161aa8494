// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/tangential_spring.h"
#include "contact_solver/damped_oscillator.h"
#include "contact_solver/motion_along_normal.h"
#include "vector3.h"

namespace cohesion::contact_solver {

/// Spring, dashpot and slider in the plane of contact, for friction or for rolling friction.
///
/// In a persistent contact they give a discrete force at each time level, from the staggered
/// velocity. In a resolved step the midpoint rule integrates them over the time in contact
/// (contact/tangential_spring.h).
class DiscreteSpring {
 public:
  struct State {
    Vector3
        stretch{};  ///< at the last time level, before the staggered velocity adds to it, [length]
    Vector3
        impulse{};  ///< of the last step; after a resolved one, half of it is pending, [momentum]
  };

  /// step [time]; inverse_mass [1/mass]: the effective one of the motion that stretches the spring.
  DiscreteSpring(const contact::TangentialParameters& p, double step, double inverse_mass)
      : law_(p),
        constants_(discrete_constants(p.stiffness, p.damping, 1.0 / inverse_mass, step)),
        ends_(discrete_end_constants(p.stiffness, p.damping, 1.0 / inverse_mass, step)),
        friction_(p.friction),
        step_(step),
        inverse_mass_(inverse_mass) {}

  /// A spring whose stiffness changes from step to step. Spring and dashpot act at the time level,
  /// as in the Verlet scheme, without a closed form.
  static DiscreteSpring at_time_level(const contact::TangentialParameters& p, double step,
                                      double inverse_mass) {
    return {p, constants_at_time_level(p.stiffness, p.damping, step, inverse_mass),
            ends_at_time_level(p.stiffness, p.damping, step, inverse_mass), step, inverse_mass};
  }

  /// The constants of such a spring, for advance_persistent() with the same step and mass.
  DiscreteConstants constants_at_time_level(double stiffness, double damping) const {
    return constants_at_time_level(stiffness, damping, step_, inverse_mass_);
  }

  /// Impulse at the time level of a persistent contact. `rate` [length/time]: staggered velocity of
  /// the surfaces; repulsion [force]: of normal spring and dashpot; persisted: the contact was
  /// persistent in the last step, too; after a resolved step half of its impulse is pending. Sets
  /// `slips`. displacement_weight [1]: contact::displacement_weight(), 1 if the stiffness is
  /// constant.
  [[gnu::always_inline]] Vector3 advance_persistent(const contact::Plane& plane,
                                                    const Vector3& rate, double repulsion,
                                                    bool persisted, State& state, bool& slips,
                                                    double displacement_weight = 1.0) const {
    return advance_persistent(plane, rate, repulsion, persisted, displacement_weight, constants_,
                              ends_.first, state, slips);
  }
  /// The same of a contact that was persistent in the last step and has other constants now.
  [[gnu::always_inline]] Vector3 advance_persistent(const contact::Plane& plane,
                                                    const Vector3& rate, double repulsion,
                                                    const DiscreteConstants& constants,
                                                    State& state, bool& slips,
                                                    double displacement_weight = 1.0) const {
    return advance_persistent(plane, rate, repulsion, true, displacement_weight, constants,
                              constants, state, slips);
  }

  const DiscreteConstants& constants() const { return constants_; }
  /// [energy]
  double stored_energy(const Vector3& stretch) const { return stored_energy(constants_, stretch); }
  static double stored_energy(const DiscreteConstants& constants, const Vector3& stretch) {
    return 0.5 * constants.stiffness * dot(stretch, stretch);
  }
  /// Energy that a persistent contact has lost since the last time level, in all and in its
  /// dashpot, [energy].
  struct Losses {
    double all = 0.0, damped = 0.0;
  };
  /// A persistent contact at a time level, with the impulse that acted there.
  struct AtLevel {
    const DiscreteConstants& constants;
    const State& state;
  };
  /// The energy that the spring has released, less the work of its impulses. While the contact
  /// slips, the dashpot is stretched with the spring. Where the stiffness has changed: `left` of
  /// the last stretch, `displacement_weight` as above.
  [[gnu::always_inline]] Losses losses(const contact::Plane& plane, const Vector3& rate,
                                       const AtLevel& last, double left, const AtLevel& now,
                                       bool slips, double displacement_weight = 1.0) const {
    const double released = stored_energy(last.constants, last.state.stretch) -
                            stored_energy(now.constants, now.state.stretch);
    const double all = released - 0.5 * dot(last.state.impulse + now.state.impulse, rate);
    if (!slips) return {all, all};
    const Vector3 stretched = now.state.stretch - plane.turned_into(left * last.state.stretch);
    return {all, now.constants.damping / (displacement_weight * displacement_weight * step_) *
                     dot(stretched, stretched)};
  }

  /// Twice the impulse from the staggered to the true velocity of a sticking contact, in closed
  /// form without other forces. `stretch`: at the last time level; displacement_weight: as above.
  Vector3 sticking_impulse(const contact::Plane& plane, const Vector3& rate, const Vector3& stretch,
                           double displacement_weight) const {
    const Vector3 stretched = plane.turned_into(stretch) + (displacement_weight * step_) * rate;
    return step_ * sticking_force(ends_.last, stretched, rate);
  }
  /// Ends a persistent contact, after advance_persistent() with the same `rate`: sets the pending
  /// impulse, `sticking` up to the Coulomb limit of the normal force `last`.
  void end_persistent(const Vector3& sticking, double last, State& state) const {
    state.impulse = sticking;
    const double limit = step_ * friction_ * std::max(last, 0.0), size = norm(sticking);
    if (size > limit) state.impulse = (limit / size) * sticking;
  }

  /// A resolved step, from `stretch` at the time level, or of a contact that begins. `rate`: of the
  /// ends without the spring itself; `mean`: with it, as the particles move; touches_at_end: at the
  /// next time level.
  [[gnu::always_inline]] contact::TangentialStep resolve(const contact::Plane& plane,
                                                         const Vector3& stretch,
                                                         const Vector3& rate,
                                                         const NormalRecord& normal,
                                                         bool touches_at_end, Vector3& mean) const {
    contact::TangentialStep step =
        law_.advance(plane.turned_into(stretch), rate, normal.contact_time, inverse_mass_,
                     normal.repulsion_impulse, normal.repulsion_at_end);
    mean = rate + (0.5 * inverse_mass_) * step.impulse;
    if (!touches_at_end) {  // parted: what the spring still stored is lost
      step.friction += law_.stored_energy(step.displacement);
      step.displacement = {};
    }
    return step;
  }

  /// The effective one of the motion that stretches the spring, [1/mass].
  double inverse_mass() const { return inverse_mass_; }
  /// A spring whose slider has no friction gives no force.
  bool is_present() const { return friction_ > 0.0; }

 private:
  DiscreteSpring(const contact::TangentialParameters& p, const DiscreteConstants& constants,
                 const DiscreteEndConstants& ends, double step, double inverse_mass)
      : law_(p),
        constants_(constants),
        ends_(ends),
        friction_(p.friction),
        step_(step),
        inverse_mass_(inverse_mass) {}

  static DiscreteConstants constants_at_time_level(double stiffness, double damping, double step,
                                                   double inverse_mass) {
    const double part = 1.0 / (1.0 + 0.5 * damping * step * inverse_mass);
    return {part * stiffness, part * damping};
  }
  /// An approximation of DiscreteEndConstants to second order: the mean force of a half step is
  /// that at its middle, a quarter of a step from the time level, by linear extrapolation. The
  /// closed form of linear springs has a third in place of the quarter.
  static DiscreteEndConstants ends_at_time_level(double stiffness, double damping, double step,
                                                 double inverse_mass) {
    const double part = 1.0 / (1.0 + 0.25 * damping * step * inverse_mass);
    const double change = 0.25 * step * stiffness;
    return {{part * stiffness, part * (damping + change)},
            {part * stiffness, part * (damping - change)}};
  }

  /// first: of the first step of a persistent contact.
  [[gnu::always_inline]] Vector3 advance_persistent(const contact::Plane& plane,
                                                    const Vector3& rate, double repulsion,
                                                    bool persisted, double displacement_weight,
                                                    const DiscreteConstants& constants,
                                                    const DiscreteConstants& first, State& state,
                                                    bool& slips) const {
    const Vector3 turned = plane.turned_into(state.stretch);
    const Vector3 stretched = turned + (displacement_weight * step_) * rate;
    // After a resolved step the stretch already includes the slip.
    const Vector3 before = persisted ? turned : stretched;
    Vector3 s = stretched;
    Vector3 force = persisted
                        ? sticking_force(constants, s, rate)
                        : sticking_force(first, s, rate + (0.5 * inverse_mass_) * state.impulse);
    const double limit = friction_ * std::max(repulsion, 0.0);
    const double square = dot(force, force);
    slips = square > limit * limit;
    if (slips) {  // spring and dashpot together carry the Coulomb force
      force = (limit / std::sqrt(square)) * force;
      const double drag = persisted ? constants.damping / (displacement_weight * step_) : 0.0;
      if (persisted && constants.stiffness + drag > 0.0)
        s = (1.0 / (constants.stiffness + drag)) * (drag * before - force);
    }
    const Vector3 impulse = persisted ? step_ * force : 0.5 * (state.impulse + step_ * force);
    state = {s, impulse};
    return impulse;
  }

  static Vector3 sticking_force(const DiscreteConstants& spring, const Vector3& s,
                                const Vector3& rate) {
    return -spring.stiffness * s - spring.damping * rate;
  }

  contact::TangentialSpring law_;
  DiscreteConstants constants_;
  DiscreteEndConstants ends_;
  double friction_;
  double step_;
  double inverse_mass_;
};

}  // namespace cohesion::contact_solver
