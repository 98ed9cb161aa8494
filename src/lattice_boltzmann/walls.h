// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lattice_boltzmann/d3q19.h"
#include "validation.h"

/// Fixed spheres in a periodic box of lattice nodes, and the links that they cut. Lengths in
/// spacings.
namespace cohesion::lattice_boltzmann {

struct FixedSphere {
  std::array<double, 3> centre;
  double radius;
};

/// Nodes of a box with a layer of images around it.
class Grid {
 public:
  /// Throws InvalidParameter unless there are at least four nodes along each edge.
  explicit Grid(const std::array<int, 3>& nodes) : nodes_(nodes) {
    for (const int n : nodes) require(n >= 4, "nodes along an edge", n, "must be 4 or more");
  }

  int nodes(int k) const { return nodes_[k]; }
  /// Of the box, without images.
  double volume() const { return static_cast<double>(nodes_[0]) * nodes_[1] * nodes_[2]; }
  std::size_t size() const { return index(0, 0, nodes_[2] + 1); }

  /// From 0 to nodes - 1 in the box; -1 and nodes are images.
  std::size_t index(int x, int y, int z) const {
    const std::size_t row = static_cast<std::size_t>(z + 1) * (nodes_[1] + 2) + (y + 1);
    return row * (nodes_[0] + 2) + (x + 1);
  }
  std::ptrdiff_t offset(int q) const {
    const auto& c = velocity[q];
    const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(c[2]) * (nodes_[1] + 2) + c[1];
    return row * (nodes_[0] + 2) + c[0];
  }

 private:
  std::array<int, 3> nodes_;
};

/// A link from a node in the fluid into a sphere.
struct Link {
  std::size_t node;  ///< in the fluid, no image
  double distance;   ///< from the node to the wall, over the link's length; 1/2 where the node
                     ///< behind is in no fluid, for whoever interpolates

  bool halved() const { return distance == 0.5; }
};

/// Nodes of the fluid side by side along x.
struct Run {
  std::size_t first;
  int nodes;
};

/// Which nodes are fluid, and all links that a sphere cuts.
class Walls {
 public:
  /// Throws InvalidParameter unless radii are positive and spheres smaller than the box.
  Walls(const Grid& grid, const std::vector<FixedSphere>& spheres)
      : grid_(grid), spheres_(spheres), owner_(grid.size(), fluid) {
    for (std::size_t s = 0; s < spheres.size(); s++) {
      require_positive("radius of a sphere", spheres[s].radius);
      for (int k = 0; k < 3; k++)
        require(2.0 * spheres[s].radius <= grid.nodes(k), "diameter of a sphere",
                2.0 * spheres[s].radius, "must not be larger than the box");
      fill(static_cast<int>(s));
    }
    copy_images();
    find_runs();
    find_links();
  }

  bool is_fluid(std::size_t node) const { return owner_[node] == fluid; }
  int spheres() const { return static_cast<int>(spheres_.size()); }
  /// Those along velocity q into a sphere.
  const std::vector<Link>& links(int sphere, int q) const {
    return links_[sphere * directions + q];
  }
  /// Of a layer of the box, 0 to nodes(2) - 1.
  const std::vector<Run>& runs(int z) const { return runs_[z]; }
  /// Nodes of the box in fluid.
  std::size_t fluid_nodes() const { return fluid_nodes_; }

 private:
  static constexpr std::int32_t fluid = -1;

  static int wrapped(int i, int n) { return (i % n + n) % n; }

  /// From a sphere's centre to a node, by the nearest image.
  double from_centre(const FixedSphere& s, int k, int i) const {
    const double n = grid_.nodes(k), d = i - s.centre[k];
    return d - n * std::round(d / n);
  }

  void fill(int number) {
    const FixedSphere& s = spheres_[number];
    std::array<int, 3> low, high;
    for (int k = 0; k < 3; k++) {
      low[k] = static_cast<int>(std::ceil(s.centre[k] - s.radius));
      high[k] = static_cast<int>(std::floor(s.centre[k] + s.radius));
    }
    for (int z = low[2]; z <= high[2]; z++)
      for (int y = low[1]; y <= high[1]; y++)
        for (int x = low[0]; x <= high[0]; x++) {
          const double dx = x - s.centre[0], dy = y - s.centre[1], dz = z - s.centre[2];
          if (dx * dx + dy * dy + dz * dz < s.radius * s.radius)
            owner_[grid_.index(wrapped(x, grid_.nodes(0)), wrapped(y, grid_.nodes(1)),
                               wrapped(z, grid_.nodes(2)))] = number;
        }
  }

  void copy_images() {
    for (int z = -1; z <= grid_.nodes(2); z++)
      for (int y = -1; y <= grid_.nodes(1); y++)
        for (int x = -1; x <= grid_.nodes(0); x++)
          owner_[grid_.index(x, y, z)] = owner_[grid_.index(
              wrapped(x, grid_.nodes(0)), wrapped(y, grid_.nodes(1)), wrapped(z, grid_.nodes(2)))];
  }

  void find_runs() {
    runs_.resize(grid_.nodes(2));
    for (int z = 0; z < grid_.nodes(2); z++)
      for (int y = 0; y < grid_.nodes(1); y++)
        for (int x = 0; x < grid_.nodes(0); x++) {
          const std::size_t node = grid_.index(x, y, z);
          if (!is_fluid(node)) continue;
          fluid_nodes_++;
          if (x > 0 && is_fluid(node - 1))
            runs_[z].back().nodes++;
          else
            runs_[z].push_back({node, 1});
        }
  }

  void find_links() {
    links_.resize(spheres_.size() * directions);
    for (int z = 0; z < grid_.nodes(2); z++)
      for (int y = 0; y < grid_.nodes(1); y++)
        for (int x = 0; x < grid_.nodes(0); x++) {
          const std::size_t node = grid_.index(x, y, z);
          if (!is_fluid(node)) continue;
          for (int q = 1; q < directions; q++) {
            const std::int32_t hit = owner_[node + grid_.offset(q)];
            if (hit == fluid) continue;
            const bool room = is_fluid(node - grid_.offset(q));
            links_[hit * directions + q].push_back(
                {node, room ? distance(spheres_[hit], q, {x, y, z}) : 0.5});
          }
        }
  }

  /// To where a link from a node outside enters the sphere, over the link's length.
  double distance(const FixedSphere& s, int q, const std::array<int, 3>& node) const {
    double cc = 0.0, rc = 0.0, rr = 0.0;
    for (int k = 0; k < 3; k++) {
      const double r = from_centre(s, k, node[k]), c = velocity[q][k];
      cc += c * c;
      rc += r * c;
      rr += r * r;
    }
    const double root = std::sqrt(std::max(0.0, rc * rc - cc * (rr - s.radius * s.radius)));
    return std::min(1.0, std::max(0.0, (-rc - root) / cc));
  }

  Grid grid_;
  std::vector<FixedSphere> spheres_;
  std::vector<std::int32_t> owner_;       // sphere that a node is in
  std::vector<std::vector<Link>> links_;  // of each sphere and velocity
  std::vector<std::vector<Run>> runs_;    // of each layer
  std::size_t fluid_nodes_ = 0;
};

}  // namespace cohesion::lattice_boltzmann
