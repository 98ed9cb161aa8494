// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

/// The drag on a sphere among spheres of other sizes, over any closure of equal ones.
///
///   F_total,i = (eps y_i + phi y_i^2 + c eps y_i^3) F_total(eps, <Re>),   phi = 1 - eps,
///
/// F = force/(3 pi mu d_i U) (stokes_scaled.h), y_i = d_i/<d>, <Re> = rho U <d>/mu,
/// <d> = sum d^3/sum d^2 the Sauter mean of the spheres around, and F_total without index that of
/// equal spheres with the diameter <d>. The first two terms are what Carman and Kozeny's pressure
/// drop by surface asks for: they leave it that of equal spheres, sum d_i F_total,i =
/// F_total sum d_i y_i. The third, c = 0.064, was fitted to simulations: it raises the drop by
/// 1 + c eps M, M = <d^4>/(<d^2> <d>^2), and is there for equal spheres, too.
///
/// Beside -V_i grad p (form A), with the grad p of all these forces, the drag is what is left:
///
///   F_drag,i = F_total,i - phi y_i^2 (1 + c eps M) F_total
///            = (y_i + c (y_i^3 - phi M y_i^2)) F_drag(eps, <Re>).
///
/// So it goes with y_i alone where c is 0. A bracket of F_total taken for one of F_drag is wrong by
/// up to the factor eps + phi y_i.
///
/// Validity: two sizes of a ratio up to four, phi from 0.1 to 0.6, <Re> up to 1000: within 10 % on
/// the average.
///
/// Source: M. A. van der Hoef, R. Beetstra, J. A. M. Kuipers, J. Fluid Mech. 528 (2005) 233;
/// R. Beetstra, M. A. van der Hoef, J. A. M. Kuipers, AIChE J. 53 (2007) 489, with an erratum on
/// the two forms, AIChE J. 53 (2007) 3020.
namespace cohesion::drag {

struct MixtureLaw {
  std::string_view name;
  bool mixes;    ///< false: each sphere as among spheres of its own size
  double cubic;  ///< c [1]
};

inline constexpr std::array mixture_laws{
    MixtureLaw{"none", false, 0.0},
    MixtureLaw{"carmanKozeny", true, 0.0},
    MixtureLaw{"vanDerHoef", true, 0.064},
};

/// Of two diameters, up to which the simulations went that the laws rest on, [1].
inline constexpr double largest_mixed_ratio = 4.0;

/// The spheres around a sphere.
struct SizesAround {
  double sauter;  ///< <d>, [length]
  double spread;  ///< M = <d^4>/(<d^2> <d>^2), [1]; 1 where all are equal

  /// From the sums of their second, third and fourth powers.
  static SizesAround from_sums(double second, double third, double fourth) {
    const double sauter = third / second;
    return {sauter, fourth / (second * sauter * sauter)};
  }
};

/// b of a sphere of the diameter `d` [length] in form A over V_p beta/(1 - eps), with the closure
/// at <d>, [1]. Above 0 where phi M is below 7.9, as it is but for a few giants among dwarfs.
inline double mixed_drag(const MixtureLaw& law, double void_fraction, double d,
                         const SizesAround& around) {
  const double y = d / around.sauter;
  return 1.0 / y + law.cubic * (y - (1.0 - void_fraction) * around.spread);
}

/// The same in form B: of the drag that is F_total.
inline double mixed_total(const MixtureLaw& law, double void_fraction, double d,
                          const SizesAround& around) {
  const double y = d / around.sauter;
  return void_fraction / y + (1.0 - void_fraction) + law.cubic * void_fraction * y;
}

}  // namespace cohesion::drag
