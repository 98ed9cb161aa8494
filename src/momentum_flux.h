// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "vector3.h"

namespace cohesion {

/// R J, xx, yy, zz, xy, xz, yz, [momentum length], of an impulse on j that i gives and the way R
/// from i to j that this momentum goes: positive in compression; xy is R_x J_y, as in the engines'
/// virial. Summed and divided by volume and time it is the stress that the impulses carry.
using MomentumFlux = std::array<double, 6>;

inline MomentumFlux momentum_flux(const Vector3& r, const Vector3& on_j) {
  return {r.x * on_j.x, r.y * on_j.y, r.z * on_j.z, r.x * on_j.y, r.x * on_j.z, r.y * on_j.z};
}

}  // namespace cohesion
