// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "hard_sphere/event_simulation.h"
#include "hard_sphere/gas_of_spheres.h"

namespace cohesion::hard_sphere {

/// Compares the neighbour lists of a simulation with a search through all images of all pairs.
class NeighbourListCheck {
 public:
  /// A distance within the fraction `round_off` of a surface can be on either side of it.
  explicit NeighbourListCheck(EventSimulation& simulation, double round_off = 1e-12)
      : simulation_(simulation),
        lists_(simulation.neighbour_lists()),
        now_(simulation.end()),
        round_off_(round_off),
        count_(static_cast<int>(simulation.bodies.size())) {}

  int within = 0;  // pairs closer than the edge, each counted twice

  void check() {
    for (int i = 0; i < count_; i++) {
      check_list(i);
      for (int j = 0; j < count_; j++) {
        if (j == i) continue;
        for_each_image(simulation_.box(), now_, position(j) - position(i), 1,
                       [&](const Vector3& boxes, const Vector3& r) { check(i, j, boxes, r); });
      }
    }
  }

 private:
  Vector3 position(int i) const { return simulation_.flights[i].at(now_); }

  void check(int i, int j, const Vector3& boxes, const Vector3& r) {
    const HardSphere &a = simulation_.bodies[i], &b = simulation_.bodies[j];
    const auto surfaces = simulation_.surfaces(i, j);
    const double distance = norm(r);
    if (a.inverse_mass + b.inverse_mass > 0.0) {
      EXPECT_GE(distance, surfaces.core * (1.0 - round_off_)) << i << ' ' << j;
    }
    if (distance >= surfaces.edge * (1.0 - round_off_)) return;
    within++;
    const Neighbour* const n = find(i, j, boxes);
    ASSERT_TRUE(n) << i << ' ' << j;
    EXPECT_EQ(n->inside, surfaces.has_well()) << i << ' ' << j;
    EXPECT_NEAR(simulation_.distance(i, *n, now_), distance, round_off_);
  }

  /// Checks the entries of a list: flags agree with distances, no entry occurs twice, and the list
  /// of the partner has the same pair.
  void check_list(int i) {
    for (const Neighbour* n = lists_.begin(i); n != lists_.end(i); n++) {
      const auto surfaces = simulation_.surfaces(i, n->body);
      if (n->inside) {
        EXPECT_LT(simulation_.distance(i, *n, now_), surfaces.edge * (1.0 + round_off_)) << i;
      } else if (surfaces.has_well()) {
        EXPECT_GT(simulation_.distance(i, *n, now_), surfaces.edge * (1.0 - round_off_)) << i;
      }
      EXPECT_EQ(lists_.find_neighbour(i, n->body, n->image), n);
      if (n->is_wall()) continue;
      const PeriodicImage &image = lists_.image(n->image), &reverse = lists_.image(image.opposite);
      EXPECT_TRUE(same(reverse.displacement, -image.displacement));
      EXPECT_TRUE(same(reverse.velocity, -image.velocity));
      const Neighbour* const back = lists_.find_neighbour(n->body, i, image.opposite);
      ASSERT_TRUE(back) << i << ' ' << n->body;
      EXPECT_EQ(back->inside, n->inside) << i << ' ' << n->body;
    }
  }

  const Neighbour* find(int i, int j, const Vector3& boxes) {
    const auto& box = simulation_.box();
    for (const Neighbour* n = lists_.begin(i); n != lists_.end(i); n++) {
      if (n->body != j) continue;
      const PeriodicImage& image = lists_.image(n->image);
      if (same(image.displacement, box.edges * boxes) && same(image.velocity, box.rates * boxes))
        return n;
    }
    return nullptr;
  }

  EventSimulation& simulation_;
  NeighbourLists& lists_;
  double now_, round_off_;
  int count_;
};

}  // namespace cohesion::hard_sphere
