// SPDX-License-Identifier: BSD-3-Clause
#include "advice/warning_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "advice/thesis_pair.h"

namespace cohesion::advice {
namespace {

AdvisedContact pair(const std::string& name = "1 - 1") {
  const PairParameters p = thesis_pair();
  return {
      name, {p.radius_i, p.mass_i}, {p.radius_j, p.mass_j}, {p.stiffness, p.damping}, p.adhesion};
}

constexpr double DT = 1e-6;  // far above 15 steps per contact: only the cut-off is missed

/// What is new of these contacts.
class GivenAdviceTest : public ::testing::Test {
 protected:
  Report news(const std::vector<AdvisedContact>& contacts, double dt, double speed,
              bool within_run = false) {
    const RunConditions now{{}, {speed, 0.0, dt}, within_run};
    return given.only_new(report("a style", sampled_scheme, contacts, now.run), contacts, now);
  }
  void expect_nothing(const Report& r) {
    EXPECT_EQ(r.table, "");
    EXPECT_TRUE(r.warnings.empty());
  }

  WarningFilter given;
};

}  // namespace

TEST_F(GivenAdviceTest, TheSameIsNotSaidAgain) {
  const Report first = news({pair()}, DT, 0.1);
  EXPECT_NE(first.table, "");
  EXPECT_EQ(first.warnings.size(), 2u);  // cut-off, spring too soft
  expect_nothing(news({pair()}, DT, 0.1));
}

TEST_F(GivenAdviceTest, NothingIsSaidOfNoContacts) { expect_nothing(news({}, DT, 0.1)); }

TEST_F(GivenAdviceTest, SpeedsThatVaryAreNotNews) {
  news({pair()}, DT, 0.1);
  expect_nothing(news({pair()}, DT, 0.2));
  expect_nothing(news({pair()}, DT, 0.01));
  EXPECT_NE(news({pair()}, DT, 1.1).table, "");  // more than ten times the first
  expect_nothing(news({pair()}, DT, 1.1));
}

TEST_F(GivenAdviceTest, AWarningThatTheSpeedBringsComesWithTheTableAndOnce) {
  news({pair()}, DT, 0.1);
  // An impact that presses more than 1 % of the diameter.
  const Report fast = news({pair()}, DT, 0.9);
  ASSERT_EQ(fast.warnings.size(), 1u);
  EXPECT_EQ(fast.warnings[0].subject, Subject::impact_overlap);
  EXPECT_NE(fast.table, "");
  expect_nothing(news({pair()}, DT, 0.1));
  expect_nothing(news({pair()}, DT, 0.9));
}

TEST_F(GivenAdviceTest, AnotherStepIsToldButWhatItDoesNotChangeIsNot) {
  news({pair()}, DT, 0.1);
  const Report longer = news({pair()}, 2 * DT, 0.1);
  EXPECT_NE(longer.table, "");
  ASSERT_EQ(longer.warnings.size(), 1u);
  EXPECT_EQ(longer.warnings[0].subject, Subject::cutoff_steps);
}

TEST_F(GivenAdviceTest, ALittleBetterIsNotNews) {
  const auto larger = [](double factor) {
    AdvisedContact c = pair();
    c.i = {factor * c.i.radius, factor * c.i.mass};
    c.j = {factor * c.j.radius, factor * c.j.mass};
    c.springs.damping *= std::sqrt(factor);
    c.adhesion.force *= factor;
    c.adhesion.tail_energy *= factor;
    return c;
  };
  news({pair()}, DT, 0.1);
  expect_nothing(news({larger(1.9)}, DT, 0.1));
  expect_nothing(news({larger(1.9)}, DT / 1.9, 0.1));
  EXPECT_NE(news({larger(0.99)}, DT, 0.1).table, "");
  EXPECT_NE(news({larger(2.1)}, DT, 0.1).table, "");
  EXPECT_NE(news({larger(2.1)}, DT / 2.1, 0.1).table, "");
  AdvisedContact stronger = larger(2.1);
  stronger.adhesion.force *= 1.01;
  EXPECT_NE(news({stronger}, DT / 2.1, 0.1).table, "");
}

TEST_F(GivenAdviceTest, WithinARunOnlyWarningsAndContactsAreNews) {
  news({pair()}, DT, 0.1);
  expect_nothing(news({pair()}, 2 * DT, 0.1, true));
  const Report few = news({pair()}, 10 * DT, 0.1, true);  // 9.25 steps per contact
  ASSERT_EQ(few.warnings.size(), 1u);
  EXPECT_EQ(few.warnings[0].subject, Subject::contact_steps);
  EXPECT_EQ(few.table, "");
  const Report more = news({pair(), pair("1 - 2")}, 10 * DT, 0.1, true);
  EXPECT_NE(more.table.find("1 - 2"), std::string::npos);
  for (const Warning& warning : more.warnings) EXPECT_EQ(warning.contacts.back(), "1 - 2");
}

TEST_F(GivenAdviceTest, AReasonToStopIsAlwaysSaid) {
  for (int k = 0; k < 2; k++) EXPECT_NE(news({pair()}, 1e-3, 0.1, k == 1).stop, "");
}

TEST_F(GivenAdviceTest, ASpringOfAPowerIsTheSameAtEveryOverlap) {
  AdvisedContact hertz = pair();
  hertz.springs.exponent = 1.5;
  hertz.springs.overlap = 1e-7;
  news({hertz}, DT, 0.1);
  hertz.springs.overlap *= 4.0;  // F/x goes as its root
  hertz.springs.stiffness *= 2.0;
  expect_nothing(news({hertz}, DT, 0.1));
  hertz.springs.stiffness *= 2.0;
  EXPECT_NE(news({hertz}, DT, 0.1).table, "");
}

TEST(ChangeDetector, SeesLighterSmallerAndFasterParticlesAndLongerSteps) {
  constexpr double none = std::numeric_limits<double>::infinity();
  ChangeDetector watch;
  const std::vector<LightestParticle> usual{{none, none}, {1.0, 1.0}, {none, none}};
  EXPECT_TRUE(watch.worse(usual, {0.0, 0.0, 1.0}));
  watch.judged(usual, {1.0, 0.0, 1.0});
  EXPECT_FALSE(watch.worse(usual, {2.0, 0.0, 1.0}));
  EXPECT_FALSE(watch.worse({{none, none}, {2.0, 2.0}, {none, none}}, {0.0, 0.0, 0.5}));
  EXPECT_TRUE(watch.worse(usual, {2.1, 0.0, 1.0}));
  EXPECT_TRUE(watch.worse(usual, {1.0, 0.0, 1.1}));
  EXPECT_FALSE(watch.worse({{none, none}, {0.9995, 0.9995}, {none, none}}, {1.0, 0.0, 1.0005}));
  EXPECT_TRUE(watch.worse({{none, none}, {0.998, 1.0}, {none, none}}, {1.0, 0.0, 1.0}));
  EXPECT_TRUE(watch.worse(usual, {1.0, 0.0, 1.002}));
  EXPECT_TRUE(watch.worse({{none, none}, {1.0, 0.9}, {none, none}}, {1.0, 0.0, 1.0}));
  EXPECT_TRUE(watch.worse({{none, none}, {0.9, 1.0}, {none, none}}, {1.0, 0.0, 1.0}));
  EXPECT_TRUE(watch.worse({{none, none}, {1.0, 1.0}, {5.0, none}}, {1.0, 0.0, 1.0}));
}

TEST(ChangeDetector, SeesThatParticlesHaveMoreNeighbours) {
  ChangeDetector watch;
  const auto run = [](Crowd crowd) { return RunNumbers{1.0, 0.0, 1.0, 0.0, crowd}; };
  watch.judged({}, run(Crowd::separate));
  EXPECT_FALSE(watch.worse({}, run(Crowd::pair)));
  EXPECT_FALSE(watch.worse({}, run(Crowd::separate)));
  EXPECT_TRUE(watch.worse({}, run(Crowd::several)));
}

TEST(ChangeDetector, LooksWhereListStepOrParticlesMayBeOthers) {
  ChangeDetector watch;
  watch.set_up({10});
  watch.judged({}, {0.0, 0.0, 1.0});
  EXPECT_FALSE(watch.may_differ(false, 5, 1.0));
  EXPECT_TRUE(watch.may_differ(true, 5, 1.0));
  EXPECT_TRUE(watch.may_differ(false, 5, 1.1));
  EXPECT_FALSE(watch.may_differ(false, 5, 1.0005));
  EXPECT_TRUE(watch.may_differ(false, 10, 1.0));
  EXPECT_TRUE(watch.may_differ(false, 11, 1.0));
  watch.forget();
  EXPECT_TRUE(watch.may_differ(false, 5, 1.0));
}

}  // namespace cohesion::advice
