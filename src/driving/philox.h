// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "constants.h"
#include "vector3.h"

/// Random numbers that are a function of what they are for: no state, so that they are the same on
/// any number of processes, in any order, and after a restart.
namespace cohesion::driving {

/// Four random words of 32 bits for a counter and a key, Philox4x32-10: J. K. Salmon et al.,
/// Parallel random numbers: as easy as 1, 2, 3, SC 2011.
inline std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                           std::array<std::uint32_t, 2> key) {
  constexpr int rounds = 10;
  for (int round = 0; round < rounds; round++) {
    const std::uint64_t a = std::uint64_t{0xD2511F53} * counter[0];
    const std::uint64_t b = std::uint64_t{0xCD9E8D57} * counter[2];
    const auto high = [](std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32); };
    const auto low = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
    counter = {high(b) ^ counter[1] ^ key[0], low(b), high(a) ^ counter[3] ^ key[1], low(a)};
    key[0] += 0x9E3779B9;
    key[1] += 0xBB67AE85;
  }
  return counter;
}

/// Three independent normal deviates of the variance 1, of a particle in a step; Box and Muller's.
inline Vector3 normal_deviates(std::uint32_t seed, std::uint64_t step, std::uint64_t particle) {
  const auto of = [](std::uint64_t word, int half) {
    return static_cast<std::uint32_t>(word >> (32 * half));
  };
  const auto drawn = [&](std::uint32_t set) {
    return philox({of(particle, 0), of(particle, 1), of(step, 0), of(step, 1)}, {seed, set});
  };
  const auto first = drawn(0), second = drawn(1);
  const auto pair = [](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    // 53 bits, in (0, 1]
    const auto uniform = [](std::uint32_t x, std::uint32_t y) {
      return (static_cast<double>((std::uint64_t{x} << 21) ^ (y >> 11)) + 1.0) * 0x1p-53;
    };
    const double r = std::sqrt(-2.0 * std::log(uniform(a, b)));
    const double angle = 2.0 * pi * uniform(c, d);
    return std::array{r * std::cos(angle), r * std::sin(angle)};
  };
  const auto xy = pair(first[0], first[1], first[2], first[3]);
  const auto z = pair(second[0], second[1], second[2], second[3]);
  return {xy[0], xy[1], z[0]};
}

}  // namespace cohesion::driving
