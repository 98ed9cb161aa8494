// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector3.h"

namespace cohesion::void_fraction {

/// Box along the axes, [length]; sides may lie at infinity.
struct Box {
  Vector3 low;
  Vector3 high;
};

struct Sphere {
  Vector3 centre;  ///< [length]
  double radius;   ///< [length] > 0
};

/// A cell of a mesh as a kernel sees it. A direction that a mesh does not resolve has no end: the
/// box reaches to infinity there, and the coordinate of a point does not matter.
class Cell {
 public:
  virtual ~Cell() = default;

  /// The cell, if it is a box along the axes, else none.
  virtual const Box* box() const = 0;

  /// Whether the point [length] is in the cell; points of its faces are.
  virtual bool contains(const Vector3& point) const = 0;
};

}  // namespace cohesion::void_fraction
