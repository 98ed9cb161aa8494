// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact_solver/wall.h"
#include "hard_sphere/crossing.h"

namespace cohesion::hard_sphere {

using contact_solver::Wall;
using contact_solver::WallState;

/// A wall in uniform motion.
struct MovingWall {
  Wall wall;
  WallState state;         ///< velocity, and displacement at the time `when`
  double rim_speed = 0.0;  ///< surface speed of a rotating cylinder, [length/time]
  double when = 0.0;       ///< [time]

  WallState at(double time) const {
    return {state.displacement + (time - when) * state.velocity, state.velocity};
  }
};

/// The next surface that a centre at the height h above a plane reaches; u = dh/dt.
inline Crossing next_crossing_of_plane(double h, double u, const SurfaceDistances& surfaces,
                                       bool inside) {
  if (u == 0.0 || (u > 0.0 && !inside)) return {};
  if (u > 0.0) return {h >= surfaces.edge ? 0.0 : (surfaces.edge - h) / u, Surface::edge_outward};
  const bool core = inside || !surfaces.has_well();
  const double surface = core ? surfaces.core : surfaces.edge;
  return {h <= surface ? 0.0 : (surface - h) / u, core ? Surface::core : Surface::edge_inward};
}

/// The same inside a cylinder of radius R; r and w are the components across the axis. The particle
/// leaves the well of the wall where its distance from the axis decreases to R - edge.
inline Crossing next_crossing_of_cylinder(const Vector3& r, const Vector3& w, double radius,
                                          const SurfaceDistances& surfaces, bool inside) {
  const double b = dot(r, w), ww = dot(w, w), rr = dot(r, r);
  const auto c = [&](double gap) { return rr - (radius - gap) * (radius - gap); };
  if (!inside && surfaces.has_well())
    return {time_to_rise(b, ww, c(surfaces.edge)), Surface::edge_inward};
  const double leave = inside ? time_to_fall(b, ww, c(surfaces.edge)) : never;
  if (leave < never) return {leave, Surface::edge_outward};
  // A concave wall meets a particle that moves along it.
  if (b == 0.0 && ww > 0.0 && c(surfaces.core) >= 0.0) return {0.0, Surface::core};
  return {time_to_rise(b, ww, c(surfaces.core)), Surface::core};
}

/// The next surface of a wall that a centre reaches which has the position x at the time `when` and
/// the velocity v.
inline Crossing next_crossing(const MovingWall& wall, const Vector3& x, const Vector3& v,
                              double when, const SurfaceDistances& surfaces, bool inside) {
  if (wall.wall.shape == Wall::z_cylinder)
    return next_crossing_of_cylinder({x.x, x.y, 0.0}, {v.x, v.y, 0.0}, wall.wall.position, surfaces,
                                     inside);
  const WallState now = wall.at(when);
  const double h = wall.wall.nearest(x, now, 0.0).distance;
  const double u = dot(wall.wall.normal(), v - now.velocity);
  return next_crossing_of_plane(h, u, surfaces, inside);
}

}  // namespace cohesion::hard_sphere
