// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::event_stepping {

/// Whether one force will do for the contacts of a particle: not beside an event, nor for young
/// contacts beside any other, whose one force takes what others do for motion of its own. Elastic
/// gases would heat, dense ones with adhesion cool. Each contact adds its part to the sum of a
/// particle; the sum says.
namespace unrest {

constexpr double of_old = 1.0;
constexpr double of_young = 1e6;
constexpr double of_event = 2e6;

inline bool is_restless(double sum) { return sum > of_young; }

}  // namespace unrest
}  // namespace cohesion::event_stepping
