// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "validation.h"

namespace cohesion::test {

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// What no physical parameter may be; zero is left to the caller.
inline const std::vector<double> never_right{not_a_number, infinity, -infinity, -1e-3};

/// `build` throws InvalidParameter whose message holds `named`.
template <class Build>
void expect_invalid(Build build, const std::string& named) {
  try {
    build();
    ADD_FAILURE() << "accepted, although '" << named << "' cannot be right";
  } catch (const InvalidParameter& bad) {
    EXPECT_NE(std::string(bad.what()).find(named), std::string::npos)
        << "the message does not name '" << named << "': " << bad.what();
  }
}

}  // namespace cohesion::test
