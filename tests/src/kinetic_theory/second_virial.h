// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>

#include "hamaker/law.h"
#include "kinetic_theory/gauss_legendre.h"
#include "sphere.h"
#include "square_well/parameters.h"
#include "validation.h"

/// The second virial coefficient of equal spheres that attract each other, over that of hard
/// spheres without attraction, 2 pi d^3/3:
///
///   b = 1 - (3/d^3) int (exp(-U(r)/T) - 1) r^2 dr,   r from d to where U ends
///
/// It is the exact limit of y/y_HS for few spheres: p = n T (1 + 4 phi b + ...).
///
/// Symbols: d diameter, r distance of the centres [length]; U energy of a pair, zero far away,
/// negative where it attracts, T = m theta of the motion along one direction [energy]. It falls
/// from 1, with no attraction, below all bounds as T falls; zero is Boyle's temperature. Of elastic
/// spheres: pairs that lose energy gather more than exp(-U/T).
namespace cohesion::kinetic_theory {

/// b of square wells, 1 - (lambda^3 - 1)(exp(D/T) - 1); lambda r_out/r, `depth_over_t` D/T [1].
/// Throws InvalidParameter as square_well::require_valid().
inline double second_virial_of_well(double lambda, double depth_over_t) {
  square_well::require_valid(square_well::well(depth_over_t, lambda));
  return 1.0 - (lambda * lambda * lambda - 1.0) * std::expm1(depth_over_t);
}

/// b of the Hamaker attraction with its surface and outer cut-offs (hamaker/law.h) beyond a hard
/// core; `radius` r of both [length], `temperature` T [energy]. Below H_cut, where the force is
/// constant, over the gap, between the cut-offs over its logarithm, to 1e-12. Throws
/// InvalidParameter unless r, T > 0, and where |U|/T at touch is so large that its exponential is
/// beyond all numbers.
template <class Form>
double second_virial_of_attraction(const hamaker::HamakerLaw<Form>& law, double radius,
                                   double temperature) {
  require_positive("radius of the spheres", radius);
  require_positive("temperature T", temperature);
  const PairGeometry pair = two_spheres(radius, radius);
  const double touch = law.energy(0.0, pair) / temperature;
  require(-touch < std::log(std::numeric_limits<double>::max()), "depth of the attraction over T",
          -touch, "must be below 709: pairs would never part; take a larger temperature");
  const double diameter = 2.0 * radius;
  constexpr double room = 1e-13;  // beside 1/3, that of a core; U of a thin tail is a difference
  const auto gathered = [&](double gap) {
    const double r = 1.0 + gap / diameter;
    return r * r * std::expm1(-law.energy(gap, pair) / temperature) / diameter;
  };
  const auto in_logarithm = [&](double s) { return gathered(std::exp(s)) * std::exp(s); };
  return 1.0 - 3.0 * (gauss_legendre(gathered, 0.0, law.surface_cutoff(), room) +
                      gauss_legendre(in_logarithm, std::log(law.surface_cutoff()),
                                     std::log(law.outer_cutoff()), room));
}

}  // namespace cohesion::kinetic_theory
