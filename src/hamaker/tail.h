// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sphere.h"

namespace cohesion::hamaker {

/// The attraction of a HamakerLaw (law.h) beyond H_cut, which a pair crosses as it separates under
/// a load. One law serves all pairs of the same materials.
class Tail {
 public:
  /// The barrier under a load [force] from a gap [length] on, [energy].
  virtual double barrier(double load, double gap, const PairGeometry&) const = 0;
  /// The work of the attraction from H_cut to a gap [length], [energy].
  virtual double work_up_to(double gap, const PairGeometry&) const = 0;
  /// H_out, [length].
  virtual double outer_cutoff() const = 0;

 protected:
  ~Tail() = default;
};

}  // namespace cohesion::hamaker
