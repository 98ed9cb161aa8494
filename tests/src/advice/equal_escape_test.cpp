// SPDX-License-Identifier: BSD-3-Clause
#include "advice/equal_escape.h"

#include <gtest/gtest.h>

#include "advice/contact_numbers.h"
#include "advice/thesis_pair.h"
#include "contact_solver/spheres.h"
#include "contact_solver/square_well_solver.h"
#include "refuses.h"

namespace cohesion::advice {
namespace {

const auto spring = contact::normal_contact(thesis::contact(), thesis::reduced_mass);

/// Whether a head-on pair comes apart again.
template <class Solver>
bool parts(const contact::Adhesion& a, double speed) {
  const double dt = 0.25 * thesis::contact_time;
  auto pair = contact_solver::meeting<Solver, contact_solver::ContactHistory::normal_only>(
      thesis::contact(), a, dt, 2.0 * thesis::radius + a.cutoff, speed, 0.0, 2.3 * dt);
  bool met = false;
  for (int n = 0; n < 2000; n++) {
    pair.step();
    met = met || pair.any_in_range();
    if (met && pair.are_apart()) return true;
  }
  return false;
}

}  // namespace

TEST(EqualEscape, WellAndHamakerHoldPairsUpToTheSameSpeed) {
  for (const double hamaker : {1e-19, 5e-19, 2e-18}) {
    const contact::Adhesion a = thesis::adhesion(hamaker);
    const contact::Adhesion well{0.0, 1e-5, equal_depth(spring, a)};
    const double escape = contact::AdhesiveContact(spring, a).escape_velocity();
    // contact_solver_test.cpp, square_well_solver_test.cpp: both integrate the pair to better than
    // 1e-8.
    for (const double off : {-1e-7, 1e-7}) {
      EXPECT_EQ(parts<contact_solver::ContactSolver>(a, escape * (1.0 + off)), off > 0.0);
      EXPECT_EQ(parts<contact_solver::SquareWellSolver>(well, escape * (1.0 + off)), off > 0.0);
    }
  }
}

TEST(EqualEscape, OfTheThesisPair) {
  // A = 5e-19 J: 2.6749904905705694e-3 m/s (contact_solver_test.cpp); e = 0.94868239;
  // mu v^2/2/(1/e^2 - 1) with mu = 6.93768e-7 kg: 2.4822e-12 J/0.111121.
  EXPECT_NEAR(equal_depth(spring, thesis::adhesion(5e-19)) / 2.23374e-11, 1.0, 1e-4);
}

TEST(EqualEscape, OfAWellIsItsDepth) {
  for (const double depth : {1e-13, 1e-11, 1e-10})
    // e is rounded, 1/e^2 - 1 = 0.11 by 20 times that.
    EXPECT_NEAR(equal_depth(spring, {0.0, 1e-5, depth}) / depth, 1.0, 1e-13);
}

TEST(EqualEscape, HamakerConstantsOfTheThesisWells) {
  // The thesis, found by trial: D = 1e-11 J with A = 3.34e-19 J, printed with three digits. The
  // others by an integration of the motion (tests/tools/cohesion_mapping_test.py), good to 1e-9.
  const contact::Adhesion unit =
      contact::adhesion_of(hamaker::HamakerLaw<hamaker::SmallGap>({1.0, 4e-10, 1e-7}),
                           two_spheres(thesis::radius, thesis::radius));
  const auto constant = [&](double depth) {
    return adhesion_of_escape_velocity(spring, unit, escape_velocity_of_depth(spring, depth));
  };
  EXPECT_NEAR(constant(1e-11), 3.34e-19, 0.005e-19);
  EXPECT_NEAR(constant(1e-11) / 3.338019109e-19, 1.0, 1e-8);
  EXPECT_NEAR(constant(5e-11) / 7.491511298e-19, 1.0, 1e-8);
  EXPECT_NEAR(constant(1e-10) / 1.060388233e-18, 1.0, 1e-8);
}

TEST(EqualEscape, AConstantIsFoundAgainFromItsDepth) {
  for (const double restitution : {0.01, 0.5, 0.95, 0.9999})
    for (const double stiffness : {1.0, 800.0, 1e7})
      for (const double hamaker : {1e-23, 1e-19, 1e-15}) {
        const auto contact = contact::LinearSpringDashpot::from_restitution(stiffness, restitution,
                                                                            thesis::reduced_mass);
        const double speed =
            escape_velocity_of_depth(contact, equal_depth(contact, thesis::adhesion(hamaker)));
        // v_esc is good to some roundings of 1/e^2 - 1, which has 2e-4 left at e = 0.9999.
        EXPECT_NEAR(adhesion_of_escape_velocity(contact, thesis::adhesion(1.0), speed) / hamaker,
                    1.0, 1e-11);
      }
}

TEST(EqualEscape, AdviceOnAWellHasItsEscapeVelocity) {
  PairParameters p = thesis_pair();
  p.adhesion = {0.0, 1e-5, 5e-11};
  const ContactNumbers n(p);
  const double mu = 0.5 * p.mass_i;
  const double e = contact::LinearSpringDashpot(p.stiffness, p.damping, mu).restitution();
  EXPECT_NEAR(n.escape_velocity() / std::sqrt(2.0 * 5e-11 / mu * (1.0 / (e * e) - 1.0)), 1.0,
              1e-13);
  EXPECT_EQ(n.bond_number(), 0.0);
  EXPECT_EQ(n.static_overlap_over_diameter(), 0.0);
  EXPECT_NEAR(n.steps_in_cutoff(), 1e-5 / std::hypot(p.speed, std::sqrt(1e-10 / mu)) / p.dt, 1e-9);
}

TEST(EqualEscape, RefusesWhatHasNoDepth) {
  const contact::LinearSpringDashpot elastic(800.0, 0.0, 1e-6);
  const auto dead = contact::LinearSpringDashpot::from_restitution(800.0, 0.0, 1e-6);
  expect_refused([&] { depth_of_escape_velocity(elastic, 0.1); }, "restitution e");
  expect_refused([&] { depth_of_escape_velocity(dead, 0.1); }, "restitution e");
  expect_refused([&] { depth_of_escape_velocity(spring, -0.1); }, "escape velocity");
  expect_refused([&] { adhesion_of_escape_velocity(elastic, thesis::adhesion(1.0), 0.1); },
                 "restitution e");
  expect_refused([&] { adhesion_of_escape_velocity(spring, thesis::adhesion(1.0), 0.0); },
                 "escape velocity");
  expect_refused([&] { adhesion_of_escape_velocity(spring, {}, 0.1); }, "adhesion force");
}

}  // namespace cohesion::advice
