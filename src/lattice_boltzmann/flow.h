// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lattice_boltzmann/d3q19.h"
#include "lattice_boltzmann/relaxation.h"
#include "lattice_boltzmann/walls.h"

namespace cohesion::lattice_boltzmann {

using Vector = std::array<double, 3>;

/// An incompressible fluid of density 1 that a body force drives through fixed spheres in a
/// periodic box; lattice units: spacing, step, density 1.
///
/// Populations relax to the equilibrium of incompressible flow (X. He, L.-S. Luo, J. Stat. Phys. 88
/// (1997) 927) with two relaxation times (relaxation.h), and a force of second order (Z. Guo, C.
/// Zheng, B. Shi, Phys. Rev. E 65 (2002) 046308). Walls are where the spheres are, by the
/// interpolation of two populations along a link, "CLI" of Ginzburg, Verhaeghe, d'Humieres (2008),
///
///   f_-q(x, t + 1) = f~_q(x) + k (f~_q(x - c_q) - f~_-q(x)),     k = (1 - 2 delta)/(1 + 2 delta),
///
/// delta being the distance to the wall; where x - c_q is in a sphere k = 0. The force on a sphere
/// is the momentum that its links turn round (A. J. C. Ladd, J. Fluid Mech. 271 (1994) 285).
class Flow {
 public:
  Flow(const Grid& grid, const Walls& walls, const Relaxation& relaxation, int spheres)
      : grid_(grid), walls_(&walls), relaxation_(relaxation), forces_(spheres, Vector{}) {
    for (int q = 0; q < directions; q++) {
      now_[q].assign(grid.size(), weight(q));
      next_[q].assign(grid.size(), weight(q));
    }
    open_.assign(grid.size(), 0.0);
    for (std::size_t node = 0; node < grid.size(); node++) open_[node] = walls.is_fluid(node);
  }

  /// Per mass of fluid, [spacing/step^2].
  void set_body_force(const Vector& force) { body_force_ = force; }

  void step() {
    copy_images();
    reflect();
    for (int z = 0; z < grid_.nodes(2); z++)
      for (int y = 0; y < grid_.nodes(1); y++) stream_and_collide(grid_.index(0, y, z));
    std::swap(now_, next_);
  }

  /// Mean over the box, spheres at rest counted: superficial, [spacing/step]. Between steps.
  Vector superficial_velocity() const {
    Vector sum{};
    for (int z = 0; z < grid_.nodes(2); z++)
      for (int y = 0; y < grid_.nodes(1); y++)
        for (int x = 0; x < grid_.nodes(0); x++) {
          const std::size_t node = grid_.index(x, y, z);
          if (!walls_->is_fluid(node)) continue;
          const Vector u = velocity_at(node);
          for (int k = 0; k < 3; k++) sum[k] += u[k];
        }
    for (double& s : sum) s /= grid_.volume();
    return sum;
  }

  /// Of a node in the fluid, half the force before and half after it taken: in the middle of a
  /// collision.
  Vector velocity_at(std::size_t node) const {
    Vector u{};
    for (int q = 1; q < directions; q++)
      for (int k = 0; k < 3; k++) u[k] += now_[q][node] * velocity[q][k];
    // Collisions have added the whole force to what is kept.
    for (int k = 0; k < 3; k++) u[k] -= 0.5 * body_force_[k];
    return u;
  }

  /// On each sphere in the last step, by its surface: without the mean pressure gradient that the
  /// body force stands for, which adds its volume times that.
  const std::vector<Vector>& forces() const { return forces_; }

 private:
  using Populations = std::array<std::vector<double>, directions>;

  /// Of the layer around the box.
  void copy_images() {
    const int nx = grid_.nodes(0), ny = grid_.nodes(1), nz = grid_.nodes(2);
    for (std::vector<double>& f : now_) {
      for (int z = 0; z < nz; z++)
        for (int y = 0; y < ny; y++) {
          const std::size_t row = grid_.index(0, y, z);
          f[row - 1] = f[row + nx - 1];
          f[row + nx] = f[row];
        }
      const auto copy = [&](std::size_t to, std::size_t from, std::size_t count) {
        std::copy_n(f.begin() + from, count, f.begin() + to);
      };
      const std::size_t row = nx + 2;
      for (int z = 0; z < nz; z++) {
        copy(grid_.index(-1, -1, z), grid_.index(-1, ny - 1, z), row);
        copy(grid_.index(-1, ny, z), grid_.index(-1, 0, z), row);
      }
      const std::size_t layer = row * (ny + 2);
      copy(grid_.index(-1, -1, -1), grid_.index(-1, -1, nz - 1), layer);
      copy(grid_.index(-1, -1, nz), grid_.index(-1, -1, 0), layer);
    }
  }

  /// What comes back from walls is put where the stream will fetch it: in the node in the sphere.
  void reflect() {
    std::fill(forces_.begin(), forces_.end(), Vector{});
    for (const Link& link : walls_->links()) {
      const std::ptrdiff_t along = grid_.offset(link.q);
      const std::vector<double>& out = now_[link.q];
      std::vector<double>& back = now_[opposite(link.q)];
      const double k = (1.0 - 2.0 * link.distance) / (1.0 + 2.0 * link.distance);
      const double gone = out[link.node];
      const double came = gone + k * (out[link.node - along] - back[link.node]);
      back[link.node + along] = came;
      for (int d = 0; d < 3; d++) forces_[link.sphere][d] += velocity[link.q][d] * (gone + came);
    }
  }

  void stream_and_collide(std::size_t row) {
    std::array<const double*, directions> in;
    std::array<double*, directions> out;
    for (int q = 0; q < directions; q++) {
      in[q] = now_[q].data() + (row - grid_.offset(q));
      out[q] = next_[q].data() + row;
    }
    const double* open = open_.data() + row;
    const double even = relaxation_.even(), odd = relaxation_.odd();
    const double gx = body_force_[0], gy = body_force_[1], gz = body_force_[2];
#pragma GCC ivdep
    for (int x = 0; x < grid_.nodes(0); x++) {
      double f[directions], density = 0.0, ux = 0.5 * gx, uy = 0.5 * gy, uz = 0.5 * gz;
      for (int q = 0; q < directions; q++) {
        f[q] = in[q][x];
        density += f[q];
        ux += f[q] * velocity[q][0];
        uy += f[q] * velocity[q][1];
        uz += f[q] * velocity[q][2];
      }
      const double uu = ux * ux + uy * uy + uz * uz, ug = ux * gx + uy * gy + uz * gz;
      const double m = open[x];
      const double rest = f[0] + even * (weight(0) * (density - 1.5 * uu) - f[0]) -
                          (1.0 - 0.5 * even) * weight(0) * 3.0 * ug;
      out[0][x] = weight(0) + m * (rest - weight(0));
      for (int q = 1; q < directions; q += 2) {
        const double w = weight(q);
        const double cu = velocity[q][0] * ux + velocity[q][1] * uy + velocity[q][2] * uz;
        const double cg = velocity[q][0] * gx + velocity[q][1] * gy + velocity[q][2] * gz;
        const double sum = 0.5 * (f[q] + f[q + 1]), difference = 0.5 * (f[q] - f[q + 1]);
        const double s = sum + even * (w * (density + 4.5 * cu * cu - 1.5 * uu) - sum) +
                         (1.0 - 0.5 * even) * w * (9.0 * cu * cg - 3.0 * ug);
        const double d =
            difference + odd * (w * 3.0 * cu - difference) + (1.0 - 0.5 * odd) * w * 3.0 * cg;
        out[q][x] = w + m * (s + d - w);
        out[q + 1][x] = w + m * (s - d - w);
      }
    }
  }

  Grid grid_;
  const Walls* walls_;
  Relaxation relaxation_;
  Vector body_force_{};
  Populations now_, next_;    // after collisions
  std::vector<double> open_;  // 1 in the fluid, 0 in spheres
  std::vector<Vector> forces_;
};

}  // namespace cohesion::lattice_boltzmann
