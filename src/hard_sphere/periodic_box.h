// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "vector3.h"

namespace cohesion::hard_sphere {

/// A box with three edge vectors, (xx, 0, 0), (xy, yy, 0), (xz, yz, zz), that change uniformly in
/// time.
struct PeriodicBox {
  /// The six components [length], or their rates [length/time].
  struct Edges {
    double xx = 0.0, yy = 0.0, zz = 0.0, yz = 0.0, xz = 0.0, xy = 0.0;

    Vector3 operator*(const Vector3& a) const {
      return {xx * a.x + xy * a.y + xz * a.z, yy * a.y + yz * a.z, zz * a.z};
    }
    bool is_zero() const {
      return xx == 0.0 && yy == 0.0 && zz == 0.0 && yz == 0.0 && xz == 0.0 && xy == 0.0;
    }
  };

  Vector3 origin;  ///< [length]
  Edges edges;     ///< at time 0, [length]
  Edges rates;     ///< [length/time]
  std::array<bool, 3> periodic{};

  Edges edges_at(double time) const {
    const Edges &a = edges, &r = rates;
    return {a.xx + time * r.xx, a.yy + time * r.yy, a.zz + time * r.zz,
            a.yz + time * r.yz, a.xz + time * r.xz, a.xy + time * r.xy};
  }

  /// Fractional coordinates of x relative to the origin of the box.
  static Vector3 fraction(const Edges& h, const Vector3& x) {
    const double z = x.z / h.zz, y = (x.y - z * h.yz) / h.yy;
    return {(x.x - y * h.xy - z * h.xz) / h.xx, y, z};
  }

  /// Inverse of the three widths of the box between opposite faces, [1/length]: the largest change
  /// of each fractional coordinate per length.
  static std::array<double, 3> inverse_widths(const Edges& h) {
    const double x = 1.0 / h.xx, y = 1.0 / h.yy, z = 1.0 / h.zz;
    const double xy = -h.xy * x * y, yz = -h.yz * y * z;
    const double xz = (h.xy * h.yz * y - h.xz) * x * z;
    return {std::sqrt(x * x + xy * xy + xz * xz), std::sqrt(y * y + yz * yz), z};
  }

  /// Velocity gradient of the flow in the position at time 0, [1/time].
  Edges gradient() const {
    const Edges &h = edges, &r = rates;
    const double xx = r.xx / h.xx, yy = r.yy / h.yy, zz = r.zz / h.zz;
    const double xy = (r.xy - xx * h.xy) / h.yy, yz = (r.yz - yy * h.yz) / h.zz;
    return {xx, yy, zz, yz, (r.xz - xx * h.xz - xy * h.yz) / h.zz, xy};
  }

  /// Upper bound of the relative velocity of two points over their distance, [1/time].
  double strain_rate() const {
    const Edges& r = rates;
    const double xx = r.xx / edges.xx, yy = r.yy / edges.yy, zz = r.zz / edges.zz;
    const double xy = r.xy / edges.yy, xz = r.xz / edges.zz, yz = r.yz / edges.zz;
    return std::sqrt(xx * xx + yy * yy + zz * zz + xy * xy + xz * xz + yz * yz);
  }
};

}  // namespace cohesion::hard_sphere
