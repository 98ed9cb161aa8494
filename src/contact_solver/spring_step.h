// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "contact_solver/contact_bodies.h"
#include "contact_solver/contact_spring.h"
#include "contact_solver/contact_state.h"

namespace cohesion::contact_solver {

/// A step of the spring of friction or of rolling friction, in a persistent contact or a resolved
/// step.
class SpringStep {
 public:
  /// The normal motion of a step, as friction needs it.
  struct Normal {
    const ContactState& before;
    const ContactState& after;
    const ContactStep& step;
    double offset;            ///< true rate at the time level less the staggered one
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

  /// step [time]; friction_load [force]: ContactSolver::friction_load(). The bodies must outlive
  /// it.
  SpringStep(const ContactBodies& bodies, double step, double friction_load)
      : bodies_(bodies), step_(step), friction_load_(friction_load) {}

  /// The impulse of a spring at this time level; `by_other` [length/time]: the change of its rate
  /// by the other spring in the first half of a resolved step.
  Vector3 advance(const ContactSpring& contact_spring, const ContactBodies::Touch& touch,
                  const Vector3& rate, const Vector3& by_other, const Normal& n,
                  DiscreteSpring::State& state, Energies* energies) const {
    const double in_step = n.overlap_in_step(), in_last_step = n.overlap_in_last_step();
    const DiscreteSpring spring = contact_spring.at(in_step);
    const DiscreteSpring::State last = state;
    const double left = contact_spring.left_of_stretch(in_last_step, in_step);
    state.stretch = left * state.stretch;
    state.impulse = touch.plane().turned_into(state.impulse);
    // A contact that begins at a time level begins with the true velocity.
    const double true_force = 2.0 * bodies_.reduced_mass() * n.offset / step_;
    bool slips = false;
    Vector3 stretch{}, impulse;
    if (n.after.is_persistent()) {
      const double limiting =
          n.persisted() ? n.step.repulsion : 2.0 * n.step.force - true_force + friction_load_;
      impulse =
          spring.advance_persistent(touch.plane(), rate, limiting, n.persisted(), state, slips);
      stretch = state.stretch;
    } else {
      if (n.persisted()) {
        const Vector3 sticking = spring.sticking_impulse(touch.plane(), rate, state.stretch);
        spring.advance_persistent(touch.plane(), rate, n.repulsion_before, true, state, slips);
        spring.end_persistent(sticking, true_force + friction_load_, state);
        stretch = state.stretch;
      } else if (n.touches()) {
        stretch = touch.plane().turned_into(state.stretch);
        if (n.before.in_range()) stretch += step_ * rate;
      }
      impulse = resolve(spring, touch, stretch, rate + by_other, n, state, energies);
    }
    if (energies) {
      energies->stored = spring.stored_energy(stretch);
      if (n.persisted())
        energies->before =
            spring.losses(touch.plane(), rate, {contact_spring.constants_at(in_last_step), last},
                          left, {spring.constants(), {stretch, impulse}}, slips);
    }
    return impulse;
  }

 private:
  /// The same of a resolved step, from `stretch` at the time level; state.impulse is pending.
  Vector3 resolve(const DiscreteSpring& spring, const ContactBodies::Touch& touch,
                  const Vector3& stretch, const Vector3& rate, const Normal& n,
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

  const ContactBodies& bodies_;
  double step_;
  double friction_load_;
};

}  // namespace cohesion::contact_solver
