// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "statistics/watched_series.h"
#include "validation.h"

namespace cohesion::statistics {

/// A number that the rule watches: what it is made of, and how far it may change.
struct Watched {
  std::size_t terms;  ///< ratios whose sum it is
  double tolerance;   ///< of the relative change from block to block [1]; BlockRule::any
};

/// Tells when blocks of a run are alike. Source: M. Weber, thesis, chapter 4. From a progress of
/// `start` on (in any unit that grows with the run: collisions per particle, time, strain) the run
/// is cut into blocks of equal progress. The rule is met when every watched number, averaged over
/// the last block, differs from that of the block before by less than its tolerance.
///
/// Two blocks that end a run have been chosen for being alike, so their difference says nothing
/// about the error. That comes from all blocks, each cut into batches.
class BlockRule {
 public:
  static constexpr int batches_per_block = 16;
  /// The tolerance of a number that is reported and not waited for.
  static constexpr double any = std::numeric_limits<double>::max();

  /// Throws InvalidParameter for a start below zero, a block or tolerance that is not above.
  BlockRule(double start, double block, const std::vector<Watched>& watched)
      : start_(start), batch_(block / batches_per_block) {
    require_non_negative("start", start);
    require_positive("block", block);
    for (const Watched& w : watched) {
      require_positive("tolerance", w.tolerance);
      tolerances_.push_back(w.tolerance);
      series_.emplace_back(w.terms);
      open_batch_.resize(open_batch_.size() + w.terms);
    }
  }

  /// Adds a sample: the progress since the run began, and what the terms of all watched numbers,
  /// one after the other, have gained since the sample before. Returns whether a block has ended.
  /// Where samples are farther apart than batches or blocks these are longer.
  bool add(double progress, const std::vector<Ratio>& gains) {
    if (progress < start_) return false;
    const double now = std::floor((progress - start_) / batch_);
    if (batches_passed_ < 0.0) {
      batches_passed_ = now;
      return false;
    }
    for (std::size_t k = 0; k < gains.size(); k++) open_batch_[k] += gains[k];
    if (now <= batches_passed_) return false;
    const bool block_ended = whole_blocks(now) > whole_blocks(batches_passed_);
    batches_passed_ = now;
    close_batch();
    if (block_ended) ends_.push_back(series_.front().batches());
    return block_ended;
  }

  int blocks() const { return static_cast<int>(ends_.size()); }
  std::size_t watched() const { return series_.size(); }

  bool met() const {
    for (std::size_t w = 0; w < watched(); w++)
      if (tolerances_[w] < any && !(change(w) < tolerances_[w])) return false;
    return blocks() >= 2;
  }

  /// Relative change of a watched number between the last two blocks: difference over mean size
  /// [1]; 0 where both are the same, 0 included; infinite while there are fewer than two blocks,
  /// and where a term has counted nothing in one of them: that a ratio over nothing stays says
  /// nothing.
  double change(std::size_t w) const {
    const int last = blocks() - 1;
    if (last < 1 || !counted_in_block(w, last) || !counted_in_block(w, last - 1))
      return std::numeric_limits<double>::infinity();
    const double now = in_block(w, last), before = in_block(w, last - 1);
    if (now == before) return 0.0;
    return std::abs(now - before) / (0.5 * (std::abs(now) + std::abs(before)));
  }

  /// The value of a watched number in block b, counted from 0.
  double in_block(std::size_t w, int b) const { return series_[w].value_over(begin(b), ends_[b]); }

  /// The mean of a watched number over all batches since the start.
  Mean mean(std::size_t w) const { return series_[w].mean(); }

  /// The state of the rule as plain numbers, for restore().
  std::vector<double> state() const {
    std::vector<double> numbers{start_, batch_, batches_passed_, static_cast<double>(ends_.size()),
                                static_cast<double>(series_.front().batches())};
    for (const std::size_t end : ends_) numbers.push_back(static_cast<double>(end));
    append(numbers, open_batch_);
    for (const WatchedSeries& series : series_) append(numbers, series.sums());
    return numbers;
  }

  /// Continues from the state of a rule with the same start and block that watched as many terms.
  /// Throws InvalidParameter when it was another.
  void restore(const std::vector<double>& numbers) {
    const std::size_t head = 5, n = numbers.size();
    const std::size_t blocks = n < head ? 0 : static_cast<std::size_t>(numbers[3]);
    const std::size_t batches = n < head ? 0 : static_cast<std::size_t>(numbers[4]);
    require(n == head + blocks + 2 * open_batch_.size() * (1 + batches), "numbers in the restart",
            static_cast<double>(n), "watch the same values as the run that wrote it");
    require(numbers[0] == start_, "start in the restart", numbers[0],
            "give the same start as the run that wrote it");
    require(numbers[1] == batch_, "block in the restart", batches_per_block * numbers[1],
            "give the same block as the run that wrote it");
    batches_passed_ = numbers[2];
    const double* at = numbers.data() + head;
    ends_.clear();
    for (std::size_t b = 0; b < blocks; b++) ends_.push_back(static_cast<std::size_t>(*at++));
    const auto next = [&at] {
      const Ratio ratio{at[0], at[1]};
      at += 2;
      return ratio;
    };
    for (Ratio& ratio : open_batch_) ratio = next();
    for (WatchedSeries& series : series_) {
      series = WatchedSeries(series.terms());
      std::vector<Ratio> batch(series.terms());
      for (std::size_t i = 0; i < batches; i++) {
        for (Ratio& ratio : batch) ratio = next();
        series.add(batch.data());
      }
    }
  }

 private:
  std::size_t begin(int b) const { return b > 0 ? ends_[b - 1] : 0; }
  bool counted_in_block(std::size_t w, int b) const {
    return series_[w].counted(begin(b), ends_[b]);
  }

  static double whole_blocks(double batches) { return std::floor(batches / batches_per_block); }

  void close_batch() {
    const Ratio* batch = open_batch_.data();
    for (WatchedSeries& series : series_) {
      series.add(batch);
      batch += series.terms();
    }
    open_batch_.assign(open_batch_.size(), {});
  }

  static void append(std::vector<double>& numbers, const std::vector<Ratio>& ratios) {
    for (const Ratio& ratio : ratios) {
      numbers.push_back(ratio.numerator);
      numbers.push_back(ratio.denominator);
    }
  }

  double start_, batch_;
  double batches_passed_ = -1.0;  // whole batches since the start; below 0: not there yet
  std::vector<double> tolerances_;
  std::vector<WatchedSeries> series_;
  std::vector<Ratio> open_batch_;  // of the batch that has not ended
  std::vector<std::size_t> ends_;  // of blocks: batches up to there
};

}  // namespace cohesion::statistics
