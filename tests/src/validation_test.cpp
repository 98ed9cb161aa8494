// SPDX-License-Identifier: BSD-3-Clause
#include "validation.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "refuses.h"

namespace {

using namespace cohesion;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Validation, PassesWhatIsRight) {
  EXPECT_NO_THROW(require(true, "x", 1.0, "remedy"));
  EXPECT_NO_THROW(require_positive("x", 1e-300));
  EXPECT_NO_THROW(require_non_negative("x", 0.0));
}

TEST(Validation, MessageHoldsNameValueAndRemedy) {
  expect_refused([] { require(false, "width w", -2.5, "must be less"); },
                 "width w = -2.5: must be less");
  expect_refused([] { require_positive("x", not_a_number); },
                 "x = nan: must be a finite number greater");
  expect_refused([] { require_non_negative("x", infinity); }, "x = inf: must be a finite number");
}

TEST(Validation, RefusesWhatIsNotAFiniteNumberOfTheRightSign) {
  for (const double bad : {not_a_number, infinity, -infinity, -1e-3}) {
    expect_refused([&] { require_positive("x", bad); }, "x = ");
    expect_refused([&] { require_non_negative("x", bad); }, "x = ");
  }
  expect_refused([] { require_positive("x", 0.0); }, "x = 0");
}

TEST(Validation, ErrorIsAnInvalidArgument) {
  EXPECT_THROW(require_positive("x", -1.0), std::invalid_argument);
}

}  // namespace
