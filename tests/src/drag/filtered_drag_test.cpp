// SPDX-License-Identifier: BSD-3-Clause
#include "drag/filtered_drag.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "named_table.h"

namespace cohesion::drag {

TEST(RadlSundaresan, HasTheValuesThatAHandFinds) {
  // phi = 0.05: a = 1.96 + 29.40/20 + 164.91/400 - 1923/8000 = 1.96 + 1.47 + 0.412275 - 0.240375;
  // x = 0.02: h = 0.239 + 0.0928 - 0.001764 + 0.00202904.
  EXPECT_NEAR(RadlSundaresan::a(0.05), 3.6019, 1e-12);
  EXPECT_NEAR(RadlSundaresan::h(0.05), 0.33206504, 1e-12);
  // In cells of twice L: 1 - 0.33206504/(3.6019/2 + 1) = 1 - 0.33206504/2.80095
  EXPECT_NEAR(RadlSundaresan::factor(0.05, 2.0), 0.88144556, 1e-8);
  // phi = 0.5: a = 1.79; x = 0.02: h = 0.850 - 0.027 - 0.002452 - 0.0010608
  EXPECT_NEAR(RadlSundaresan::a(0.5), 1.79, 1e-15);
  EXPECT_NEAR(RadlSundaresan::h(0.5), 0.8194872, 1e-12);
}

TEST(RadlSundaresan, LeavesFineCellsFewParticlesAndPackedBedsAsTheyAre) {
  for (const double phi : {0.01, 0.1, 0.3, 0.5})
    EXPECT_NEAR(RadlSundaresan::factor(phi, 1e-9), 1.0, 1e-9) << phi;
  for (const double filter : {0.1, 10.0, 1e9}) {
    EXPECT_EQ(RadlSundaresan::factor(0.0, filter), 1.0) << filter;
    // The root of h is at 0.6 to the roundings of its coefficients.
    EXPECT_NEAR(RadlSundaresan::factor(0.6, filter), 1.0, 1e-14) << filter;
    EXPECT_EQ(RadlSundaresan::factor(0.64, filter), 1.0) << filter;
  }
}

TEST(RadlSundaresan, IsAShareOfTheDragThatFallsWithTheFilter) {
  for (int permille = 1; permille <= 650; permille++) {
    const double phi = permille / 1000.0;
    double last = 1.0;
    for (double filter = 1e-2; filter < 1e4; filter *= 1.5) {
      const double factor = RadlSundaresan::factor(phi, filter);
      ASSERT_GT(factor, 0.0) << phi << " " << filter;
      ASSERT_LE(factor, last) << phi << " " << filter;
      last = factor;
    }
    EXPECT_GT(RadlSundaresan::a(phi), 0.0) << phi;
  }
}

/// Of neighbouring pieces, how far the later is from the earlier where they meet.
template <class Pieces>
double step(const Pieces& pieces, std::size_t i) {
  return pieces[i + 1].at(pieces[i].end) - pieces[i].at(pieces[i].end);
}

TEST(RadlSundaresan, JumpsWhereItIsDocumentedTo) {
  // Half of the last decimal: 5e-4 of either constant, 5e-3 of a slope over 0.16 at most: 1.8e-3.
  for (std::size_t i = 0; i + 1 < RadlSundaresan::h_pieces.size(); i++)
    EXPECT_NEAR(step(RadlSundaresan::h_pieces, i), 0.0, 1.8e-3) << i;
  const double jumps[] = {2.4647 - 21.51, 0.004, -0.001, -0.005, -0.088};
  for (std::size_t i = 0; i + 1 < RadlSundaresan::a_pieces.size(); i++)
    EXPECT_NEAR(step(RadlSundaresan::a_pieces, i), jumps[i], 5e-4) << i;
  const auto fall = [](double phi, double filter) {
    return RadlSundaresan::factor(std::nextafter(phi, 0.0), filter) -
           RadlSundaresan::factor(phi, filter);
  };
  struct {
    double phi, filter, fall;
  } const rows[] = {
      {0.016, 1.0, 0.031}, {0.4, 1.0, 0.010}, {0.016, 10.0, 0.062}, {0.4, 10.0, 0.006}};
  for (const auto& row : rows) EXPECT_NEAR(fall(row.phi, row.filter), row.fall, 5e-4) << row.phi;
}

TEST(FilterLength, IsTheStoppingDistanceByTheFroudeNumber) {
  const double speed = 0.22, d = 75e-6, g = 9.81;
  const double froude = speed * speed / (g * d);
  EXPECT_NEAR(filter_length(speed, d, g) / (speed * speed / g * std::pow(froude, -2.0 / 3.0)), 1.0,
              1e-14);
}

TEST(DragFilter, IsNoneUnlessItIsNamed) {
  EXPECT_EQ(find_by_name(drag_filters, "dragFilter", "none").factor, nullptr);
  EXPECT_EQ(find_by_name(drag_filters, "dragFilter", "radlSundaresan").factor(0.3, 5.0),
            RadlSundaresan::factor(0.3, 5.0));
}

}  // namespace cohesion::drag
