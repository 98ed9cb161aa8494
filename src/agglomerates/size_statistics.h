// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

namespace cohesion::agglomerates {

/// Number of agglomerates by size, current and in the mean over time. The last entry counts all
/// sizes from the largest one asked for on; those of size 1 are particles without partner.
class SizeDistribution {
 public:
  explicit SizeDistribution(int largest) : numbers(largest, 0.0), over_time(largest, 0.0) {}

  std::vector<double>& current() { return numbers; }
  const std::vector<double>& sums() const { return over_time; }
  std::vector<double>& sums() { return over_time; }

  void clear() { std::fill(numbers.begin(), numbers.end(), 0.0); }
  void add(double size, double number = 1.0) {
    const double last = static_cast<double>(numbers.size());
    numbers[static_cast<std::size_t>(std::min(size, last)) - 1] += number;
  }
  /// Adds the current numbers to the sums over time, for this time [time].
  void add_time(double time) {
    for (std::size_t i = 0; i < numbers.size(); i++) over_time[i] += time * numbers[i];
  }

 private:
  std::vector<double> numbers, over_time;
};

/// Mean over time of the mean size of the agglomerates that there were; times without any do not
/// count. Source: M. Weber, thesis, chapter 4, "time-weighted".
struct TimeWeightedSize {
  double size_time = 0.0, time = 0.0;

  /// Adds the number of agglomerates and of particles in them, for this time [time].
  void add_time(double duration, double agglomerates, double particles) {
    if (agglomerates == 0.0) return;
    size_time += duration * particles / agglomerates;
    time += duration;
  }
  double mean() const { return time > 0.0 ? size_time / time : 0.0; }
};

}  // namespace cohesion::agglomerates
