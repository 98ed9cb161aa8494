// SPDX-License-Identifier: BSD-3-Clause
#include "advice/contact_advice.h"

#include "advice/thesis_pair.h"
#include "refuses.h"

namespace cohesion::advice {
namespace {

const Finding* find(const std::vector<Finding>& findings, Subject subject) {
  for (const Finding& v : findings)
    if (v.subject == subject) return &v;
  return nullptr;
}

void expect_nothing(const PairParameters& p, const SchemeLimits& limits, Subject subject) {
  const auto findings = advise(ContactNumbers(p), limits);
  const Finding* found = find(findings, subject);
  EXPECT_EQ(found, nullptr) << found->sentence;
}

/// The finding on `subject`, which must be there; a sentence with `part`.
void expect_verdict(const PairParameters& p, const SchemeLimits& limits, Subject subject,
                    Severity severity, const std::string& part) {
  const auto findings = advise(ContactNumbers(p), limits);
  const Finding* found = find(findings, subject);
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->severity, severity) << found->sentence;
  EXPECT_NE(found->sentence.find(part), std::string::npos) << found->sentence;
}

/// The thesis' pair at `steps` time steps per contact.
PairParameters at_steps(double steps) {
  PairParameters p = thesis_pair();
  p.dt = pi / ContactNumbers(p).frequency() / steps;
  return p;
}

PairParameters without_adhesion() {
  PairParameters p = thesis_pair();
  p.adhesion = {0.0, 0.0, 0.0};
  return p;
}

}  // namespace

TEST(ContactAdvice, StepsPerContactAreJudgedByTheScheme) {
  const auto subject = Subject::contact_steps;
  expect_nothing(at_steps(15.1), sampled_scheme, subject);
  // pi/(15 w0) = 6.167e-6 s, named so that it is small enough.
  expect_verdict(at_steps(14.9), sampled_scheme, subject, Severity::warning,
                 "reduce the time step to 6.16e-06");
  expect_nothing(at_steps(4.1), exact_scheme, subject);
  expect_verdict(at_steps(3.9), exact_scheme, subject, Severity::warning,
                 "exact scheme should have 4");
  expect_verdict(at_steps(0.9), exact_scheme, subject, Severity::error, "fewer than 1");
}

TEST(ContactAdvice, NamesNoStepBeyondThatOfParticlesWithSeveralContacts) {
  const ContactNumbers pair(at_steps(3.9));
  const double steady = 0.5 * pair.parameters().dt;
  const Finding found = advise(pair, exact_scheme, steady).front();
  EXPECT_EQ(found.subject, Subject::contact_steps);
  EXPECT_LE(found.largest_step, steady);
  EXPECT_GT(found.largest_step, 0.99 * steady);
}

TEST(ContactAdvice, NoLeastNumberOfStepsIsNamedWhereThereIsNone) {
  for (const Finding& v : advise(ContactNumbers(at_steps(10.0)), sampled_scheme))
    EXPECT_EQ(v.sentence.find("fewer than"), std::string::npos) << v.sentence;
}

TEST(ContactAdvice, UnstableLeapfrogIsAnErrorWhereTheForceIsSampled) {
  // pi/2 steps without dashpot; the thesis' zeta = 0.0168 asks for 1.7 % more.
  expect_nothing(at_steps(1.62), sampled_scheme, Subject::stability);
  expect_verdict(at_steps(1.58), sampled_scheme, Subject::stability, Severity::error, "unstable");
  PairParameters elastic = at_steps(1.58);
  elastic.damping = 0.0;
  expect_nothing(elastic, sampled_scheme, Subject::stability);
  expect_nothing(elastic, exact_scheme, Subject::stability);
}

TEST(ContactAdvice, SkippedCutoffIsAWarningWhereTheForceIsSampled) {
  PairParameters p = thesis_pair();
  // H_cut/u = 3.999e-9 s at 0.1 m/s and the gain on the way.
  expect_verdict(p, sampled_scheme, Subject::cutoff_steps, Severity::warning, "to 3.99e-09");
  expect_nothing(p, exact_scheme, Subject::cutoff_steps);
  p.dt = 3.9e-9;
  expect_nothing(p, sampled_scheme, Subject::cutoff_steps);
}

TEST(ContactAdvice, EscapeVelocityThatADashpotLeavesOpenIsAWarningWhereTheForceIsSampled) {
  const auto subject = Subject::escape_velocity;
  // e = 0.5: zeta = 0.2154, at 20 steps 2 zeta w0 dt/(1 - e^2) = 0.0902.
  PairParameters p = without_adhesion();
  const double mass = 0.5 * p.mass_i;
  p.damping =
      2.0 * std::log(2.0) * std::sqrt(mass * p.stiffness / (pi * pi + std::pow(std::log(2.0), 2)));
  p.dt = pi * std::sqrt(mass / p.stiffness) / 20.0;
  // v_esc = sqrt(3 * 2 W/mu): 0.0433 m/s.
  p.adhesion.tail_energy = 0.5 * mass * 0.025 * 0.025;
  p.speed = 0.05;
  expect_verdict(p, sampled_scheme, subject, Severity::warning, "0.0433, open by 9.02 %");
  expect_nothing(p, exact_scheme, subject);
  PairParameters slow = p;
  slow.speed = 0.45 * 0.0433;
  expect_nothing(slow, sampled_scheme, subject);
  p.dt *= 20.0 / 27.1;
  expect_nothing(p, sampled_scheme, subject);
}

TEST(ContactAdvice, EscapeVelocityIsOpenByAStepOfTheContactWithHardlyADashpot) {
  PairParameters p = at_steps(20.0);
  p.damping *= 1e-9;
  EXPECT_NEAR(ContactNumbers(p).sampled_escape_error(), 1.0 / 20.0, 1e-9);
  p.damping = 0.0;
  EXPECT_NEAR(ContactNumbers(p).sampled_escape_error(), 1.0 / 20.0, 1e-15);
}

TEST(ContactAdvice, WayOfARoundingInAStepIsAWarning) {
  PairParameters p = without_adhesion();
  p.dt = 1e-6;
  // pi/2 2^-52 1 mm/(u dt) = 1/15: 5.23e-12 m/s.
  p.speed = 5.3e-12;
  expect_nothing(p, sampled_scheme, Subject::rounding);
  p.speed = 5.1e-12;
  expect_verdict(p, sampled_scheme, Subject::rounding, Severity::warning, "6.84 %");
  // (pi/2 + 2) 2^-52 1 mm/(u dt) = 1/15: 1.189e-11 m/s.
  for (const SchemeLimits& scheme : {exact_scheme, exact_scheme_one_pass}) {
    p.speed = 1.2e-11;
    expect_nothing(p, scheme, Subject::rounding);
    p.speed = 1.18e-11;
    expect_verdict(p, scheme, Subject::rounding, Severity::warning, "6.72 %");
  }
  p.speed = 0.0;
  expect_nothing(p, sampled_scheme, Subject::rounding);
  expect_nothing(p, exact_scheme, Subject::rounding);
}

TEST(ContactAdvice, LargeOverlapIsAWarningAndAnErrorOnceItPassesWalls) {
  PairParameters p = without_adhesion();
  p.damping = 0.0;
  const double w0 = ContactNumbers(p).frequency();
  const auto speed_for = [=](double over_diameter) { return over_diameter * 1e-3 * w0; };
  p.speed = speed_for(0.0099);
  expect_nothing(p, exact_scheme, Subject::impact_overlap);
  p.speed = speed_for(0.1);
  // Ten times 1 %: a hundred times the stiffness, and a tenth of the step.
  expect_verdict(p, exact_scheme, Subject::impact_overlap, Severity::warning, "to about 8e+04");
  p.dt = 2e-6;
  expect_verdict(p, exact_scheme, Subject::impact_overlap, Severity::warning,
                 "lower the time step to 2e-07");
  p.is_linear = false;
  expect_verdict(p, exact_scheme, Subject::impact_overlap, Severity::warning,
                 "to up to 316 times its value; for as many steps per contact, lower the time step "
                 "to 2e-07");
  p.speed = speed_for(0.501);
  expect_verdict(p, exact_scheme, Subject::impact_overlap, Severity::error, "through walls");
}

TEST(ContactAdvice, LargeStaticOverlapNamesTheStiffness) {
  PairParameters p = thesis_pair();
  expect_nothing(p, exact_scheme, Subject::static_overlap);
  p.adhesion.force = 800.0 * 2e-5;  // K times 2 % of d
  expect_verdict(p, exact_scheme, Subject::static_overlap, Severity::warning, "to about 1.6e+03");
}

TEST(ContactAdvice, APairWithoutAdhesionAtEnoughStepsIsGood) {
  PairParameters p = without_adhesion();
  p.dt = 1e-6;
  EXPECT_TRUE(advise(ContactNumbers(p), sampled_scheme).empty());
}

}  // namespace cohesion::advice
