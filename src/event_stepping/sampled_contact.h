// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/contact_parameters.h"
#include "event_stepping/contact_bodies.h"
#include "event_stepping/contact_memory.h"
#include "event_stepping/pair_step.h"
#include "event_stepping/spring_on_grid.h"

namespace cohesion::event_stepping {

/// What a sampled contact does in a step.
struct SampledStep {
  Action action;
  double repulsion = 0.0;  ///< impulse of spring and dashpot, [momentum]
  Vector3 friction{};      ///< impulse on j, [momentum]
};

/// One contact whose forces are taken where it stands on the grid: the scheme to compare with.
/// Pair: SampledHamaker, SampledWell, SampledBridge or WellEdge. Everything that does not change
/// from step to step is worked out once; pairs of equal bodies can share it.
template <class Pair>
class SampledContact {
 public:
  using Attraction = typename Pair::Attraction;
  static constexpr bool on_grid = false;
  /// Whether what a pair does that is not in contact is the impulse of an edge.
  static constexpr bool pushes_at_edge = Pair::pushes_at_edge;

  SampledContact(const contact::ContactParameters& parameters, const Attraction& attraction,
                 const Body& i, const Body& j, const StepWindow& window)
      : bodies_(i, j),
        window_(window),
        normal_contact_(contact::normal_contact(parameters, bodies_.reduced_mass())),
        pair_(normal_contact_, attraction, bodies_.distance(), window.length()),
        sliding_(contact::tangential_contact(parameters, normal_contact_), 2.0 * window.after,
                 bodies_.inverse_sliding_mass()),
        rolling_(contact::rolling_contact(parameters, normal_contact_), 2.0 * window.after,
                 bodies_.inverse_rolling_mass()) {}

  bool is_between(const Body& i, const Body& j) const { return bodies_.are(i, j); }
  const ContactBodies& bodies() const { return bodies_; }
  /// Gap up to which the pair attracts in this scheme, [length].
  double range() const { return pair_.range(); }
  /// Whether there is any adhesion; at a well as wide as the contact it has no range.
  bool attracts() const { return pair_.range() > 0.0 || pair_.adhesion_energy(0.0) < 0.0; }

  bool within_reach(const RelativeState& grid) const { return pair_.within_reach(grid, window_); }

  /// Whether a pair of which nothing is remembered stands within the gap `range` [length], and has
  /// not fallen into it: then it was outside `before` [time].
  bool stands_within(const RelativeState& grid, double range, double before) const {
    const double edge = bodies_.distance() + range;
    return norm(grid.separation) < edge && norm(grid.separation - before * grid.velocity) < edge;
  }

  /// `memory`, of which the phase says whether the pair is in range, and the losses of the step
  /// around the grid point (of springs in the plane of contact: the one before it) are changed.
  template <int SIZE>
  [[gnu::always_inline]] SampledStep compute(const PairMotion& grid, ContactMemory& memory,
                                             ContactLosses* losses) const {
    const Vector3& s = grid.relative.separation;
    const PairStep normal = pair_.advance(grid.relative, window_, memory.in_range());
    memory.phase = normal.inside ? ContactMemory::inside : ContactMemory::beyond;
    if (losses) losses->normal_damping = normal.normal.dissipated;
    SampledStep step;
    step.action.impulse = bodies_.reduced_mass() * normal.change.velocity;
    step.repulsion = normal.normal.repulsion_impulse;
    if constexpr (SIZE >= ContactMemory::with_friction) {
      const ContactBodies::Touch touch(bodies_, s);
      SpringOnGrid::Losses lost;
      step.friction = spring_impulse(
          sliding_, touch, touch.sliding_velocity(grid.relative.velocity, grid.spin_i, grid.spin_j),
          normal, memory.sliding, losses ? &lost : nullptr);
      touch.add_sliding_impulse(step.friction, step.action);
      if (losses) {
        losses->tangential_damping = lost.damped;
        losses->friction = lost.friction;
      }
      if constexpr (SIZE >= ContactMemory::with_rolling) {
        lost = {};
        touch.add_rolling_impulse(
            spring_impulse(rolling_, touch, touch.rolling_velocity(grid.spin_i, grid.spin_j),
                           normal, memory.rolling, losses ? &lost : nullptr),
            step.action);
        if (losses) losses->rolling = lost.damped + lost.friction;
      }
    }
    return step;
  }

  /// The part of the impulse on j that spring, dashpot and friction give; the rest is adhesion.
  Vector3 by_contact(const PairMotion& grid, const SampledStep& step) const {
    if (!attracts()) return step.action.impulse;
    const Vector3& s = grid.relative.separation;
    return (step.repulsion / norm(s)) * s + step.friction;
  }

  /// What is stored at the grid point. `memory`: after compute().
  StoredEnergies stored(const PairMotion& grid, const ContactMemory& memory) const {
    const double overlap = bodies_.distance() - norm(grid.relative.separation);
    return {pair_.spring_energy(overlap), sliding_.stored_energy(memory.sliding.stretch),
            rolling_.stored_energy(memory.rolling.stretch),
            memory.in_range() ? pair_.adhesion_energy(overlap) : 0.0};
  }

 private:
  [[gnu::always_inline]] Vector3 spring_impulse(const SpringOnGrid& spring,
                                                const ContactBodies::Touch& touch,
                                                const Vector3& rate, const PairStep& normal,
                                                SpringOnGrid::Memory& memory,
                                                SpringOnGrid::Losses* lost) const {
    // The first step of a run is half of one, from the grid point on.
    const double part = window_.length() / (2.0 * window_.after);
    bool slips;
    if (normal.normal.contact_time > 0.0)
      return part * spring.advance_lasting(touch.plane(), rate, normal.normal.repulsion_at_end,
                                           true, memory, slips, lost);
    if (lost) *lost = {0.0, spring.lost_at_end(rate, memory)};
    memory = {};
    return {};
  }

  ContactBodies bodies_;
  StepWindow window_;
  contact::LinearSpringDashpot normal_contact_;
  Pair pair_;
  SpringOnGrid sliding_;
  SpringOnGrid rolling_;
};

}  // namespace cohesion::event_stepping
