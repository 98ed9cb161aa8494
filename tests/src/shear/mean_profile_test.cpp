// SPDX-License-Identifier: BSD-3-Clause
#include "shear/mean_profile.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

#include "shear/granular_temperature.h"
#include "shear/kinetic_stress.h"
#include "shear/slip.h"

namespace cohesion::shear {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

struct Particle {
  double mass, y;
  Vector3 v;
};

std::vector<Particle> gas(int n, double slope, double intercept, double speed) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-4.0, 4.0), mass(0.5, 2.0);
  std::normal_distribution<double> v(0.0, speed);
  std::vector<Particle> particles;
  for (int i = 0; i < n; i++) {
    const double y = place(random);
    particles.push_back(
        {mass(random), y, {intercept + slope * y + v(random), v(random), v(random)}});
  }
  return particles;
}

MeanProfile fit_of(const std::vector<Particle>& particles) {
  ProfileSums sums;
  for (const Particle& p : particles) sums.add(p.mass, p.y, p.v);
  return fit(sums);
}

}  // namespace

TEST(MeanProfile, FindsALineExactly) {
  const MeanProfile p = fit_of(gas(500, 0.7, -1.5, 0.0));
  // Sums of 500 terms up to 2*4*4 each: 500 roundings of a sum below 500*32, over the spread.
  EXPECT_NEAR(p.slope, 0.7, 500 * eps * 20);
  EXPECT_NEAR(p.intercept, -1.5, 500 * eps * 20);
  for (const double f : p.fluctuation) EXPECT_NEAR(f, 0.0, 500 * eps * 50);
}

TEST(MeanProfile, LeavesResidualsThatNoOtherLineMakesSmaller) {
  const auto particles = gas(200, 0.7, -1.5, 1.0);
  const MeanProfile p = fit_of(particles);
  const auto square = [&](double slope, double intercept) {
    double sum = 0.0;
    for (const auto& q : particles) {
      const double away = q.v.x - intercept - slope * q.y;
      sum += q.mass * away * away;
    }
    return sum / p.mass;
  };
  const double least = square(p.slope, p.intercept);
  // 200 roundings of sums that are some ten times the result, which is about 1.
  EXPECT_NEAR(p.fluctuation[0], least, 200 * eps * 20);
  for (const double d : {-1e-3, 1e-3}) {
    EXPECT_GT(square(p.slope + d, p.intercept), least);
    EXPECT_GT(square(p.slope, p.intercept + d), least);
  }
}

TEST(MeanProfile, GivesTheFluctuationsOfADirectSum) {
  const auto particles = gas(200, -0.3, 0.2, 1.0);
  const MeanProfile p = fit_of(particles);
  double mean_y = 0.0, mean_z = 0.0;
  for (const auto& q : particles) {
    mean_y += q.mass * q.v.y / p.mass;
    mean_z += q.mass * q.v.z / p.mass;
  }
  std::array<double, 6> direct{};
  for (const auto& q : particles) {
    const double x = q.v.x - p.at(q.y), y = q.v.y - mean_y, z = q.v.z - mean_z;
    const double products[6] = {x * x, y * y, z * z, x * y, x * z, y * z};
    for (int k = 0; k < 6; k++) direct[k] += q.mass * products[k];
  }
  const auto stress = kinetic_stress(p, 25.0);
  // 200 roundings of sums that are some ten times the result.
  for (int k = 0; k < 6; k++) {
    EXPECT_NEAR(p.fluctuation[k], direct[k] / p.mass, 200 * eps * 20);
    EXPECT_NEAR(stress[k], direct[k] / 25.0, 200 * eps * 20 * p.mass / 25.0);
  }
  const double t = (direct[0] + direct[1] + direct[2]) / p.mass / 3.0;
  EXPECT_NEAR(granular_temperature(p, 3), t, 200 * eps * 20);
  EXPECT_NEAR(granular_temperature(p, 2), (direct[0] + direct[1]) / p.mass / 2.0, 200 * eps * 20);
}

TEST(MeanProfile, OfNothingOrOneHeightHasNoSlope) {
  EXPECT_EQ(fit(ProfileSums()).mass, 0.0);
  EXPECT_EQ(fit(ProfileSums()).fluctuation[0], 0.0);
  ProfileSums sums;
  sums.add(1.0, 3.1, {1.0, 0.0, 0.0});
  sums.add(1.0, 3.1, {3.0, 0.0, 0.0});
  EXPECT_EQ(fit(sums).slope, 0.0);
  EXPECT_EQ(fit(sums).intercept, 2.0);
  EXPECT_EQ(fit(sums).fluctuation[0], 1.0);
}

TEST(Layers, SlipIsTheRootMeanSquareOfWhatALineCannotFollow) {
  // Layers at -3, -1, 1, 3 with velocities 1, -1, -1, 1: no slope, mean 0, all of it is slip.
  Layers layers(4, 8.0);
  ProfileSums sums;
  for (const auto& [y, u] :
       {std::pair{-3.0, 1.0}, std::pair{-1.0, -1.0}, std::pair{1.0, -1.0}, std::pair{3.0, 1.0}}) {
    layers.add(2.0, y, u);
    sums.add(2.0, y, {u, 0.0, 0.0});
  }
  EXPECT_EQ(layers.slip(fit(sums)), 1.0);
  EXPECT_EQ(layers.mean_velocity(1), -1.0);
  EXPECT_EQ(layers.mean_position(3), 3.0);
  EXPECT_EQ(layers.mass(0), 2.0);
  EXPECT_EQ(Layers(3, 1.0).slip(fit(sums)), 0.0);
}

TEST(Layers, TakeParticlesAtTheEdgesOfTheBox) {
  Layers layers(5, 1.0);
  layers.add(1.0, -0.5, 0.0);
  layers.add(1.0, 0.5, 0.0);
  EXPECT_EQ(layers.mass(0), 1.0);
  EXPECT_EQ(layers.mass(4), 1.0);
}

}  // namespace cohesion::shear
