// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "hamaker/parameters.h"
#include "validation.h"

/// Coarse graining: spheres that stand for many grains.
namespace cohesion::powder {

/// Parcels of l^3 grains, spheres of the grains' density and l times their diameter, whose contacts
/// are those of the grains magnified by l at the same speeds:
///
///   lengths (d, H_cut, H_out, r_a) l      times l      K l      forces l^2      masses, energies
///   l^3      moduli 1      energies of surfaces l
///
/// The Hamaker constant is an energy, and so is the depth of a square well; the width of the well
/// is a length. From this
/// - pairs stick at the speed at which grains do, and the whole curve of restitution over speed is
///   theirs; so are overlaps over the diameter;
/// - forces over d^2 are kept: the tensile strength, and its ratio to the pressure of a bed of the
///   same height;
/// - the gas is to see grains: the drag on a parcel is grains() times that of one of
///   drag_diameter().
///
/// Not kept: the Bond number F_ad/(m g), which is 1/l of the grains'; the diameter over lengths of
/// the apparatus and of the mesh; collisions in a time, 1/l of the grains', and with them what
/// dilute suspensions lose to collisions and carry by them (viscosity of rapid flow ~ d); spins,
/// which are 1/l of the grains'.
///
/// Source: dimensions alone. K ~ l and F_ad ~ l^2 are what S. C. Thakur, J. Y. Ooi, H. Ahmadian
/// (Powder Technol. 293 (2016) 130) found to leave confined compression and unconfined strength of
/// a cohesive solid as they are.
/// In a vessel of a few parcels they lie more loosely than grains, with a higher minimum
/// fluidisation: narrowest_vessel parcels across raise it by a tenth (examples/coarse-graining).
/// Walls are the likely cause; a wider vessel, which would show it, was not computed.
class Parcels {
 public:
  static constexpr double narrowest_vessel = 18.0;

  /// Throws InvalidParameter unless 1 <= l < infinity.
  explicit Parcels(double ratio) : ratio_(ratio) {
    require(std::isfinite(ratio) && ratio >= 1.0, "diameter of parcels over that of grains", ratio,
            "must be 1 or more");
  }

  double ratio() const { return ratio_; }

  double length(double of_grains) const { return ratio_ * of_grains; }
  double time(double of_grains) const { return ratio_ * of_grains; }
  double stiffness(double of_grains) const { return ratio_ * of_grains; }
  double surface_energy(double of_grains) const { return ratio_ * of_grains; }
  double force(double of_grains) const { return ratio_ * ratio_ * of_grains; }
  double mass(double of_grains) const { return grains() * of_grains; }
  double energy(double of_grains) const { return mass(of_grains); }

  hamaker::HamakerParameters attraction(const hamaker::HamakerParameters& of_grains) const {
    return {energy(of_grains.hamaker_constant), length(of_grains.surface_cutoff),
            length(of_grains.outer_cutoff), length(of_grains.asperity_radius),
            length(of_grains.asperity_height)};
  }

  /// Grains in a parcel.
  double grains() const { return ratio_ * ratio_ * ratio_; }
  double number(double of_grains) const { return of_grains / grains(); }

  /// Of a grain in the parcel, for the law of drag.
  double drag_diameter(double of_parcel) const { return of_parcel / ratio_; }

 private:
  double ratio_;
};

}  // namespace cohesion::powder
