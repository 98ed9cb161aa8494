// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "advice/equal_escape.h"
#include "sampled_contact/sampled_hamaker.h"
#include "sampled_contact/sampled_well.h"

/// Head-on escape velocities of scheme sampled. Its forces are those on the grid, so that whether a
/// pair sticks depends on where in the step it meets: each speed has a fraction of positions at
/// which it does.
///
/// Source: derived here; measured in docs/verification/contacts.md.
namespace cohesion::advice {

struct SampledEscape {
  double mean;            ///< integral of the fraction that sticks over the speeds, [length/time]
  double slowest_parted;  ///< of those tried, [length/time]; rarer ones may be slower
  double fastest_stuck;   ///< the same
};

/// Standard error of the mean over the exact escape velocity, at most, from how many pairs it is. A
/// bias comes on top: speeds at which fewer than about one position in 16 sticks, or parts, may be
/// cut off. Against 6000 speeds and positions, D = 5e-11 J and A = 7.49e-19 J of the bed's spheres:
/// Hamaker 2e-5 and 4e-5, wells 6e-4 and 4e-3 of the exact velocity, at 2.25e-5 s and t_c/4.
inline constexpr double sampling_error = 1e-3;

/// A head-on pair at its first grid point, `separation` and `approach` > 0.
struct HeadOnStart {
  double separation;  ///< of the centres, [length]
  double approach;    ///< half a step before, [length/time]
  bool inside;        ///< of its well
};

/// Whether `pair` (SampledHamaker or SampledWell) parts after its first contact. It sticks when it
/// turns back before it is out of range; that a later impact may let it out again, as the scheme
/// does not keep energy, is not considered. On the grid as engines have it, velocities half a step
/// before positions; `step` [time]. Throws InvalidParameter after ten million steps.
template <class Pair>
bool parts(const Pair& pair, const HeadOnStart& start, double step) {
  const contact_solver::StepWindow window{0.5 * step, 0.5 * step};
  Vector3 separation{start.separation, 0, 0}, velocity{-start.approach, 0, 0};
  bool inside = start.inside, parting = false;
  for (long steps = 0; steps < 10'000'000; steps++) {
    if (inside || pair.within_reach(norm(separation))) {
      const sampled_contact::PairStep now = pair.advance(separation, velocity, window, inside);
      inside = now.inside;
      velocity += now.velocity_change;
    } else if (parting) {
      return true;
    }
    if (parting && velocity.x <= 0.0) return false;
    parting = velocity.x > 0.0;
    separation += step * velocity;
  }
  require(false, "time step", step,
          "a pair is not free again after ten million steps: take a longer one, or scheme exact, "
          "which is what short ones come to");
  return false;
}

namespace detail {

/// Pairs that parted and stuck, of n speeds between `low` and `high` at n positions each.
struct Survey {
  double slowest_parted, fastest_stuck;
  double stuck;  ///< fraction of all
};

template <class PartsAt>
Survey survey(const PartsAt& parts_at, double low, double high, int n) {
  constexpr double golden = 0.6180339887498949;  // no two speeds share their positions
  Survey seen{high, low, 0.0};
  for (int i = 0; i < n; i++)
    for (int k = 0; k < n; k++) {
      const double speed = low + (high - low) * (i + 0.5) / n;
      const double position = (k + 0.5) / n + golden * i;
      if (parts_at(speed, position - std::floor(position))) {
        seen.slowest_parted = std::min(seen.slowest_parted, speed);
      } else {
        seen.fastest_stuck = std::max(seen.fastest_stuck, speed);
        seen.stuck += 1.0 / n / n;
      }
    }
  return seen;
}

/// `parts_at(speed, position)`, position between 0 and 1: where in the step. `exact`: the escape
/// velocity of the laws integrated exactly.
template <class PartsAt>
SampledEscape sampled_escape(const PartsAt& parts_at, double exact, double step) {
  constexpr int few = 16;
  constexpr double farthest = 4.0;
  // Below `low` all stick, above `high` all part, as far as few pairs tell.
  double low = 0.0, high = farthest * exact;
  for (double last = 2.0 * high; high - low < 0.7 * last;) {
    last = high - low;
    const Survey seen = survey(parts_at, low, high, few);
    const double spacing = (high - low) / few;
    require(high < farthest * exact || seen.fastest_stuck + spacing < high, "time step", step,
            "pairs stick at several times the exact escape velocity: take a shorter one");
    low = std::max(low, std::min(seen.slowest_parted, seen.fastest_stuck) - spacing);
    high = std::min(high, std::max(seen.slowest_parted, seen.fastest_stuck) + spacing);
  }
  // Each of n^2 places in the plane of speed and position is stuck or not: the standard error of
  // that fraction is at most 1/(2 n).
  const double per_error = 0.5 * (high - low) / (sampling_error * exact);
  const int n = std::max(few, static_cast<int>(std::ceil(per_error)));
  const Survey seen = survey(parts_at, low, high, n);
  return {low + (high - low) * seen.stuck, seen.slowest_parted, seen.fastest_stuck};
}

inline void require_sampled_step(const contact::LinearSpringDashpot& spring, double step) {
  require(step > 0.0 && step <= 0.5 * spring.contact_time(), "time step", step,
          "must be above zero and at most half a contact time for scheme sampled");
}

}  // namespace detail

/// The escape of a Hamaker attraction, at `step` [time]; the pair comes from beyond the outer
/// cut-off.
/// Throws InvalidParameter where the exact escape velocity has none to compare with
/// (equal_escape.h), unless a contact has two steps, and where pairs stick at four times the exact
/// velocity.
inline SampledEscape sampled_escape(const contact::LinearSpringDashpot& spring,
                                    const sampled_contact::SampledHamaker::Attraction& attraction,
                                    double contact_distance, double step) {
  require_sticking(spring);
  detail::require_sampled_step(spring, step);
  const contact::Adhesion adhesion =
      std::visit([&](const auto& law) { return contact::adhesion_of(law, attraction.geometry); },
                 attraction.law);
  const double exact = contact::AdhesiveContact(spring, adhesion).escape_velocity();
  require_positive("escape velocity", exact);
  const sampled_contact::SampledHamaker pair(spring, attraction, contact_distance);
  const double edge = contact_distance + pair.range();
  return detail::sampled_escape(
      [&](double speed, double position) {
        return parts(pair, {edge + speed * step * position, speed, false}, step);
      },
      exact, step);
}

/// The escape of a square well (square_well/parameters.h), at `step` [time]. The pair starts in its
/// well, with what it gained at the edge, so that the contact is at every position in the step
/// alike: from a well of one width the impulse at the edge, put on at a grid point, would let it
/// meet at some positions only, others for each width and angle. Throws as for Hamaker, and unless
/// the well is wider than what the pair flies in a step: passages of narrower ones are missed.
inline SampledEscape sampled_escape(const contact::LinearSpringDashpot& spring,
                                    const contact::Adhesion& well, double contact_distance,
                                    double step) {
  require_sticking(spring);
  detail::require_sampled_step(spring, step);
  const double exact = escape_velocity_of_depth(spring, well.tail_energy);
  require_positive("escape velocity", exact);
  const contact::AdhesiveContact contact(spring, well);
  const double way = contact.entry_speed(exact) * step;
  require(well.cutoff > way, "width of the well", well.cutoff,
          "must exceed the way of a pair in a time step for scheme sampled: a wider well, or a "
          "shorter step");
  // Head-on the width does not matter: the narrowest one spares the flight to the edge.
  const sampled_contact::SampledWell pair(spring, {0.0, way, well.tail_energy}, contact_distance);
  return detail::sampled_escape(
      [&](double speed, double position) {
        const double entry = contact.entry_speed(speed);
        return parts(pair, {contact_distance + entry * step * position, entry, true}, step);
      },
      exact, step);
}

}  // namespace cohesion::advice
