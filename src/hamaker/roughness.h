// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "hamaker/parameters.h"
#include "validation.h"

namespace cohesion::hamaker {

/// What is measured of a rough surface.
struct Roughness {
  double rms;         ///< root mean square of the heights about the mean plane, [length]
  double wavelength;  ///< lambda, mean distance of neighbouring peaks, [length]
};

/// The cap that asperity.h takes.
struct Asperity {
  double radius;  ///< r_a, [length]; 0: smooth surfaces
  double height;  ///< h_a, [length]
};

/// k_1, height of the peaks over rms, [1].
inline constexpr double peak_over_rms = 1.817;

/// The asperities of a surface of one scale of roughness. Peaks and troughs are caps of spheres
/// with a base of diameter lambda/2, so that the next peak is lambda away:
///
///   h_a = k_1 rms        r_a = (lambda/4)^2/(2 h_a) = lambda^2/(32 k_1 rms)
///
/// With these asperity.h is in the form of small gaps, at contact H_cut = H_0,
///
///   F = (A R*/(6 H_0^2)) [1/(1 + 58.14 R* rms/lambda^2) + 1/(1 + 1.817 rms/H_0)^2].
///
/// k_1 is that of flat caps whose bases lie as close as circles can: they cover pi/(2 sqrt 3) of
/// the plane, the mean of the square of a cap's height over its base is h_a^2/3, and k_1 = sqrt(6
/// sqrt(3)/pi) = 1.8188, of which the source has 1.817. Heights and radii do not depend on the
/// particles; of two rough surfaces rms and lambda are those of the rougher one.
///
/// rms = 0 gives smooth surfaces. It is not the limit of rms -> 0, which is twice their attraction
/// (asperity.h): the formula is one of peaks of H_0 and more.
///
/// Throws InvalidParameter unless rms >= 0, lambda > 0, and the cap is flat enough for r_a >= h_a,
/// lambda >= sqrt(32) k_1 rms.
///
/// Source: Y. I. Rabinovich, J. J. Adler, A. Ata, R. K. Singh, B. M. Moudgil, J. Colloid Interface
/// Sci. 232 (2000) 10 and 17. k_1 derived here besides, by the geometry above; the papers
/// themselves were not at hand, their formula is as later works print it.
inline Asperity asperity_of(const Roughness& r) {
  require_non_negative("rms roughness", r.rms);
  require_positive("wavelength of the roughness", r.wavelength);
  if (r.rms == 0.0) return {0.0, 0.0};
  const double height = peak_over_rms * r.rms;
  const double radius = r.wavelength * r.wavelength / (32.0 * height);
  std::ostringstream remedy;
  remedy << "must be at least " << std::sqrt(32.0) * peak_over_rms << " times the rms of " << r.rms
         << ": the peaks are taken for flat caps";
  // The limit to the last digit is still the limit.
  require(radius >= (1.0 - 1e-9) * height, "wavelength of the roughness", r.wavelength,
          remedy.str());
  return {std::max(radius, height), height};
}

/// Of surfaces given by the radius of their asperities, or by rms and wavelength of their
/// roughness, [length]; empty: not given. Throws InvalidParameter as for a Roughness.
inline Asperity asperity_of(double radius, const std::vector<double>& roughness) {
  if (roughness.empty()) return {radius, 0.0};
  return asperity_of({roughness.at(0), roughness.at(1)});
}

/// Of which asperity_of() is p's asperity, but for the last digit.
inline Roughness roughness_of(const HamakerParameters& p) {
  const double height = height_of_asperity(p);
  return {height / peak_over_rms, std::sqrt(32.0 * height * p.asperity_radius)};
}

}  // namespace cohesion::hamaker
