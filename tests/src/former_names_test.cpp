// SPDX-License-Identifier: BSD-3-Clause
#include "former_names.h"

#include <gtest/gtest.h>

#include <vector>

#include "cohesion_version.h"

namespace cohesion {

namespace {

/// A version as numbers, which compare in order.
std::vector<int> version(std::string_view text) {
  std::vector<int> numbers{0};
  for (const char letter : text)
    if (letter == '.')
      numbers.push_back(0);
    else
      numbers.back() = 10 * numbers.back() + (letter - '0');
  return numbers;
}

}  // namespace

TEST(FormerNames, AreReplacedWithASentence) {
  std::vector<std::string> sentences;
  const auto warn = [&](const std::string& sentence) { sentences.push_back(sentence); };
  for (const FormerName& row : former_names) {
    sentences.clear();
    EXPECT_EQ(current_name(row.what, row.name, warn), row.now);
    ASSERT_EQ(sentences.size(), 1u);
    for (const std::string_view part : {row.what, row.name, row.now, row.refused_from})
      EXPECT_NE(sentences.front().find(part), std::string::npos) << sentences.front();
  }
}

TEST(FormerNames, OfSchemes) {
  std::string told;
  const auto warn = [&](const std::string& sentence) { told = sentence; };
  EXPECT_EQ(current_name("scheme", "event", warn), "exact");
  EXPECT_EQ(told,
            "scheme 'event' is now called 'exact'; write 'exact', since from version 0.4.0 on the "
            "old word stops the run");
}

TEST(FormerNames, OtherNamesStayWithoutASentence) {
  const auto warn = [](const std::string& sentence) { ADD_FAILURE() << sentence; };
  EXPECT_EQ(current_name("scheme", "exact", warn), "exact");
  EXPECT_EQ(current_name("scheme", "sometimes", warn), "sometimes");
  EXPECT_EQ(current_name("form", "event", warn), "event");  // a name of another table
}

TEST(FormerNames, NoneReplacesAnother) {
  const auto warn = [](const std::string& sentence) { ADD_FAILURE() << sentence; };
  for (const FormerName& row : former_names)
    EXPECT_EQ(current_name(row.what, row.now, warn), row.now);
}

// docs/deprecation.md
TEST(FormerNames, AreGoneInTheVersionThatRefusesThem) {
  for (const FormerName& row : former_names)
    EXPECT_LT(version(COHESION_VERSION), version(row.refused_from)) << row.name;
}

}  // namespace cohesion
