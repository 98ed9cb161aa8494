// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lattice_boltzmann/collision.h"
#include "lattice_boltzmann/d3q19.h"
#include "lattice_boltzmann/walls.h"

namespace cohesion::lattice_boltzmann {

/// Populations after collisions, one array for each velocity, that are streamed in place: a node
/// writes where it has read and nowhere else, so that nodes may go in any order and on any thread
/// (the two-state scheme of P. Bailey, J. Myre, S. Walsh, D. Lilja, M. Saar, ICPP 2009). Between
/// steps they are
///
///   at home:   f_q(x) at (q, x),             or
///   ahead:     f_q(x) at (-q, x + c_q), where the next collision wants it.
///
/// They are deviations from those of the fluid at rest.
class Populations {
 public:
  explicit Populations(const Grid& grid) : grid_(grid) {
    // Arrays a multiple of a page apart would share the same few lines of a cache.
    const std::size_t page = 4096 / sizeof(double), lines = 192 / sizeof(double);
    stride_ = (grid.size() + page - 1) / page * page + lines;
    values_.assign(stride_ * directions, 0.0);
  }

  /// f_q(node) after its last collision; nodes of the box.
  double operator()(int q, std::size_t node) const {
    return ahead_ ? at(opposite(q), node + grid_.offset(q)) : at(q, node);
  }

  /// In place of f_q(node).
  void set(int q, std::size_t node, double value) {
    if (ahead_)
      values_[opposite(q) * stride_ + node + grid_.offset(q)] = value;
    else
      values_[q * stride_ + node] = value;
  }

  /// Where collisions read and write.
  PopulationPointers row() {
    PopulationPointers row;
    for (int q = 0; q < directions; q++) {
      double* streamed = array(q) - grid_.offset(q);
      double* home = array(opposite(q));
      row.in[q] = ahead_ ? home : streamed;
      row.out[opposite(q)] = ahead_ ? home : streamed;
    }
    return row;
  }

  /// By the node x of a link along velocity q: f_q(x), f_q(x - c_q) and f_-q(x), and where what
  /// comes back from the wall goes for the next collision to read it. The second has no meaning
  /// where the link is halved.
  struct AlongLinks {
    const double *gone, *behind, *back;
    double* came;
  };
  AlongLinks along(int q) {
    const std::ptrdiff_t c = grid_.offset(q);
    double *to = array(q), *fro = array(opposite(q));
    if (ahead_) return {fro + c, fro, to - c, to};
    return {to, to - c, fro, fro + c};
  }

  /// Makes the box periodic for velocity q: what the next collision reads, or what the last one
  /// wrote, in the layer of images.
  void wrap(int q) {
    // To and from: the layer on the side where f_q leaves the box, and the nodes that it stands
    // for. At home an image of what comes in on the other side is made; ahead, what went out, in
    // the array of the opposite velocity, is brought in.
    const auto& c = velocity[q];
    double* f = array(ahead_ ? opposite(q) : q);
    for (int step = 0; step < 3; step++) {
      const int k = ahead_ ? 2 - step : step;
      if (c[k] == 0) continue;
      std::array<int, 3> low, high, from{}, to{};
      for (int d = 0; d < 3; d++) {
        // Those that are done already count with their images where they are made, and without
        // them where they are brought in.
        low[d] = (d < k) ? std::min(0, ahead_ ? c[d] : -c[d]) : 0;
        high[d] = grid_.nodes(d) + ((d < k) ? std::max(0, ahead_ ? c[d] : -c[d]) : 0);
      }
      const int n = grid_.nodes(k), outside = c[k] > 0 ? n : -1, inside = c[k] > 0 ? 0 : n - 1;
      from[k] = ahead_ ? outside : n - 1 - inside;
      to[k] = ahead_ ? inside : n - 1 - outside;
      low[k] = 0;
      high[k] = 1;
      for (int z = low[2]; z < high[2]; z++)
        for (int y = low[1]; y < high[1]; y++) {
          const std::size_t start = grid_.index(low[0] + from[0], y + from[1], z + from[2]);
          std::copy_n(f + start, high[0] - low[0],
                      f + grid_.index(low[0] + to[0], y + to[1], z + to[2]));
        }
    }
  }

  /// After a step's collisions.
  void turn() { ahead_ = !ahead_; }
  bool ahead() const { return ahead_; }

 private:
  double* array(int q) { return values_.data() + q * stride_; }
  double at(int q, std::size_t node) const { return values_[q * stride_ + node]; }

  Grid grid_;
  std::size_t stride_;
  std::vector<double> values_;
  bool ahead_ = false;
};

}  // namespace cohesion::lattice_boltzmann
