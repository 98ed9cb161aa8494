// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <variant>

#include "contact/contact_parameters.h"
#include "contact_solver/contact_bodies.h"
#include "contact_solver/contact_history.h"
#include "contact_solver/contact_state.h"
#include "contact_solver/discrete_spring.h"

namespace cohesion::contact_solver {

/// The spring of friction, or of rolling friction, of a contact. With a linear normal spring its
/// stiffness is constant. With Hertz's it grows with the overlap, as Mindlin's: while it grows, the
/// force is kept and the stretch decreases; while it falls, the stretch is kept and the force
/// decreases. So no change of the overlap adds energy to it. While the overlap grows, a
/// displacement adds to the force by the mean of the stiffnesses at both ends of the step. With any
/// stiffness K <= K_m <= K' the spring gains no energy: from a force f to f' it loses
/// f^2/2 (1/K - 1/K_m) + f'^2/2 (1/K_m - 1/K') >= 0.
///
/// Source: C. Thornton, S. J. Cummins, P. W. Cleary, Powder Technol. 233 (2013) 30.
class ContactSpring {
 public:
  enum class Kind { sliding, rolling };

  /// The normal motion of a step, as friction needs it.
  struct NormalStep {
    const ContactState& before;
    const ContactState& after;
    const ContactStep& step;
    /// The mean force of the contact in the half step before the time level, 2 mu offset/dt; 0 in
    /// the first step of a run, [force].
    double force_to_level;
    double friction_load;     ///< ContactSolver::friction_load(), [force]
    double overlap;           ///< [length]
    double overlap_before;    ///< at the time level before
    double repulsion_before;  ///< of a contact that has been persistent, [force]
    double overlap_at_end;
    double lowest;  ///< at which contact ends

    bool persisted() const { return before.is_persistent(); }
    /// The overlap that a spring has in the step that begins here, and had in the last one.
    double overlap_in_step() const {
      return after.is_persistent() ? overlap : mean(overlap, overlap_at_end);
    }
    double overlap_in_last_step() const {
      return persisted() ? overlap_before : mean(overlap_before, overlap);
    }

    bool touches() const { return overlap > lowest; }
    bool touches_at_end() const { return overlap_at_end > lowest; }

   private:
    double mean(double a, double b) const {
      return 0.5 * (std::max(a, lowest) + std::max(b, lowest));
    }
  };
  /// Energies of a spring: stored, and lost before and after the time level.
  struct Energies {
    double stored = 0.0;
    DiscreteSpring::Losses before, after;
  };

  /// inverse_mass [1/mass]: DiscreteSpring.
  ContactSpring(Kind kind, const contact::ContactParameters& contact, const contact::NormalLaw& law,
                double step, double inverse_mass)
      : kind_(kind),
        contact_(contact),
        law_(law),
        step_(step),
        inverse_mass_(inverse_mass),
        stiffens_(!contact::is_linear(law)),
        constant_(stiffens_
                      ? at(0.0)
                      : DiscreteSpring(parameters(std::get<contact::LinearSpringDashpot>(law)),
                                       step, inverse_mass)) {}

  /// Whether there is any friction.
  bool is_present() const { return constant_.is_present(); }
  bool stiffens() const { return stiffens_; }
  /// The spring if its stiffness is constant; step, mass and friction are right in any case.
  const DiscreteSpring& constant() const { return constant_; }
  /// The spring at this overlap [length].
  DiscreteSpring at(double overlap) const {
    if (!stiffens_) return constant_;
    return DiscreteSpring::at_time_level(parameters(contact::point_of(law_, overlap)), step_,
                                         inverse_mass_);
  }
  /// The constants of a persistent contact at this overlap [length].
  DiscreteConstants constants_at(double overlap) const {
    return stiffens_ ? constants_at(contact::point_of(law_, overlap)) : constant_.constants();
  }
  /// The same of a spring that stiffens, at this point of the law.
  DiscreteConstants constants_at(const contact::LawPoint& here) const {
    const contact::TangentialParameters p = parameters(here);
    return constant_.constants_at_time_level(p.stiffness, p.damping);
  }
  /// Of a persistent contact, [energy].
  double stored_energy(double overlap, const Vector3& stretch) const {
    return DiscreteSpring::stored_energy(constants_at(overlap), stretch);
  }
  /// The fraction of a stretch that is left after a change of the overlap [length].
  double left_of_stretch(double before, double now) const {
    if (!stiffens_ || !(now > before)) return 1.0;
    return contact::stretch_left(contact::point_of(law_, before).radius_stiffness,
                                 contact::point_of(law_, now).radius_stiffness);
  }

  /// The impulse of a persistent contact whose normal motion does `normal`, that was persistent in
  /// the last step, too. `values`: the stored spring; `linear`: whether the normal law is;
  /// overlap_before [length]: at the last time level; `losses` may be null.
  template <bool linear>
  [[gnu::always_inline]] Vector3 persistent_impulse(const contact::Plane& plane,
                                                    const Vector3& rate,
                                                    const PersistentStep& normal,
                                                    double overlap_before, double* values,
                                                    DiscreteSpring::Losses* losses) const {
    DiscreteSpring::State last{vector(values), vector(values + 3)}, state{last.stretch};
    Vector3 impulse;
    bool slips;
    if constexpr (linear) {
      impulse = constant_.advance_persistent(plane, rate, normal.repulsion, true, state, slips);
      if (losses)
        *losses = constant_.losses(plane, rate, {constant_.constants(), last}, 1.0,
                                   {constant_.constants(), state}, slips);
    } else {
      const double left =
          contact::stretch_left(normal.radius_stiffness_before, normal.at.radius_stiffness);
      const double weight = contact::displacement_weight(left);
      state.stretch = left * state.stretch;
      const DiscreteConstants here = constants_at(normal.at);
      impulse =
          constant_.advance_persistent(plane, rate, normal.repulsion, here, state, slips, weight);
      if (losses)
        *losses = constant_.losses(plane, rate, {constants_at(overlap_before), last}, left,
                                   {here, state}, slips, weight);
    }
    ContactHistory::store(state, values);
    return impulse;
  }

  /// The impulse of any contact at this time level; `by_other` [length/time]: the change of the
  /// rate by the other spring in the first half of a resolved step; `energies` may be null.
  Vector3 advance(const ContactBodies::Touch& touch, const Vector3& rate, const Vector3& by_other,
                  const NormalStep& n, DiscreteSpring::State& state, Energies* energies) const {
    const double in_step = n.overlap_in_step(), in_last_step = n.overlap_in_last_step();
    const DiscreteSpring spring = at(in_step);
    const DiscreteSpring::State last = state;
    const double left = left_of_stretch(in_last_step, in_step);
    // A resolved step has added its displacement with the stiffness that it had.
    const double weight = n.persisted() ? contact::displacement_weight(left) : left;
    state.stretch = left * state.stretch;
    state.impulse = touch.plane().turned_into(state.impulse);
    bool slips = false;
    Vector3 stretch{}, impulse;
    if (n.after.is_persistent()) {
      // A contact that begins at a time level begins with the true velocity.
      const double limiting = n.persisted()
                                  ? n.step.repulsion
                                  : 2.0 * n.step.force - n.force_to_level + n.friction_load;
      impulse = spring.advance_persistent(touch.plane(), rate, limiting, n.persisted(), state,
                                          slips, weight);
      stretch = state.stretch;
    } else {
      if (n.persisted()) {
        const Vector3 sticking =
            spring.sticking_impulse(touch.plane(), rate, state.stretch, weight);
        spring.advance_persistent(touch.plane(), rate, n.repulsion_before, true, state, slips,
                                  weight);
        spring.end_persistent(sticking, n.force_to_level + n.friction_load, state);
        stretch = state.stretch;
      } else if (n.touches()) {
        stretch = touch.plane().turned_into(state.stretch);
        if (n.before.in_range()) stretch += (weight * step_) * rate;
      }
      impulse = resolve(spring, touch, stretch, rate + by_other, n, state, energies);
    }
    if (energies) {
      energies->stored = spring.stored_energy(stretch);
      if (n.persisted())
        energies->before =
            spring.losses(touch.plane(), rate, {constants_at(in_last_step), last}, left,
                          {spring.constants(), {stretch, impulse}}, slips, weight);
    }
    return impulse;
  }

 private:
  /// advance() in a resolved step, from `stretch` at the time level; state.impulse is pending.
  Vector3 resolve(const DiscreteSpring& spring, const ContactBodies::Touch& touch,
                  const Vector3& stretch, const Vector3& rate, const NormalStep& n,
                  DiscreteSpring::State& state, Energies* energies) const {
    if (!(n.step.record.contact_time > 0.0)) {
      const Vector3 half = 0.5 * state.impulse;
      if (energies) energies->after.all = spring.stored_energy(stretch);
      state = {};
      return half;
    }
    const Vector3 true_rate = rate + (0.5 * spring.inverse_mass()) * state.impulse;
    Vector3 mean;
    const contact::TangentialStep now =
        spring.resolve(touch.plane(), touch.plane().part_in(stretch), true_rate, n.step.record,
                       n.touches_at_end(), mean);
    const Vector3 impulse = 0.5 * (now.impulse + state.impulse);
    if (energies) energies->after = {now.damped + now.friction, now.damped};
    const bool goes_on = n.touches_at_end();
    state = {goes_on ? now.displacement - step_ * mean : Vector3{}, now.impulse};
    return impulse;
  }

  template <class Normal>
  contact::TangentialParameters parameters(const Normal& normal) const {
    return kind_ == Kind::sliding ? contact::tangential_contact(contact_, normal)
                                  : contact::rolling_contact(contact_, normal);
  }

  Kind kind_;
  contact::ContactParameters contact_;
  contact::NormalLaw law_;
  double step_;
  double inverse_mass_;
  bool stiffens_;
  DiscreteSpring constant_;
};

}  // namespace cohesion::contact_solver
