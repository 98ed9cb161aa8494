// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hamaker/parameters.h"
#include "sphere.h"

namespace cohesion::hamaker {

/// Attraction of surfaces that an asperity of radius r_a and height h_a holds apart: that of the
/// asperity with the surface it touches, and that of the bodies behind it, which are h_a further
/// away. With the attraction F(H; R*) of smooth surfaces,
///
///   F_rough(H) = F(H; r_a R*/(r_a + R*)) + F(H + h_a; R*)
///
/// and the energies alike. H is the gap between the asperity's tip and the other surface: radii of
/// particles and positions of walls include the asperity. For the form of small gaps this is
///
///   F_rough(H) = (A R*/6) [r_a/((r_a + R*) H^2) + 1/(H + h_a)^2].
///
/// Limits of a hemisphere, h_a = r_a: smooth surfaces for r_a -> 0 (r_a << H) and for r_a ->
/// infinity (r_a >> R*); least at (H + r_a)^3 = 2 H^2 R* between them. Meant for H < r_a << R*: one
/// hemisphere between the surfaces, its tip on the line of centres. In the exact form the asperity
/// is a full sphere; the half of it that lies inside the body counts twice, which matters only at
/// gaps of r_a and more, where the bodies outweigh it.
///
/// A flat cap, h_a << r_a, and the body that it is a part of are both felt in full: for h_a << H
/// and r_a >> R* the attraction is twice that of smooth surfaces. In the form of small gaps it is
/// below that of smooth surfaces where (1 + h_a/H)^2 > 1 + r_a/R*, as every hemisphere's is
/// (range_of_validity.h).
///
/// Source: H. Rumpf, Particle Technology, Chapman and Hall (1990), for a sphere and a plane with a
/// hemisphere on it; as quoted by Y. I. Rabinovich et al., J. Colloid Interface Sci. 232 (2000) 10,
/// who give the cap's height and radius their own values (roughness.h). Two spheres come in by
/// their reduced radius.
template <class Smooth>
class Rough {
 public:
  explicit Rough(const HamakerParameters& p)
      : smooth_(without_asperity(p)),
        asperity_radius_(p.asperity_radius),
        asperity_height_(height_of_asperity(p)) {}

  /// [force/energy], per A/6
  double force(double gap, const PairGeometry& g) const {
    return smooth_.force(gap, asperity(g)) + smooth_.force(gap + asperity_height_, g);
  }

  /// Zero at infinite gap; [1], per A/6.
  double energy(double gap, const PairGeometry& g) const {
    return smooth_.energy(gap, asperity(g)) + smooth_.energy(gap + asperity_height_, g);
  }

 private:
  static HamakerParameters without_asperity(HamakerParameters p) {
    p.asperity_radius = p.asperity_height = 0.0;
    return p;
  }

  /// Of radius 0 it has no attraction.
  PairGeometry asperity(const PairGeometry& g) const {
    return two_spheres(asperity_radius_, g.reduced_radius);
  }

  Smooth smooth_;
  double asperity_radius_, asperity_height_;
};

}  // namespace cohesion::hamaker
