// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <variant>

#include "hamaker/forms.h"
#include "sphere.h"

namespace cohesion::hamaker {

/// The attraction of one pair beyond H_cut, as a pair that leaves it under a load sees it. None at
/// all: an edge without width, through which no load helps.
class Tail {
 public:
  Tail() = default;
  Tail(const AnyLaw& law, const PairGeometry& geometry) : law_(law), geometry_(geometry) {}

  /// HamakerLaw::barrier() of the pair, [energy]; infinite for an edge without width.
  double barrier(double load, double gap) const {
    if (!law_) return std::numeric_limits<double>::infinity();
    return std::visit([&](const auto& law) { return law.barrier(load, gap, geometry_); }, *law_);
  }
  /// The work of the attraction from H_cut to a gap, [energy]; likewise.
  double work_up_to(double gap) const {
    if (!law_) return std::numeric_limits<double>::infinity();
    return std::visit(
        [&](const auto& law) { return law.energy(gap, geometry_) + law.tail_energy(geometry_); },
        *law_);
  }
  /// H_out, [length]; 0 for an edge without width.
  double outer_cutoff() const {
    if (!law_) return 0.0;
    return std::visit([](const auto& law) { return law.outer_cutoff(); }, *law_);
  }
  /// Whether a gap is within the outer cut-off, but for rounding.
  bool contains(double gap) const {
    constexpr double rounding = 1e-12;
    return gap <= (1.0 + rounding) * outer_cutoff();
  }

 private:
  std::optional<AnyLaw> law_;
  PairGeometry geometry_{};
};

}  // namespace cohesion::hamaker
