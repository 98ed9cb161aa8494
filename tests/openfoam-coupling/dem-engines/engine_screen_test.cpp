// SPDX-License-Identifier: BSD-3-Clause
#include "dem-engines/engine_screen.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace {

using cohesion::coupling::EngineScreen;
using cohesion::coupling::MessageLevel;
using Messages = std::vector<std::pair<MessageLevel, std::string>>;

class Screen : public ::testing::Test {
 protected:
  ~Screen() override { std::fclose(screen_.stream()); }

  void print(const std::string& text) { std::fputs(text.c_str(), screen_.stream()); }

  Messages messages_;
  EngineScreen screen_{
      [this](MessageLevel level, const std::string& text) { messages_.emplace_back(level, text); }};
};

TEST_F(Screen, PassesOnNothingButErrorsAndWarnings) {
  print("LAMMPS (29 Sep 2021)\n");
  print("variable text string 'no ERROR here, and no WARNING'\n");
  EXPECT_TRUE(messages_.empty());
  EXPECT_FALSE(screen_.has_shown_error());
}

TEST_F(Screen, PassesOnAMessageWithAllItsLinesBeforeAnythingIsFlushed) {
  std::fprintf(screen_.stream(), "ERROR: %s (%s:%d)\nLast command: %s\n", "Illegal", "input.cpp", 7,
               "fix");
  EXPECT_EQ(messages_,
            (Messages{{MessageLevel::error, "ERROR: Illegal (input.cpp:7)\nLast command: fix"}}));
  EXPECT_TRUE(screen_.has_shown_error());
}

TEST_F(Screen, LeavesOutWhatStandsBeforeTheMessage) {
  print("\nStep Temp\nWARNING: \n\tof two lines (a.h:3)\n\n");
  EXPECT_EQ(messages_, (Messages{{MessageLevel::warning, "WARNING: \n\tof two lines (a.h:3)"}}));
}

TEST_F(Screen, PassesOnAWarningOnceAndAnErrorAlways) {
  for (int k = 0; k < 2; ++k) print("WARNING: one (a.cpp:1)\n");
  print("WARNING: two (a.cpp:1)\n");
  for (int k = 0; k < 2; ++k) print("ERROR on proc 1: lost (a.cpp:1)\n");
  ASSERT_EQ(messages_.size(), 4u);
  EXPECT_EQ(messages_[1].second, "WARNING: two (a.cpp:1)");
  EXPECT_EQ(messages_[2], messages_[3]);
}

TEST_F(Screen, SaysThatThereAreMoreThanAHundredWarningsAndNoMoreOfThem) {
  for (int k = 0; k < 300; ++k) print("WARNING: lost " + std::to_string(k) + "\n");
  ASSERT_EQ(messages_.size(), 101u);
  EXPECT_EQ(messages_[99].second, "WARNING: lost 99");
  EXPECT_EQ(messages_[100].second.rfind("more than 100 different warnings", 0), 0u);
}

TEST_F(Screen, IsTheStandardOutputForAsLongAsItIsAskedTo) {
  FILE* const before = stdout;
  {
    const EngineScreen::AsStandardOutput output(screen_);
    EXPECT_EQ(stdout, screen_.stream());
  }
  EXPECT_EQ(stdout, before);
}

}  // namespace
