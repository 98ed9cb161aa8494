// SPDX-License-Identifier: BSD-3-Clause
#include "statistics/block_rule.h"

#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "refuses.h"
#include "statistics/blocking.h"

namespace cohesion::statistics {
namespace {

/// x' = rho x + sqrt(1 - rho^2) g, variance 1: correlation rho^k, begun in equilibrium.
class Autoregressive {
 public:
  explicit Autoregressive(double rho) : rho_(rho) { x_ = normal_(random_); }
  double next() { return x_ = rho_ * x_ + std::sqrt(1 - rho_ * rho_) * normal_(random_); }
  std::vector<double> series(int n) {
    std::vector<double> values(n);
    for (double& v : values) v = next();
    return values;
  }

 private:
  double rho_, x_;
  std::mt19937 random_{20};
  std::normal_distribution<double> normal_;
};

/// Variance of the mean of n values: (1 + 2 sum over k of (1 - k/n) rho^k)/n.
double variance_of_mean(double rho, double n) {
  return ((1 + rho) / (1 - rho) - 2 * rho * (1 - std::pow(rho, n)) / (n * (1 - rho) * (1 - rho))) /
         n;
}

/// Feeds x(t) at t = 1, 2, ... until the rule is met; blocks it took, or -1.
int blocks_until_met(BlockRule& rule, const std::function<double(double)>& x, int most) {
  for (double t = 1; rule.blocks() < most; t++)
    if (rule.add(t, {{x(t), 1}}) && rule.met()) return rule.blocks();
  return -1;
}

}  // namespace

TEST(Blocking, EachLevelHasTheExpectationOfItsBlocks) {
  // E[sum of squares/(n(n - 1))] = (variance of a block's mean - variance of the mean of all)/(n -
  // 1). Of N series: squares of n values, Gaussian, relative deviation sqrt(2/((n - 1)N)) if
  // independent; neighbours whose correlation is rho at most make that sqrt((1 + rho)/(1 - rho))
  // larger at most.
  const double rho = 0.5;
  const int n = 1024, series = 400;
  Autoregressive process(rho);
  std::vector<double> squares(8);
  for (int i = 0; i < series; i++) {
    const Blocking blocking(process.series(n));
    ASSERT_EQ(blocking.size(), 8u);  // 1024 to 8 values
    for (int j = 0; j < 8; j++) squares[j] += std::pow(blocking.error_at(j), 2) / series;
  }
  for (int j = 0; j < 8; j++) {
    const double length = std::pow(2, j), left = n / length;
    const double expected = (variance_of_mean(rho, length) - variance_of_mean(rho, n)) / (left - 1);
    const double room = 5 * std::sqrt(2 / ((left - 1) * series) * (1 + rho) / (1 - rho));
    EXPECT_NEAR(squares[j] / expected, 1, room) << "level " << j;
  }
}

TEST(Blocking, FindsTheErrorOfTheMeanOfCorrelatedValues) {
  // The level chosen is not two of its standard errors below that with 128 blocks of 128 values,
  // whose expectation is the exact error less 4 %: the correlation time is 9.5, and blocks of
  // length m miss 2 rho/((1 - rho^2) m) of the variance, 7.4 %. It is no larger than the largest of
  // all levels: of those from 128 blocks on at most 1 + root of the sum of 1/(2(n - 1)), n = 8 to
  // 128, = 1.37 on average.
  const double rho = 0.9;
  const int n = 16384, series = 100;
  Autoregressive process(rho);
  double mean = 0.0;
  for (int i = 0; i < series; i++) mean += Blocking(process.series(n)).error() / series;
  mean /= std::sqrt(variance_of_mean(rho, n));
  const double of_128 = 1 / std::sqrt(2.0 * 127);
  EXPECT_GT(mean, 0.96 * (1 - 2 * of_128) * (1 - 5 * of_128 / std::sqrt(series)));
  EXPECT_LT(mean, 1.37);
}

TEST(Blocking, IsHardlyLargerWhenThereIsNoCorrelation) {
  // All levels expect the same. The finest, 1/sqrt(2(n - 1)) from it, is taken unless another is
  // larger; no more than the largest is, as above from n = 8 up to 1024: 1 + sqrt(0.134).
  const int n = 1024, series = 100;
  Autoregressive process(0.0);
  double mean = 0.0;
  for (int i = 0; i < series; i++)
    mean += Blocking(process.series(n)).error() * std::sqrt(n) / series;
  EXPECT_GT(mean, 1 - 5 / std::sqrt(2.0 * (n - 1) * series));
  EXPECT_LT(mean, 1.37);
}

TEST(Blocking, OfTooFewOrEqualValues) {
  EXPECT_EQ(Blocking({}).error(), 0.0);
  EXPECT_EQ(Blocking({3.0}).error(), 0.0);
  // The mean of 100 values has 100 roundings.
  EXPECT_NEAR(Blocking(std::vector<double>(100, 3.0)).error(), 0.0,
              300 * std::numeric_limits<double>::epsilon());
  EXPECT_DOUBLE_EQ(Blocking({1.0, 3.0}).error(), 1.0);
  // Three: sum of squares 2, /(3 2); seven values are not halved.
  EXPECT_DOUBLE_EQ(Blocking({1.0, 2.0, 3.0}).error(), std::sqrt(1.0 / 3.0));
  EXPECT_EQ(Blocking(std::vector<double>(7, 1.0)).size(), 1u);
  EXPECT_EQ(Blocking(std::vector<double>(17, 1.0)).size(), 2u);
}

TEST(WatchedSeries, IsARatioOfSumsAndItsError) {
  // Two terms: 1/2 + 3 in the first batch, 3/1 + 0 in the second, nothing in the third.
  WatchedSeries series(2);
  const Ratio batches[3][2] = {{{1, 2}, {3, 1}}, {{3, 1}, {0, 1}}, {{0, 0}, {0, 0}}};
  for (const auto& batch : batches) series.add(batch);
  EXPECT_DOUBLE_EQ(series.value_over(0, 1), 3.5);
  EXPECT_DOUBLE_EQ(series.value_over(2, 3), 0.0);
  const Mean mean = series.mean();
  EXPECT_DOUBLE_EQ(mean.value, 4.0 / 3.0 + 1.5);
  // Residuals: (1 - 4/3 2)/1 + (3 - 1.5)/(2/3), (3 - 4/3)/1 + (0 - 1.5)/(2/3), 0.
  const double a = -5.0 / 3.0 + 2.25, b = 5.0 / 3.0 - 2.25;
  EXPECT_DOUBLE_EQ(mean.error, std::sqrt((a * a + b * b) / 6));
}

TEST(WatchedSeries, ErrorOfACommonMultipleIsNone) {
  WatchedSeries series(1);
  for (int i = 1; i < 40; i++) {
    const Ratio batch{2.5 * (i % 7), 1.0 * (i % 7)};
    series.add(&batch);
  }
  EXPECT_DOUBLE_EQ(series.mean().value, 2.5);
  EXPECT_NEAR(series.mean().error, 0.0, 100 * std::numeric_limits<double>::epsilon());
}

TEST(BlockRule, OfAConstantIsMetByTwoBlocks) {
  for (const double x : {0.0, -7.0}) {
    BlockRule rule(5, 32, {{1, 1e-12}});
    EXPECT_EQ(rule.change(0), std::numeric_limits<double>::infinity());
    double t = 1;
    while (!rule.add(t, {{x, 1}})) t++;
    EXPECT_EQ(rule.blocks(), 1);
    EXPECT_EQ(rule.change(0), std::numeric_limits<double>::infinity());
    EXPECT_FALSE(rule.met());
    t++;
    while (!(rule.add(t, {{x, 1}}) && rule.met())) t++;
    EXPECT_EQ(rule.blocks(), 2);
    EXPECT_EQ(t, 5 + 2 * 32);
    EXPECT_EQ(rule.mean(0).value, x);
    EXPECT_EQ(rule.mean(0).error, 0.0);
  }
}

TEST(BlockRule, LeavesOutWhatCameBeforeTheStart) {
  BlockRule rule(100, 16, {{1, 0.01}});
  EXPECT_EQ(blocks_until_met(rule, [](double t) { return t <= 100 ? 1e9 : 2; }, 3), 2);
  EXPECT_EQ(rule.mean(0).value, 2);
}

TEST(BlockRule, FollowsALinearDriftUntilItIsSmall) {
  // x = t: mean of block b is B (b - 1/2) + 1/2, the change between b and b + 1 is 1/(b + 1/(2B)):
  // below 0.05 first at b = 20.
  BlockRule rule(0, 64, {{1, 0.05}});
  // The first sample tells where the run is; the first block has 63 values.
  EXPECT_EQ(blocks_until_met(rule, [](double t) { return t; }, 100), 21);
}

TEST(BlockRule, IsNeverMetByExponentialGrowth) {
  // Each block is exp(B/100) of the one before: change 2 tanh(B/200) = 0.32.
  BlockRule rule(0, 32, {{1, 0.3}});
  EXPECT_EQ(blocks_until_met(rule, [](double t) { return std::exp(t / 100); }, 50), -1);
  EXPECT_NEAR(rule.change(0), 2 * std::tanh(32.0 / 200), 1e-12);
  EXPECT_GT(rule.mean(0).error, 0.1 * rule.mean(0).value);
}

TEST(BlockRule, NeedsAllWatchedToBeStill) {
  BlockRule rule(0, 16, {{1, 0.01}, {2, 0.01}});
  for (double t = 1; t < 200; t++) {
    const double other = std::fmod(std::floor(t / 16), 2.0);
    if (!rule.add(t, {{1, 1}, {1, 1}, {other, 1}}) || rule.blocks() < 2) continue;
    EXPECT_EQ(rule.change(0), 0.0);
    EXPECT_GT(rule.change(1), 0.1);
    EXPECT_FALSE(rule.met());
  }
}

TEST(BlockRule, IsNotStillWhereNothingWasCounted) {
  // The second ratio counts nothing up to t = 64, then 2/1; the third, not waited for, never does.
  BlockRule rule(0, 16, {{1, 0.01}, {2, 0.01}, {1, BlockRule::any}});
  double met_at = 0;
  for (double t = 1; t <= 96; t++) {
    const Ratio late = t > 64 ? Ratio{2, 1} : Ratio{};
    if (rule.add(t, {{1, 1}, {1, 1}, late, {}}) && rule.met() && met_at == 0) met_at = t;
    if (t == 64 || t == 80) {
      EXPECT_EQ(rule.change(1), std::numeric_limits<double>::infinity());
    }
  }
  EXPECT_EQ(met_at, 96);
  EXPECT_EQ(rule.change(1), 0.0);
  EXPECT_EQ(rule.change(2), std::numeric_limits<double>::infinity());
  EXPECT_EQ(rule.mean(1).value, 3.0);
}

TEST(BlockRule, OfNothingToWaitForIsMetByTwoBlocks) {
  BlockRule rule(0, 16, {{1, BlockRule::any}});
  EXPECT_EQ(blocks_until_met(rule, [](double t) { return t; }, 5), 2);
}

TEST(BlockRule, TakesSamplesFartherApartThanBlocks) {
  BlockRule rule(0, 16, {{1, 0.01}});
  int ended = 0;
  for (double t = 0; t <= 400; t += 40) ended += rule.add(t, {{40, 40}});
  EXPECT_EQ(ended, 10);
  EXPECT_EQ(rule.mean(0).value, 1.0);
}

TEST(BlockRule, GoesOnFromItsState) {
  const std::vector<Watched> watched{{1, 1e-9}, {2, 1e-9}};
  BlockRule whole(10, 32, watched), first(10, 32, watched), second(10, 32, watched);
  Autoregressive process(0.5);
  for (double t = 1; t <= 300; t++) {
    const std::vector<Ratio> gains{{process.next(), 1}, {process.next(), 2}, {process.next(), 3}};
    whole.add(t, gains);
    (t <= 133 ? first : second).add(t, gains);
    if (t == 133) second.restore(first.state());
  }
  EXPECT_EQ(second.blocks(), whole.blocks());
  for (int w = 0; w < 2; w++) {
    EXPECT_EQ(second.mean(w).value, whole.mean(w).value);
    EXPECT_EQ(second.mean(w).error, whole.mean(w).error);
    EXPECT_EQ(second.change(w), whole.change(w));
  }
  BlockRule other(10, 32, {{1, 1e-9}});
  expect_refused([&] { other.restore(first.state()); }, "watch the same values");
  expect_refused([&] { other.restore({}); }, "watch the same values");
  BlockRule later(11, 32, watched), longer(10, 33, watched);
  expect_refused([&] { later.restore(first.state()); }, "same start");
  expect_refused([&] { longer.restore(first.state()); }, "same block");
}

TEST(BlockRule, RefusesWhatCannotBe) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused([] { BlockRule(-1, 1, {{1, 0.1}}); }, "start");
  expect_refused([] { BlockRule(0, 0, {{1, 0.1}}); }, "block");
  expect_refused([&] { BlockRule(0, nan, {{1, 0.1}}); }, "block");
  expect_refused([] { BlockRule(0, 1, {{1, 0}}); }, "tolerance");
}

}  // namespace cohesion::statistics
