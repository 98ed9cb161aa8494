// SPDX-License-Identifier: BSD-3-Clause
#include "powder/two_fluid_filter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "named_table.h"

namespace cohesion::powder {
namespace {

CellFilter filter(const char* name) { return find_by_name(cell_filters, "filter", name); }

/// Of 75 um and 1500 kg/m3 in air
CellOfGrains cell_of(double size) { return {size, {75e-6, 1500.0}, {1.2, 1.8e-5}, 9.81}; }

}  // namespace

TEST(CellFilter, IsNoneUnlessItIsNamed) { EXPECT_EQ(filter("none").factor, nullptr); }

TEST(CellFilter, OfIgciMeasuresCellsByStokesTerminalSpeed) {
  // v_t = (1500 - 1.2) 9.81 (75e-6)^2/(18 1.8e-5), g Delta/v_t^2
  const double speed = 1498.8 * 9.81 * 75e-6 * 75e-6 / (18.0 * 1.8e-5);
  for (const double phi : {0.0, 0.01, 0.1, 0.3, 0.5, 0.62})
    EXPECT_NEAR(filter("igci").factor(phi, cell_of(0.01)),
                drag::Igci::factor(phi, 0.01 * 9.81 / (speed * speed)), 1e-14)
        << phi;
}

TEST(CellFilter, OfRadlAndSundaresanIsThatOfParticlesInSuchCells) {
  const double speed = terminal_speed({75e-6, 1500.0}, {1.2, 1.8e-5}, 9.81);
  // L = (v_t d)^(2/3)/g^(1/3). The speed is the root of its balance to a few roundings.
  const double length = std::pow(speed * 75e-6, 2.0 / 3.0) / std::pow(9.81, 1.0 / 3.0);
  EXPECT_NEAR(length, 0.30e-3, 0.005e-3);
  for (const double size : {1e-4, 1e-3, 1e-2})
    for (const double phi : {0.0, 0.01, 0.1, 0.3, 0.5, 0.62})
      EXPECT_NEAR(filter("radlSundaresan").factor(phi, cell_of(size)),
                  drag::RadlSundaresan::factor(phi, size / length), 1e-14)
          << phi << " " << size;
}

TEST(CellFilter, OfRadlAndSundaresanRefusesWhatDoesNotFall) {
  EXPECT_THROW(filter("radlSundaresan").factor(0.1, {0.01, {75e-6, 1.0}, {1.2, 1.8e-5}, 9.81}),
               InvalidParameter);
}

}  // namespace cohesion::powder
