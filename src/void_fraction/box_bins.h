// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "void_fraction/cell.h"

namespace cohesion::void_fraction {

/// Boxes, and the search for those that a region meets. The space around them is cut into equal
/// bins of about their mean size, some eight for each box, and every bin knows which boxes reach
/// into it. A region as small as a box so looks at few of them, however many there are, where their
/// sizes are alike: of boxes far below the mean a bin holds as many as fit there.
///
/// A direction in which a box has no end is not cut.
class BoxBins {
 public:
  /// boxes [length]: low <= high in every direction
  explicit BoxBins(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
    if (boxes_.empty()) return;
    cut();
    fill();
  }

  const Box& operator[](std::size_t n) const { return boxes_[n]; }

  /// The numbers of the boxes that have a point in common with `around` [length], borders included,
  /// in ascending order. `found` is emptied first: give the same one again to spare its storage.
  void meeting(const Box& around, std::vector<int>& found) const {
    found.clear();
    if (boxes_.empty()) return;
    // Wider by what fill() has left out of the boxes
    std::array<BinRange, 3> range;
    for (std::size_t d = 0; d < 3; d++) range[d] = axes_[d].bins(around, -axes_[d].slack);
    int looked_at = 0;
    visit(range, [&](std::size_t bin) {
      looked_at++;
      for (std::size_t k = starts_[bin]; k < starts_[bin + 1]; k++)
        if (meet(boxes_[static_cast<std::size_t>(members_[k])], around))
          found.push_back(members_[k]);
    });
    if (looked_at == 1) return;  // A bin has each box once, in ascending order.
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  }

 private:
  struct BinRange {
    std::size_t first, last;
  };

  /// How one direction is cut.
  struct Axis {
    double Vector3::* coordinate = nullptr;
    double low = 0.0, high = 0.0;  ///< of all boxes
    double per_length = 0.0;       ///< bins per length; 0: one for all
    double slack = 0.0;            ///< [length] far below a bin, far above round-off
    std::size_t count = 1;

    std::size_t bin(double at) const {
      if (per_length == 0.0 || !(at > low)) return 0;  // A coordinate that is no number, too
      return at >= high ? count - 1
                        : std::min(count - 1, static_cast<std::size_t>((at - low) * per_length));
    }

    /// The bins of a box that is made smaller by `less` on both sides.
    BinRange bins(const Box& box, double less) const {
      const double from = box.low.*coordinate, to = box.high.*coordinate;
      const double by = std::min(less, 0.5 * (to - from));
      const std::size_t first = bin(from + by);
      return {first, std::max(first, bin(to - by))};
    }
  };

  static bool meet(const Box& a, const Box& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y &&
           b.low.y <= a.high.y && a.low.z <= b.high.z && b.low.z <= a.high.z;
  }

  /// Chooses the bins.
  void cut() {
    constexpr double bins_per_box = 8.0;
    const double boxes = static_cast<double>(boxes_.size());
    std::array<double, 3> bins{1.0, 1.0, 1.0};
    int directions = 0;
    for (std::size_t d = 0; d < 3; d++) {
      Axis& axis = axes_[d];
      axis.coordinate = std::array{&Vector3::x, &Vector3::y, &Vector3::z}[d];
      axis.low = boxes_.front().low.*axis.coordinate;
      axis.high = boxes_.front().high.*axis.coordinate;
      double sides = 0.0;
      for (const Box& box : boxes_) {
        axis.low = std::min(axis.low, box.low.*axis.coordinate);
        axis.high = std::max(axis.high, box.high.*axis.coordinate);
        sides += box.high.*axis.coordinate - box.low.*axis.coordinate;
      }
      if (!std::isfinite(sides) || sides == 0.0) continue;
      directions++;
      bins[d] = std::min(boxes * bins_per_box, (axis.high - axis.low) * boxes / sides);
    }
    // Boxes that fill little of the space around them would need many bins.
    const double all = bins[0] * bins[1] * bins[2];
    const double fewer =
        all > bins_per_box * boxes ? std::pow(bins_per_box * boxes / all, 1.0 / directions) : 1.0;
    for (std::size_t d = 0; d < 3; d++) {
      Axis& axis = axes_[d];
      if (bins[d] == 1.0) continue;
      axis.count = std::max(std::size_t{1}, static_cast<std::size_t>(std::round(bins[d] * fewer)));
      axis.per_length = static_cast<double>(axis.count) / (axis.high - axis.low);
      axis.slack = 1e-6 / axis.per_length;
    }
  }

  /// Calls on_bin(number) for every bin of the ranges.
  template <class OnBin>
  void visit(const std::array<BinRange, 3>& range, OnBin on_bin) const {
    for (std::size_t x = range[0].first; x <= range[0].last; x++)
      for (std::size_t y = range[1].first; y <= range[1].last; y++)
        for (std::size_t z = range[2].first; z <= range[2].last; z++)
          on_bin((x * axes_[1].count + y) * axes_[2].count + z);
  }

  /// Calls on_bin(number) for every bin of the box. Its borders are left out: those of a regular
  /// grid lie on those of the bins, to round-off, and its boxes would be in 27 bins each.
  template <class OnBin>
  void visit(const Box& box, OnBin on_bin) const {
    std::array<BinRange, 3> range;
    for (std::size_t d = 0; d < 3; d++) range[d] = axes_[d].bins(box, axes_[d].slack);
    visit(range, on_bin);
  }

  void fill() {
    starts_.assign(axes_[0].count * axes_[1].count * axes_[2].count + 1, 0);
    for (const Box& box : boxes_) visit(box, [&](std::size_t bin) { starts_[bin + 1]++; });
    for (std::size_t bin = 1; bin < starts_.size(); bin++) starts_[bin] += starts_[bin - 1];
    members_.resize(starts_.back());
    std::vector<std::size_t> next(starts_);
    for (std::size_t n = 0; n < boxes_.size(); n++)
      visit(boxes_[n], [&](std::size_t bin) { members_[next[bin]++] = static_cast<int>(n); });
  }

  std::vector<Box> boxes_;
  std::array<Axis, 3> axes_;
  std::vector<std::size_t> starts_;  ///< of each bin in members_, and the end of the last
  std::vector<int> members_;
};

}  // namespace cohesion::void_fraction
