// SPDX-License-Identifier: BSD-3-Clause
#include "liquid/liquid_exchange.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "drag/viscous_waves.h"
#include "liquid/sphere_in_liquid.h"

namespace cohesion::liquid {
namespace {

/// A wave that all cells see, of free spheres in a fluid without viscosity, density and step 1: the
/// spheres' velocity, their mean in the last step, the fluid's velocity and pressure gradient, and
/// what is deferred per sphere of volume 1.
using Wave = std::array<double, 5>;

struct Setting {
  double solid, density;  ///< share of the spheres, their density
  double drag;            ///< b
  int steps;              ///< of the spheres
  bool free, felt;        ///< response; whether they feel the pressure, form A
};

/// The wave after a step: what spheres displaced moves the fluid, whose momentum gives the
/// pressure; the spheres then move with both, by sphere_in_liquid.h.
Wave advanced(const Setting& s, const Wave& wave) {
  const auto [start, displaced, before, last, deferred] = wave;
  const double eps = 1.0 - s.solid, added = 0.5;
  const double u = -s.solid / eps * displaced, change = u - before;
  const double w = s.felt ? transmitted_volume(s.drag, s.density, added, 1.0, 1.0) : 0.0;
  const double known = s.free ? 0.0 : w * last;
  const double charge = source_coefficient(s.drag, s.density, added, 1.0, s.free) * (u - start) +
                        source_inertia(s.drag, s.density, added, 1.0, s.free) * change - known;
  const double gradient =
      s.felt ? -(eps * change + s.solid * (charge + deferred)) / (eps + s.solid * w) : 0.0;
  const SphereInLiquid sphere{s.drag, 0.0, s.density, added, {}};
  double v = start, mean = 0.0;
  for (int k = 0; k < s.steps; k++) {
    mean += v / s.steps;
    v += acceleration(sphere, {u - v, 0.0, 0.0}, {added * change - gradient, 0.0, 0.0},
                      1.0 / s.steps)
             .x /
         s.steps;
  }
  return {v, mean, u, gradient, s.density * (v - start) + gradient - (charge + w * gradient)};
}

/// Whether a wave grows: by its size after many steps, against that after half as many.
bool grows(const Setting& setting) {
  Wave wave{1.0, 0.7, -0.3, 0.2, 0.1};
  const auto size = [&] {
    double sum = 0.0;
    for (const double one : wave) sum += one * one;
    return std::sqrt(sum);
  };
  for (int k = 0; k < 200; k++) wave = advanced(setting, wave);
  const double half = size();
  for (int k = 0; k < 200; k++) wave = advanced(setting, wave);
  return size() > 1.5 * half;
}

}  // namespace

TEST(LiquidExchange, WavesOfSpheresThatFollowGrowAtNoDragUpToTheStatedShares) {
  for (const double density : {1e-3, 0.0625, 2.5})
    for (const double drag : {0.05, 0.3, 1.0, 6.0, 50.0}) {
      EXPECT_FALSE(grows({0.28, density, drag, 1, true, true})) << density << " " << drag;
      EXPECT_FALSE(grows({0.43, density, drag, 5, true, true})) << density << " " << drag;
      EXPECT_FALSE(grows({0.43, density, drag, 20, true, true})) << density << " " << drag;
      EXPECT_FALSE(grows({0.43, density, drag, 5, true, false})) << density << " " << drag;
    }
  EXPECT_TRUE(grows({0.5, 1e-3, 0.05, 5, true, true}));
}

TEST(LiquidExchange, WavesOfLightSpheresThatAreTakenToBeHeldGrowInFormA) {
  EXPECT_TRUE(grows({0.4, 1e-3, 6.0, 5, false, true}));
  EXPECT_TRUE(grows({0.3, 1e-3, 0.5, 1, false, true}));
  EXPECT_FALSE(grows({0.4, 1e-3, 6.0, 5, true, true}));
  EXPECT_FALSE(grows({0.15, 1e-3, 6.0, 5, false, true}));
}

TEST(LiquidExchange, WithoutAddedMassIsThatOfAGasToTheLastDigit) {
  for (const bool free : {false, true})
    for (const double b : {1e-9, 0.3, 1e6}) {
      EXPECT_EQ(source_coefficient(b, 0.7, 0.0, 0.01, free),
                drag::source_coefficient(b, 0.7, 0.01, free));
      EXPECT_EQ(transmitted_volume(b, 0.7, 0.0, 0.2, 0.01),
                drag::transmitted_volume(b, 0.7, 0.2, 0.01));
      EXPECT_EQ(source_inertia(b, 0.7, 0.0, 0.01, free), 0.0);
    }
}

TEST(LiquidExchange, ChargesWhatAFreeSphereFeels) {
  // Of slip, acceleration and pressure gradient, one by one: c, c_a and W are what the sphere feels
  // of drag and added mass, m a + V grad p, in a step of sphere_in_liquid.h.
  const double b = 1.3, mass = 0.02, added = 0.5, volume = 1.0, dt = 0.4;
  const SphereInLiquid sphere{b, 0.0, mass, added, {}};
  const auto felt = [&](double slip, double du, double gradient) {
    const Vector3 force{added * du - volume * gradient, 0.0, 0.0};
    return mass * acceleration(sphere, {slip, 0.0, 0.0}, force, dt).x + volume * gradient;
  };
  // A few roundings of numbers up to 1.
  EXPECT_NEAR(source_coefficient(b, mass, added, dt, true), felt(1.0, 0.0, 0.0), 2e-15);
  EXPECT_NEAR(source_inertia(b, mass, added, dt, true), felt(0.0, 1.0, 0.0), 2e-15);
  EXPECT_NEAR(transmitted_volume(b, mass, added, volume, dt), felt(0.0, 0.0, 1.0), 2e-15);
}

TEST(LiquidExchange, ASphereWithoutMassHandsOnItsPressureAlone) {
  EXPECT_EQ(source_coefficient(1.3, 0.0, 0.5, 0.1, true), 0.0);
  EXPECT_EQ(source_inertia(1.3, 0.0, 0.5, 0.1, true), 0.0);
  EXPECT_EQ(transmitted_volume(1.3, 0.0, 0.5, 2.0, 0.1), 2.0);
}

TEST(LiquidExchange, WavesHaveTheKappaOfTheGasWithoutAddedMass) {
  EXPECT_NEAR(displaced_with_added_mass(0.7, 0.1, 0.0), 0.3 / (0.7 * 0.1), 1e-14);
  EXPECT_EQ(viscous_share(0.7, 0.0), 1.0);
}

TEST(LiquidExchange, WavesOfSpheresWithoutMassDoNotGrowUpToTheStatedShares) {
  // kappa = (1 - eps)/eps (eps + C)/C against 2 S/(S + 1), of viscous_waves.h without viscosity.
  struct {
    int steps;
    double solid;
  } const rows[] = {{1, 0.29}, {5, 0.44}};
  for (const auto& [steps, solid] : rows)
    for (const double off : {-0.01, 0.01}) {
      const double eps = 1.0 - (solid + off);
      const drag::ViscousStep step{displaced_with_added_mass(eps, 1e-9, 0.5), 0.0,
                                   static_cast<double>(steps)};
      EXPECT_EQ(drag::viscous_waves_grow(step), off > 0.0) << steps << " " << off;
    }
}

}  // namespace cohesion::liquid
