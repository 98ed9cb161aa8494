// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/contact_parameters.h"
#include "contact_solver/contact_bodies.h"
#include "contact_solver/contact_history.h"
#include "contact_solver/contact_spring.h"
#include "contact_solver/pair_motion.h"
#include "contact_solver/step_window.h"
#include "sampled_contact/sampled_pair.h"

namespace cohesion::sampled_contact {

using namespace contact_solver;

/// One contact whose forces are taken where it stands on the grid: the scheme to compare with.
/// Pair: SampledHamaker, SampledWell or SampledBridge. Everything that does not change
/// from step to step is worked out once; pairs of equal bodies can share it.
template <class Pair>
class SampledContact {
 public:
  using Attraction = typename Pair::Attraction;
  static constexpr bool is_exact = false;

  SampledContact(const contact::ContactParameters& parameters, const Attraction& attraction,
                 const Body& i, const Body& j, const StepWindow& window)
      : bodies_(i, j),
        window_(window),
        normal_law_(
            contact::normal_law(parameters, bodies_.rolling_radius(), bodies_.reduced_mass())),
        pair_(normal_law_, attraction, bodies_.distance()),
        sliding_(ContactSpring::Kind::sliding, parameters, normal_law_, 2.0 * window.after,
                 bodies_.inverse_sliding_mass()),
        rolling_(ContactSpring::Kind::rolling, parameters, normal_law_, 2.0 * window.after,
                 bodies_.inverse_rolling_mass()) {}

  bool is_between(const Body& i, const Body& j) const { return bodies_.are(i, j); }
  const ContactBodies& bodies() const { return bodies_; }
  /// Gap up to which the pair attracts in this scheme, [length].
  double range() const { return pair_.range(); }
  /// Whether there is any adhesion; at a well as wide as the contact it has no range.
  bool attracts() const { return pair_.range() > 0.0 || pair_.adhesion_energy(0.0) < 0.0; }

  /// Whether a pair that stands at this distance [length] is in range, where nothing is known of
  /// how it came there.
  bool is_in_range(double distance) const {
    return distance < bodies_.distance() + pair_.entry_range();
  }
  /// As those of ExactContact.
  bool touches(double overlap, const ContactHistory&) const { return overlap > 0.0; }
  double friction_load(double overlap, const ContactHistory& history) const {
    return pair_.attraction(overlap, history.normal.in_range());
  }
  bool within_reach(const Vector3& separation, const Vector3&, double /*flown*/) const {
    return pair_.within_reach(norm(separation));
  }

  /// As those of ExactContact, for spheres that touch in their range. A tangential spring whose
  /// stiffness changes has no short path.
  template <int SIZE, class By, class Motion>
  [[gnu::always_inline]] bool advance_persistent(const Motion& now, double* values,
                                                 FrictionalStep& step,
                                                 ContactEnergies* energies = nullptr) const {
    constexpr bool friction = SIZE >= ContactHistory::with_friction;
    constexpr bool rolling = SIZE >= ContactHistory::with_rolling;
    if (values[0] != ContactState::inside || (friction && sliding_.stiffens())) return false;
    const Vector3 separation = now.separation(), velocity = now.velocity();
    PairStep normal = pair_.advance(separation, velocity, window_, true);
    if (!(normal.record.contact_time > 0.0)) return false;
    ContactState::store_force(normal.force, values);
    step.impulse = bodies_.reduced_mass() * normal.velocity_change;
    step.repulsion = normal.record.repulsion_impulse;
    DiscreteSpring::Losses slid, rolled;
    if constexpr (friction) {
      const PersistentStep pressed{normal.force, normal.record.repulsion_at_end, 0.0};
      const ContactBodies::Touch touch =
          ContactBodies::Touch::of_spheres(bodies_, separation, 1.0 / norm(separation));
      const Vector3 spin_i = now.spin_i(), spin_j = now.spin_j();
      step.friction = sliding_.persistent_impulse<true>(
          touch.plane(), touch.sliding_velocity(velocity, spin_i, spin_j), pressed, 0.0,
          values + ContactHistory::normal_only, energies ? &slid : nullptr);
      touch.add_sliding_impulse(step.friction, step);
      if constexpr (rolling)
        touch.add_rolling_impulse(
            rolling_.persistent_impulse<true>(touch.plane(), touch.rolling_velocity(spin_i, spin_j),
                                              pressed, 0.0, values + ContactHistory::with_friction,
                                              energies ? &rolled : nullptr),
            step);
    }
    if (energies) set_losses(normal, slid, rolled, *energies);
    return true;
  }
  template <int SIZE>
  StoredEnergies stored_persistent(const PairMotion& now, const double*,
                                   const double* values) const {
    return stored(now.separation, ContactHistory::stored(values, SIZE));
  }
  template <class Motion>
  bool is_idle(const Motion&, const double*, double) const {
    return false;
  }

  /// As ExactContact::advance(); other forces do not matter. Of `energies`, half of what the normal
  /// dashpot takes in the step around the time level is before it.
  template <int SIZE>
  [[gnu::always_inline]] FrictionalStep advance(const PairMotion& grid, const Vector3&, bool,
                                                ContactHistory& history, ContactEnergies* energies,
                                                bool with_stored = true) const {
    const Vector3& s = grid.separation;
    if (history.normal.phase == ContactState::unknown)
      history.normal.phase = stands(grid) ? ContactState::inside : ContactState::outside;
    const PairStep normal = pair_.advance(s, grid.velocity, window_, history.normal.in_range());
    history.normal.phase = normal.inside ? ContactState::inside : ContactState::outside;
    FrictionalStep step;
    step.impulse = bodies_.reduced_mass() * normal.velocity_change;
    history.normal.force = normal.force;
    step.repulsion = normal.record.repulsion_impulse;
    if (Pair::pushes_at_edge && step.repulsion == 0.0) step.at_edge = step.impulse;
    DiscreteSpring::Losses slid, rolled;
    if constexpr (SIZE >= ContactHistory::with_friction) {
      const ContactBodies::Touch touch(bodies_, s);
      const Overlaps overlaps = this->overlaps(grid);
      step.friction =
          spring_impulse(sliding_, overlaps, touch,
                         touch.sliding_velocity(grid.velocity, grid.spin_i, grid.spin_j), normal,
                         history.sliding, energies ? &slid : nullptr);
      touch.add_sliding_impulse(step.friction, step);
      if constexpr (SIZE >= ContactHistory::with_rolling)
        touch.add_rolling_impulse(
            spring_impulse(rolling_, overlaps, touch,
                           touch.rolling_velocity(grid.spin_i, grid.spin_j), normal,
                           history.rolling, energies ? &rolled : nullptr),
            step);
    }
    if (energies) {
      if (with_stored) energies->stored = stored(grid.separation, history);
      set_losses(normal, slid, rolled, *energies);
    }
    return step;
  }

  /// The part of the impulse on j that spring, dashpot and friction give; the rest is adhesion.
  Vector3 by_contact(const PairMotion& grid, const FrictionalStep& step) const {
    if (!attracts()) return step.impulse;
    const Vector3& s = grid.separation;
    return (step.repulsion / norm(s)) * s + step.friction;
  }

  /// What is stored at a time level, with its history.
  StoredEnergies stored(const Vector3& separation, const ContactHistory& history) const {
    const double overlap = bodies_.distance() - norm(separation);
    return {pair_.spring_energy(overlap), sliding_.stored_energy(overlap, history.sliding.stretch),
            rolling_.stored_energy(overlap, history.rolling.stretch),
            is_bound(history, bodies_.distance() - overlap) ? pair_.adhesion_energy(overlap) : 0.0};
  }

 private:
  static void set_losses(const PairStep& normal, const DiscreteSpring::Losses& slid,
                         const DiscreteSpring::Losses& rolled, ContactEnergies& energies) {
    const double damped = 0.5 * normal.record.dissipated;
    energies.before = {damped, slid.damped, rolled.all};
    energies.after.normal_damping = damped;
  }

  /// [length], at the time level and at the one before.
  struct Overlaps {
    double now, before;
  };
  Overlaps overlaps(const PairMotion& now) const {
    if (!sliding_.stiffens()) return {};  // not needed
    return {bodies_.distance() - norm(now.separation),
            bodies_.distance() - norm(now.separation - (2.0 * window_.before) * now.velocity)};
  }
  bool is_bound(const ContactHistory& history, double distance) const {
    return history.normal.in_range() ||
           (history.normal.phase == ContactState::unknown && is_in_range(distance));
  }
  /// Whether a pair of which nothing is known stands in range, and has not come there by its motion
  /// of the last step.
  bool stands(const PairMotion& now) const {
    return is_in_range(norm(now.separation)) &&
           is_in_range(norm(now.separation - (2.0 * window_.before) * now.velocity));
  }

  [[gnu::always_inline]] Vector3 spring_impulse(const ContactSpring& contact_spring,
                                                const Overlaps& overlaps,
                                                const ContactBodies::Touch& touch,
                                                const Vector3& rate, const PairStep& normal,
                                                DiscreteSpring::State& state,
                                                DiscreteSpring::Losses* losses) const {
    // The first step of a run is half of one, from the grid point on.
    const double part = window_.length() / (2.0 * window_.after);
    const DiscreteSpring& spring = contact_spring.constant();
    const DiscreteConstants here = contact_spring.constants_at(overlaps.now);
    const DiscreteSpring::State last = state;
    const double left = contact_spring.left_of_stretch(overlaps.before, overlaps.now);
    state.stretch = left * state.stretch;
    const bool touches = normal.record.contact_time > 0.0;
    bool slips = false;
    if (touches)
      spring.advance_persistent(touch.plane(), rate, normal.record.repulsion_at_end, here, state,
                                slips);
    else
      state = {};
    if (losses) {
      *losses =
          spring.losses(touch.plane(), rate, {contact_spring.constants_at(overlaps.before), last},
                        left, {here, state}, slips);
      if (!touches) losses->damped = 0.0;
    }
    return part * state.impulse;
  }

  ContactBodies bodies_;
  StepWindow window_;
  contact::NormalLaw normal_law_;
  Pair pair_;
  ContactSpring sliding_;
  ContactSpring rolling_;
};

}  // namespace cohesion::sampled_contact
