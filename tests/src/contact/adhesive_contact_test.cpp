// SPDX-License-Identifier: BSD-3-Clause
#include "contact/adhesive_contact.h"

#include <limits>

#include "contact/rebound.h"
#include "refuses.h"
#include "sphere.h"

namespace cohesion::contact {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The particle of the thesis' bed: 1 mm, 2650 kg/m3, K = 800 N/m, eta = 0.79e-3 kg/s (e = 0.9487),
// with A = 5e-19 J, H_cut = 4e-10 m, H_out = 1e-7 m between equal spheres.
const double mass = 2650.0 * sphere_volume(0.5e-3);
const LinearSpringDashpot bed(800.0, 0.79e-3, reduced_mass(mass, mass));
const double a_r_over_6 = 5e-19 * 0.25e-3 / 6.0;
const Adhesion bed_adhesion{a_r_over_6 / (4e-10 * 4e-10), 4e-10,
                            a_r_over_6 * (1.0 / 4e-10 - 1.0 / 1e-7)};

/// K = mu = 1, so that F_ad is the speed b and zeta = eta/2; the well has the energy `well`.
AdhesiveContact unit(double zeta, double force, double well) {
  return {LinearSpringDashpot(1.0, 2.0 * zeta, 1.0), {force, 0.0, well}};
}

double relative(double found, double expected) { return std::abs(found / expected - 1.0); }

}  // namespace

TEST(AdhesiveContact, AgreesWithAnIntegrationOfTheThesisParticle) {
  // mu x'' = -K x - eta x' + F_ad integrated by Taylor series of order 40 in steps of 0.5/w0 at 40
  // digits (mpmath), its turning points and its end by bisection within a step; the escape velocity
  // by 75 bisections over the approach speed. Knows nothing of the closed forms.
  const AdhesiveContact contact(bed, bed_adhesion);
  EXPECT_LT(relative(contact.escape_velocity(), 0.0026749667394216005462), 1e-13);
  const double expected[][4] = {
      // v, w, largest overlap, effective restitution
      {0.01, 0.008935504109191505897, 4.8585041102733049824e-7, 0.89187186257114757045},
      {0.1, 0.09449197705144251446, 3.0309614453181251108e-6, 0.94490391232810404189}};
  for (const auto& [v, w, overlap, restitution] : expected) {
    const double u = contact.entry_speed(v);
    EXPECT_LT(relative(exit_speed(contact, u), w), 1e-13);
    EXPECT_LT(relative(contact.maximum_overlap(u), overlap), 1e-13);
    EXPECT_LT(relative(effective_restitution(contact, v), restitution), 1e-13);
  }
}

TEST(AdhesiveContact, EscapeVelocityAgreesWithAnIntegrationAtAnyDampingAndDepth) {
  // K = mu = F_ad = 1: zeta, W, v_esc. Bisection for the return time of the motion run backwards
  // at 60 digits (mpmath); those at zeta = 0.01, 0.3 and 0.9 agree to all digits printed with the
  // Taylor integration and bisection over the speed of the test above.
  const double expected[][3] = {
      {1e-12, 0.0, 3.5449077018221687022e-6}, {1e-12, 0.5, 4.7801209107768848807e-6},
      {1e-12, 50, 2.6737012765714048943e-5},  {1e-8, 0.0, 0.00035449078131692174147},
      {1e-8, 0.5, 0.00047801210233945687646}, {1e-8, 50, 0.0026737013212301827075},
      {1e-4, 0.0, 0.035460132871584933408},   {1e-4, 0.5, 0.047812473257071444174},
      {1e-4, 50, 0.26741479751800557979},     {0.01, 0.0, 0.36506470694262151905},
      {0.01, 0.5, 0.48940436164086822813},    {0.01, 50, 2.7190353410451601322},
      {0.3, 0.0, 4.4841931363336780981},      {0.3, 0.5, 5.7091465426232215014},
      {0.3, 50, 27.417031499480201054},       {0.9, 0.0, 1667.2167982761993374},
      {0.9, 0.5, 2039.7593380338240574},      {0.9, 50, 7776.7538685410004698}};
  // Roundings are amplified by the exponent zeta T < 2 pi zeta/q = 13 at most.
  for (const auto& [zeta, well, speed] : expected)
    EXPECT_LT(relative(unit(zeta, 1.0, well).escape_velocity(), speed), 1e-13)
        << zeta << " " << well;
  // zeta = 0.99: q^2 = 1 - zeta^2 carries the rounding of zeta 50 times enlarged, the exponent
  // is 44.
  EXPECT_LT(relative(unit(0.99, 1.0, 0.5).escape_velocity(), 12323277602.69372067), 1e-12);
}

TEST(AdhesiveContact, WhatFormsAtTouchGivesNothingOnTheWayIn) {
  // Force, gap of rupture, v_esc of the thesis' particle: Taylor integration of the contact from
  // touch to parting, and bisection for the speed that then has F h_r left, as above.
  const double expected[][3] = {{1e-5, 1e-5, 0.017927077155182931587},
                                {1e-4, 5e-5, 0.12685323669388274131},
                                {1e-3, 1e-6, 0.061695478506996175052}};
  for (const auto& [force, gap, speed] : expected) {
    const AdhesiveContact bridge(bed, {force, gap, 0.0, true});
    EXPECT_LT(relative(bridge.escape_velocity(), speed), 1e-13) << force;
    EXPECT_EQ(bridge.entry_speed(0.1), 0.1);
    EXPECT_EQ(effective_restitution(bridge, (1.0 - 1e-12) * speed), 0.0);
    EXPECT_GT(effective_restitution(bridge, (1.0 + 1e-12) * speed), 0.0);
    // Far from that: what is left of the speed at which it parts, of the work F h_r.
    const double w = exit_speed(bridge, 1.0), lost = 2.0 * force * gap / bed.reduced_mass();
    EXPECT_LT(relative(effective_restitution(bridge, 1.0), std::sqrt(w * w - lost)), 1e-13);
  }
  // Elastic: all of F h_r has to be paid, and nothing else.
  const AdhesiveContact elastic(LinearSpringDashpot(1.0, 0.0, 1.0), {2.0, 0.25, 0.0, true});
  EXPECT_DOUBLE_EQ(elastic.escape_velocity(), 1.0);
  EXPECT_EQ(effective_restitution(elastic, 0.5), 0.0);
  EXPECT_DOUBLE_EQ(effective_restitution(elastic, 2.0), std::sqrt(0.75));
}

TEST(AdhesiveContact, OverlapAndExitAgreeWithAnIntegration) {
  // K = mu = F_ad = 1, Taylor integration as above.
  EXPECT_LT(relative(exit_speed(unit(0.3, 1.0, 0.0), 5.0), 0.56954899534687502758), 1e-13);
  EXPECT_LT(relative(unit(0.3, 1.0, 0.0).maximum_overlap(5.0), 4.0240638765564035838), 1e-14);
  EXPECT_LT(relative(unit(0.3, 1.0, 0.0).maximum_overlap(0.5), 1.426212291969398406), 1e-14);
  EXPECT_EQ(exit_speed(unit(0.3, 1.0, 0.0), 0.5), 0.0);
  EXPECT_LT(relative(unit(1.0, 1.0, 0.0).maximum_overlap(5.0), 2.1460191874407604013), 1e-14);
  EXPECT_LT(relative(unit(3.0, 1.0, 0.0).maximum_overlap(10.0), 1.6266450424528911844), 1e-14);
}

TEST(AdhesiveContact, SlowOverdampedPairCreepsToTheStaticOverlap) {
  EXPECT_EQ(unit(3.0, 1.0, 0.0).maximum_overlap(2.0), unit(3.0, 1.0, 0.0).static_overlap());
}

TEST(AdhesiveContact, WithoutAdhesionItIsTheSpringDashpot) {
  for (const double zeta : {0.0, 0.017, 0.5, 0.95, 1.0, 2.0}) {
    const AdhesiveContact contact = unit(zeta, 0.0, 0.0);
    EXPECT_NEAR(exit_speed(contact, 2.0), 2.0 * contact.spring().restitution(), 1e-14) << zeta;
    EXPECT_LT(relative(contact.maximum_overlap(2.0), contact.spring().maximum_overlap(2.0)), 1e-14)
        << zeta;
    EXPECT_NEAR(effective_restitution(contact, 2.0), contact.spring().restitution(), 1e-14) << zeta;
    EXPECT_EQ(contact.escape_velocity(), 0.0) << zeta;
  }
}

TEST(AdhesiveContact, WithoutDashpotNothingIsCaptured) {
  const AdhesiveContact contact = unit(0.0, 3.0, 2.0);
  EXPECT_EQ(contact.escape_velocity(), 0.0);
  for (const double v : {1e-9, 1e-3, 1.0, 1e6}) {
    EXPECT_EQ(effective_restitution(contact, v), 1.0) << v;
    EXPECT_EQ(exit_speed(contact, v), v);
    // Energy: K x^2/2 - F_ad x = mu u^2/2.
    EXPECT_LT(relative(contact.maximum_overlap(v), 3.0 + std::hypot(3.0, v)), 1e-15) << v;
  }
}

TEST(AdhesiveContact, WellWithoutForceInContactHasTheSquareWellsEscapeVelocity) {
  for (const double e : {1e-6, 0.1, 0.5, 0.9487, 0.999999}) {
    const auto spring = LinearSpringDashpot::from_restitution(800.0, e, 7e-7);
    const AdhesiveContact contact(spring, {0.0, 4e-10, 1e-13});
    const double ln_e = std::log(e);
    // 1/e^2 - 1 = expm1(-2 ln e); at e = 1e-6 q^2 has lost a digit: 1e-12.
    const double expected = std::sqrt(2e-13 / 7e-7 * std::expm1(-2.0 * ln_e));
    EXPECT_LT(relative(contact.escape_velocity(), expected), 1e-12) << e;
    // e_eff = sqrt(e^2 - (2W/mu)(1 - e^2)/v^2), the thesis' limit of a thin well.
    const double v = 3.0 * expected;
    EXPECT_NEAR(effective_restitution(contact, v),
                std::sqrt(e * e - 2e-13 / 7e-7 * (1.0 - e * e) / (v * v)), 1e-12)
        << e;
  }
}

TEST(AdhesiveContact, EscapeVelocityIsProportionalToForceOverRootOfMassAndStiffness) {
  // Without a well c = v_esc sqrt(mu K)/F_ad depends on e alone, over many decades of F_ad, K, mu.
  const double c = unit(0.3, 1.0, 0.0).escape_velocity();
  for (const double force : {1e-15, 1e-6, 1.0})
    for (const double stiffness : {10.0, 800.0, 1e7})
      for (const double mu : {1e-18, 7e-7, 1e-3}) {
        const double impedance = std::sqrt(mu * stiffness);
        const AdhesiveContact contact({stiffness, 0.6 * impedance, mu}, {force, 0.0, 0.0});
        EXPECT_LT(relative(contact.escape_velocity(), c * force / impedance), 1e-13);
      }
}

TEST(AdhesiveContact, EscapeVelocityHasTheLimitOfWeakDamping) {
  // Loss over one swing of amplitude b: 4 pi zeta b^2; the next order is sqrt(zeta) smaller.
  for (const double zeta : {1e-4, 1e-8, 1e-12, 1e-16})
    EXPECT_LT(relative(unit(zeta, 1.0, 0.0).escape_velocity(), std::sqrt(4.0 * pi * zeta)),
              2.0 * std::sqrt(zeta) + 1e-14)
        << zeta;
}

TEST(AdhesiveContact, ForceDecidesWhenStrongAndTheWellWhenWeak) {
  // At fixed H_cut, W = F_ad H_cut: the exponent of v_esc in F_ad goes from 1/2 to 1 as
  // b^2/(2 W/mu) = F_ad/(2 K H_cut) goes from 1e-6 to 1e6. The correction is of the order of the
  // square root of the smaller, 1e-3.
  const auto exponent = [](double force) {
    const double less = AdhesiveContact(bed, {force, 4e-10, 0.0}).escape_velocity();
    const double more = AdhesiveContact(bed, {1.01 * force, 4e-10, 0.0}).escape_velocity();
    return std::log(more / less) / std::log(1.01);
  };
  const double even = 2.0 * bed.stiffness() * 4e-10;
  EXPECT_NEAR(exponent(1e-6 * even), 0.5, 3e-3);
  EXPECT_NEAR(exponent(1e6 * even), 1.0, 3e-3);
}

TEST(AdhesiveContact, EscapesJustAboveAndIsCapturedJustBelowTheEscapeVelocity) {
  for (const double zeta : {1e-8, 0.01, 0.3, 0.9})
    for (const double well : {0.0, 1e-6, 0.5, 1e6}) {
      const AdhesiveContact contact = unit(zeta, 1.0, well);
      const double v = contact.escape_velocity();
      EXPECT_EQ(effective_restitution(contact, v * (1.0 - 1e-6)), 0.0) << zeta << " " << well;
      EXPECT_GT(effective_restitution(contact, v * (1.0 + 1e-6)), 0.0) << zeta << " " << well;
    }
}

TEST(AdhesiveContact, EscapesJustAboveTheEscapeVelocityOfExtremeParameters) {
  // A billionth above and below, over the restitutions, forces and wells of a random search that
  // found roundings: 1 - exp of strong damping, and the small difference of two speeds at weak.
  struct Case {
    double e, force, well;
  };
  for (const auto& [e, force, well] :
       {Case{1e-27, 1.0, 0.5}, Case{1e-15, 1.0, 0.5}, Case{1e-15, 1e-12, 0.5},
        Case{1e-15, 1e3, 0.5}, Case{1.0 - 1e-14, 1e7, 0.5}, Case{1.0 - 1e-14, 1e-7, 0.5}}) {
    const AdhesiveContact contact(LinearSpringDashpot::from_restitution(1.0, e, 1.0),
                                  {force, 0.0, well});
    const double v = contact.escape_velocity();
    EXPECT_EQ(effective_restitution(contact, v * (1.0 - 1e-9)), 0.0) << e << " " << force;
    EXPECT_GT(effective_restitution(contact, v * (1.0 + 1e-9)), 0.0) << e << " " << force;
  }
}

TEST(AdhesiveContact, FastPairsHaveTheRestitutionOfTheSpring) {
  // e_eff = e - O(b/v).
  EXPECT_NEAR(effective_restitution(unit(0.3, 1.0, 0.5), 1e9),
              unit(0.3, 0, 0).spring().restitution(), 1e-8);
}

TEST(AdhesiveContact, ZeroRestitutionHoldsEveryPairThatAttracts) {
  for (const double zeta : {1.0, 2.0, 1.0 - 1e-9}) {
    EXPECT_EQ(unit(zeta, 1.0, 0.5).escape_velocity(), infinity);
    EXPECT_EQ(unit(zeta, 0.0, 0.5).escape_velocity(), infinity);
    EXPECT_EQ(effective_restitution(unit(zeta, 1.0, 0.5), 1e6), 0.0);
  }
}

TEST(AdhesiveContact, EscapeVelocityIsContinuousInTheForceAtZero) {
  // The force shifts v_esc^2 by 4 zeta b u relative to w^2 (1/e^2 - 1): 1e-9 of it or so.
  const double without = unit(0.3, 0.0, 0.5).escape_velocity();
  EXPECT_LT(relative(unit(0.3, 1e-9, 0.5).escape_velocity(), without), 1e-8);
}

TEST(AdhesiveContact, RefusesWhatCannotBe) {
  for (const double bad : {-1e-30, std::nan(""), infinity}) {
    expect_refused([=] { AdhesiveContact(bed, {bad, 1.0, 1.0}); }, "adhesion force");
    expect_refused([=] { AdhesiveContact(bed, {1.0, bad, 1.0}); }, "cut-off");
    expect_refused([=] { AdhesiveContact(bed, {1.0, 1.0, bad}); }, "tail energy");
    const AdhesiveContact contact(bed, bed_adhesion);
    expect_refused([=] { exit_speed(contact, bad); }, "entry speed");
    expect_refused([=] { contact.maximum_overlap(bad); }, "entry speed");
    expect_refused([=] { effective_restitution(contact, bad); }, "approach speed");
  }
}

}  // namespace cohesion::contact
