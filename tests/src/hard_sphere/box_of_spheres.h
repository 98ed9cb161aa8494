// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "hard_sphere/event_simulation.h"

namespace cohesion::hard_sphere {

/// A box that is not periodic and extends from `low` to `high`.
inline PeriodicBox closed_box(const Vector3& low, const Vector3& high) {
  PeriodicBox box;
  box.origin = low;
  box.edges.xx = high.x - low.x;
  box.edges.yy = high.y - low.y;
  box.edges.zz = high.z - low.z;
  return box;
}

/// Parameters of a law with a well that extends to `ratio` radii.
inline HardContactParameters contact(const ImpactLaw& law, double ratio = 1.0) {
  return {law.restitution, law.friction, square_well::well(law.depth, ratio)};
}

/// Sets the position and velocity of a body at the beginning of the step, as an engine does.
inline void change_flight(EventSimulation& simulation, int body, const Vector3& position,
                          const Vector3& velocity, bool relocated = false) {
  VersionedFlight flight;
  flight.position = position;
  flight.velocity = velocity;
  flight.start_time = simulation.start();
  EventState event_state = simulation.bodies[body].event_state;
  event_state.causal_depth = -1;
  simulation.change_flight(body, flight, event_state, relocated);
}

/// Adds a velocity increment at the beginning of the step.
inline void increment_velocity(EventSimulation& simulation, int body, const Vector3& change) {
  const auto& flight = simulation.flights[body];
  change_flight(simulation, body, flight.at(simulation.start()), flight.velocity + change);
}

inline double kinetic_energy_of(const EventSimulation& simulation) {
  double sum = 0.0;
  for (std::size_t n = 0; n < simulation.bodies.size(); n++) {
    const auto& body = simulation.bodies[n];
    if (body.inverse_mass == 0.0) continue;
    const auto &v = simulation.flights[n].velocity, &spin = body.event_state.spin;
    sum += 0.5 * dot(v, v) / body.inverse_mass + 0.5 * dot(spin, spin) / body.inverse_inertia;
  }
  return sum;
}

/// Whether two events agree to the last bit.
inline bool same_bits(const Event& a, const Event& b) {
  return a.key.time == b.key.time && a.key.causal_depth == b.key.causal_depth &&
         a.key.tag_i == b.key.tag_i && a.key.tag_j == b.key.tag_j &&
         a.impact.kind == b.impact.kind && a.impact.inside == b.impact.inside &&
         a.was_inside == b.was_inside && a.elastic == b.elastic &&
         same(a.separation, b.separation) && same(a.impact.impulse, b.impact.impulse) &&
         same(a.impact.spin_impulse, b.impact.spin_impulse);
}

/// Spheres of two sizes, of masses 1 and 2, in a box of six walls.
struct BoxOfSpheres {
  EventSimulation simulation;
  std::vector<Event> all;  // events so far

  explicit BoxOfSpheres(int edge, const ImpactLaw& law, double ratio = 1.2, double space = 1.6) {
    simulation.pairs.set(0, 0, contact(law, ratio));
    const double length = edge * space;
    for (const Wall::Shape shape : {Wall::x_plane, Wall::y_plane, Wall::z_plane}) {
      simulation.walls.push_back({{{shape, 1.0, 0.0}, {}}, {{law, ratio}}});
      simulation.walls.push_back({{{shape, -1.0, length}, {}}, {{law, ratio}}});
    }
    for (int n = 0; n < edge * edge * edge; n++) {
      HardSphere body;
      body.tag = n + 1;
      const double mass = 1.0 + n % 2;
      body.radius = n % 2 ? 0.5 : 0.4;
      body.inverse_mass = 1.0 / mass;
      body.inverse_inertia = 1.0 / (0.4 * mass * body.radius * body.radius);
      simulation.bodies.push_back(body);
      const auto position = [&](int i) { return space * (i + 0.5); };
      VersionedFlight flight;
      flight.position = {position(n % edge), position(n / edge % edge), position(n / edge / edge)};
      flight.velocity = {std::sin(12.3 * n + 1), std::sin(7.7 * n + 2), std::sin(3.1 * n + 3)};
      simulation.flights.push_back(flight);
    }
    simulation.neighbour_lists().bodies_in_box = static_cast<double>(simulation.bodies.size());
    simulation.reset_time(closed_box({}, {length, length, length}));
    simulation.set_up(never, {});
  }

  void step(double dt) {
    simulation.begin_step(dt);
    simulation.run(simulation.end());
    all.insert(all.end(), simulation.events.begin(), simulation.events.end());
  }

  Vector3 position(int body) const { return simulation.flights[body].at(simulation.end()); }
  double kinetic_energy() const { return kinetic_energy_of(simulation); }
};

}  // namespace cohesion::hard_sphere
