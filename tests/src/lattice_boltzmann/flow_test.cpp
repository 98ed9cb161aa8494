// SPDX-License-Identifier: BSD-3-Clause
#include "lattice_boltzmann/flow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>
#include <vector>

namespace cohesion::lattice_boltzmann {

namespace {

const Grid grid({9, 8, 7});
const Vector force{3e-5, -2e-5, 1e-5};

int wrapped(int i, int n) { return (i % n + n) % n; }

/// The same flow as the method has it on paper: two copies of all populations, nodes by three
/// numbers, nothing in place.
class FlowOnPaper {
 public:
  FlowOnPaper(const Walls& walls, const Relaxation& relaxation)
      : walls_(walls), relaxation_(relaxation), now_(directions, std::vector<double>(504, 0.0)) {}

  void step() {
    auto next = now_;
    for (int n = 0; n < 504; n++)
      for (int q = 0; q < directions; q++) next[q][n] = now_[q][neighbour(n, opposite(q))];
    held = {};
    std::size_t cut = 0;
    for (int s = 0; s < walls_.spheres(); s++)
      for (int q = 1; q < directions; q++)
        for (const Link& link : walls_.links(s, q)) {
          const int n = number(link.node), back = opposite(q);
          const double k = (1.0 - 2.0 * link.distance) / (1.0 + 2.0 * link.distance);
          double came = now_[q][n] + k * (now_[q][neighbour(n, back)] - now_[back][n]);
          if (cut == before_.size()) before_.push_back(0.0);
          came = 0.5 * (came + before_[cut]);
          before_[cut++] = came;
          next[back][n] = came;
          for (int d = 0; d < 3; d++) held[d] += velocity[q][d] * (now_[q][n] + came);
        }
    for (int n = 0; n < 504; n++)
      if (walls_.is_fluid(node(n))) collide(next, n);
    now_ = next;
  }

  Vector velocity_at(int n) const {
    Vector u{};
    for (int q = 0; q < directions; q++)
      for (int d = 0; d < 3; d++) u[d] += now_[q][n] * velocity[q][d];
    for (int d = 0; d < 3; d++) u[d] -= 0.5 * force[d];
    return u;
  }

  static std::size_t node(int n) { return grid.index(n % 9, n / 9 % 8, n / 72); }

  Vector held{};

 private:
  static int neighbour(int n, int q) {
    const auto& c = velocity[q];
    return wrapped(n % 9 + c[0], 9) + 9 * wrapped(n / 9 % 8 + c[1], 8) +
           72 * wrapped(n / 72 + c[2], 7);
  }
  static int number(std::size_t of) {
    for (int n = 0; n < 504; n++)
      if (node(n) == of) return n;
    return -1;
  }

  void collide(std::vector<std::vector<double>>& f, int n) const {
    double density = 0.0;
    Vector u{};
    for (int q = 0; q < directions; q++) {
      density += f[q][n];
      for (int d = 0; d < 3; d++) u[d] += f[q][n] * velocity[q][d];
    }
    for (int d = 0; d < 3; d++) u[d] += 0.5 * force[d];
    std::vector<double> equilibrium(directions), source(directions), old(directions);
    for (int q = 0; q < directions; q++) {
      double cu = 0.0, cg = 0.0, uu = 0.0, ug = 0.0;
      for (int d = 0; d < 3; d++) {
        cu += velocity[q][d] * u[d];
        cg += velocity[q][d] * force[d];
        uu += u[d] * u[d];
        ug += u[d] * force[d];
      }
      equilibrium[q] = weight(q) * (density + 3.0 * cu + 4.5 * cu * cu - 1.5 * uu);
      source[q] = weight(q) * (3.0 * cg + 9.0 * cu * cg - 3.0 * ug);
      old[q] = f[q][n];
    }
    for (int q = 0; q < directions; q++) {
      const int b = opposite(q);
      const auto half = [&](const std::vector<double>& a, double sign) {
        return 0.5 * (a[q] + sign * a[b]);
      };
      const double even = relaxation_.even(), odd = relaxation_.odd();
      f[q][n] = old[q] + even * (half(equilibrium, 1) - half(old, 1)) +
                odd * (half(equilibrium, -1) - half(old, -1)) + (1 - 0.5 * even) * half(source, 1) +
                (1 - 0.5 * odd) * half(source, -1);
    }
  }

  const Walls& walls_;
  Relaxation relaxation_;
  std::vector<std::vector<double>> now_;
  std::vector<double> before_;  // what came back by each link
};

}  // namespace

// In place, by rows and with images: after an odd and an even number of steps, across every face of
// the box, with spheres across faces and an edge and a gap without room. To round-off of
// populations of 1e-4 and sums of some twenty.
TEST(Flow, IsThatOnPaper) {
  const std::vector<FixedSphere> spheres{{{8.7, 0.2, 3.1}, 1.9}, {{4.2, 7.6, 6.8}, 1.7}};
  const Walls walls(grid, spheres);
  const Relaxation relaxation(0.07);
  Flow flow(grid, walls, relaxation);
  flow.set_body_force(force);
  FlowOnPaper paper(walls, relaxation);
  for (int step = 1; step <= 41; step++) {
    flow.step();
    paper.step();
    Vector held{};
    for (const Vector& f : flow.forces())
      for (int d = 0; d < 3; d++) held[d] += f[d];
    for (int d = 0; d < 3; d++) ASSERT_NEAR(held[d], paper.held[d], 1e-16) << step;
    for (int n = 0; n < 504; n++) {
      if (!walls.is_fluid(FlowOnPaper::node(n))) continue;
      const Vector u = flow.velocity_at(FlowOnPaper::node(n)), expected = paper.velocity_at(n);
      for (int d = 0; d < 3; d++) ASSERT_NEAR(u[d], expected[d], 1e-17) << step << ' ' << n;
    }
  }
  EXPECT_GT(flow.superficial_velocity()[0], 1e-5);
}

// Whoever does which part, and when: the bits are the same.
TEST(Flow, DoesNotDependOnHowTheWorkIsShared) {
  const Walls walls(grid, {{{8.7, 0.2, 3.1}, 1.9}, {{4.2, 7.6, 6.8}, 1.7}});
  const Shared backwards = [](int count, const std::function<void(int)>& part) {
    for (int i = count; i-- > 0;) part(i);
  };
  const Shared on_two_threads = [](int count, const std::function<void(int)>& part) {
    std::thread other([&] {
      for (int i = 0; i < count; i += 2) part(i);
    });
    for (int i = 1; i < count; i += 2) part(i);
    other.join();
  };
  const auto run = [&](const Shared& shared) {
    Flow flow(grid, walls, Relaxation(0.07), shared);
    flow.set_body_force(force);
    for (int step = 0; step < 31; step++) flow.step();
    std::vector<Vector> found = flow.forces();
    found.push_back(flow.superficial_velocity());
    return found;
  };
  const std::vector<Vector> expected = run(one_by_one);
  EXPECT_EQ(run(backwards), expected);
  EXPECT_EQ(run(on_two_threads), expected);
}

// Between two walls of spheres there is no exact flow; without any sphere the fluid falls freely,
// and each step adds the force to its velocity.
TEST(Flow, FallsFreelyWithoutSpheres) {
  const Walls walls(grid, {});
  Flow flow(grid, walls, Relaxation(0.2));
  flow.set_body_force(force);
  for (int step = 0; step < 10; step++) flow.step();
  // The half of the last force is yet to come.
  for (int d = 0; d < 3; d++)
    EXPECT_NEAR(flow.superficial_velocity()[d], 9.5 * force[d], 1e-13 * std::abs(force[d]));
}

}  // namespace cohesion::lattice_boltzmann
