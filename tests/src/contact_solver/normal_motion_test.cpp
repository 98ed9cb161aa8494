// SPDX-License-Identifier: BSD-3-Clause
#include "contact_solver/normal_motion.h"

#include <gtest/gtest.h>

#include <random>

#include "contact_solver/thesis_contact.h"

namespace cohesion::contact_solver {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

NormalMotion thesis_motion(const contact::ContactParameters& p, const contact::Adhesion& a,
                           double step) {
  return {contact::normal_contact(p, thesis::reduced_mass), a, step};
}

double energy(const NormalMotion& motion, Overlap s) {
  return 0.5 * motion.reduced_mass() * s.v * s.v + motion.spring_energy(s.x) +
         motion.adhesion_energy(s.x);
}

}  // namespace

TEST(NormalMotion, RestitutionIsExactForAnyStepAndPhase) {
  const contact::LinearSpringDashpot law(800.0, 0.79e-3, thesis::reduced_mass);
  for (const double steps_per_contact : {2.0, 3.3, 10.0, 50.0, 1000.0})
    for (int phase = 0; phase < 8; phase++) {
      const double dt = thesis::contact_time / steps_per_contact;
      const NormalMotion motion = thesis_motion(thesis::contact(), {}, dt);
      Overlap s{0.0, 0.3};
      NormalRecord record;
      double time = 0.0, first = dt * (phase + 0.5) / 8.0;
      bool inside = true;
      while (inside && time < 2.0 * thesis::contact_time) {
        time += motion.advance(s, first > 0.0 ? first : dt, 0.0, inside, record);
        first = 0.0;
      }
      ASSERT_FALSE(inside);
      // Up to 1000 steps, each a rotation in the (x, v) plane rounded to 1 epsilon: 2e-13.
      EXPECT_NEAR(s.v, -0.3 * law.restitution(), 0.3 * 1e-12);
      EXPECT_NEAR(time / law.contact_time(), 1.0, 1e-12);
      EXPECT_NEAR(record.contact_time, time, 1e-12 * time);
      // The contact's impulse is mu (1 + e) v, its loss mu (1 - e^2) v^2/2.
      const double e = law.restitution(), mu = thesis::reduced_mass;
      EXPECT_NEAR(record.repulsion_impulse, mu * (1.0 + e) * 0.3, mu * 1e-12);
      EXPECT_NEAR(record.dissipated, 0.5 * mu * (1.0 - e * e) * 0.09, mu * 1e-12);
    }
}

TEST(NormalMotion, TheEdgeGivesAndTakesTheTailsEnergy) {
  const contact::Adhesion a = thesis::adhesion(5e-19);
  const NormalMotion motion = thesis_motion(thesis::elastic(), a, 1e-5);
  const double mu = thesis::reduced_mass;
  const Overlap in = motion.enter({-a.cutoff, 0.01});
  EXPECT_NEAR(0.5 * mu * (in.v * in.v - 1e-4), a.tail_energy, 8 * eps * 0.5e-4 * mu);
  // Back out through the gap from halfway, with enough speed.
  Overlap s{-0.5 * a.cutoff, -0.02};
  NormalRecord record;
  bool inside = true;
  const double taken = motion.advance(s, 1e-5, 0.0, inside, record);
  EXPECT_FALSE(inside);
  EXPECT_EQ(s.x, -a.cutoff);
  const double lost = 0.5 * mu * (4e-4 - s.v * s.v);
  EXPECT_NEAR(lost, 0.5 * a.force * a.cutoff + a.tail_energy, 8 * eps * 2e-4 * mu);
  // Uniform deceleration over the half gap: time = 2 (way)/(sum of speeds at both ends).
  const double at_edge = std::sqrt(s.v * s.v + 2.0 * a.tail_energy / mu);
  EXPECT_NEAR(taken, a.cutoff / (0.02 + at_edge), 1e-12 * taken);
}

TEST(NormalMotion, APairTooSlowForTheTailIsReflectedAtTheEdge) {
  const contact::Adhesion a = thesis::adhesion(5e-19);
  const NormalMotion motion = thesis_motion(thesis::elastic(), a, 1e-5);
  const double edge_speed = std::sqrt(2.0 * a.tail_energy / thesis::reduced_mass);
  for (const double part : {0.5, 0.999999, 1.000001, 2.0}) {
    // At the edge with this part of the speed that the tail costs.
    const double v = part * edge_speed;
    Overlap s{-a.cutoff, -v};
    NormalRecord record;
    bool inside = true;
    motion.advance(s, 1e-9, 0.0, inside, record);
    EXPECT_EQ(inside, part < 1.0) << part;
    if (part < 1.0) {
      EXPECT_NEAR(s.v, v + a.force / thesis::reduced_mass * 1e-9, 8 * eps * v);
    }
  }
}

TEST(NormalMotion, ACapturedElasticPairKeepsItsEnergy) {
  for (const double hamaker : {1e-19, 5e-19, 2e-18})
    for (const double dt : {0.5, 0.21, 0.037}) {
      const contact::Adhesion a = thesis::adhesion(hamaker);
      const double step = dt * thesis::contact_time;
      const NormalMotion motion = thesis_motion(thesis::elastic(), a, step);
      // With 0.9 of the tail's energy at the edge: bounces between edge and contact.
      Overlap s{-a.cutoff, std::sqrt(1.8 * a.tail_energy / thesis::reduced_mass)};
      const double start = energy(motion, s);
      const double deepest = 0.5 * a.force * a.force / 800.0 + a.tail_energy;
      NormalRecord record;
      double worst = 0.0, largest_speed = 0.0;
      for (int n = 0; n < 20000; n++) {
        bool inside = true;
        motion.advance(s, step, 0.0, inside, record);
        ASSERT_TRUE(inside);
        worst = std::max(worst, std::abs(energy(motion, s) - start));
        largest_speed = std::max(largest_speed, s.v);
      }
      // A few phases per step, rounded to a few epsilon of the largest energy each, at worst all
      // one way: 20000 steps, 1e-10.
      EXPECT_LT(worst, 1e-10 * deepest) << hamaker << " " << dt;
      EXPECT_FALSE(record.unresolved);
      EXPECT_LT(std::abs(record.dissipated), 1e-10 * deepest);
    }
}

TEST(NormalMotion, ImpulseIsThatOfTheMotion) {
  // One coarse step through entry, contact and gap against many fine ones; the impulse follows from
  // the change in speed under the constant drive.
  const contact::Adhesion a = thesis::adhesion(5e-19);
  const NormalMotion motion = thesis_motion(thesis::contact(), a, 1.2 * thesis::contact_time);
  const double centrifugal = 10.0, drive = a.force / thesis::reduced_mass - centrifugal;
  Overlap s{-a.cutoff, 0.1};
  NormalRecord record;
  bool inside = true;
  const double taken = motion.advance(s, 1.2 * thesis::contact_time, centrifugal, inside, record);
  ASSERT_FALSE(inside);
  const double at_edge = -std::sqrt(s.v * s.v + 2.0 * a.tail_energy / thesis::reduced_mass);
  EXPECT_NEAR(record.repulsion_impulse, thesis::reduced_mass * (drive * taken - (at_edge - 0.1)),
              1e-13 * thesis::reduced_mass);

  Overlap fine{-a.cutoff, 0.1};
  double time = 0.0;
  inside = true;
  const int n = 20000;
  while (inside) {
    time += motion.advance(fine, taken / n, centrifugal, inside, record);
  }
  // Composition only rounds, n times.
  EXPECT_NEAR(time, taken, 1e-11 * taken);
  EXPECT_NEAR(fine.v, s.v, 1e-11);
}

TEST(NormalMotion, ALoadCarriesAPairThroughTheTailWhereItPaysTheRest) {
  // At the edge with a part of the energy of the tail U = F_ad H_cut, under L = f F_ad: it leaves
  // at rest where f U (H - H_cut)/H_cut is what it lacks, once it has (1 - sqrt(f))^2 U; till then
  // the load alone speeds it up.
  const contact::Adhesion a = thesis::adhesion(1e-19);
  const NormalMotion motion = thesis_motion(thesis::elastic(), a, 1e-5);
  const double mu = thesis::reduced_mass, edge_speed = std::sqrt(2.0 * a.tail_energy / mu);
  for (const double f : {1e-4, 0.01, 0.3, 0.9, 1.01, 2.0, 50.0})
    for (const double excess : {-0.01, 0.01, 0.5}) {
      const double least = f < 1.0 ? (1.0 - std::sqrt(f)) * (1.0 - std::sqrt(f)) : 0.0;
      const double part = std::min(std::max(least + excess, 0.0), 1.0 - 1e-9);
      const double speed = std::sqrt(part) * edge_speed, load = f * a.force / mu;
      const double flight = (edge_speed - speed) / load;
      Overlap s{-a.cutoff, -speed};
      NormalRecord record;
      bool inside = true;
      const double taken = motion.advance(s, 1.001 * flight, load, inside, record);
      EXPECT_EQ(inside, part < least) << f << " " << excess;
      if (inside) continue;
      EXPECT_NEAR(taken, flight, 10.0 * eps * edge_speed / load);
      EXPECT_EQ(s.v, 0.0);
      EXPECT_NEAR(-s.x / a.cutoff, 1.0 + (1.0 - part) / f, 1e-12 / f) << f << " " << excess;
      const double farthest = 1.0 + (1.0 - least) / f;  // 2/sqrt(f), where f < 1
      EXPECT_LE(-s.x, a.cutoff * farthest * (1.0 + 1e-12));
    }
}

TEST(NormalMotion, APairPushedBeyondTheTailDoesNotLeaveFarAway) {
  // Under next to no load nothing pays for the tail on the way from there.
  const hamaker::HamakerLaw<hamaker::SmallGap> law({1e-19, 4e-10, 1e-7});
  const contact::Adhesion a =
      contact::adhesion_with_tail(law, two_spheres(thesis::radius, thesis::radius));
  const NormalMotion motion = thesis_motion(thesis::elastic(), a, 1e-5);
  for (const double gap : {0.9e-7, 1.1e-7, 1e-6}) {
    Overlap s{-gap, 0.0};
    NormalRecord record;
    bool inside = true;
    motion.advance(s, 1e-9, 1e-9 * a.force / thesis::reduced_mass, inside, record);
    EXPECT_TRUE(inside);
    EXPECT_NEAR(s.x, -gap, 1e-10);
  }
}

TEST(NormalMotion, APairThatLosesItsLoadInTheTailTurnsRoundThere) {
  // Half of F_ad carries it through half of its way; without a load it has 0.6 U then, which the
  // tail has taken at the gap H_cut/(1 - 0.6): it turns within a step of that, and is captured.
  const hamaker::HamakerLaw<hamaker::SmallGap> law({1e-19, 4e-10, 1e-6});
  const contact::Adhesion a =
      contact::adhesion_with_tail(law, two_spheres(thesis::radius, thesis::radius));
  const NormalMotion motion = thesis_motion(thesis::elastic(), a, 1e-5);
  const double mu = thesis::reduced_mass, load = 0.5 * a.force / mu;
  const auto speed = [&](double part) { return std::sqrt(2.0 * part * a.tail_energy / mu); };
  Overlap s{-a.cutoff, -speed(0.2)};
  NormalRecord record;
  bool inside = true;
  motion.advance(s, (speed(0.6) - speed(0.2)) / load, load, inside, record);
  ASSERT_TRUE(inside);
  ASSERT_NEAR(s.v, -speed(0.6), 1e-12 * speed(0.6));
  const double step = 0.05 * a.cutoff / speed(0.6);
  double farthest = 0.0;
  for (int n = 0; n < 100; n++) {
    motion.advance(s, step, 0.0, inside, record);
    farthest = std::max(farthest, -s.x / a.cutoff);
  }
  EXPECT_TRUE(inside);
  // Of the tail that ends at H_out, 2500 H_cut.
  EXPECT_NEAR(farthest, 2.5, 0.05 + 0.01);
  EXPECT_NEAR(energy(motion, s), 0.6 * a.tail_energy - a.tail_energy, 1e-12 * a.tail_energy);
  EXPECT_NEAR(record.dissipated, 0.0, 1e-12 * a.tail_energy);
}

TEST(NormalMotion, ASlowLoadPartsARestingContactAtTheAdhesionForce) {
  // At rest in contact at its equilibrium; what the load is above F_ad moves it to the edge within
  // half a period, in which an elastic pair gets as far out again.
  const contact::Adhesion a = thesis::adhesion(1e-19);
  for (const double dt : {0.25, 0.1, 0.02}) {
    const double step = dt * thesis::contact_time;
    const NormalMotion motion = thesis_motion(thesis::elastic(), a, step);
    for (const double f : {0.999, 1.001}) {
      const double outward = f * a.force / thesis::reduced_mass;
      Overlap s{(1.0 - f) * a.force / 800.0, 0.0};
      NormalRecord record;
      bool inside = true;
      for (int n = 0; inside && n < 10.0 / dt; n++)
        motion.advance(s, step, outward, inside, record);
      EXPECT_EQ(inside, f < 1.0) << dt;
    }
  }
}

TEST(NormalMotion, NoLoadHelpsThroughAnEdgeWithoutWidth) {
  const contact::Adhesion well{0.0, 0.0, 5e-11};
  const NormalMotion motion = thesis_motion(thesis::elastic(), well, 1e-5);
  const double v = 0.999 * std::sqrt(2.0 * well.tail_energy / thesis::reduced_mass);
  Overlap s{1e-12, -v};
  NormalRecord record;
  bool inside = true;
  motion.advance(s, 1e-8, 10.0, inside, record);
  EXPECT_TRUE(inside);
  EXPECT_GT(s.v, 0.0);
}

TEST(NormalMotion, ARattleTooFastForTheStepIsReportedAndKeepsItsEnergy) {
  // Between contact and edge, turning so fast that it is pressed outwards: A = 1e-16 J, a period of
  // 4e-8 s against half the contact time, 4.6e-5 s.
  const double range = 1e-10, force = 1e-16 * thesis::radius / (12.0 * range * range);
  const contact::Adhesion a{force, range, force * range};
  const double pull = force / thesis::reduced_mass, dt = 0.5 * thesis::contact_time;
  const NormalMotion motion = thesis_motion(thesis::elastic(), a, dt);
  Overlap s{-range, std::sqrt(1.99 * pull * range)};
  const double outward = 1.99 * pull;
  // Energy with that of the constant centrifugal acceleration.
  const auto total = [&] { return energy(motion, s) + thesis::reduced_mass * outward * s.x; };
  const double start = total();
  NormalRecord record;
  bool inside = true;
  EXPECT_LT(motion.advance(s, dt, outward, inside, record), dt);
  EXPECT_TRUE(inside);
  EXPECT_TRUE(record.unresolved);
  // Each of the 1000/3 contacts rounds the overlap to a few epsilon of the equilibrium,
  // drive/w0^2 = -5e-4 m, five million times the overlap; times the force.
  const double drive = outward - pull;
  EXPECT_NEAR(
      total(), start,
      350 * 4 * eps * drive * drive / (800.0 / thesis::reduced_mass) * thesis::reduced_mass);
}

TEST(NormalMotion, BeyondTheRangeThereIsNoForceButTheTailIsStillOwed) {
  // A pair that counts as inside and was pushed out by its other partners.
  const contact::Adhesion a = thesis::adhesion(5e-19);
  const NormalMotion motion = thesis_motion(thesis::elastic(), a, 1e-5);
  const double edge_speed = std::sqrt(2.0 * a.tail_energy / thesis::reduced_mass);
  const double x = -10.0 * a.cutoff;
  for (const double v : {-2.0 * edge_speed, -0.5 * edge_speed, 0.5 * edge_speed}) {
    Overlap s{x, v};
    const double start = energy(motion, s);
    NormalRecord record;
    bool inside = true;
    const double back = 9.0 * a.cutoff / std::abs(v);  // flight to the edge
    motion.advance(s, back, 0.0, inside, record);
    if (v < -edge_speed) {
      EXPECT_FALSE(inside);
      EXPECT_EQ(s.x, x);
      EXPECT_NEAR(s.v * s.v, v * v - edge_speed * edge_speed, 8 * eps * v * v);
    } else {
      EXPECT_TRUE(inside);
      EXPECT_NEAR(s.x, -a.cutoff, 1e-12 * a.cutoff);
      EXPECT_NEAR(s.v, std::abs(v), 1e-9 * std::abs(v));
      EXPECT_NEAR(energy(motion, s), start, 1e-9 * a.tail_energy);
    }
  }
}

TEST(NormalMotion, EnteringBelowTheEdgeGainsTheAdhesionsWorkUpToThere) {
  const contact::Adhesion a = thesis::adhesion(5e-19);
  const NormalMotion motion = thesis_motion(thesis::elastic(), a, 1e-5);
  for (const double x : {-2.0 * a.cutoff, -a.cutoff, -0.3 * a.cutoff, 0.0, 2e-9}) {
    const double spring = motion.spring_energy(x);
    const Overlap in = motion.enter({x, 1e-3});
    // Kinetic energy outside equals kinetic plus adhesion energy inside.
    EXPECT_NEAR(energy(motion, in) - spring, 0.5 * thesis::reduced_mass * 1e-6,
                16 * eps * (std::abs(motion.adhesion_energy(x)) + thesis::reduced_mass * 1e-6));
  }
}

}  // namespace cohesion::contact_solver
