// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "contact/contact_parameters.h"
#include "contact_solver/contact_bodies.h"
#include "contact_solver/contact_history.h"
#include "contact_solver/contact_solver.h"
#include "contact_solver/contact_spring.h"
#include "contact_solver/normal_energies.h"

namespace cohesion::contact_solver {

/// A contact of two spheres, or of a sphere and a wall. A solver integrates the normal motion;
/// springs, dashpots and sliders give friction and rolling friction (contact_spring.h). In a
/// persistent contact these are discrete springs (discrete_spring.h). In a resolved step the
/// midpoint rule integrates them over the time in contact; half of their impulse acts at time level
/// n, half at n+1.
///
/// Momentum and angular momentum are conserved to round-off. Pairs of equal bodies can share an
/// object: it contains only what does not change from step to step.
///
/// Solver: ContactSolver, SquareWellSolver, LiquidBridgeSolver, JkrSolver or WellEdgeSolver. The
/// template parameter SIZE of functions is the number of stored values (ContactHistory): it
/// decides whether there is friction and rolling friction.
template <class Solver>
class ExactContact {
 public:
  using Attraction = contact::Adhesion;
  static constexpr bool is_exact = true;

  /// step [time].
  ExactContact(const contact::ContactParameters& parameters, const contact::Adhesion& attraction,
               const Body& i, const Body& j, double step)
      : bodies_(i, j),
        step_(step),
        normal_law_(
            contact::normal_law(parameters, bodies_.rolling_radius(), bodies_.reduced_mass())),
        solver_(normal_law_, attraction, bodies_.distance(), step),
        sliding_(ContactSpring::Kind::sliding, parameters, normal_law_, step,
                 bodies_.inverse_sliding_mass()),
        rolling_(ContactSpring::Kind::rolling, parameters, normal_law_, step,
                 bodies_.inverse_rolling_mass()),
        lowest_overlap_(solver_.lowest_overlap()),
        friction_load_(solver_.friction_load()),
        touch_energy_(solver_.adhesion_energy(0.0)) {
    if (sliding_.is_present() || rolling_.is_present()) solver_.leave_out_exchange();
  }

  bool is_between(const Body& i, const Body& j) const { return bodies_.are(i, j); }
  const ContactBodies& bodies() const { return bodies_; }
  const Solver& solver() const { return solver_; }
  /// Gap up to which the pair attracts, [length].
  double range() const { return solver_.outer_distance() - bodies_.distance(); }
  /// Whether there is any adhesion. That of a well as wide as the contact has no range.
  bool attracts() const { return range() > 0.0 || touch_energy_ < 0.0; }

  /// Whether a pair without a stored state is in range at this distance [length].
  bool is_in_range(double distance) const { return distance <= solver_.entry_distance(); }

  /// Whether the surfaces touch at this overlap [length], and the normal force of Coulomb's limit
  /// less the contact force there, [force].
  bool touches(double overlap, const ContactHistory& history) const {
    return history.normal.in_range() && overlap > lowest_overlap_;
  }
  double friction_load(double, const ContactHistory&) const { return friction_load_; }

  /// Whether a pair out of range may enter it in this step. `flown` [length]: upper bound of the
  /// displacement by forces within the step.
  bool within_reach(const Vector3& separation, const Vector3& velocity, double flown) const {
    const double range = solver_.outer_distance() + flown;
    const double square = dot(separation, separation);
    const double closing = -step_ * dot(separation, velocity);
    const double reach = range + std::max(closing, 0.0) / range;
    if (square > reach * reach) return false;
    // A straight flight comes no nearer than its component along the line of centres does.
    const double distance = std::sqrt(square);
    return distance * (distance - range) <= std::max(closing, 0.0);
  }

  /// Whether a pair in its well, with nothing pending, certainly meets neither contact nor edge in
  /// this step, so that no force acts. `values`: the stored history; `flown`: as above.
  template <class Motion>
  [[gnu::always_inline]] bool is_idle(const Motion& motion, const double* values,
                                      double flown) const {
    if constexpr (Solver::may_be_idle) {
      if (!ContactState::is_idle(values)) return false;
      const Vector3 s = motion.separation();
      return solver_.is_clear(dot(s, s), step_ * norm(motion.velocity()) + flown);
    } else {
      return false;
    }
  }

  /// Advances a contact of two spheres that was persistent in the last step and certainly remains
  /// so, and adds its impulses to `step`. Returns false, and changes nothing, where that is not
  /// certain. `now`: has separation(), velocity(), spin_i() and spin_j(), as the members
  /// of PairMotion; `values`: the stored history; `By`: LinearContact or IntegratedContact;
  /// ContactMotion where laws differ; `energies`: without stored ones, may be null.
  template <int SIZE, class By, class Motion>
  [[gnu::always_inline]] bool advance_persistent(const Motion& now, double* values,
                                                 FrictionalStep& step,
                                                 ContactEnergies* energies = nullptr) const {
    if (values[0] != ContactState::persistent) return false;
    if constexpr (std::is_same_v<By, ContactMotion>) {
      return std::visit(
          [&](const auto& by) {
            return advance_persistent_by<SIZE>(by, now, values, step, energies);
          },
          solver_.contact());
    } else {
      const By* const by = std::get_if<By>(&solver_.contact());
      if (!by) __builtin_unreachable();
      return advance_persistent_by<SIZE>(*by, now, values, step, energies);
    }
  }

  /// What such a contact stores at the time level. `before`: the stored history that
  /// advance_persistent() was given; `values`: the one that it left.
  template <int SIZE>
  StoredEnergies stored_persistent(const PairMotion& now, const double* before,
                                   const double* values) const {
    const ContactHistory after = ContactHistory::stored(values, SIZE);
    const StaggeredMotion at = motion(now.separation, now.velocity, 1.0 / norm(now.separation));
    const double overlap = bodies_.distance() - at.distance;
    const ContactState last = ContactState::stored(before);
    ContactEnergies energies;
    set_normal_stored(solver_, {at, 0.0, false, last, after.normal, after.normal.force, 0.0},
                      bodies_.distance(), energies);
    energies.stored.tangential_spring = sliding_.stored_energy(overlap, after.sliding.stretch);
    energies.stored.rolling_spring = rolling_.stored_energy(overlap, after.rolling.stretch);
    return energies.stored;
  }

  /// Advances any contact. `acceleration` [length/time^2]: of j relative to i by all forces of the
  /// last step except impulses; `first`: in the first step of a run, whose velocities are those of
  /// the time level. `energies` may be null;
  /// `with_stored`: whether stored energies are evaluated, too.
  template <int SIZE>
  FrictionalStep advance(const PairMotion& now, const Vector3& acceleration, bool first,
                         ContactHistory& history, ContactEnergies* energies,
                         bool with_stored = true) const {
    const Vector3& s = now.separation;
    const double inverse = 1.0 / norm(s);
    const StaggeredMotion at = motion(s, now.velocity, inverse);
    const double external =
        first ? 0.0 : solver_.external(inverse * dot(s, acceleration), at, history.normal);
    FrictionalStep step;
    if (history.normal.phase == ContactState::outside && !solver_.within_reach(at, external))
      return step;
    const ContactState before = history.normal;
    const double velocity_step = first ? 0.5 * step_ : step_;
    const ContactStep normal = solver_.advance(at, external, velocity_step, history.normal);
    step.repulsion = velocity_step * normal.repulsion;
    step.unresolved = normal.record.unresolved;
    step.impulse = (velocity_step * normal.force * inverse) * s;
    if (solver_.gave_impulse(history.normal)) step.at_edge = step.impulse;
    const ContactSpring::NormalStep n{
        before,
        history.normal,
        normal,
        first ? 0.0 : 2.0 * bodies_.reduced_mass() * solver_.offset(at, external, before) / step_,
        friction_load_,
        bodies_.distance() - at.distance,
        bodies_.distance() - at.distance + step_ * at.mean_rate(step_),
        solver_.repulsion(at, before),
        overlap_at_end(now, step.impulse),
        lowest_overlap_};
    if (energies) {
      const SolvedStep solved{at,           external,         first, before, history.normal,
                              normal.force, normal.dissipated};
      set_normal_losses(solver_, solved, *energies);
      if (with_stored) set_normal_stored(solver_, solved, bodies_.distance(), *energies);
    }
    if constexpr (SIZE >= ContactHistory::with_friction) {
      const ContactBodies::Touch touch(bodies_, s, inverse);
      add_sliding(now, touch, n, history.sliding, step, energies);
      if constexpr (SIZE >= ContactHistory::with_rolling)
        add_rolling(now, touch, n, history.rolling, step, energies);
    }
    return step;
  }

  /// Converts the history where the last step had another length, `last_step` [time], so that the
  /// true rate after it is unchanged. Half of each force of that step has acted before this time
  /// level. `acceleration`: as in advance().
  void change_step(double last_step, const PairMotion& now, const Vector3& acceleration,
                   ContactHistory& history) const {
    ContactState& state = history.normal;
    const Vector3& s = now.separation;
    const double inverse = 1.0 / norm(s);
    if (state.is_persistent()) {
      state.last_rate = motion(s, now.velocity, inverse).mean_rate(step_) -
                        step_ * inverse * dot(s, acceleration);
    } else if (solver_.gave_impulse(state)) {
      state.force *= last_step / step_;
    } else if (state.phase == ContactState::touching || state.phase == ContactState::inside) {
      state.velocity_offset *= step_ / last_step;
    } else {
      // The velocity after an event does not depend on the step.
      state.velocity_offset += 0.5 * bodies_.inverse_mass() * state.force * (last_step - step_);
      if (state.phase == ContactState::settling) state.phase = ContactState::left;
    }
  }

  /// The impulse of spring, dashpot and friction on j; the rest is adhesion.
  Vector3 by_contact(const PairMotion& now, const FrictionalStep& step) const {
    if (!attracts()) return step.impulse;
    const Vector3& s = now.separation;
    return (step.repulsion / norm(s)) * s + step.friction;
  }

  /// Stored energies at a time level between two runs.
  StoredEnergies stored(const Vector3& separation, const ContactHistory& history) const {
    const double distance = norm(separation), overlap = bodies_.distance() - distance;
    const bool found_in_range =
        history.normal.phase == ContactState::unknown && is_in_range(distance);
    if (!history.normal.in_range() && !found_in_range) return {};
    return {
        solver_.spring_energy(overlap), sliding_.stored_energy(overlap, history.sliding.stretch),
        rolling_.stored_energy(overlap, history.rolling.stretch), solver_.adhesion_energy(overlap)};
  }

 private:
  /// Motion and history are read where they are used: otherwise they do not fit into registers.
  template <int SIZE, class By, class Motion>
  [[gnu::always_inline]] bool advance_persistent_by(const By& by, const Motion& now, double* values,
                                                    FrictionalStep& step,
                                                    ContactEnergies* energies) const {
    Vector3 s = now.separation(), v = now.velocity();
    const double square = dot(s, s), inverse = 1.0 / std::sqrt(square);
    const double rate = inverse * dot(s, v);
    DistanceMotion motion =
        DistanceMotion::of_pair(square * inverse, inverse, rate, dot(v, v), step_);
    PersistentStep result;
    ContactState normal = ContactState::stored_persistent(values);
    if (!solver_.advance_persistent(by, motion, touch_energy_, normal, result) || result.taut)
      return false;
    normal.store_persistent(values);
    if (energies) set_persistent_losses(result, *energies);
    step.repulsion = step_ * result.repulsion;
    step.impulse = (step_ * result.force * inverse) * s;
    if constexpr (SIZE >= ContactHistory::with_friction) {
      constexpr bool linear = std::is_same_v<By, LinearContact>;
      auto touch = ContactBodies::Touch::of_spheres(bodies_, s, inverse);
      Vector3 across = v - (inverse * rate) * s;
      const double overlap_before = bodies_.distance() - motion.distance + step_ * motion.rate;
      DiscreteSpring::Losses slid, rolled;
      step.friction = sliding_.persistent_impulse<linear>(
          touch.plane(), touch.sliding_velocity_across(across, now.spin_i(), now.spin_j()), result,
          overlap_before, values + ContactHistory::normal_only, energies ? &slid : nullptr);
      touch.add_sliding_impulse(step.friction, step);
      if constexpr (SIZE >= ContactHistory::with_rolling)
        touch.add_rolling_impulse(
            rolling_.persistent_impulse<linear>(
                touch.plane(), touch.rolling_velocity(now.spin_i(), now.spin_j()), result,
                overlap_before, values + ContactHistory::with_friction,
                energies ? &rolled : nullptr),
            step);
      if (energies) {
        energies->before.tangential_damping = slid.damped;
        energies->before.rolling = rolled.all;
      }
    }
    return true;
  }

  StaggeredMotion motion(const Vector3& separation, const Vector3& velocity, double inverse) const {
    const double rate = inverse * dot(separation, velocity);
    const double across = dot(velocity, velocity) - rate * rate;
    return {1.0 / inverse, rate, bodies_.is_wall() ? 0.0 : std::sqrt(std::max(across, 0.0))};
  }

  /// The overlap at the next time level without other forces.
  double overlap_at_end(const PairMotion& now, const Vector3& impulse) const {
    const Vector3 velocity = now.velocity + bodies_.inverse_mass() * impulse;
    return bodies_.distance() - norm(now.separation + step_ * velocity);
  }

  /// Adds impulse and energies of sliding friction.
  void add_sliding(const PairMotion& now, const ContactBodies::Touch& touch,
                   const ContactSpring::NormalStep& n, DiscreteSpring::State& state,
                   FrictionalStep& step, ContactEnergies* energies) const {
    ContactSpring::Energies spring;
    step.friction =
        sliding_.advance(touch, touch.sliding_velocity(now.velocity, now.spin_i, now.spin_j), {}, n,
                         state, energies ? &spring : nullptr);
    touch.add_sliding_impulse(step.friction, step);
    if (!energies) return;
    energies->stored.tangential_spring = spring.stored;
    energies->before.tangential_damping = spring.before.damped;
    energies->after.tangential_damping = spring.after.damped;
  }
  /// The same of rolling friction, after sliding friction.
  void add_rolling(const PairMotion& now, const ContactBodies::Touch& touch,
                   const ContactSpring::NormalStep& n, DiscreteSpring::State& state,
                   FrictionalStep& step, ContactEnergies* energies) const {
    ContactSpring::Energies spring;
    // Friction has turned the spheres by this much in the middle of a resolved step.
    const Vector3 turned = touch.rolling_velocity(bodies_.inverse_inertia_i() * step.torque_i,
                                                  bodies_.inverse_inertia_j() * step.torque_j);
    touch.add_rolling_impulse(
        rolling_.advance(touch, touch.rolling_velocity(now.spin_i, now.spin_j), turned, n, state,
                         energies ? &spring : nullptr),
        step);
    if (!energies) return;
    energies->stored.rolling_spring = spring.stored;
    energies->before.rolling = spring.before.all;
    energies->after.rolling = spring.after.all;
  }

  ContactBodies bodies_;
  double step_;
  contact::NormalLaw normal_law_;
  Solver solver_;
  ContactSpring sliding_;
  ContactSpring rolling_;
  double lowest_overlap_;
  double friction_load_;
  double touch_energy_;  // of the adhesion at touch
};

}  // namespace cohesion::contact_solver
