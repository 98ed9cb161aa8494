// SPDX-License-Identifier: BSD-3-Clause
#include "driving/drive.h"

#include <gtest/gtest.h>

#include <vector>

#include "driving/philox.h"

namespace cohesion::driving {
namespace {

struct Particle {
  double mass;
  Vector3 v, w;
};

/// Of unequal masses, with a common velocity and random motion.
std::vector<Particle> gas(int count, int dimensions, double spread = 1.0) {
  std::vector<Particle> all;
  for (int i = 0; i < count; i++) {
    const auto id = static_cast<std::uint64_t>(i);
    Vector3 v = spread * normal_deviates(1, 0, id), w = normal_deviates(2, 0, id);
    if (dimensions == 2) v.z = w.z = 0.0;
    v += {3.0, -2.0, 0.0};
    all.push_back({0.5 + 0.1 * (i % 7), v, w});
  }
  return all;
}

Sums::Values sums_of(const std::vector<Particle>& all) {
  Sums::Values sums{};
  for (const Particle& p : all) {
    const auto own = Sums::of(p.mass, p.v, p.w);
    for (int k = 0; k < Sums::count; k++) sums[k] += own[k];
  }
  return sums;
}

double kinetic(const std::vector<Particle>& all) { return 0.5 * sums_of(all)[Sums::energy]; }

void act(std::vector<Particle>& all, const VelocityChange& action) {
  for (Particle& p : all) p.v += action.change(p.v, p.w);
}

/// Rounding of the sums: 1000 numbers of the order of 10.
constexpr double rounding = 1e-11;

}  // namespace

TEST(Philox, IsThatOfItsAuthors) {
  // The known answers of Random123, kat_vectors.
  using Words = std::array<std::uint32_t, 4>;
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(NormalDeviates, HaveTheMomentsOfIndependentNormalOnes) {
  // Of n draws the mean is known to 1/sqrt(n), the square to sqrt(2/n), the fourth power to
  // sqrt(96/n), a product to 1/sqrt(n): five of these.
  const int n = 100000;
  Vector3 mean;
  double square[3] = {}, fourth[3] = {}, product[3] = {}, next = 0.0, other_step = 0.0;
  for (int i = 0; i < n; i++) {
    const auto id = static_cast<std::uint64_t>(i);
    const Vector3 w = normal_deviates(7, 11, id);
    mean += w;
    const double c[3] = {w.x, w.y, w.z};
    for (int k = 0; k < 3; k++) {
      square[k] += c[k] * c[k];
      fourth[k] += c[k] * c[k] * c[k] * c[k];
      product[k] += c[k] * c[(k + 1) % 3];
    }
    next += w.x * normal_deviates(7, 11, id + 1).x;
    other_step += w.x * normal_deviates(7, 12, id).x;
  }
  const double unit = 5.0 / std::sqrt(n);
  for (const double m :
       {mean.x, mean.y, mean.z, product[0], product[1], product[2], next, other_step})
    EXPECT_NEAR(m / n, 0.0, unit);
  for (int k = 0; k < 3; k++) {
    EXPECT_NEAR(square[k] / n, 1.0, unit * std::sqrt(2.0));
    EXPECT_NEAR(fourth[k] / n, 3.0, unit * std::sqrt(96.0));
  }
}

TEST(Drive, RescalesToTheTemperatureAndKeepsMomentum) {
  for (const int dimensions : {2, 3})
    for (const double T : {0.5, 1.7}) {
      auto all = gas(1000, dimensions);
      const auto before = sums_of(all);
      const double energy = kinetic(all);
      const VelocityChange action = rescaled(before, T, dimensions);
      EXPECT_EQ(action.temperature, temperature_of(before, dimensions));
      act(all, action);
      const auto after = sums_of(all);
      EXPECT_NEAR(temperature_of(after, dimensions), T, rounding);
      for (int k = 0; k < 3; k++)
        EXPECT_NEAR(after[Sums::momentum + k], before[Sums::momentum + k], 1e3 * rounding);
      EXPECT_NEAR(kinetic(all) - energy, action.energy, 1e3 * rounding);
    }
}

TEST(Drive, TemperatureIsTheMeanSquareAboutTheMeanVelocity) {
  const std::vector<Particle> two{{1.0, {1.0, 0.0, 0.0}, {}}, {3.0, {-1.0, 2.0, 0.0}, {}}};
  // mean (-0.5, 1.5, 0); m v'.v' = 1 (1.5^2 + 1.5^2) + 3 (0.5^2 + 0.5^2) = 6, over d times 4
  EXPECT_DOUBLE_EQ(temperature_of(sums_of(two), 3), 0.5);
  EXPECT_DOUBLE_EQ(temperature_of(sums_of(two), 2), 0.75);
  EXPECT_EQ(temperature_of(Sums::Values{}, 3), 0.0);
}

TEST(Drive, KicksUpToTheTemperatureAndKeepsMomentum) {
  for (const int dimensions : {2, 3}) {
    auto all = gas(1000, dimensions, 0.9);
    const auto before = sums_of(all);
    const double T = 1.01 * temperature_of(before, dimensions), energy = kinetic(all);
    const VelocityChange action = kicked(before, T, dimensions);
    EXPECT_GT(action.strength, 0.0);
    act(all, action);
    const auto after = sums_of(all);
    EXPECT_NEAR(temperature_of(after, dimensions), T, rounding);
    for (int k = 0; k < 3; k++)
      EXPECT_NEAR(after[Sums::momentum + k], before[Sums::momentum + k], 1e3 * rounding);
    EXPECT_NEAR(kinetic(all) - energy, action.energy, 1e3 * rounding);
    EXPECT_NEAR(action.energy, 0.5 * dimensions * before[Sums::mass] * (T - action.temperature),
                1e3 * rounding);
    // Kicks have nothing of the motion that is there: their own energy is all that is put in.
    double kicks = 0.0;
    const auto start = gas(1000, dimensions, 0.9);
    for (std::size_t i = 0; i < all.size(); i++) {
      const Vector3 kick = all[i].v - start[i].v;
      kicks += 0.5 * all[i].mass * dot(kick, kick);
    }
    EXPECT_NEAR(kicks, action.energy, 1e3 * rounding);
  }
}

TEST(Drive, KicksNothingThatIsHotEnough) {
  const auto all = gas(100, 3);
  const auto sums = sums_of(all);
  const double found = temperature_of(sums, 3);
  for (const double T : {0.5 * found, found, found * (1 + 1e-15)}) {
    const VelocityChange action = kicked(sums, T, 3);
    EXPECT_EQ(action.energy, 0.0);
    EXPECT_EQ(norm(action.change(all[0].v, all[0].w)), 0.0);
  }
}

TEST(Drive, KicksParticlesAtRest) {
  auto all = gas(100, 3, 0.0);
  act(all, kicked(sums_of(all), 2.0, 3));
  EXPECT_NEAR(temperature_of(sums_of(all), 3), 2.0, rounding);
}

TEST(Drive, LeavesWhatCannotBeDriven) {
  // Particles at rest cannot be scaled; one alone has its own mean velocity.
  auto still = gas(100, 3, 0.0);
  for (Particle& p : still) p.v = {};
  EXPECT_EQ(rescaled(sums_of(still), 1.0, 3).scale, 0.0);
  const auto one = gas(1, 3);
  EXPECT_EQ(kicked(sums_of(one), 1.0, 3).energy, 0.0);
  EXPECT_EQ(norm(kicked(sums_of(one), 1.0, 3).change(one[0].v, one[0].w)), 0.0);
  EXPECT_EQ(kicked(Sums::Values{}, 1.0, 3).energy, 0.0);
}

}  // namespace cohesion::driving
