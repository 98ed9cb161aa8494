// SPDX-License-Identifier: BSD-3-Clause
// fix gas/coupling in a real LAMMPS or LIGGGHTS, written to and read from outside as a gas solver
// does it. Runs on any number of ranks: every rank checks the particles that it owns.

#include <gtest/gtest.h>
#include <mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "gas_coupling_engine.h"
#include "sphere.h"

namespace {

using cohesion::drag::GasOnParticle;
using Six = std::array<double, 6>;

constexpr double rounding = std::numeric_limits<double>::epsilon();

/// Velocity half a step later, where the engine's integrator takes and leaves the drag.
double half_step_velocity(Engine& engine, int i, int k, double dt) {
  return engine.atom().v[i][k] + 0.5 * dt * engine.atom().f[i][k] / engine.atom().rmass[i];
}

/// Different for every particle, and for every entry of its row.
double mark(int tag, int entry) { return 100.0 * tag + entry; }

void mark_rows(Engine& engine, double drag_coefficient_scale) {
  for (int i = 0; i < engine.atom().nlocal; i++) {
    auto* row = reinterpret_cast<double*>(&engine.gas(i));
    for (int k = 0; k < GasOnParticle::size; k++) row[k] = mark(engine.atom().tag[i], k);
    engine.gas(i).drag_coefficient *= drag_coefficient_scale;
    for (double& gradient : engine.gas(i).pressure_gradient) gradient *= drag_coefficient_scale;
  }
}

TEST(FixGasCoupling, ParticlesStartWithoutGas) {
  Engine engine;
  engine.fill(6, 1e-5, false);
  for (int i = 0; i < engine.atom().nlocal; i++) {
    const auto* row = reinterpret_cast<double*>(&engine.gas(i));
    for (int k = 0; k < GasOnParticle::size; k++) EXPECT_EQ(row[k], 0.0);
    for (int k = 0; k < 3; k++) EXPECT_EQ(engine.atom().f[i][k], 0.0);
  }
  EXPECT_EQ(engine.extract("gsa"), nullptr);
}

// The drag of a step is exact for velocities at half steps, whatever x = b dt/m: from
// v_(1/2) on, v_(n+1/2) - v_inf = (v_(1/2) - v_inf) exp(-x n), v_inf = u + F/b.
void relax(double x) {
  constexpr double dt = 1e-5;
  constexpr int steps = 40;
  Engine engine;
  engine.fill(6, dt, true);
  const double u[3] = {0.3, -0.2, 0.7}, gradient[3] = {100.0, 50.0, -12000.0};
  std::vector<std::array<double, 3>> first(7);
  auto& atom = engine.atom();
  for (int i = 0; i < atom.nlocal; i++) {
    engine.gas(i).drag_coefficient = x * atom.rmass[i] / dt;
    std::copy_n(u, 3, engine.gas(i).velocity);
    std::copy_n(gradient, 3, engine.gas(i).pressure_gradient);
  }
  std::vector<double> mine(21, 0.0), all(21, 0.0);
  for (int i = 0; i < atom.nlocal; i++)
    for (int k = 0; k < 3; k++)
      mine[3 * atom.tag[i] - 3 + k] = half_step_velocity(engine, i, k, dt);
  MPI_Allreduce(mine.data(), all.data(), 21, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);

  engine.command("run " + std::to_string(steps) + " pre no post no");
  for (int i = 0; i < atom.nlocal; i++)
    for (int k = 0; k < 3; k++) {
      const double b = x * atom.rmass[i] / dt;
      const double force = (k == 2 ? -gravity * atom.rmass[i] : 0.0) -
                           cohesion::sphere_volume(atom.radius[i]) * gradient[k];
      const double terminal = u[k] + force / b;
      const double start = all[3 * atom.tag[i] - 3 + k];
      const double expected = terminal + (start - terminal) * std::exp(-x * steps);
      // Each step rounds a handful of numbers of the size of the velocities, 10 at most; gravity is
      // handed over in six decimals, which it has exactly.
      EXPECT_NEAR(half_step_velocity(engine, i, k, dt), expected,
                  steps * 8 * rounding * (10.0 + std::abs(terminal)))
          << "x = " << x << " component " << k;
    }
}

TEST(FixGasCoupling, RelaxesToTerminalVelocityExactlyAtAnyStep) {
  for (const double x : {1e-3, 0.1, 1.0, 20.0}) relax(x);
}

// Reading v at whole steps: against the exponential the error is that of the half step that
// velocity Verlet starts and ends with, cosh(x/2)^2 - 1 = x^2/4 of the distance from v_inf.
TEST(FixGasCoupling, FollowsTheExponentialToSecondOrderAtWholeSteps) {
  constexpr double dt = 1e-5, x = 0.01;
  constexpr int steps = 100;
  Engine engine;
  engine.fill(4, dt, false);
  auto& atom = engine.atom();
  for (int i = 0; i < atom.nlocal; i++) engine.gas(i).drag_coefficient = x * atom.rmass[i] / dt;
  engine.command("run " + std::to_string(steps));
  for (int i = 0; i < atom.nlocal; i++) {
    const double exact = (2.0 + atom.tag[i] - 1) * std::exp(-x * steps);
    EXPECT_NEAR(atom.v[i][0], exact, 0.26 * x * x * exact);
  }
}

TEST(FixGasCoupling, ImpulsesAreTheChangeOfMomentum) {
  constexpr double dt = 1e-5;
  constexpr int steps = 200;
  Engine engine;
  engine.fill(6, dt, true);
  auto& atom = engine.atom();
  for (int i = 0; i < atom.nlocal; i++) {
    GasOnParticle& gas = engine.gas(i);
    gas.drag_coefficient = 1e-4 * atom.tag[i];
    for (int k = 0; k < 3; k++) gas.velocity[k] = 0.1 * (k + atom.tag[i]);
    for (int k = 0; k < 3; k++) gas.pressure_gradient[k] = 1000.0 * (k - 1) * atom.tag[i];
  }
  std::fill_n(engine.impulse(), 6, 0.0);
  std::vector<double> mine(21, 0.0), before(21, 0.0);
  for (int i = 0; i < atom.nlocal; i++)
    for (int k = 0; k < 3; k++)
      mine[3 * atom.tag[i] - 3 + k] = half_step_velocity(engine, i, k, dt);
  MPI_Allreduce(mine.data(), before.data(), 21, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  engine.command("run " + std::to_string(steps) + " pre no post no");

  Six expected{}, felt{}, total{};
  for (int i = 0; i < atom.nlocal; i++)
    for (int k = 0; k < 3; k++) {
      const double m = atom.rmass[i];
      const double change =
          m * (half_step_velocity(engine, i, k, dt) - before[3 * atom.tag[i] - 3 + k]);
      const double pressure =
          -cohesion::sphere_volume(atom.radius[i]) * 1000.0 * (k - 1) * atom.tag[i] * dt * steps;
      const double weight = k == 2 ? -m * gravity * dt * steps : 0.0;
      // m v is rounded in each step, v at most 10.
      const double tolerance = steps * 4 * rounding * m * 10.0;
      EXPECT_NEAR(engine.gas(i).drag_impulse[k], change - pressure - weight, tolerance);
      expected[k] += engine.gas(i).drag_impulse[k];
      expected[3 + k] += pressure;
    }
  MPI_Allreduce(expected.data(), felt.data(), 6, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  MPI_Allreduce(engine.impulse(), total.data(), 6, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  for (int k = 0; k < 6; k++) {
    // Two sums of the same numbers in another order; their size is that of drag and pressure.
    EXPECT_NEAR(total[k], felt[k], 6 * steps * rounding * 1e-4) << "component " << k;
  }
  EXPECT_NE(total[0], 0.0);
  EXPECT_NE(total[3], 0.0);
}

TEST(FixGasCoupling, ASetUpRecordsNoImpulse) {
  Engine engine;
  engine.fill(6, 1e-5, true);
  mark_rows(engine, 1e-6);
  std::fill_n(engine.impulse(), 6, 0.0);
  engine.command("run 0");
  for (int k = 0; k < 6; k++) EXPECT_EQ(engine.impulse()[k], 0.0);
  for (int i = 0; i < engine.atom().nlocal; i++)
    for (int k = 0; k < 3; k++)
      EXPECT_EQ(engine.gas(i).drag_impulse[k], mark(engine.atom().tag[i], 7 + k));
  // The forces themselves are on, and their sums are what the fix shows.
  double mine = 0.0, all = 0.0;
  for (int i = 0; i < engine.atom().nlocal; i++) mine += engine.atom().f[i][0];
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_NE(all, 0.0);
  EXPECT_NEAR(engine.variable("f_gas[1]+f_gas[4]"), all, 20 * rounding * std::abs(all));
}

TEST(FixGasCoupling, RowsMoveWithTheParticles) {
  Engine engine;
  engine.fill(12, 1e-5, false);
  auto& atom = engine.atom();
  mark_rows(engine, 0.0);
  std::set<int> mine, now;
  std::vector<int> order, order_now;
  for (int i = 0; i < atom.nlocal; i++) {
    mine.insert(atom.tag[i]);
    order.push_back(atom.tag[i]);
  }
  // 0.02 to 0.13 m of a box of 0.1 m: some change rank, some cross the boundary.
  engine.command("run 1000 pre no post no");
  for (int i = 0; i < atom.nlocal; i++) {
    now.insert(atom.tag[i]);
    order_now.push_back(atom.tag[i]);
    const auto* row = reinterpret_cast<double*>(&engine.gas(i));
    for (int k = 0; k < GasOnParticle::size; k++) {
      const bool zeroed = k == 0 || (k >= 4 && k < 7);
      EXPECT_EQ(row[k], zeroed ? 0.0 : mark(atom.tag[i], k)) << "particle " << atom.tag[i];
    }
  }
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (ranks > 1)
    EXPECT_NE(mine, now) << "no particle changed rank";
  else
    EXPECT_NE(order, order_now) << "no particle changed its place in memory";
}

TEST(FixGasCoupling, RestartKeepsTheRows) {
  Engine engine;
  engine.fill(12, 1e-5, false);
  mark_rows(engine, 0.0);
  // A second fix of this kind: each must find its own values in the file.
  engine.command("fix other all gas/coupling");
  const std::string file = std::string(std::getenv("COHESION_TEST_FOLDER")) + "/gas.restart";
  engine.command("run 10");
  engine.command("write_restart " + file);
  engine.command("clear");
  engine.commands(load_styles());
  engine.command("newton off");
  engine.command("read_restart " + file);
  engine.commands(no_contacts());
  engine.command("fix gas all gas/coupling");
  engine.command("fix other all gas/coupling");
  engine.command("fix move all nve/sphere");
  engine.command("run 0");
  ASSERT_EQ(engine.variable("atoms"), 12);
  for (int i = 0; i < engine.atom().nlocal; i++) {
    const auto* row = reinterpret_cast<double*>(&engine.gas(i));
    for (int k : {1, 2, 3, 7, 8, 9}) EXPECT_EQ(row[k], mark(engine.atom().tag[i], k));
    EXPECT_EQ(engine.gas(i, "other").velocity[0], 0.0);
  }
}

/// A row of the liquid that is different for every particle, and moves none.
void mark_liquid(Engine& engine, const std::string& fix = "gas") {
  for (int i = 0; i < engine.atom().nlocal; i++) {
    cohesion::liquid::LiquidOnParticle& row = engine.liquid(i, fix);
    row = {};
    row.added_mass = mark(engine.atom().tag[i], 20) * 1e-12;
    row.drag_per_slip = mark(engine.atom().tag[i], 21) * 1e-12;
  }
}

void expect_marked_liquid(Engine& engine, const std::string& fix = "gas") {
  for (int i = 0; i < engine.atom().nlocal; i++) {
    EXPECT_EQ(engine.liquid(i, fix).added_mass, mark(engine.atom().tag[i], 20) * 1e-12);
    EXPECT_EQ(engine.liquid(i, fix).drag_per_slip, mark(engine.atom().tag[i], 21) * 1e-12);
    EXPECT_EQ(engine.liquid(i, fix).lift[2], 0.0);
  }
}

TEST(FixGasCoupling, RowsOfTheLiquidMoveWithTheParticles) {
  Engine engine;
  engine.fill(12, 1e-5, false);
  mark_rows(engine, 0.0);
  mark_liquid(engine);
  engine.command("run 1000 pre no post no");
  expect_marked_liquid(engine);
}

TEST(FixGasCoupling, RestartKeepsTheRowsOfTheLiquid) {
  Engine engine;
  engine.fill(12, 1e-5, false);
  mark_rows(engine, 0.0);
  // One with a liquid, one without: rows of two lengths in the file.
  engine.command("fix other all gas/coupling");
  engine.command("run 0");
  mark_liquid(engine, "other");
  const std::string file = std::string(std::getenv("COHESION_TEST_FOLDER")) + "/liquid.restart";
  engine.command("write_restart " + file);
  engine.command("clear");
  engine.commands(load_styles());
  engine.command("newton off");
  engine.command("read_restart " + file);
  engine.commands(no_contacts());
  engine.command("fix gas all gas/coupling");
  engine.command("fix other all gas/coupling");
  engine.command("fix move all nve/sphere");
  engine.command("run 0");
  ASSERT_EQ(engine.variable("atoms"), 12);
  expect_marked_liquid(engine, "other");
  for (int i = 0; i < engine.atom().nlocal; i++)
    EXPECT_EQ(engine.gas(i).velocity[1], mark(engine.atom().tag[i], 2));
  engine.extract("no_liquid", "other");
  mark_liquid(engine);
  expect_marked_liquid(engine);
}

// Gravity and the pressure of a liquid at rest on spheres with its added mass: from half step to
// half step the velocity grows by (rho V - m) g/(m + rho V/2) dt. What the fix tells beside
// pressure is what the added mass takes.
TEST(FixGasCoupling, AddedMassIsMovedWithTheSphere) {
  constexpr double dt = 1e-5, rho = 1e6;
  constexpr int steps = 20;
  Engine engine;
  engine.fill(6, dt, true);
  auto& atom = engine.atom();
  std::vector<double> mine(7, 0.0), before(7, 0.0);
  for (int i = 0; i < atom.nlocal; i++) {
    engine.liquid(i).added_mass = 0.5 * rho * cohesion::sphere_volume(atom.radius[i]);
    engine.gas(i).pressure_gradient[2] = -rho * gravity;
  }
  for (int i = 0; i < atom.nlocal; i++) mine[atom.tag[i]] = half_step_velocity(engine, i, 2, dt);
  MPI_Allreduce(mine.data(), before.data(), 7, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  engine.command("run " + std::to_string(steps) + " pre no post no");
  for (int i = 0; i < atom.nlocal; i++) {
    const double displaced = rho * cohesion::sphere_volume(atom.radius[i]), m = atom.rmass[i];
    const double gained = (displaced - m) * gravity / (m + 0.5 * displaced) * dt * steps;
    const double found = half_step_velocity(engine, i, 2, dt) - before[atom.tag[i]];
    EXPECT_NEAR(found, gained, steps * 8 * rounding);
    EXPECT_NEAR(engine.gas(i).drag_impulse[2] / (-0.5 * displaced * gained), 1.0, 1e-12);
  }
}

TEST(FixGasCoupling, RowsAreOutputPerAtom) {
  Engine engine;
  engine.fill(12, 1e-5, false);
  mark_rows(engine, 0.0);
  engine.command("compute rows all reduce sum f_gas[2] f_gas[10]");
  engine.command("thermo_style custom step c_rows[1] c_rows[2]");
  engine.command("run 0");
  double expected[2] = {0.0, 0.0};
  for (int tag = 1; tag <= 12; tag++) {
    expected[0] += mark(tag, 1);
    expected[1] += mark(tag, 9);
  }
  EXPECT_EQ(engine.variable("c_rows[1]"), expected[0]);  // sums of integers
  EXPECT_EQ(engine.variable("c_rows[2]"), expected[1]);
}

TEST(FixGasCoupling, OnlyItsGroupFeelsTheGas) {
  Engine engine;
  engine.fill(6, 1e-5, false);
  engine.command("unfix gas");
  engine.command("group some id 1 3");
  engine.command("fix gas some gas/coupling");
  engine.command("run 0");
  mark_rows(engine, 1e-6);
  engine.command("run 0");
  for (int i = 0; i < engine.atom().nlocal; i++) {
    const bool inside = engine.atom().tag[i] == 1 || engine.atom().tag[i] == 3;
    EXPECT_EQ(engine.atom().f[i][0] != 0.0, inside);
  }
}

/// What extract() says of gravity along z, of all ranks.
std::array<double, 2> gravity_along_z(Engine& engine) {
  const auto* range = static_cast<double*>(engine.extract("gravity"));
  if (range == nullptr) return {0.0, 0.0};
  std::array<double, 2> low_and_minus_high{range[2], -range[5]}, all{};
  MPI_Allreduce(low_and_minus_high.data(), all.data(), 2, MPI_DOUBLE, MPI_MIN, MPI_COMM_WORLD);
  return {all[0], -all[1]};
}

TEST(FixGasCoupling, TellsTheGravityOfTheParticlesThatMove) {
  Engine engine;
  engine.fill(6, 1e-5, true);
  mark_rows(engine, 1e-6);
  engine.command("run 0");
  std::vector<double> before;
  for (int i = 0; i < 3 * engine.atom().nlocal; i++) before.push_back(engine.atom().f[0][i]);
  // A weight over a mass rounds twice.
  for (const double found : gravity_along_z(engine))
    EXPECT_NEAR(found, -gravity, 2 * rounding * gravity);
  for (std::size_t i = 0; i < before.size(); i++) EXPECT_EQ(engine.atom().f[0][i], before[i]);

  engine.command("group some id 2 3");
  engine.command("fix more some gravity 2 vector 0 0 1");
  engine.command("run 0");
  EXPECT_NEAR(gravity_along_z(engine)[1], 2 - gravity, 3 * rounding * gravity);
  // Those that have more of it are held.
  engine.command("fix hold some freeze");
  engine.command("run 0");
  EXPECT_NEAR(gravity_along_z(engine)[1], -gravity, 2 * rounding * gravity);
  engine.command("unfix move");
  engine.command("run 0");
  const auto none = gravity_along_z(engine);
  EXPECT_GT(none[0], none[1]);
}

TEST(FixGasCoupling, NamesTheFixesWhoseForcesItDoesNotSee) {
  Engine engine;
  engine.fill(2, 1e-5, true);
  EXPECT_EQ(engine.extract("unseen_fixes"), nullptr);
  engine.command("fix flat all planeforce 0 0 1");
  EXPECT_EQ(engine.extract("unseen_fixes"), nullptr);
  engine.command("fix late all addforce 0 0 1");
  engine.command("fix later all gravity 1 vector 0 0 1");
  const auto* fixes = static_cast<char*>(engine.extract("unseen_fixes"));
  ASSERT_NE(fixes, nullptr);
  EXPECT_STREQ(fixes, "fix late addforce, fix later gravity");
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  testing::InitGoogleTest(&argc, argv);
  int result = RUN_ALL_TESTS();
  MPI_Allreduce(MPI_IN_PLACE, &result, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Finalize();
  return result;
}
