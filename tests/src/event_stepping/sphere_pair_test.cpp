// SPDX-License-Identifier: BSD-3-Clause
#include "event_stepping/sphere_pair.h"

#include <gtest/gtest.h>

#include <random>

#include "../refuses.h"
#include "event_stepping/pair_run.h"
#include "event_stepping/turning.h"

namespace cohesion::event_stepping {
namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double contact_distance = 2.0 * thesis::radius;
const Body particle{thesis::radius, 1.0 / thesis::mass};

using Spheres = PairRun<SpherePair>;

/// Two thesis particles that meet at the edge of the range with `speed` at `angle` to the normal,
/// `wait` after the start.
Spheres meeting(const contact::ContactParameters& p, const contact::Adhesion& a, double dt,
                double speed, double angle, double wait) {
  const Vector3 velocity{-speed * std::cos(angle), speed * std::sin(angle), 0.0};
  const Vector3 at_edge{contact_distance + a.cutoff, 0.0, 0.0};
  return {p, a, particle, particle, dt, {at_edge - wait * velocity, velocity}};
}

}  // namespace

TEST(SpherePair, EscapesAtTheIndependentlyIntegratedVelocityForAnyStepAndPhase) {
  // Escape velocity of the head-on thesis pair: bisection over scipy's DOP853 (relative tolerance
  // 3e-14) through gap, contact and gap, the tail an edge of F_ad H_cut; mpmath agrees to 16
  // digits.
  const double expected[][2] = {{1e-19, 0.00054426138952532112},
                                {5e-19, 0.0026749904905705694},
                                {2e-18, 0.010664100926264648}};
  for (const auto& [hamaker, escape] : expected)
    for (const double part : {2.0, 4.0, 10.0, 50.0})
      for (int phase = 0; phase < 8; phase++)
        // The distance of 1e-3 m is rounded to 1e-19 m, H_cut to 3e-10 of itself, the energy to
        // leave likewise, in each of the few steps near the edge.
        for (const double off : {-1e-8, 1e-8}) {
          const double dt = thesis::contact_time / part;
          Spheres run = meeting(thesis::contact(), thesis::adhesion(hamaker), dt,
                                escape * (1.0 + off), 0.0, dt * (phase + 0.37) / 8.0);
          EXPECT_EQ(run.run_to_escape(4 * static_cast<int>(part)), off > 0.0)
              << hamaker << " " << part << " " << phase;
          EXPECT_EQ(run.unresolved(), 0);
        }
}

TEST(SpherePair, RestitutionIsExactForAnyStepAndPhase) {
  const contact::LinearSpringDashpot law(800.0, 0.79e-3, thesis::reduced_mass);
  for (const double part : {2.0, 4.0, 10.0, 50.0})
    for (int phase = 0; phase < 8; phase++) {
      const double dt = thesis::contact_time / part;
      Spheres run = meeting(thesis::contact(), {}, dt, 0.3, 0.0, dt * (phase + 0.37) / 8.0);
      ASSERT_TRUE(run.run_to_escape(200));
      // 1e-19 m of rounding in each of < 60 steps times w0 = 3.4e4/s: 2e-13 m/s.
      EXPECT_NEAR(-run.approach(), 0.3 * law.restitution(), 3e-13);
    }
}

TEST(SpherePair, LastingContactsTakeTheShortWayToTheSameEnd) {
  const contact::LinearSpringDashpot spring(800.0, 0.79e-3, thesis::reduced_mass);
  const contact::Adhesion adhesion = thesis::adhesion(2e-18);
  std::mt19937 random(4711);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int lasting = 0;
  for (const double part : {2.5, 10.0, 20.0, 50.0}) {
    const double dt = thesis::contact_time / part;
    const StepWindow window{0.5 * dt, 0.5 * dt};
    const SpherePair pair(spring, adhesion, contact_distance, dt);
    // Made for other steps, so that it follows each event of this one.
    const SpherePair other(spring, adhesion, contact_distance, 2.0 * dt);
    for (int n = 0; n < 2000; n++) {
      const Vector3 direction{uniform(random), uniform(random), uniform(random)};
      const double distance = contact_distance * (1.0 - 0.005 * (1.0 + uniform(random)));
      const RelativeState grid{(distance / norm(direction)) * direction,
                               0.3 * Vector3{uniform(random), uniform(random), uniform(random)}};
      const PairStep step = pair.advance(grid, window, true);
      const PairStep expected = other.advance(grid, window, true);
      const bool lasts = expected.normal.contact_time == dt && expected.overlap_at_end > 0.0;
      lasting += lasts;
      // Rounding: that of some ten operations on separation and speed. An overlap is a difference
      // of distances; times w0, and times the mass, it enters velocity and impulse.
      const double length = 10.0 * eps * contact_distance;
      const double speed = 10.0 * eps * norm(grid.velocity) + length / thesis::contact_time * 4.0;
      EXPECT_EQ(step.inside, expected.inside);
      EXPECT_NEAR(step.overlap_at_end, expected.overlap_at_end, length);
      EXPECT_LE(norm(step.change.separation - expected.change.separation), length);
      EXPECT_LE(norm(step.change.velocity - expected.change.velocity), speed);
      EXPECT_NEAR(step.normal.contact_time, expected.normal.contact_time, 4 * eps * dt);
      EXPECT_NEAR(step.normal.repulsion_impulse, expected.normal.repulsion_impulse,
                  thesis::reduced_mass * speed);
    }
  }
  EXPECT_GT(lasting, 4000);
}

TEST(SpherePair, ObliqueImpactsDoNotDependOnTheStep) {
  const contact::Adhesion a = thesis::adhesion(5e-19);
  for (const double angle : {0.0, 20.0, 40.0, 60.0, 80.0})
    for (const double speed : {0.02, 0.1, 1.0}) {
      const auto leave = [&](double part, double wait) {
        const double dt = thesis::contact_time / part;
        Spheres run = meeting(thesis::contact(), a, dt, speed, angle * degree, wait * dt);
        EXPECT_TRUE(run.run_to_escape(5000)) << angle << " " << speed;
        return run.state();
      };
      const RelativeState fine = leave(200.0, 0.37);
      for (const double part : {2.0, 4.0, 10.0}) {
        const RelativeState coarse = leave(part, 0.71);
        // Rounding: 1e-19 m in each of < 300 steps, times w0: 1e-12 m/s, and up to 80 degrees the
        // normal velocity amplifies it by v/(v cos) < 20 where the tail is paid. Turning: the
        // tangent of the half angle is cut at its fifth power, v dt/R < 0.05: 0.05^5/120 v at 1
        // m/s, nothing below.
        const double turn = std::min(1.0, speed * thesis::contact_time / part / contact_distance);
        const double bound = 2e-11 + 3.0 * speed * std::pow(turn, 5) / 120.0;
        EXPECT_LT(norm(coarse.velocity - fine.velocity), bound)
            << angle << " " << speed << " " << part;
      }
    }
}

TEST(SpherePair, ObliqueImpactsErrByTheOverlapOverTheDistance) {
  // Speed, angle of impact; from scipy's DOP853 in polar coordinates with the centrifugal term
  // L^2/R(t)^3: normal speed after the impact, angle the normal has turned by, largest overlap/R.
  // A = 5e-19 J. What the constant centrifugal term errs by, measured so (relative, at most;
  // impacts at 0.1, 1 and 5 m/s, which overlap by 0.3, 3 and 13 % of R at 20 degrees): normal
  // speed 1.5e-6, 5e-5, 8e-4, less than 0.02 of the overlap/R; angle and
  // time 1.5e-5, 1.2e-3, 2.4e-2, 1.2 of it.
  const double expected[][5] = {{0.1, 20, 0.088770517547077127, 0.00329791724816759, 0.00286},
                                {0.1, 40, 0.072299111426158427, 0.00624145257495158, 0.00236},
                                {0.1, 60, 0.04705591077324707, 0.00858770147711337, 0.00159},
                                {0.1, 80, 0.016034576355874467, 0.0108907923703159, 0.00067},
                                {1, 20, 0.8913409420255729, 0.0328130315525988, 0.027},
                                {1, 40, 0.7271843956444265, 0.0607897895019721, 0.0218},
                                {1, 60, 0.47541756068408508, 0.0797332327448633, 0.0139},
                                {1, 80, 0.16609885461594079, 0.0836781374431763, 0.00436},
                                {5, 20, 4.4635411057045626, 0.186683077065417, 0.132},
                                {5, 40, 3.6543202811475068, 0.318550673422099, 0.1},
                                {5, 60, 2.4035443415993409, 0.363556305923061, 0.0567},
                                {5, 80, 0.84954294118099771, 0.255932739103817, 0.0118}};
  for (const auto& [speed, angle, normal_speed, turned, overlap] : expected) {
    const double dt = thesis::contact_time / 50.0;
    const contact::Adhesion a = thesis::adhesion(5e-19);
    Spheres run = meeting(thesis::contact(), a, dt, speed, angle * degree, 0.37 * dt);
    ASSERT_TRUE(run.run_to_escape(500));
    // The velocity is constant from the edge on: its direction is that of the turned normal plus
    // the angle between normal and velocity.
    const double sideways = speed * std::sin(angle * degree);
    const Vector3 v = run.state().velocity;
    const double left_normal = std::sqrt(std::max(0.0, dot(v, v) - sideways * sideways));
    const double direction = std::atan2(v.y, v.x) - std::atan2(sideways, left_normal);
    // The centrifugal acceleration is off by at most 3 overlap/R, the rate of turning by less.
    EXPECT_NEAR(direction / turned, 1.0, 3.0 * overlap) << speed << " " << angle;
    // Its work in and out cancels but for what the dashpot, which takes 1 - e^2 = 0.1 of the normal
    // energy, takes differently: relative to that energy the centrifugal work is 2 tan^2 overlap/R.
    const double tangent = std::tan(angle * degree);
    EXPECT_NEAR(left_normal / normal_speed, 1.0,
                0.1 * 3.0 * overlap * 2.0 * tangent * tangent * overlap + 1e-9)
        << speed << " " << angle;
  }
}

TEST(SpherePair, ElasticObliqueImpactsKeepEnergyAndAngularMomentum) {
  for (const double hamaker : {0.0, 5e-19})
    for (const double angle : {0.0, 30.0, 60.0, 85.0})
      for (const double part : {2.0, 10.0, 100.0}) {
        const contact::Adhesion a = hamaker > 0.0 ? thesis::adhesion(hamaker) : contact::Adhesion{};
        const double dt = thesis::contact_time / part, v = 0.5;
        Spheres run = meeting(thesis::elastic(), a, dt, v, angle * degree, 0.37 * dt);
        const Vector3 before = run.angular_momentum();
        ASSERT_TRUE(run.run_to_escape(1000));
        // Each step rounds position and velocity a few times.
        const double few = 16.0 * eps * run.steps();
        EXPECT_LT(norm(run.angular_momentum() - before), few * v * contact_distance);
        // Energy: in and out at the same distance. Places of 1 mm are rounded by up to 1.1e-19 m in
        // each direction, their distance, a root of squares, by up to twice that: 4e-19 m per step
        // times the contact's force, K v/w0 at most, is 8e-19 w0/v = 5.4e-14 of the energy.
        EXPECT_NEAR(dot(run.state().velocity, run.state().velocity) / (v * v), 1.0,
                    few + 5.4e-14 * run.steps());
      }
}

TEST(SpherePair, ACapturedElasticPairKeepsEnergyAndAngularMomentum) {
  for (const double around : {0.0, 0.02})
    for (const double part : {2.0, 4.7, 30.0}) {
      const contact::Adhesion a = thesis::adhesion(5e-19);
      const double dt = thesis::contact_time / part;
      const double in = 0.9 * std::sqrt(2.0 * a.tail_energy / thesis::reduced_mass);
      Spheres run(thesis::elastic(), a, particle, particle, dt,
                  {{contact_distance - 1e-9, 0, 0}, {-in, around, 0}});
      run.set_inside(true, 1e-9);
      const double start = run.energy();
      const Vector3 turning = run.angular_momentum();
      double worst = 0.0;
      const int steps = 20000;
      for (int n = 0; n < steps; n++) {
        run.step();
        ASSERT_TRUE(run.last().inside);
        worst = std::max(worst, std::abs(run.energy() - start));
      }
      // The well is F^2/(2 K) + 2 F H_cut deep. Rounding of the distance by a few 1e-19 m per step
      // at a force F adds up at random, 5 sigma; centrifugal energy L^2/(2 R^2) is followed to
      // first order in the overlap x < 4 F/K: the rest, 1.5 u^2 (x/R)^2, comes and goes.
      const double well = 0.5 * a.force * a.force / 800.0 + 2.0 * a.tail_energy;
      const double rounding = 5.0 * std::sqrt(steps) * 4e-19 * a.force;
      const double x = 4.0 * a.force / 800.0 / contact_distance;
      const double centrifugal = 1.5 * thesis::reduced_mass * around * around * x * x;
      EXPECT_LT(worst, rounding + centrifugal) << part << " " << around;
      EXPECT_LT(rounding / well, 1e-8);
      EXPECT_LT(norm(run.angular_momentum() - turning), 16.0 * eps * steps * norm(turning) + 1e-30);
    }
}

TEST(SpherePair, IsReversible) {
  const contact::Adhesion a = thesis::adhesion(5e-19);
  for (const double speed : {0.001, 0.01, 0.5})
    for (const double angle : {0.0, 25.0, 70.0})
      for (const double part : {2.0, 4.0, 17.0}) {
        const double dt = thesis::contact_time / part;
        Spheres run = meeting(thesis::elastic(), a, dt, speed, angle * degree, 0.37 * dt);
        const RelativeState start = run.state();
        const int steps = static_cast<int>(4.0 * part);
        for (int n = 0; n < steps; n++) run.step();
        run.reverse();
        for (int n = 0; n < steps; n++) run.step();
        // 1e-19 m per step, which a slow pair's way through the edge amplifies: the tail's speed of
        // 4e-4 m/s falls to v cos: relative to the speed 1e-9 is 1e-12 m/s and more.
        EXPECT_LT(norm(run.state().velocity + start.velocity), 1e-9 * speed)
            << speed << " " << angle << " " << part;
        EXPECT_LT(norm(run.state().separation - start.separation),
                  1e-9 * (speed * dt * steps + 1e-7))
            << speed << " " << angle << " " << part;
        EXPECT_FALSE(run.last().inside);
      }
}

TEST(SpherePair, JitterBetweenStepsDoesNotLeakEnergyFromTheTally) {
  // A captured elastic pair whose distance others change by up to +-`jitter` between steps. The
  // work of the shift is the change of the stored energy; everything else must balance to rounding.
  std::mt19937 random(5);
  for (const double jitter : {1e-9, 1e-8})
    for (const double part : {2.0, 10.0}) {
      const contact::Adhesion a = thesis::adhesion(5e-19);
      const double dt = thesis::contact_time / part;
      Spheres run = meeting(thesis::elastic(), a, dt, 1e-4, 0.0, 0.37 * dt);
      std::uniform_real_distribution<double> shift(-jitter, jitter);
      const double well = 0.5 * a.force * a.force / 800.0 + 2.0 * a.tail_energy;
      double leak = 0.0, largest = 0.0;
      const int steps = 20000;
      for (int n = 0; n < steps; n++) {
        // A pair that jitter has driven out is sent back.
        if (!run.last().inside && run.approach() < 0.0 && run.distance() > contact_distance + 1e-7)
          run.reverse();
        run.shift({(run.state().separation.x > 0.0 ? 1.0 : -1.0) * shift(random), 0.0, 0.0});
        const double after = run.stored_at(contact_distance - run.distance());
        const double balance = run.kinetic() + after;
        run.step();
        const double change = run.kinetic() + run.stored() - balance;
        leak += change;
        largest = std::max(largest, std::abs(change) / (well + balance + after));
      }
      // Rounding of the distance, 4e-19 m per step at forces of a few F, all one way.
      EXPECT_LT(std::abs(leak), steps * 4e-19 * 10.0 * a.force) << jitter << " " << part;
      EXPECT_LT(largest, 1e-8) << jitter << " " << part;
    }
}

TEST(SpherePair, ReachCoversAllThatCanHappenWithinTheWindow) {
  const contact::Adhesion a = thesis::adhesion(5e-19);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int met = 0;
  for (int n = 0; n < 20000; n++) {
    const double dt = 1e-5;
    const StepWindow window{0.5 * dt, 0.5 * dt};
    const SpherePair pair(contact::normal_contact(thesis::contact(), thesis::reduced_mass), a,
                          contact_distance, dt);
    const Vector3 v{uniform(random), uniform(random), uniform(random)};
    const Vector3 x{contact_distance * (1.0 + 0.01 * uniform(random)), 0.0, 0.0};
    const PairStep step = pair.advance({x, v}, window, false);
    const bool happens = norm(step.change.velocity) > 0.0;
    met += happens;
    if (happens) {
      EXPECT_TRUE(pair.within_reach({x, v}, window));
    }
  }
  EXPECT_GT(met, 1000);
}

TEST(SpherePair, RangesInWhichPairsTurnAsTouching) {
  // At the limit L^2/D^3 is a tenth too much.
  const double limit = largest_range_over_distance;
  EXPECT_NEAR((1.0 + limit) * (1.0 + limit) * (1.0 + limit), 1.1, 0.005);
  EXPECT_NO_THROW(require_turns_as_touching({1.0, 3.0 * limit, 0.0}, 3.0));
  expect_refused([&] { require_turns_as_touching({1.0, 0.11, 0.0}, 3.0); },
                 "surface cut-off H_cut of the contact = 0.11: must not be above 0.1");
  EXPECT_NO_THROW(require_turns_as_touching({0.0, 3.0, 0.0}, 3.0));
}

}  // namespace cohesion::event_stepping
