// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "statistics/blocking.h"

namespace cohesion::statistics {

/// A mean as a ratio of two sums that grow: values over samples, or the growth of a total over
/// time, or that of one total over another's. `numerator` has the unit of the mean times that of
/// `denominator`.
struct Ratio {
  double numerator = 0.0, denominator = 0.0;

  Ratio& operator+=(const Ratio& other) {
    numerator += other.numerator;
    denominator += other.denominator;
    return *this;
  }
  /// The ratio; 0 where nothing was counted.
  double value() const { return denominator != 0.0 ? numerator / denominator : 0.0; }
};

struct Mean {
  double value = 0.0, error = 0.0;  ///< with its standard error, same unit
};

/// One watched number, the sum of some ratios, over batches of a run. Over any range of batches
/// each ratio is the sum of its `numerator` over that of its `denominator`: long batches count for
/// more, and batches in which nothing happened do no harm.
class WatchedSeries {
 public:
  explicit WatchedSeries(std::size_t terms) : terms_(terms) {}

  std::size_t terms() const { return terms_; }
  std::size_t batches() const { return sums_.size() / terms_; }
  /// The ratios of all batches, terms within batches.
  const std::vector<Ratio>& sums() const { return sums_; }

  /// Adds a batch: one ratio per term, from `batch` on.
  void add(const Ratio* batch) { sums_.insert(sums_.end(), batch, batch + terms_); }

  /// The value over batches first to last - 1.
  double value_over(std::size_t first, std::size_t last) const {
    double value = 0.0;
    for (const Ratio& total : totals(first, last)) value += total.value();
    return value;
  }

  /// Whether each ratio has counted anything over batches first to last - 1.
  bool counted(std::size_t first, std::size_t last) const {
    const std::vector<Ratio> all = totals(first, last);
    return std::all_of(all.begin(), all.end(), [](const Ratio& r) { return r.denominator != 0.0; });
  }

  /// The mean over all batches. The error is that of a ratio estimator (W. G. Cochran, Sampling
  /// Techniques, 3rd ed., 1977, eq. 6.13): what batch i adds to it is the sum over terms of
  /// (numerator_i - value denominator_i)/(mean of denominator), and these are blocked.
  Mean mean() const {
    const std::size_t n = batches();
    const std::vector<Ratio> all = totals(0, n);
    std::vector<double> residuals(n, 0.0);
    for (std::size_t i = 0; i < n; i++)
      for (std::size_t k = 0; k < terms_; k++) {
        const Ratio& batch = sums_[i * terms_ + k];
        if (all[k].denominator != 0.0)
          residuals[i] += (batch.numerator - all[k].value() * batch.denominator) *
                          static_cast<double>(n) / all[k].denominator;
      }
    return {value_over(0, n), Blocking(residuals).error()};
  }

 private:
  std::vector<Ratio> totals(std::size_t first, std::size_t last) const {
    std::vector<Ratio> all(terms_);
    for (std::size_t i = first * terms_; i < last * terms_; i++) all[i % terms_] += sums_[i];
    return all;
  }

  std::size_t terms_;
  std::vector<Ratio> sums_;
};

}  // namespace cohesion::statistics
