// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "contact/adhesion.h"
#include "sphere.h"

namespace cohesion::hamaker {

/// The attraction of one pair beyond H_cut under a law (law.h).
template <class Law>
class Tail : public contact::Tail {
 public:
  Tail(const Law& law, const PairGeometry& geometry) : law_(law), geometry_(geometry) {}

  double barrier(double load, double gap) const override {
    return law_.barrier(load, gap, geometry_);
  }
  double work_up_to(double gap) const override {
    return law_.energy(gap, geometry_) + law_.tail_energy(geometry_);
  }
  double outer_cutoff() const override { return law_.outer_cutoff(); }

 private:
  Law law_;
  PairGeometry geometry_;
};

/// The adhesion of a pair under `law`; none at all when it has no force.
template <class Law>
contact::Adhesion adhesion_of(const Law& law, const PairGeometry& geometry) {
  const double force = law.adhesion_force(geometry);
  if (force == 0.0) return {};
  return {force, law.surface_cutoff(), law.tail_energy(geometry), false,
          std::make_shared<const Tail<Law>>(law, geometry)};
}

}  // namespace cohesion::hamaker
