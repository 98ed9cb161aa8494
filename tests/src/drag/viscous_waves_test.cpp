// SPDX-License-Identifier: BSD-3-Clause
#include "drag/viscous_waves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cohesion::drag {
namespace {

/// What a wave grows by in a step, found by steps: the engine's kicks and drifts one by one, sizes
/// taken over the second half of `n` steps.
double stepped(double kappa, double viscous, int engine_steps, double seen, int n) {
  // Velocity and impulse of an engine step; gas velocities in units of -(1 - eps)/eps.
  double v = 1.0, kick = 0.2, gas = 0.4, mean = -0.7, log_size = 0.0;
  const double implicit = viscous * (1.0 - seen);
  const double late = implicit * seen / 3.0;
  for (int i = 0; i < n; i++) {
    const double next = seen * mean;
    // What the gas's momentum gains, the particles lose by grad p, kappa of it in these units.
    const double impulse = -kappa * (next - gas + implicit * next + late * gas);
    gas = next;
    mean = 0.0;
    for (int k = 0; k < engine_steps; k++) {
      v += 0.5 * kick;
      mean += v / engine_steps;
      kick = impulse / engine_steps;
      v += 0.5 * kick;
    }
    const double size = std::hypot(std::hypot(v, mean), std::hypot(gas, kick));
    for (double* x : {&v, &mean, &gas, &kick}) *x /= size;
    if (2 * i >= n) log_size += std::log(size);
  }
  return std::exp(2.0 * log_size / n);
}

double stepped(const ViscousStep& step, int n) {
  double largest = 0.0;
  for (int i = 0; i <= 32; i++)
    largest = std::max(largest, stepped(step.displaced, step.viscous,
                                        static_cast<int>(step.engine_steps), i / 32.0, n));
  return largest;
}

constexpr std::array<double, 3> engine_steps{1.0, 5.0, 12.0};

}  // namespace

TEST(ViscousWaves, GrowAsTheyDoStepByStep) {
  const int n = 8000;
  for (const double steps : engine_steps)
    for (const double kappa : {0.001, 0.06, 0.6, 1.5})
      for (const double viscous : {0.1, 2.4, 24.0, 240.0, 1e4}) {
        const ViscousStep step{kappa, viscous, steps};
        // The mean over n/2 steps; the direction turns, its size by less than a factor of 1e6:
        // entries differ by up to kappa M.
        const double error = std::log(1e6) / (0.5 * n);
        const double found = std::max(1.0, stepped(step, n));
        EXPECT_NEAR(std::log(viscous_growth(step)), std::log(found), error)
            << kappa << ' ' << viscous << ' ' << steps;
      }
}

TEST(ViscousWaves, WithoutViscosityGrowFromADisplacedMassOn) {
  // (l - 1)(l^2 + kappa w l + kappa (1 - w)) = 0: a pair with the product kappa (1 - w)
  for (const double steps : engine_steps) {
    const double limit = 2.0 * steps / (steps + 1.0);
    EXPECT_EQ(viscous_growth({0.99 * limit, 0.0, steps}), 1.0);
    EXPECT_GT(viscous_growth({1.01 * limit, 0.0, steps}), 1.0);
    EXPECT_FALSE(viscous_waves_grow({0.99 * limit, 0.0, steps}));
    EXPECT_TRUE(viscous_waves_grow({1.01 * limit, 0.0, steps}));
  }
  EXPECT_EQ(longest_viscous_step({3.0, 0.0, 5.0}), 0.0);
}

TEST(ViscousWaves, WithEnoughStepsOfTheEngineAShortStepDoes) {
  for (const double kappa : {0.5, 0.999, 1.0, 1.2, 1.5, 1.9, 1.99}) {
    const double steps = engine_steps_needed(kappa);
    EXPECT_LT(kappa, 2.0 * steps / (steps + 1.0) + 1e-15);
    EXPECT_GT(longest_viscous_step({kappa, 1e4, steps}), 0.0) << kappa;
    if (steps > 1.0) {
      EXPECT_EQ(longest_viscous_step({kappa, 1e-9, steps - 1.0}), 0.0) << kappa;
    }
  }
  EXPECT_EQ(engine_steps_needed(2.0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(longest_viscous_step({2.0, 1.0, 1e6}), 0.0);
  // A share of the step does, in as many steps of the engine; where these are as long as they were,
  // the shortest that can be, of one of them, is too short.
  const ViscousStep step{1.5, 5.0, 5.0};
  EXPECT_GT(viscous_growth(step), 1.2);
  const double share = longest_viscous_step(step);
  EXPECT_EQ(viscous_growth(shortened(step, 0.999 * share, 5.0)), 1.0);
  EXPECT_GT(viscous_growth(shortened(step, 1.01 * share, 5.0)), 1.0);
  EXPECT_GT(viscous_growth(shortened(step, 0.2, 1.0)), 1.2);
}

TEST(ViscousWaves, OfWhatIsNotFiniteGrowWithoutEnd) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {infinite, std::numeric_limits<double>::quiet_NaN()})
    for (const ViscousStep& step :
         {ViscousStep{bad, 1.0, 5.0}, ViscousStep{0.1, bad, 5.0}, ViscousStep{0.1, 1.0, bad}}) {
      EXPECT_FALSE(is_finite(step));
      EXPECT_EQ(viscous_growth(step), infinite);
      EXPECT_EQ(longest_viscous_step(step), 0.0);
    }
}

TEST(ViscousWaves, LongestStepIsWhereTheyBeginToGrow) {
  for (const double steps : engine_steps)
    for (const double kappa : {0.001, 0.06, 0.6}) {
      const ViscousStep step{kappa, 50.0 / kappa, steps};
      const double share = longest_viscous_step(step);
      ASSERT_GT(share, 0.0);
      ASSERT_LT(share, 1.0);
      const auto growth = [&](double s) {
        return viscous_growth({kappa, step.viscous * s, steps});
      };
      EXPECT_EQ(growth(0.999 * share), 1.0);
      EXPECT_GT(growth(1.01 * share), 1.0);
    }
  EXPECT_EQ(longest_viscous_step({0.06, 2.0, 5.0}), 1.0);
}

TEST(ViscousWaves, NeedNoLookWhereNoneGrows) {
  for (const double steps : engine_steps)
    for (const double kappa : {1e-6, 1e-3, 0.1, 0.2, 0.249})
      EXPECT_EQ(viscous_growth({kappa, 0.49999 / kappa - 2.0, steps}), 1.0);
  EXPECT_TRUE(surely_no_viscous_waves({7e-4, 3e-2, 5.0}));
  EXPECT_FALSE(surely_no_viscous_waves({0.6, 0.0, 5.0}));
}

}  // namespace cohesion::drag
