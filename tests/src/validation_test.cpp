// SPDX-License-Identifier: BSD-3-Clause
#include "validation.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "expect_invalid.h"

namespace {

using namespace cohesion;
using namespace cohesion::test;

TEST(Validation, PassesWhatIsRight) {
  EXPECT_NO_THROW(require(true, "x", 1.0, "remedy"));
  EXPECT_NO_THROW(require_positive("x", 1e-300));
  EXPECT_NO_THROW(require_non_negative("x", 0.0));
}

TEST(Validation, MessageHoldsNameValueAndRemedy) {
  expect_invalid([] { require(false, "width w", -2.5, "must be less"); },
                 "width w = -2.5: must be less");
  expect_invalid([] { require_positive("x", not_a_number); },
                 "x = nan: must be a finite number greater");
  expect_invalid([] { require_non_negative("x", infinity); }, "x = inf: must be a finite number");
}

TEST(Validation, RefusesWhatIsNotAFiniteNumberOfTheRightSign) {
  for (const double bad : never_right) {
    expect_invalid([&] { require_positive("x", bad); }, "x = ");
    expect_invalid([&] { require_non_negative("x", bad); }, "x = ");
  }
  expect_invalid([] { require_positive("x", 0.0); }, "x = 0");
}

TEST(Validation, ErrorIsAnInvalidArgument) {
  EXPECT_THROW(require_positive("x", -1.0), std::invalid_argument);
}

}  // namespace
