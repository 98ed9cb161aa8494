// SPDX-License-Identifier: BSD-3-Clause
#include "nearest_name.h"

#include <gtest/gtest.h>

#include <array>

namespace cohesion {

TEST(NearestName, CountsLettersThatDiffer) {
  EXPECT_EQ(letters_apart("", ""), 0);
  EXPECT_EQ(letters_apart("drag", "drag"), 0);
  EXPECT_EQ(letters_apart("dragfactor", "dragFactor"), 0);
  EXPECT_EQ(letters_apart("drug", "drag"), 1);
  EXPECT_EQ(letters_apart("drags", "drag"), 1);
  EXPECT_EQ(letters_apart("dag", "drag"), 1);
  EXPECT_EQ(letters_apart("", "drag"), 4);
  EXPECT_EQ(letters_apart("from", "form"), 2);
  // The textbooks' pairs
  EXPECT_EQ(letters_apart("kitten", "sitting"), 3);
  EXPECT_EQ(letters_apart("intention", "execution"), 5);
}

TEST(NearestName, IsTheSameBothWays) {
  const std::array words{"slip", "script", "smoothingWidth", "voidFraction", "", "minVoidFraction"};
  for (const char* one : words)
    for (const char* other : words)
      EXPECT_EQ(letters_apart(one, other), letters_apart(other, one)) << one << ' ' << other;
}

TEST(NearestName, FindsWhatWasMeant) {
  struct Row {
    std::string_view name;
  };
  const std::array table{Row{"drag"}, Row{"dragFactor"}, Row{"dragExponent"}, Row{"depth"}};
  EXPECT_EQ(nearest_name(table, "dragfaktor"), "dragFactor");
  EXPECT_EQ(nearest_name(table, "DRAG"), "drag");
  EXPECT_EQ(nearest_name(table, "exponent"), "dragExponent");
  EXPECT_EQ(nearest_name(table, "width"), "depth");
}

}  // namespace cohesion
