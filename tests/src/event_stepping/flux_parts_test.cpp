// SPDX-License-Identifier: BSD-3-Clause
#include "event_stepping/flux_parts.h"

#include <gtest/gtest.h>

#include <limits>

namespace cohesion::event_stepping {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

struct Law {
  bool pulls;
  bool attracts() const { return pulls; }
};

constexpr double repulsion = 3.0, pull = 2.0;
const Vector3 place{0.6, 0.8, 0.0}, friction{-0.4, 0.3, 0.0};

FluxParts one_step(bool attracts, double share) {
  PairStep step;
  step.normal.repulsion_impulse = repulsion;
  FrictionStep sliding{};
  sliding.spring.impulse = friction;
  const double normal = attracts ? repulsion - pull : repulsion;
  FluxParts parts;
  parts.add(share, Law{attracts}, place, step, sliding, normal * place + friction);
  return parts;
}

}  // namespace

TEST(FluxParts, SpringAndFrictionAreOfContactTheRestIsOfAdhesion) {
  const FluxParts parts = one_step(true, 0.5);
  const MomentumFlux contact = momentum_flux(place, repulsion * place + friction);
  const MomentumFlux adhesion = momentum_flux(place, -pull * place);
  for (std::size_t k = 0; k < contact.size(); k++) {
    EXPECT_NEAR(parts.of[FluxParts::contact][k], 0.5 * contact[k], 16 * eps);
    EXPECT_NEAR(parts.of[FluxParts::adhesion][k], 0.5 * adhesion[k], 16 * eps);
  }
}

TEST(FluxParts, NothingIsOfAdhesionWhereNothingAttracts) {
  const FluxParts parts = one_step(false, 1.0);
  for (const double a : parts.of[FluxParts::adhesion]) EXPECT_EQ(a, 0.0);
}

TEST(MomentumFlux, IsPositiveInCompressionAndNotSymmetricWithFriction) {
  const MomentumFlux flux = momentum_flux({1.0, 2.0, 3.0}, {4.0, 5.0, 6.0});
  EXPECT_EQ(flux, (MomentumFlux{4.0, 10.0, 18.0, 5.0, 6.0, 12.0}));
}

}  // namespace cohesion::event_stepping
