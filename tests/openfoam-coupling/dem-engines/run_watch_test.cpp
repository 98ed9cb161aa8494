// SPDX-License-Identifier: BSD-3-Clause
#include "dem-engines/run_watch.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <regex>
#include <string>
#include <thread>
#include <vector>

namespace {

using cohesion::coupling::RunWatch;
using std::chrono::milliseconds;

constexpr RunWatch::Times quick{milliseconds(1), milliseconds(20), milliseconds(40)};

/// The first reports, `number` of them and those that come meanwhile.
std::vector<std::string> reports(std::size_t number,
                                 const std::function<RunWatch::Steps()>& steps) {
  std::vector<std::string> texts;
  std::mutex mutex;
  std::atomic<std::size_t> so_far = 0;
  {
    const RunWatch watch(
        steps,
        [&](const std::string& text) {
          const std::lock_guard lock(mutex);
          texts.push_back(text);
          ++so_far;
        },
        quick);
    while (so_far < number) std::this_thread::sleep_for(milliseconds(1));
  }
  return texts;
}

TEST(RunWatch, ReportsNothingOfWhatIsSoonOver) {
  bool any = false;
  {
    const RunWatch watch([] { return RunWatch::Steps{0, 1, 2}; },
                         [&](const std::string&) { any = true; });
  }
  EXPECT_FALSE(any);
}

TEST(RunWatch, CountsTheStepsOfTheRunAndWhatIsLeftByItsSpeed) {
  // A step per read; the first of them is where the watch begins.
  long at = 700;
  const auto steps = [&at] { return RunWatch::Steps{500, at++, 100500}; };
  const std::regex form(R"((\S+) s, step (\d+) of 100000 of a run, about (\S+) s left of it)");
  double seconds = 0;
  for (const auto& text : reports(3, steps)) {
    std::smatch found;
    ASSERT_TRUE(std::regex_match(text, found, form)) << text;
    EXPECT_GT(std::stod(found[1]), seconds);
    seconds = std::stod(found[1]);
    const double step = std::stod(found[2]);
    const double left = seconds * (100000 - step) / (step - 200);
    EXPECT_NEAR(std::stod(found[3]), left, 0.011 * left) << "both of three digits: " << text;
  }
}

TEST(RunWatch, BeginsAnewWithAnotherRun) {
  // The second has made no step yet, so that nothing is known of its speed.
  const auto begin = RunWatch::Clock::now();
  const auto steps = [&] {
    return RunWatch::Clock::now() - begin < milliseconds(10) ? RunWatch::Steps{0, 900, 1000}
                                                             : RunWatch::Steps{1000, 1000, 3000};
  };
  const std::string text = reports(1, steps).front();
  EXPECT_NE(text.find("step 0 of 2000 of a run"), std::string::npos) << text;
  EXPECT_EQ(text.find("left"), std::string::npos) << text;
}

TEST(RunWatch, ReportsWhenNoRunIsUnderWay) {
  const std::string text = reports(1, [] { return RunWatch::Steps{0, 0, 0}; }).front();
  EXPECT_NE(text.find("no run under way"), std::string::npos) << text;
}

}  // namespace
