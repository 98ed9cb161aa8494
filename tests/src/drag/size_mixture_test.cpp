// SPDX-License-Identifier: BSD-3-Clause
#include "drag/size_mixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "drag/drag_closure.h"
#include "drag/drag_law.h"
#include "drag/model_form.h"
#include "named_table.h"

namespace cohesion::drag {

namespace {

const MixtureLaw& law(const char* name) { return find_by_name(mixture_laws, "dragMixture", name); }

struct Size {
  double number, diameter;  // per volume; [length]
};
using Sizes = std::vector<Size>;

// A large one and 64 small ones of a quarter of its diameter: equal volumes.
const Sizes one_to_four{{64.0, 1.0}, {1.0, 4.0}};

double sum(const Sizes& sizes, int power) {
  double all = 0.0;
  for (const Size& s : sizes) all += s.number * std::pow(s.diameter, power);
  return all;
}

SizesAround around(const Sizes& sizes) {
  return SizesAround::from_sums(sum(sizes, 2), sum(sizes, 3), sum(sizes, 4));
}

}  // namespace

TEST(SizeMixture, EqualSpheresFeelTheClosureWithTheTermOfTheSimulations) {
  const SizesAround equal = around({{100.0, 0.3}});
  for (const double eps : {0.36, 0.7, 1.0})
    for (const MixtureLaw& mixture : mixture_laws)
      for (const ModelForm& form : model_forms)
        // Of some operations with numbers of 1
        EXPECT_NEAR(form.mixed_drag(mixture, eps, 0.3, equal), 1.0 + mixture.cubic * eps, 1e-14)
            << mixture.name << ' ' << form.name;
}

// Worked by hand: <d> = 1.6, M = 1.5625, y = 5/8 and 5/2.
TEST(SizeMixture, OneToFourIsAsOnPaper) {
  const SizesAround sizes = around(one_to_four);
  EXPECT_NEAR(sizes.sauter, 1.6, 1e-15);
  EXPECT_NEAR(sizes.spread, 1.5625, 1e-15);
  const double small = 0.625 * 0.625, large = 2.5 * 2.5, eps = 0.4;
  // F_total over that of equal spheres
  EXPECT_NEAR(small * mixed_total(law("carmanKozeny"), eps, 1.0, sizes), 0.484375, 1e-14);
  EXPECT_NEAR(large * mixed_total(law("carmanKozeny"), eps, 4.0, sizes), 4.75, 1e-14);
  EXPECT_NEAR(small * mixed_total(law("vanDerHoef"), eps, 1.0, sizes), 0.490625, 1e-14);
  EXPECT_NEAR(large * mixed_total(law("vanDerHoef"), eps, 4.0, sizes), 5.15, 1e-14);
  // F_drag
  EXPECT_NEAR(small * mixed_drag(law("carmanKozeny"), eps, 1.0, sizes), 0.625, 1e-14);
  EXPECT_NEAR(large * mixed_drag(law("carmanKozeny"), eps, 4.0, sizes), 2.5, 1e-14);
  EXPECT_NEAR(small * mixed_drag(law("vanDerHoef"), eps, 1.0, sizes), 0.6171875, 1e-14);
  EXPECT_NEAR(large * mixed_drag(law("vanDerHoef"), eps, 4.0, sizes), 3.125, 1e-14);
}

// A packed bed of three sizes: each sphere feels the same in both forms, drag and pressure
// together, and the pressure gradient is that of equal spheres, times what the third term adds.
TEST(SizeMixture, APackedBedHasTheSameForcesInBothForms) {
  const Sizes sizes{{64.0, 1.0}, {9.0, 2.0}, {1.0, 4.0}};
  const SizesAround mixed = around(sizes);
  const double eps = 0.42, slip = 0.3, density = 1.2, viscosity = 1.8e-5;
  const double per_volume = (1.0 - eps) / (sum(sizes, 3) * sphere_volume(0.5));
  for (const Closure& closure : closures)
    for (const MixtureLaw& mixture : mixture_laws) {
      if (!mixture.mixes) continue;
      const DragLaw drag(closure);
      const auto force = [&](const ModelForm& form, double d) {
        return slip * form.drag_over_a(eps) *
               drag.coefficient_among(form.mixed_drag(mixture, eps, d, mixed), mixed.sauter, eps,
                                      slip, d, density, viscosity);
      };
      // eps grad p = - sum F_drag in form A, grad p = - sum F_total in form B
      double gradient[2] = {0.0, 0.0};
      for (const Size& s : sizes)
        for (int form = 0; form < 2; form++)
          gradient[form] += per_volume * s.number * force(model_forms[form], s.diameter);
      gradient[0] /= eps;
      const double equal = (1.0 - eps) / eps * slip *
                           drag.per_solid_volume(eps, slip, mixed.sauter, density, viscosity);
      const double more = 1.0 + mixture.cubic * eps * mixed.spread;
      EXPECT_NEAR(gradient[0], equal * more, 1e-12 * equal) << closure.name << ' ' << mixture.name;
      EXPECT_NEAR(gradient[1], equal * more, 1e-12 * equal) << closure.name << ' ' << mixture.name;
      for (const Size& s : sizes) {
        const double beside = force(model_forms[0], s.diameter);
        const double total = beside + sphere_volume(0.5 * s.diameter) * gradient[0];
        EXPECT_NEAR(force(model_forms[1], s.diameter), total, 1e-12 * total) << closure.name;
      }
    }
}

// With one of a hundred diameters among many, a third term that was fitted for four.
TEST(SizeMixture, TheDragIsLostOnlyFarBeyondTheRangeOfTheLaw) {
  const Sizes wide{{1e6, 1.0}, {1.0, 100.0}};
  const SizesAround sizes = around(wide);
  EXPECT_GT(0.6 * sizes.spread, 7.9);
  EXPECT_GT(mixed_drag(law("carmanKozeny"), 0.4, 100.0, sizes), 0.0);
  for (double phi_spread = 0.0; phi_spread < 7.9; phi_spread += 0.1)
    for (double y = 0.05; y < 20.0; y *= 1.1)
      EXPECT_GT(mixed_drag(law("vanDerHoef"), 0.5, y, {1.0, 2.0 * phi_spread}), 0.0) << y;
}

}  // namespace cohesion::drag
