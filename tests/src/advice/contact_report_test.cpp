// SPDX-License-Identifier: BSD-3-Clause
#include "advice/contact_report.h"

#include <gtest/gtest.h>

#include <limits>

#include "advice/thesis_pair.h"
#include "hamaker/law.h"
#include "hamaker/small_gap.h"

namespace cohesion::advice {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

AdvisedContact pair() {
  const PairParameters p = thesis_pair();
  return {"1 - 1",
          {p.radius_i, p.mass_i},
          {p.radius_j, p.mass_j},
          {p.stiffness, p.damping},
          p.adhesion};
}

RunNumbers run() { return {0.1, 9.81, 2.25e-5}; }

}  // namespace

TEST(ContactReport, RowHasTheNumbersOfTheContact) {
  const Report r = report("a style", sampled_scheme, {pair()}, run());
  const ContactNumbers n = numbers(pair(), run());
  EXPECT_NE(r.table.find("a style, scheme sampled: what to expect"), std::string::npos) << r.table;
  EXPECT_NE(r.table.find("\n  1 - 1          0.14"), std::string::npos) << r.table;
  EXPECT_NE(r.table.find(detail::number("%.4g", n.steps_per_contact())), std::string::npos);
  EXPECT_NE(r.table.find(detail::number("%.3g", n.escape_velocity())), std::string::npos);
  EXPECT_NE(r.table.find(detail::number("%.3g", n.well_energy() / n.spring_adhesion_energy())),
            std::string::npos);
  EXPECT_EQ(r.stop, "");
}

TEST(ContactReport, WarnsAndStopsWithTheNameOfTheContact) {
  const Report r = report("a style", sampled_scheme, {pair()}, run());
  ASSERT_EQ(r.warnings.size(), 3u);  // steps, cut-off, spring too soft
  for (const Warning& warning : r.warnings) {
    EXPECT_EQ(warning.contacts, std::vector<std::string>{"1 - 1"});
    EXPECT_EQ(warning.text.find("a style, 1 - 1: "), 0u);
  }
  RunNumbers large = run();
  large.dt = 1e-3;
  EXPECT_EQ(report("a style", sampled_scheme, {pair()}, large).stop.find("a style, 1 - 1: "), 0u);
}

TEST(ContactReport, StepsBeyondTheSteadyOneStopWhereAParticleHasSeveralContacts) {
  AdvisedContact damped = pair();
  damped.adhesion = {};
  damped.springs.damping =
      contact::LinearSpringDashpot::from_restitution(800.0, 0.5, damped.reduced_mass()).damping();
  // The limit is 4.3 contact times of the undamped spring, 9.25e-5 s.
  RunNumbers numbers{0.1, 0.0, 9.25e-5 / 4.2};
  const auto report_of = [&](Crowd crowd) {
    numbers.crowd = crowd;
    return report("a style", exact_scheme, {damped}, numbers);
  };
  EXPECT_EQ(report_of(Crowd::pair).stop, "");
  EXPECT_TRUE(report_of(Crowd::pair).warnings.empty());
  EXPECT_EQ(report_of(Crowd::separate).stop, "");
  ASSERT_EQ(report_of(Crowd::separate).warnings.size(), 1u);
  EXPECT_EQ(report_of(Crowd::separate).warnings[0].subject, Subject::steadiness);
  const std::string stop = report_of(Crowd::several).stop;
  EXPECT_NE(stop.find("gain energy without bound: reduce it to 2.1"), std::string::npos) << stop;
  numbers.plane = true;  // 3.5 steps
  EXPECT_EQ(report_of(Crowd::several).stop, "");
  numbers = {0.1, 0.0, 9.25e-5 / 4.4, 0.0, Crowd::several};
  EXPECT_EQ(report_of(Crowd::several).stop, "");
  EXPECT_EQ(report("a style", sampled_scheme, {damped}, numbers).stop, "");
}

TEST(ContactReport, RunsAtTheStepThatAnErrorNames) {
  std::vector<AdvisedContact> all(3, pair());
  const double restitutions[] = {0.5, 0.3, 0.4};
  for (int k = 0; k < 3; k++) {
    all[k].adhesion = {};
    all[k].springs.damping = contact::LinearSpringDashpot::from_restitution(800.0, restitutions[k],
                                                                            all[k].reduced_mass())
                                 .damping();
  }
  RunNumbers numbers{0.1, 0.0, 9.25e-5 / 4.2, 0.0, Crowd::several};
  for (const double first : {9.25e-5 / 4.2, 9.25e-5 / 0.9}) {
    numbers.dt = first;
    for (const SchemeLimits& limits : {exact_scheme, sampled_scheme}) {
      const std::string stop = report("a style", limits, all, numbers).stop;
      if (stop.empty()) continue;
      const std::string remedy = stop.substr(stop.find("reduce"));
      RunNumbers shorter = numbers;
      shorter.dt = std::stod(remedy.substr(remedy.find_first_of("123456789")));
      EXPECT_EQ(report("a style", limits, all, shorter).stop, "") << stop;
    }
  }
}

TEST(ContactReport, LeavesOutWarningsThatTheStepOfAnErrorSatisfies) {
  std::vector<Warning> warnings{{{"1 - 1"}, Subject::contact_steps, "2e-7"},
                                {{"1 - 2"}, Subject::contact_steps, "1e-7"},
                                {{"1 - 2"}, Subject::impact_overlap, "2 %"}};
  detail::remove_satisfied(warnings, {2e-7, 1e-7, infinite}, 1.4e-7);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0].text, "1e-7");
  EXPECT_EQ(warnings[1].subject, Subject::impact_overlap);
}

TEST(ContactReport, ADoubtStandsBeforeTheStiffnessThatWouldBearTheAdhesion) {
  AdvisedContact strong = pair();
  strong.adhesion.force *= 1e4;
  strong.doubt = "the constant is too large; ";
  const Report r = report("a style", exact_scheme, {strong}, run());
  EXPECT_EQ(r.stop.find("a style, 1 - 1: the constant is too large; the overlap of a resting"), 0u)
      << r.stop;
  // Not before advice about the step.
  RunNumbers large = run();
  large.dt = 1e-3;
  AdvisedContact usual = pair();
  usual.doubt = strong.doubt;
  const std::string stop = report("a style", exact_scheme, {usual}, large).stop;
  EXPECT_NE(stop, "");
  EXPECT_EQ(stop.find(usual.doubt), std::string::npos) << stop;
}

TEST(ContactReport, SoftnessOfSeveralContactsIsSaidOnceWithTheirNames) {
  std::vector<AdvisedContact> all(3, pair());
  all[1].name = "1 - 2";
  all[2].name = "2 - 2";
  all[2].adhesion = {};
  for (AdvisedContact& c : all) c.material_words = "'words'";
  const auto soft = [&] {
    std::vector<std::string> found;
    for (const Warning& w : report("a style", exact_scheme, all, run()).warnings)
      if (w.subject == Subject::softness) found.push_back(w.text);
    return found;
  };
  ASSERT_EQ(soft().size(), 1u);
  EXPECT_EQ(soft()[0].find("a style, 1 - 1, 1 - 2: "), 0u) << soft()[0];
  EXPECT_NE(soft()[0].find("'words' keeps its escape velocity"), std::string::npos) << soft()[0];
  for (AdvisedContact& c : all) c.material = {c.springs.stiffness, contact::Keep::escape_velocity};
  EXPECT_TRUE(soft().empty());
}

TEST(ContactReport, NamesBothRatiosToTheMaterialUnderTheTable) {
  AdvisedContact c = pair(), other = c;
  other.name = "1 - 2";
  c.material = other.material = {100.0 * c.springs.stiffness, contact::Keep::escape_velocity};
  const auto table = [&] { return report("a style", exact_scheme, {c, other}, run()).table; };
  EXPECT_NE(table().find("stiffness 800 for 80000 of the material: escape velocity 1, pull-off "
                         "force 0.1 times the material's (1 - 1, 1 - 2)\n"),
            std::string::npos)
      << table();
  c.material = other.material = {c.springs.stiffness, contact::Keep::escape_velocity};
  EXPECT_EQ(table().find("of the material"), std::string::npos) << table();
  c.material.stiffness *= 100.0;
  c.adhesion = {};
  EXPECT_EQ(table().find("of the material"), std::string::npos) << table();
}

TEST(ContactReport, NamesBothRatiosOfHertzsAndJkrsContactToTheMaterial) {
  const double radius = 0.5e-3, mass = 2650.0 * sphere_volume(radius), ratio = 1e3;
  const hamaker::HamakerLaw<hamaker::SmallGap> law({7.49e-19, 4e-10, 1e-7});
  for (const double w : {0.0, 0.05}) {
    contact::ContactParameters soft, real;
    contact::set_hertz(soft, 5e6, 0.3);
    contact::set_hertz(real, ratio * 5e6, 0.3);
    soft.restitution = real.restitution = 0.9;
    soft.work_of_adhesion = real.work_of_adhesion = w;
    const auto contact_of = [&](const contact::ContactParameters& p) {
      AdvisedContact c = pair();
      c.i = c.j = {radius, mass};
      c.springs = springs_of(p, 0.5 * radius, 0.5 * mass);
      c.adhesion = contact::adhesion_of(law, two_spheres(radius, radius));
      if (w > 0.0) c.adhesion = {contact::JkrSpringDashpot::pull_off_force(0.5 * radius, w)};
      return c;
    };
    AdvisedContact c = contact_of(soft);
    const auto sentence = [&](contact::Keep keep) {
      c.material = {ratio * soft.modulus, keep, contact::hertz_power};
      return detail::over_material_sentence(c, run());
    };
    const std::string moduli = "modulus E* 2.74725e+06 for 2.74725e+09 of the material: ";
    // 1000^(-2/5)
    EXPECT_EQ(sentence(contact::Keep::escape_velocity),
              moduli + "escape velocity 1, pull-off force 0.0631 times the material's");
    const double more = escape_velocity(c, run()) / escape_velocity(contact_of(real), run());
    EXPECT_EQ(sentence(contact::Keep::force), moduli +
                                                  detail::number("escape velocity %.3g", more) +
                                                  ", pull-off force 1 times the material's");
    EXPECT_GT(more, 2.0);
  }
}

TEST(ContactReport, ContactOfTheImmovableIsLeftOut) {
  AdvisedContact fixed = pair();
  fixed.i.mass = fixed.j.mass = infinite;
  const Report r = report("a style", sampled_scheme, {fixed}, run());
  EXPECT_EQ(r.table.find("1 - 1"), std::string::npos);
  EXPECT_TRUE(r.warnings.empty());
}

TEST(ContactReport, SpeedIsThatOfAFallWhereNothingMoves) {
  RunNumbers rest = run();
  rest.fastest = 0.0;
  EXPECT_DOUBLE_EQ(approach_speed(rest, pair()), std::sqrt(2.0 * 9.81 * 1e-3));
  RunNumbers fast = run();
  fast.fastest = 0.2;
  EXPECT_EQ(approach_speed(fast, pair()), 0.2);
}

TEST(ContactReport, WallIsAPartnerOfInfiniteSize) {
  AdvisedContact wall = pair();
  wall.j = {infinite, infinite};
  EXPECT_DOUBLE_EQ(wall.diameter(), 1e-3);
  EXPECT_DOUBLE_EQ(wall.reduced_mass(), wall.i.mass);
  EXPECT_DOUBLE_EQ(numbers(wall, run()).parameters().speed, 0.14007141035914503);
}

TEST(ContactReport, SpringOfAPowerIsThatOfTheImpact) {
  AdvisedContact hertz = pair();
  hertz.springs.exponent = 1.5;
  hertz.springs.overlap = 1e-7;
  const ContactNumbers n = numbers(hertz, run());
  const double u = std::sqrt(std::pow(n.parameters().speed, 2) +
                             2.0 * hertz.adhesion.well_energy() / hertz.reduced_mass());
  EXPECT_DOUBLE_EQ(
      n.parameters().stiffness,
      linear_springs(hertz.springs, hertz.reduced_mass(), hertz.adhesion.force, u).stiffness);
  EXPECT_GT(n.parameters().stiffness, 2.0 * hertz.springs.stiffness);
}

TEST(ContactReport, EscapeVelocityOfHertzIsThatOfItsImpact) {
  // Spheres of 1 mm and 2650 kg/m3, E 5e6 Pa, nu 0.3, A 7.49e-19 J, H_cut 0.4 nm, H_out 0.1 um; by
  // integrations of the eighth order by scipy (tests/support, hertz_contact.py).
  const double radius = 0.5e-3, mass = 2650.0 * sphere_volume(radius);
  const hamaker::HamakerLaw<hamaker::SmallGap> law({7.49e-19, 4e-10, 1e-7});
  contact::ContactParameters p;
  contact::set_hertz(p, 5e6, 0.3);
  for (const auto& [restitution, exact] :
       {std::pair{0.9, 0.0183218}, std::pair{0.5, 0.0727543}, std::pair{0.3, 0.141285}}) {
    p.restitution = restitution;
    AdvisedContact hertz = pair();
    hertz.i = hertz.j = {radius, mass};
    hertz.adhesion = contact::adhesion_of(law, two_spheres(radius, radius));
    hertz.springs = springs_of(p, 0.5 * radius, 0.5 * mass);
    EXPECT_NEAR(escape_velocity(hertz, run()), exact, 1e-4 * exact) << restitution;
  }
}

}  // namespace cohesion::advice
