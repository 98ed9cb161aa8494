// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <string_view>
#include <type_traits>

#include "drag/beetstra.h"
#include "drag/constant_coefficient.h"
#include "drag/di_felice.h"
#include "drag/ergun_rowe_henwood.h"
#include "drag/ergun_wen_yu.h"
#include "drag/hill_koch_ladd.h"
#include "drag/rong.h"
#include "drag/syamlal_obrien.h"
#include "drag/tang.h"
#include "drag/tenneti.h"
#include "drag/validity.h"
#include "drag/wen_yu.h"

/// The table of drag closures, or drag laws as users call them: the one place that knows them all.
/// How to add one: docs/contributing.md.
namespace cohesion::drag {

/// Drag per volume of solid and unit slip, beta/(1 - eps), [mass/(volume time)]; arguments as in
/// SyamlalOBrien::per_solid_volume. The drag on a particle of volume V_p is
/// V_p beta/(1 - eps) (u - v), beside -V_p grad p (stokes_scaled.h).
using PerSolidVolume = double (*)(double void_fraction, double slip, double diameter,
                                  double density, double viscosity);

/// The same for closures with a free exponent n of the void fraction, as in ErgunWenYu.
using WithExponent = double (*)(double n, double void_fraction, double slip, double diameter,
                                double density, double viscosity);

struct Closure {
  std::string_view name;
  PerSolidVolume per_solid_volume = nullptr;
  Validity validity{};
  WithExponent with_exponent = nullptr;  ///< none when the closure has no exponent to choose
  std::string_view no_exponent;          ///< why there is none, as a message has it after "as"
  /// Whether the drag goes with the square of the slip, and the coefficient b with the slip.
  bool quadratic = false;
  /// Whether the closure is that of a coefficient C_d of 1, and the user gives it.
  bool takes_coefficient = false;
  /// Drag over what the closure says, [1], of spheres of one density in a fluid of another; none
  /// where it is the same for all. Not above 0 where there is no such drag.
  double (*of_densities)(double sphere_density, double density) = nullptr;
};

/// The row of a law: a struct with `name`, `validity`, per_solid_volume(), and either
/// with_exponent() or the text `no_exponent`.
template <class Law, class = void>
inline constexpr Closure row{Law::name, &Law::per_solid_volume, Law::validity, Law::with_exponent,
                             ""};
template <class Law>
inline constexpr Closure row<Law, std::void_t<decltype(Law::no_exponent)>>{
    Law::name, &Law::per_solid_volume, Law::validity, nullptr, Law::no_exponent};

inline constexpr std::array closures{
    row<SyamlalOBrien>, row<ErgunWenYu>, row<ErgunRoweHenwood>, row<DiFelice>,
    row<HillKochLadd>,  row<Beetstra>,   row<Tenneti>,          row<Tang>,
    row<WenYu>,         row<Rong>,
};

/// Where a closure of one coefficient holds: nowhere it says that it does not.
inline constexpr Validity anywhere{0.0, std::numeric_limits<double>::infinity(),
                                   std::numeric_limits<double>::infinity()};

/// Closures of one drag coefficient, for bubbles in an emulsion: no closures of beds.
inline constexpr std::array coefficient_closures{
    Closure{ConstantCd::name, &ConstantCd::per_solid_volume, anywhere, nullptr,
            ConstantCd::no_exponent, true, true, nullptr},
    Closure{DavidsonTaylor::name, &DavidsonTaylor::per_solid_volume, anywhere, nullptr,
            DavidsonTaylor::no_exponent, true, false, &DavidsonTaylor::share},
};

/// All closures: what a coupled case may name.
inline constexpr auto all_closures = [] {
  std::array<Closure, closures.size() + coefficient_closures.size()> all{};
  for (std::size_t i = 0; i < all.size(); i++)
    all[i] = i < closures.size() ? closures[i] : coefficient_closures[i - closures.size()];
  return all;
}();

}  // namespace cohesion::drag
