// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "void_fraction/cell.h"

namespace cohesion::void_fraction {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// A box as a cell.
class BoxCell : public Cell {
 public:
  explicit BoxCell(const Box& box) : box_(box) {}

  const Box* box() const override { return &box_; }

  bool contains(const Vector3& p) const override {
    return p.x >= box_.low.x && p.x <= box_.high.x && p.y >= box_.low.y && p.y <= box_.high.y &&
           p.z >= box_.low.z && p.z <= box_.high.z;
  }

 private:
  Box box_;
};

}  // namespace cohesion::void_fraction
