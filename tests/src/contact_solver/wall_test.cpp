// SPDX-License-Identifier: BSD-3-Clause
#include "contact_solver/wall.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "constants.h"

namespace {

using cohesion::Vector3;
using cohesion::contact_solver::FarFromWalls;
using cohesion::contact_solver::is_behind;
using cohesion::contact_solver::StepWindow;
using cohesion::contact_solver::Wall;
using cohesion::contact_solver::WallCourse;
using cohesion::contact_solver::WallMotion;
using cohesion::contact_solver::WallPoint;
using cohesion::contact_solver::WallState;

constexpr double step = 1e-3;
constexpr StepWindow whole{0.5 * step, 0.5 * step};

WallMotion swing() { return {{}, {0.0, 0.0, 0.01}, 0.05, 0.0}; }

double place(double t) { return 0.01 * (1.0 - std::cos(2.0 * cohesion::pi * t / 0.05)); }

TEST(WallMotion, ConstantVelocityIsExact) {
  WallMotion motion;
  motion.velocity = {0.1, -0.2, 0.3};
  for (const StepWindow& window : {whole, StepWindow{0.0, 0.5 * step}}) {
    const WallState now = motion.over(7 * step, window);
    EXPECT_EQ(now.velocity.z, 0.3);
    EXPECT_EQ(now.displacement.y, -0.2 * (7 * step));
  }
}

// Some ten operations on places of 0.02 m at most, rounded by 2e-18 m each.
TEST(WallMotion, ChordJoinsThePlacesAtBothEndsOfTheStep) {
  for (int n = 0; n < 60; n++) {
    const double t = n * step;
    const WallState now = swing().over(t, whole);
    EXPECT_NEAR(now.displacement.z - 0.5 * step * now.velocity.z, place(t - 0.5 * step), 2e-17);
    EXPECT_NEAR(now.displacement.z + 0.5 * step * now.velocity.z, place(t + 0.5 * step), 2e-17);
  }
}

TEST(WallMotion, FirstStepStartsAtTheGridPoint) {
  const WallState now = swing().over(0.0, {0.0, 0.5 * step});
  EXPECT_NEAR(now.displacement.z, 0.0, 2e-17);
  EXPECT_NEAR(now.displacement.z + 0.5 * step * now.velocity.z, place(0.5 * step), 2e-17);
}

// Steps of 1, 0.5 and 2 ms are exact sums of halves of the first; the swing is that of place().
TEST(WallCourse, GoesOnWhenTheStepChanges) {
  WallCourse course(swing());
  double t = 0.0;
  for (const double dt : {step, 0.5 * step, 2.0 * step, step})
    for (int n = 0; n < 13; n++) {
      course.begin_step(dt);
      t += dt;
      const WallState now = course.over({0.5 * dt, 0.5 * dt});
      EXPECT_NEAR(course.time(), t, 1e-16);
      EXPECT_NEAR(now.displacement.z + 0.5 * dt * now.velocity.z, place(t + 0.5 * dt), 1e-15);
    }
}

// With one step the time is a product, as that of steps that are counted.
TEST(WallCourse, TimeIsAMultipleOfTheStep) {
  WallCourse course(swing());
  for (int n = 1; n < 1000; n++) {
    course.begin_step(step);
    EXPECT_EQ(course.time(), n * step);
  }
}

TEST(WallCourse, ContinuesTheSameMotionToTheLastBit) {
  WallCourse run(swing());
  for (int n = 0; n < 37; n++) run.begin_step(step);
  WallCourse again(swing());
  again.continue_from(run.numbers());
  for (int n = 0; n < 20; n++) {
    run.begin_step(step);
    again.begin_step(step);
    EXPECT_EQ(again.over(whole).displacement.z, run.over(whole).displacement.z);
  }
}

TEST(WallCourse, AnotherMotionBeginsWhereTheWallIs) {
  WallCourse before(swing());
  for (int n = 0; n < 37; n++) before.begin_step(step);
  WallMotion motion;
  motion.velocity = {0.0, 0.0, 0.3};
  WallCourse after(motion);
  after.continue_from(before.numbers());
  EXPECT_NEAR(after.over(whole).displacement.z, place(37 * step), 1e-16);
  after.begin_step(step);
  EXPECT_NEAR(after.over(whole).displacement.z, place(37 * step) + 0.3 * step, 1e-16);
  WallCourse still{WallMotion{}};
  still.continue_from(after.numbers());
  EXPECT_NEAR(still.over(whole).displacement.z, place(37 * step) + 0.3 * step, 1e-16);
  EXPECT_EQ(still.over(whole).velocity.z, 0.0);
}

TEST(Wall, IsNotFeltFromBehindUntilItIsClear) {
  constexpr double clear = 0.5;
  EXPECT_TRUE(is_behind(false, 0.0, clear));
  EXPECT_TRUE(is_behind(false, -0.1, clear));
  EXPECT_TRUE(is_behind(true, 0.4, clear));
  EXPECT_FALSE(is_behind(true, 0.5, clear));
  EXPECT_FALSE(is_behind(false, 0.1, clear));
}

TEST(WallMotion, RefusesAPeriodThatIsNotPositive) {
  WallMotion motion = swing();
  for (const double period : {0.0, -1.0}) {
    motion.period = period;
    EXPECT_THROW(require_valid(motion), cohesion::InvalidParameter);
  }
}

TEST(Wall, NearestPointOfAPlane) {
  const WallState moved{{0.0, 0.0, 0.5}, {1.0, 2.0, 3.0}};
  const WallPoint above = Wall{Wall::z_plane, 1.0, 1.0}.nearest({5.0, 6.0, 1.75}, moved, 0.0);
  EXPECT_EQ(above.distance, 0.25);
  EXPECT_EQ(above.separation.z, -0.25);
  EXPECT_EQ(above.velocity.y, 2.0);
  const WallPoint below = Wall{Wall::x_plane, -1.0, 7.0}.nearest({5.0, 6.0, 1.75}, moved, 0.0);
  EXPECT_EQ(below.distance, 2.0);
  EXPECT_EQ(below.separation.x, 2.0);
  EXPECT_LT((Wall{Wall::x_plane, -1.0, 4.0}.nearest({5.0, 6.0, 1.75}, moved, 0.0).distance), 0.0);
}

TEST(Wall, NearestPointOfACylinder) {
  const Wall cylinder{Wall::z_cylinder, 1.0, 10.0};
  const WallPoint point = cylinder.nearest({3.0, 4.0, -2.0}, {}, 2.0);
  EXPECT_DOUBLE_EQ(point.distance, 5.0);
  EXPECT_DOUBLE_EQ(point.separation.x, 3.0);
  EXPECT_DOUBLE_EQ(point.separation.y, 4.0);
  EXPECT_EQ(point.separation.z, 0.0);
  // Clockwise from above.
  EXPECT_DOUBLE_EQ(point.velocity.x, 1.6);
  EXPECT_DOUBLE_EQ(point.velocity.y, -1.2);
  EXPECT_LT(cylinder.nearest({30.0, 4.0, -2.0}, {}, 0.0).distance, 0.0);
  EXPECT_EQ(cylinder.nearest({0.0, 0.0, 0.0}, {}, 2.0).distance, 10.0);
}

// A distance is rounded by a few units of 1 at 1e-16; nearer to the reach either is right.
TEST(FarFromWalls, AgreesWithTheDistanceFromEachWall) {
  const std::vector<std::vector<Wall>> all{
      {{Wall::x_plane, 1.0, -0.5}},
      {{Wall::y_plane, 1.0, -0.7}, {Wall::y_plane, -1.0, 0.6}, {Wall::z_plane, -1.0, 0.5}},
      {{Wall::z_cylinder, 1.0, 0.9}, {Wall::z_plane, 1.0, -0.4}, {Wall::z_plane, 1.0, -0.6}},
      {{Wall::z_cylinder, 1.0, 0.1}}};
  const WallState now{{0.05, -0.1, 0.15}, {}};
  const double reach = 0.2;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (const std::vector<Wall>& walls : all) {
    const FarFromWalls far(walls, now.displacement, reach);
    int found = 0;
    for (int n = 0; n < 10000; n++) {
      const Vector3 centre{any(random), any(random), any(random)};
      double least = std::numeric_limits<double>::infinity();
      for (const Wall& wall : walls)
        least = std::min(least, wall.nearest(centre, now, 0.0).distance);
      const double x[] = {centre.x, centre.y, centre.z};
      if (std::abs(least - reach) > 1e-14) {
        EXPECT_EQ(far.contains(x), least > reach);
      }
      found += far.contains(x);
    }
    EXPECT_EQ(found > 0, walls[0].position != 0.1);
  }
}

}  // namespace
