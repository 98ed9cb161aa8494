// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "shear/mean_profile.h"

namespace cohesion::shear {

/// Sums over layers across the gradient, which tell how far the mean velocity of each is from the
/// mean profile: plain numbers, to be added over ranks.
class Layers {
 public:
  /// Divides the height of the box [length], whose middle is y = 0, into `number` layers.
  Layers(int number, double box_height) : height(box_height), values(3 * number, 0.0) {}

  int number() const { return static_cast<int>(values.size()) / 3; }
  std::vector<double>& sums() { return values; }

  /// Adds a particle: mass [mass], position in the box [length], velocity along the flow
  /// [length/time].
  void add(double mass, double y, double u) {
    const int n = number();
    const int layer = std::clamp(static_cast<int>((y / height + 0.5) * n), 0, n - 1);
    values[3 * layer] += mass;
    values[3 * layer + 1] += mass * y;
    values[3 * layer + 2] += mass * u;
  }

  double mass(int layer) const { return values[3 * layer]; }
  /// Mean position of the particles in the layer, [length]; 0 without any.
  double mean_position(int layer) const { return mean(layer, 1); }
  double mean_velocity(int layer) const { return mean(layer, 2); }

  /// Root of the mass-weighted mean square of layer velocity - mean profile, [length/time]. Of n
  /// particles in equilibrium at temperature T it is about sqrt(T number()/n), not zero.
  double slip(const MeanProfile& profile) const {
    double square = 0.0, all = 0.0;
    for (int i = 0; i < number(); i++) {
      const double slip_of_layer = mean_velocity(i) - profile.at(mean_position(i));
      square += mass(i) * slip_of_layer * slip_of_layer;
      all += mass(i);
    }
    return all > 0.0 ? std::sqrt(square / all) : 0.0;
  }

 private:
  double mean(int layer, int k) const {
    return mass(layer) > 0.0 ? values[3 * layer + k] / mass(layer) : 0.0;
  }

  double height;
  std::vector<double> values;
};

}  // namespace cohesion::shear
