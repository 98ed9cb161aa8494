// SPDX-License-Identifier: BSD-3-Clause
#include "kinetic_theory/cohesive_compressibility.h"

#include "kinetic_theory/second_virial.h"
#include "refuses.h"

namespace cohesion::kinetic_theory {
namespace {

/// y/y_HS, [1]
double ratio_of(double phi, double lambda, double depth_over_t) {
  return CohesiveRatio::value(phi, gathered_by_well(lambda, depth_over_t));
}

}  // namespace

TEST(CohesiveCompressibility, IsWithinWhatItSaysOfTheGasesThatWereMeasured) {
  // examples/compressibility: phi, D/T, y/y_HS
  const struct {
    double phi, depth_over_t, ratio;
  } rows[] = {{0.1, 0.3, 0.9295}, {0.1, 1.0, 0.6947}, {0.2, 0.6, 0.8248}, {0.3, 0.3, 0.9097},
              {0.3, 1.0, 0.6298}, {0.4, 0.6, 0.7741}, {0.5, 0.3, 0.8876}, {0.5, 1.0, 0.5979}};
  for (const auto& [phi, depth_over_t, ratio] : rows)
    EXPECT_NEAR(ratio_of(phi, 1.05, depth_over_t), ratio, 0.0071) << phi << " " << depth_over_t;
}

TEST(CohesiveCompressibility, IsTheSecondVirialCoefficientOfFewSpheres) {
  for (const double lambda : {1.01, 1.05, 1.2})
    for (const double depth_over_t : {0.0, 0.5, 1.0})
      EXPECT_NEAR(ratio_of(1e-9, lambda, depth_over_t), second_virial_of_well(lambda, depth_over_t),
                  1e-8);
}

TEST(CohesiveCompressibility, IsOneWithoutWells) {
  EXPECT_DOUBLE_EQ(ratio_of(0.4, 1.05, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(ratio_of(0.4, 1.0, 0.5), 1.0);
}

TEST(CohesiveCompressibility, RefusesWellsThatThereAreNone) {
  expect_refused([&] { ratio_of(0.1, 0.9, 1.0); }, "ratio r_out/r");
  expect_refused([&] { ratio_of(0.1, 1.1, -1.0); }, "depth D");
}

}  // namespace cohesion::kinetic_theory
