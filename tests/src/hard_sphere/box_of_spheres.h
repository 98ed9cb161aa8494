// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "hard_sphere/event_simulation.h"

/// Spheres of two sizes in a box of six walls, without any engine: every pair and every wall is a
/// candidate. Of mass 1 and 2.
struct BoxOfSpheres {
  using EventSimulation = cohesion::hard_sphere::EventSimulation;
  using Vector3 = cohesion::Vector3;

  EventSimulation simulation;
  std::vector<cohesion::hard_sphere::Event> all;  // so far

  explicit BoxOfSpheres(int edge, const cohesion::hard_sphere::Law& law, double ratio = 1.2,
                        double space = 1.6) {
    using namespace cohesion::hard_sphere;
    simulation.laws = {law};
    const double length = edge * space;
    for (const Wall::Shape shape : {Wall::x_plane, Wall::y_plane, Wall::z_plane}) {
      simulation.walls.push_back({{shape, 1.0, 0.0}, {}, 0.0});
      simulation.walls.push_back({{shape, -1.0, length}, {}, 0.0});
    }
    for (int n = 0; n < edge * edge * edge; n++) {
      Body body;
      body.tag = n + 1;
      const double mass = 1.0 + n % 2;
      body.radius = n % 2 ? 0.5 : 0.4;
      body.inverse_mass = 1.0 / mass;
      body.inverse_inertia = 1.0 / (0.4 * mass * body.radius * body.radius);
      const auto place = [&](int i) { return space * (i + 0.5); };
      body.flight.end = {place(n % edge), place(n / edge % edge), place(n / edge / edge)};
      body.flight.velocity = {std::sin(12.3 * n + 1), std::sin(7.7 * n + 2), std::sin(3.1 * n + 3)};
      simulation.bodies.push_back(body);
    }
    const auto edge_of = [&](double core) { return law.depth > 0.0 ? ratio * core : core; };
    for (int i = 0; i < static_cast<int>(simulation.bodies.size()); i++) {
      for (int j = i + 1; j < static_cast<int>(simulation.bodies.size()); j++) {
        const double core = simulation.bodies[i].radius + simulation.bodies[j].radius;
        simulation.candidates.push_back({i, j, 0, 0, {core, edge_of(core)}});
      }
      const double core = simulation.bodies[i].radius;
      for (int w = 0; w < 6; w++)
        simulation.candidates.push_back({i, -1 - w, 0, 0, {core, edge_of(core)}});
    }
    simulation.index_candidates();
  }

  /// Straight flight, as an engine would do it.
  void fly(double dt) {
    for (auto& body : simulation.bodies) {
      auto& flight = body.flight;
      flight = {flight.end + dt * flight.velocity, flight.velocity, 0.0, flight.spin};
    }
  }

  void begin(double dt) {
    fly(dt);
    simulation.begin_step(dt);
    for (int n = 0; n < static_cast<int>(simulation.candidates.size()); n++) simulation.predict(n);
    simulation.order_queue();
  }

  void step(double dt) {
    begin(dt);
    simulation.run(dt);
    all.insert(all.end(), simulation.events.begin(), simulation.events.end());
  }

  double kinetic_energy() const {
    double sum = 0.0;
    for (const auto& body : simulation.bodies) {
      const auto& f = body.flight;
      sum += 0.5 * dot(f.velocity, f.velocity) / body.inverse_mass +
             0.5 * dot(f.spin, f.spin) / body.inverse_inertia;
    }
    return sum;
  }

  double farthest_from(const BoxOfSpheres& other) const {
    double farthest = 0.0;
    for (std::size_t n = 0; n < simulation.bodies.size(); n++)
      farthest = std::max(
          farthest, norm(simulation.bodies[n].flight.end - other.simulation.bodies[n].flight.end));
    return farthest;
  }
};
