// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <iterator>

#include "vector3.h"

namespace cohesion {

/// The directions along which something else than contacts decides how a particle moves: the space
/// that all added directions span. Contacts move the particle in the rest of the `dimensions` of
/// the simulation, 2 or 3.
class HeldDirections {
 public:
  explicit HeldDirections(int dimensions = 3) : dimensions_(dimensions) {}

  /// Any length but 0. In two dimensions the third component has no effect.
  void add(Vector3 direction) {
    if (dimensions_ == 2) direction.z = 0.0;
    const double length = norm(direction);
    for (int k = 0; k < count_; k++) direction -= dot(direction, basis_[k]) * basis_[k];
    const double left = norm(direction);
    if (left <= rounded * length || count_ == dimensions_) return;
    basis_[count_++] = (1.0 / left) * direction;
  }
  /// What is left of a force.
  Vector3 left_of(Vector3 force) const {
    if (dimensions_ == 2) force.z = 0.0;
    for (const Vector3& held : *this) force -= dot(held, force) * held;
    return force;
  }

  bool none() const { return count_ == 0; }
  /// Contacts do not move the particle at all.
  bool all() const { return count_ == dimensions_; }

  /// Unit vectors at right angles, which span the space.
  const Vector3* begin() const { return basis_.data(); }
  const Vector3* end() const { return basis_.data() + count_; }

 private:
  // What rounding leaves of a direction that lies in the space, over its length.
  static constexpr double rounded = 1e-12;

  int dimensions_;
  int count_ = 0;
  std::array<Vector3, 3> basis_{};
};

/// Whether nothing is left of any force on which each of `some`, pointers in their order, acts: the
/// order matters for directions that are not at right angles.
template <class Some>
bool leave_nothing(const Some& some) {
  const Vector3 axes[] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  return std::all_of(std::begin(axes), std::end(axes), [&](Vector3 left) {
    for (const HeldDirections* held : some) left = held->left_of(left);
    return norm(left) <= 1e-9;
  });
}

/// Across `direction`: what fix lineforce and others hold that leave one direction free.
inline HeldDirections all_but(const Vector3& direction, int dimensions) {
  HeldDirections across(dimensions);
  const Vector3 axes[] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  const double square = dot(direction, direction);
  for (const Vector3& axis : axes) across.add(axis - (dot(axis, direction) / square) * direction);
  return across;
}

/// The most by which the places of particles may differ in a direction in which some are held,
/// over the smallest radius, so that all contacts count as being across it: a normal that leans by
/// this over two radii changes the mass that a contact moves by its square, 2.5e-7.
inline constexpr double most_off_layer = 1e-3;

}  // namespace cohesion
