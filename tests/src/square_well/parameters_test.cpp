// SPDX-License-Identifier: BSD-3-Clause
#include "square_well/parameters.h"

#include <limits>

#include "refuses.h"

namespace cohesion::square_well {

TEST(WellParameters, EdgeIsTheSumOfBothOuterRadii) {
  const SquareWellParameters p{0.3, 1.5, 1.25};
  EXPECT_DOUBLE_EQ(edge(p, 2.0, 4.0), 8.0);
  EXPECT_DOUBLE_EQ(width(p, 2.0, 4.0), 2.0);
  EXPECT_DOUBLE_EQ(edge(reversed(p), 4.0, 2.0), 8.0);
  EXPECT_DOUBLE_EQ(width(p, 2.0, 0.0), 1.0);  // beside a wall: (ratio - 1) r
}

TEST(WellParameters, BoundsOfTheEdgeHoldForAnyRadii) {
  for (const SquareWellParameters& p :
       {well(0.3, 1.01), SquareWellParameters{0.3, 1.5, 1.25}, SquareWellParameters{0.3, 1.0, 2.0}})
    for (const double other : {1e-3, 0.5, 1.0, 7.0, 1e3}) {
      const double share = edge(p, 1.0, other) / (1.0 + other);
      EXPECT_LT(edge_bounds(p, false).inside, share * share);
      EXPECT_GT(edge_bounds(p, false).outside, share * share);
    }
  // The nearest that they can be: those of a material with itself, and beside a wall, whose ratio
  // counts nothing.
  for (const EdgeBounds& b :
       {edge_bounds(well(0.3, 1.5), false), edge_bounds({0.3, 1.5, 9.0}, true)}) {
    EXPECT_NEAR(b.inside, 2.25, 1e-11);
    EXPECT_NEAR(b.outside, 2.25, 1e-11);
  }
}

TEST(WellParameters, UnlikeMaterialsTakeTheMeanDepthAndEachItsRatio) {
  const SquareWellParameters m = mixed(well(0.2, 1.5), well(0.8, 1.1));
  EXPECT_DOUBLE_EQ(m.depth, 0.4);
  EXPECT_EQ(m.ratio_i, 1.5);
  EXPECT_EQ(m.ratio_j, 1.1);
  EXPECT_EQ(mixed(well(0.2, 1.5), {}).depth, 0.0);
}

TEST(WellParameters, AsAnAdhesionAllOfTheEnergyIsAtTheEdge) {
  const contact::Adhesion a = adhesion_of(well(0.3, 1.5), 2.0, 4.0);
  EXPECT_EQ(a.force, 0.0);
  EXPECT_DOUBLE_EQ(a.cutoff, 3.0);
  EXPECT_EQ(a.tail_energy, 0.3);
  EXPECT_EQ(adhesion_of(well(0.0, 1.5), 2.0, 4.0).cutoff, 0.0);  // no well has no width
}

TEST(WellParameters, RefuseWhatIsNoWell) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused([&] { require_valid(well(-1e-11, 1.01)); }, "depth D");
  expect_refused([&] { require_valid(well(nan, 1.01)); }, "depth D");
  expect_refused([&] { require_valid(well(1e-11, 0.99)); }, "ratio r_out/r");
  EXPECT_NO_THROW(require_valid(well(1e-11, 3.0)));
  expect_refused([&] { require_valid(well(1e-11, 3.01)); }, "must not be above 3");
  expect_refused([&] { require_valid(well(1e-11, nan)); }, "ratio r_out/r");
  require_valid(well(1e-11, 1.0));
}

}  // namespace cohesion::square_well
