// SPDX-License-Identifier: BSD-3-Clause
#include "drag/model_form.h"

#include <gtest/gtest.h>

#include "named_table.h"

namespace cohesion::drag {

namespace {

struct Forces {
  double on_gas, on_particle;
};

/// Per volume of gas and particles at rest, one direction: n particles of V_p n = 1 - eps.
Forces at_rest(const ModelForm& form, double eps, double drag, double grad_p, double rho_g) {
  const double felt = form.shares_pressure ? grad_p : rho_g;
  const double on_particle = drag * form.drag_over_a(eps) - (1.0 - eps) * felt;
  const double on_gas =
      (form.shares_pressure ? eps : 1.0) * (rho_g - grad_p) - drag * form.drag_over_a(eps);
  return {on_gas, on_particle};
}

}  // namespace

TEST(ModelForm, TheSamePressureGradientHoldsTheGasInAPackedBed) {
  for (const double eps : {0.3, 0.42, 0.7, 1.0}) {
    const double drag = 123.0, rho_g = -11.8;
    const double grad_p = rho_g - drag / eps;
    for (const ModelForm& form : model_forms) {
      // Sums of a few numbers of 400, each rounded to 1e-16
      EXPECT_NEAR(at_rest(form, eps, drag, grad_p, rho_g).on_gas, 0.0, 1e-12) << form.name;
      // What particles feel is the same then, too.
      EXPECT_NEAR(at_rest(form, eps, drag, grad_p, rho_g).on_particle, drag - (1.0 - eps) * grad_p,
                  1e-12)
          << form.name;
    }
  }
}

TEST(ModelForm, GasAndParticlesTogetherFeelWeightAndPressure) {
  const double eps = 0.6, drag = 50.0, grad_p = -300.0, rho_g = -11.8;
  for (const ModelForm& form : model_forms) {
    const Forces forces = at_rest(form, eps, drag, grad_p, rho_g);
    EXPECT_NEAR(forces.on_gas + forces.on_particle, eps * rho_g - grad_p, 1e-12) << form.name;
  }
}

TEST(ModelForm, OfASingleSphereIsOne) {
  for (const ModelForm& form : model_forms) EXPECT_EQ(form.drag_over_a(1.0), 1.0);
}

TEST(ModelForm, IsFoundByName) {
  EXPECT_TRUE(find_by_name(model_forms, "form", "A").shares_pressure);
  EXPECT_FALSE(find_by_name(model_forms, "form", "B").shares_pressure);
}

}  // namespace cohesion::drag
