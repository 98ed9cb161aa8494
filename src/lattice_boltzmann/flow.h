// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "lattice_boltzmann/collision.h"
#include "lattice_boltzmann/d3q19.h"
#include "lattice_boltzmann/populations.h"
#include "lattice_boltzmann/relaxation.h"
#include "lattice_boltzmann/walls.h"

namespace cohesion::lattice_boltzmann {

/// Does part(0) to part(count - 1), in any order and on any threads, and returns when all are done.
using Shared = std::function<void(int count, const std::function<void(int)>& part)>;

inline void one_by_one(int count, const std::function<void(int)>& part) {
  for (int i = 0; i < count; i++) part(i);
}

/// An incompressible fluid of density 1 that a body force drives through fixed spheres in a
/// periodic box; lattice units: spacing, step, density 1.
///
/// Collisions are those of collision.h. Walls are where the spheres are, by the interpolation of
/// two populations along a link, "CLI" of I. Ginzburg, F. Verhaeghe, D. d'Humieres, Commun. Comput.
/// Phys. 3 (2008) 427,
///
///   f_-q(x, t + 1) = f~_q(x) + k (f~_q(x - c_q) - f~_-q(x)),     k = (1 - 2 delta)/(1 + 2 delta),
///
/// delta being the distance to the wall; where x - c_q is in a sphere k = 0. What comes back is the
/// mean of this and of what came back the step before: nothing else where the flow is steady, and
/// without it coarse flows with inertia drift away, since the interpolation, whose weights are not
/// all positive, feeds what goes to and fro from step to step. The force on a sphere is the
/// momentum that its links turn round (A. J. C. Ladd, J. Fluid Mech. 271 (1994) 285).
///
/// What is computed does not depend on how the work is shared, to the last bit.
class Flow {
 public:
  Flow(const Grid& grid, const Walls& walls, const Relaxation& relaxation,
       Shared shared = one_by_one)
      : grid_(grid),
        walls_(&walls),
        relaxation_(relaxation),
        shared_(std::move(shared)),
        populations_(grid),
        forces_(walls.spheres(), Vector{}),
        layers_(grid.nodes(2), Vector{}) {
    for (int sphere = 0; sphere < walls.spheres(); sphere++)
      for (int q = 0; q < directions; q++)
        came_before_.emplace_back(walls.links(sphere, q).size(), 0.0);
  }

  /// Per mass of fluid, [spacing/step^2].
  void set_body_force(const Vector& force) { body_force_ = force; }

  void step() {
    shared_(directions, [this](int q) { populations_.wrap(q); });
    shared_(walls_->spheres(), [this](int sphere) { forces_[sphere] = reflect(sphere); });
    const PopulationPointers row = populations_.row();
    shared_(grid_.nodes(2),
            [&](int z) { collide(row, walls_->runs(z), relaxation_, body_force_); });
    populations_.turn();
  }

  /// Mean over the box, spheres at rest counted: superficial, [spacing/step]. Between steps.
  Vector superficial_velocity() {
    shared_(grid_.nodes(2), [this](int z) {
      layers_[z] = Vector{};
      for (const Run& run : walls_->runs(z))
        for (int i = 0; i < run.nodes; i++) {
          const Vector u = velocity_at(run.first + i);
          for (int k = 0; k < 3; k++) layers_[z][k] += u[k];
        }
    });
    Vector sum{};
    for (const Vector& layer : layers_)
      for (int k = 0; k < 3; k++) sum[k] += layer[k];
    for (double& s : sum) s /= grid_.volume();
    return sum;
  }

  /// Of a node in the fluid, half the force before and half after it taken: in the middle of a
  /// collision.
  Vector velocity_at(std::size_t node) const {
    Vector u{};
    for (int q = 1; q < directions; q++) {
      const double f = populations_(q, node);
      for (int k = 0; k < 3; k++) u[k] += f * velocity[q][k];
    }
    // Collisions have added the whole force to what is kept.
    for (int k = 0; k < 3; k++) u[k] -= 0.5 * body_force_[k];
    return u;
  }

  /// On each sphere in the last step, by its surface: without the mean pressure gradient that the
  /// body force stands for, which adds its volume times that.
  const std::vector<Vector>& forces() const { return forces_; }

 private:
  /// Turns round what has come to a sphere; the force on it.
  Vector reflect(int sphere) {
    Vector force{};
    for (int q = 1; q < directions; q++) {
      const Populations::AlongLinks f = populations_.along(q);
      double turned = 0.0;
      double* before = came_before_[sphere * directions + q].data();
      for (const Link& link : walls_->links(sphere, q)) {
        const double gone = f.gone[link.node];
        double came = gone;
        if (!link.halved()) {
          const double k = (1.0 - 2.0 * link.distance) / (1.0 + 2.0 * link.distance);
          came += k * (f.behind[link.node] - f.back[link.node]);
        }
        came = 0.5 * (came + *before);
        *before++ = came;
        f.came[link.node] = came;
        turned += gone + came;
      }
      for (int d = 0; d < 3; d++) force[d] += velocity[q][d] * turned;
    }
    return force;
  }

  Grid grid_;
  const Walls* walls_;
  Relaxation relaxation_;
  Shared shared_;
  Vector body_force_{};
  Populations populations_;
  std::vector<std::vector<double>> came_before_;  // by each link, in the last step
  std::vector<Vector> forces_;
  std::vector<Vector> layers_;  // sums over them
};

}  // namespace cohesion::lattice_boltzmann
