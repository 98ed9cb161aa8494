// SPDX-License-Identifier: BSD-3-Clause
#include "drag/pressure_waves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "drag/momentum_exchange.h"

namespace cohesion::drag {

namespace {

enum class Scene { wave, flux_stays, held_and_flux_stays };

/// Particles and gas in a step, by the exchange's own functions and with the engine's steps one by
/// one; mass, volume and gas step 1, gas without inertia.
class StepByStep {
 public:
  StepByStep(const PressureStep& step, Scene scene) : s_(step), scene_(scene) {}

  PressureWave advanced(const PressureWave& wave) {
    velocity_ = wave[0];
    displaced_ = wave[1];
    pressure_ = wave[2] * s_.step;
    deferred_ = wave[3] * s_.step;
    advance();
    return {velocity_, displaced_, pressure_ / s_.step, deferred_ / s_.step};
  }

 private:
  void advance() {
    const double n = 1.0 - s_.void_fraction, b = s_.step;
    const double u = scene_ == Scene::wave ? -n / s_.void_fraction * displaced_ : 0.0;
    const double c = source_coefficient(b, 1.0, 1.0, s_.free);
    const double transmitted = transmitted_volume(b, 1.0, 1.0, 1.0);
    const double last = last_pressure_on_gas(transmitted, pressure_, s_.free);
    // Nothing is left of the forces on the gas: eps grad p and n of those of a particle.
    const double source = explicit_source(c, velocity_, 0.0, deferred_, 1.0) + last;
    pressure_ = s_.felt ? n * (source - c * u) / (s_.void_fraction + n * transmitted) : 0.0;
    const double charged = source_impulse(c, u, velocity_, 1.0) + transmitted * pressure_ - last;
    deferred_ = (scene_ == Scene::held_and_flux_stays ? 0.0 : felt(u)) - charged;
  }

  /// Impulse of the drag on a particle that moves.
  double felt(double u) {
    const double dt = 1.0 / s_.engine_steps;
    const ParticleDrag drag(s_.step, 1.0, dt);
    double impulse = 0.0;
    displaced_ = 0.0;
    for (int k = 0; k < static_cast<int>(s_.engine_steps); k++) {
      displaced_ += velocity_ * dt;
      const double force = drag.force(u - velocity_, -pressure_);
      velocity_ += (force - pressure_) * dt;
      impulse += force * dt;
    }
    return impulse;
  }

  const PressureStep s_;
  const Scene scene_;
  double velocity_ = 0.0, displaced_ = 0.0, pressure_ = 0.0, deferred_ = 0.0;
};

using Matrix = std::array<PressureWave, 4>;

/// What a step makes of each of the four of a wave, as columns. Held particles have neither
/// velocity nor displacement.
Matrix matrix(const PressureStep& step, Scene scene) {
  Matrix columns{};
  for (std::size_t i = scene == Scene::held_and_flux_stays ? 2 : 0; i < 4; i++) {
    PressureWave one{};
    one[i] = 1.0;
    columns[i] = StepByStep(step, scene).advanced(one);
  }
  return columns;
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 4; i++)
    for (std::size_t j = 0; j < 4; j++)
      for (std::size_t k = 0; k < 4; k++) c[i][j] += a[i][k] * b[k][j];
  return c;
}

/// Whether all eigenvalues are below `radius` in size: the characteristic polynomial by Faddeev and
/// LeVerrier, its roots over the radius by Schur and Cohn. No power of the matrix is looked at.
bool eigenvalues_below(double radius, const Matrix& of) {
  std::vector<double> p(5, 1.0);  // p[k] goes with L^k
  Matrix m{};
  for (std::size_t k = 1; k <= 4; k++) {
    for (std::size_t i = 0; i < 4; i++) m[i][i] += p[5 - k];
    m = product(of, m);
    p[4 - k] = -(m[0][0] + m[1][1] + m[2][2] + m[3][3]) / static_cast<double>(k);
  }
  for (std::size_t k = 0; k <= 4; k++) p[k] *= std::pow(radius, static_cast<double>(k));
  while (p.size() > 1) {
    const std::size_t n = p.size() - 1;
    const double share = p[0] / p[n];
    if (!(std::abs(share) < 1.0)) return false;
    std::vector<double> lower(n);
    for (std::size_t k = 0; k < n; k++) lower[k] = p[k + 1] - share * p[n - 1 - k];
    p = lower;
  }
  return true;
}

}  // namespace

TEST(PressureWaves, GrowByTheLargestEigenvalueOfAStepDoneOneByOne) {
  // pressure_growth() is to 1e-6; ten times that for rounding where roots are near each other.
  constexpr double resolution = 1e-5;
  int grow = 0;
  for (const bool felt : {true, false})
    for (const bool free : {false, true})
      for (const double steps : {3.0, 5.0, 20.0})
        for (const double x : {0.3, 1.0, 4.0, 8.0, 50.0, 1e6})
          for (const double eps : {0.3, 0.4, 0.5, 0.6, 0.7, 0.9}) {
            const PressureStep step{x, eps, steps, free, felt};
            const double growth = pressure_growth(step);
            const Matrix of = matrix(step, Scene::wave);
            EXPECT_TRUE(eigenvalues_below(growth * (1.0 + resolution), of))
                << x << " " << eps << " " << steps << free << felt;
            EXPECT_FALSE(eigenvalues_below(growth * (1.0 - resolution), of))
                << x << " " << eps << " " << steps << free << felt;
            grow += pressure_waves_grow(step);
          }
  EXPECT_GT(grow, 20);
}

TEST(PressureWaves, InFormBGrowWhereTheirRootsLeaveTheCircle) {
  for (const double steps : {5.0, 40.0})
    for (const double x : {0.5, 3.0, 30.0, 1e6})
      for (double eps = 0.255; eps < 0.8; eps += 0.01) {
        const double n = 1.0 - eps, decay = std::exp(-x);
        const double sampled = (1.0 - decay) / (steps * (1.0 - std::exp(-x / steps)));
        const double k = n / eps;
        const bool real = k * (1.0 + decay - 2.0 * sampled) > 1.0 + decay;
        const bool pair = k * (sampled - decay) > 1.0;
        EXPECT_EQ(pressure_waves_grow({x, eps, steps, false, false}), real || pair)
            << x << " " << eps << " " << steps;
      }
}

TEST(PressureWaves, WithStiffDragGrowBelowAVoidFraction) {
  for (const bool free : {false, true})
    for (const double steps : {5.0, 40.0})
      for (double eps = 0.395; eps < 0.8; eps += 0.01) {
        const double n = 1.0 - eps, r = free ? 0.0 : 1.0;
        const double drives = n / eps * (1.0 + 4.0 * r * n) * (1.0 - 2.0 / steps);
        EXPECT_EQ(pressure_waves_grow({1e9, eps, steps, free}), drives > 1.0)
            << eps << steps << free;
      }
}

TEST(PressureWaves, FreeParticlesAndPressureDieOutWhereTheFluxStays) {
  for (const bool free : {false, true})
    for (const double steps : {2.0, 5.0, 20.0})
      for (const double x : {0.01, 0.3, 1.0, 4.0, 50.0, 1e6})
        for (const double eps : {0.3, 0.45, 0.62, 0.8, 0.95}) {
          const Matrix of = matrix({x, eps, steps, free}, Scene::flux_stays);
          EXPECT_TRUE(eigenvalues_below(1.0, of)) << x << " " << eps << " " << steps << free;
          // Stiff: a matrix of four of which a power vanishes, but for 1/x.
          if (x > 1e5) {
            EXPECT_TRUE(eigenvalues_below(std::pow(x, -0.25), of)) << eps << " " << steps << free;
          }
        }
}

TEST(PressureWaves, OfHeldParticlesDieOutAsTheirRootsSay) {
  for (const bool free : {false, true})
    for (const double x : {0.3, 1.0, 4.0, 1e6})
      for (const double eps : {0.2, 0.3, 0.45, 0.62, 0.95}) {
        const Matrix of = matrix({x, eps, 5.0, free}, Scene::held_and_flux_stays);
        const double a = (1.0 - eps) * (1.0 - (1.0 - std::exp(-x)) / x);
        const double root = free ? a / (eps + a) : std::sqrt(a / (eps + a));
        // By rounding of 1e-16 two roots that are one come apart by 1e-8.
        EXPECT_TRUE(eigenvalues_below(root * (1.0 + 1e-7), of));
        EXPECT_FALSE(eigenvalues_below(root * (1.0 - 1e-7), of));
        EXPECT_LT(root, 1.0);
      }
}

TEST(PressureWaves, DoNotGrowInTheStepThatIsSaid) {
  for (const double eps : {0.3, 0.4, 0.5, 0.6})
    for (const double steps : {5.0, 30.0}) {
      const double longest = longest_pressure_step({1e4, eps, steps, false});
      EXPECT_FALSE(pressure_waves_grow({longest, eps, steps, false}));
      EXPECT_TRUE(pressure_waves_grow({longest * 1.002, eps, steps, false}));
    }
  EXPECT_EQ(longest_pressure_step({1e4, 0.8, 5.0, false}), 1e4);
  EXPECT_EQ(longest_pressure_step({1e4, 0.55, 30.0, true}), 1e4);
  EXPECT_FALSE(pressure_waves_grow({3.0, 1.0, 5.0, false}));
}

TEST(PressureWaves, LimitsSeeThoseThatGrowInNoStiffStep) {
  int windows = 0;
  for (const bool felt : {true, false})
    for (const bool free : {false, true})
      for (const double steps : {1.0, 2.0, 3.0, 4.0, 5.0}) {
        PressureLimits limits(steps, free, felt);
        for (const double eps : {0.265, 0.345, 0.385, 0.455, 0.505, 0.585}) {
          const double longest = limits.longest(eps);
          for (double x = 0.01; x < 1e6; x *= 1.3)
            if (pressure_waves_grow({x, eps, steps, free, felt})) {
              EXPECT_LT(longest, x) << eps << " " << steps << free << felt;
              windows += !pressure_waves_grow({1e9, eps, steps, free, felt});
            }
        }
      }
  EXPECT_GT(windows, 0);
}

TEST(PressureWaves, LimitsOfManyParticlesAreOnTheSafeSideByAHundredthOfTheVoidFraction) {
  PressureLimits limits(30.0, false, true);
  for (const double eps : {0.305, 0.4, 0.4567, 0.55, 0.62, 1.0})
    for (int again = 0; again < 2; again++) {
      const double found = limits.longest(eps);
      EXPECT_LE(found, longest_pressure_step({1e9, eps, 30.0, false}) * (1.0 + 1e-3));
      EXPECT_GE(found, longest_pressure_step({1e9, std::max(eps - 0.01, 0.01), 30.0, false}) *
                           (1.0 - 1e-3));
    }
}

}  // namespace cohesion::drag
