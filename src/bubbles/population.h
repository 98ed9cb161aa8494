// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "bubbles/breaking.h"
#include "bubbles/bubble.h"
#include "bubbles/merging.h"
#include "bubbles/nozzles.h"

namespace cohesion::bubbles {

/// What is asked of a population of bubbles. Diameters [length]; a largest diameter of 0: nothing
/// merges; an infinite one for breaking: nothing breaks.
struct Rules {
  double top = std::numeric_limits<double>::infinity();  ///< height above which bubbles leave
  double merge_up_to = 0.0;
  double break_above = std::numeric_limits<double>::infinity();
  double rest = 0.0;     ///< of halves, before they merge again [time]
  double density = 0.0;  ///< of bubbles from nozzles [mass/length^3]
  Vector3 velocity{};    ///< the same [length/time]
};

/// Sums since the beginning: numbers [1] and volumes [length^3].
struct BubbleTotals {
  double injected = 0.0, injected_volume = 0.0;
  double removed = 0.0, removed_volume = 0.0;
  double merged = 0.0, broken = 0.0;
};

/// What a round of events makes of a list of bubbles.
struct Events {
  std::vector<bool> gone;  ///< of each that was there
  std::vector<bool> changed;
  std::vector<Merger> mergers;
  /// Bubbles that are new: with the place in the list of the one that they broke off, if any.
  struct New {
    Bubble bubble;
    std::optional<std::size_t> from;
  };
  std::vector<New> born;
  /// Bubbles that nozzles blew into, after all else.
  std::vector<Nozzles::Fed> fed;
};

/// Nozzles give bubbles, or where these merge blow into those in their places, which counts as a
/// bubble that came and merged. `present`: those of `bubbles` that are there, at `place_of`, and
/// their new halves.
inline void nozzles_give(std::vector<Bubble>& bubbles, std::vector<Bubble>& present,
                         const std::vector<std::size_t>& place_of, const Rules& rules,
                         const BubbleBox& box, Nozzles& nozzles, double time, long& next_number,
                         BubbleTotals& totals, Events& events) {
  const double most_together = sphere_volume(0.5 * rules.merge_up_to);
  for (std::size_t k = 0; k < nozzles.count(); k++) {
    const double volume = nozzles.gives(k, present, box);
    if (volume > 0.0) {
      const Bubble fresh{next_number++, nozzles.place(k), rules.velocity, radius_of(volume),
                         rules.density * volume};
      events.born.push_back({fresh, std::nullopt});
      present.push_back(fresh);
      totals.injected += 1.0;
      totals.injected_volume += fresh.volume();
    } else if (const auto fed = nozzles.feeds(k, bubbles, events.gone, box, most_together, time)) {
      Bubble& one = bubbles[fed->bubble];
      const Bubble blown{one.number, nozzles.place(k), rules.velocity, radius_of(fed->volume),
                         rules.density * fed->volume};
      one = merged(one, blown, box);
      present[place_of[fed->bubble]] = one;
      events.changed[fed->bubble] = true;
      events.fed.push_back(*fed);
      totals.injected += 1.0;
      totals.injected_volume += fed->volume;
      totals.merged += 1.0;
    }
  }
}

/// A round of events at a time, in this order: those above the top leave, touching ones merge,
/// large ones break, nozzles give. `bubbles`, sorted by number, are changed in place; next_number
/// is the first that none has had.
inline Events round_of_events(std::vector<Bubble>& bubbles, const Rules& rules,
                              const BubbleBox& box, Nozzles* nozzles, double time,
                              long& next_number, BubbleTotals& totals) {
  Events events;
  events.gone.assign(bubbles.size(), false);
  events.changed.assign(bubbles.size(), false);
  std::vector<Bubble> inside;
  std::vector<std::size_t> place;
  for (std::size_t i = 0; i < bubbles.size(); i++) {
    if (bubbles[i].position.z > rules.top) {
      events.gone[i] = true;
      totals.removed += 1.0;
      totals.removed_volume += bubbles[i].volume();
    } else {
      inside.push_back(bubbles[i]);
      place.push_back(i);
    }
  }
  if (rules.merge_up_to > 0.0)
    for (const Merger& pair : mergers(inside, box, rules.merge_up_to, time)) {
      const Merger there{place[pair.into], place[pair.gone]};
      bubbles[there.into] = merged(bubbles[there.into], bubbles[there.gone], box);
      events.gone[there.gone] = events.changed[there.into] = true;
      events.mergers.push_back(there);
      totals.merged += 1.0;
    }
  std::vector<Bubble> present;
  const std::size_t there_before = bubbles.size();
  std::vector<std::size_t> place_of(there_before, 0);
  for (std::size_t i = 0; i < there_before; i++) {
    if (events.gone[i]) continue;
    if (2.0 * bubbles[i].radius > rules.break_above)
      if (const auto halves = broken(bubbles[i], next_number, box, time + rules.rest)) {
        bubbles[i] = halves->first;
        events.changed[i] = true;
        events.born.push_back({halves->second, i});
        present.push_back(halves->second);
        next_number++;
        totals.broken += 1.0;
      }
    place_of[i] = present.size();
    present.push_back(bubbles[i]);
  }
  if (nozzles)
    nozzles_give(bubbles, present, place_of, rules, box, *nozzles, time, next_number, totals,
                 events);
  return events;
}

}  // namespace cohesion::bubbles
