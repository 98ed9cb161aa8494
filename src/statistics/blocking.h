// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace cohesion::statistics {

/// Standard error of the mean of correlated values by blocking. Source: H. Flyvbjerg, H. G.
/// Petersen, J. Chem. Phys. 91 (1989) 461. Neighbours are averaged in pairs, again and again; at
/// each level the error is estimated as if the n values left were independent, sqrt(sum of
/// squares/(n(n-1))). It grows until the blocks are longer than the correlation and then stays.
class Blocking {
 public:
  static constexpr std::size_t least = 8;  ///< values that a level needs for an estimate

  /// `values` in order of time, of any unit. Of an odd number the first is left out of the pairs.
  explicit Blocking(std::vector<double> values) {
    while (values.size() >= 2 && (values.size() >= least || levels.empty())) {
      levels.push_back(level_of(values));
      const std::size_t odd = values.size() % 2, half = values.size() / 2;
      for (std::size_t i = 0; i < half; i++)
        values[i] = 0.5 * (values[odd + 2 * i] + values[odd + 2 * i + 1]);
      values.resize(half);
    }
  }

  std::size_t size() const { return levels.size(); }
  /// The estimate at a level, in the unit of the values; level 0 are the values themselves.
  double error_at(std::size_t level) const { return levels[level].error; }

  /// The estimate at the finest level that no coarser one exceeds by more than two of its standard
  /// errors, error/sqrt(2(n - 1)) each. 0 for fewer than two values: not known.
  double error() const {
    for (std::size_t j = 0; j < levels.size(); j++)
      if (stays_from(j)) return levels[j].error;
    return 0.0;
  }

 private:
  struct Level {
    double error, uncertainty;
  };

  static Level level_of(const std::vector<double>& values) {
    const double n = static_cast<double>(values.size());
    double mean = 0.0, square = 0.0;
    for (const double v : values) mean += v / n;
    for (const double v : values) square += (v - mean) * (v - mean);
    const double error = std::sqrt(square / n / (n - 1.0));
    return {error, error / std::sqrt(2.0 * (n - 1.0))};
  }

  bool stays_from(std::size_t j) const {
    return std::all_of(levels.begin() + static_cast<std::ptrdiff_t>(j), levels.end(),
                       [&](const Level& coarser) {
                         return coarser.error - 2.0 * coarser.uncertainty <= levels[j].error;
                       });
  }

  std::vector<Level> levels;
};

}  // namespace cohesion::statistics
