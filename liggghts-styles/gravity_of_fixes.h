// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_GRAVITY_OF_FIXES_H
#define COHESION_GRAVITY_OF_FIXES_H

#include <vector>

#include "fix_gravity.h"
#include "modify.h"
#include "vector3.h"

namespace LIGGGHTS {
namespace Cohesion {

/// The accelerations of all fixes gravity, [length/time^2], as they are now.
class GravityOfFixes {
 public:
  explicit GravityOfFixes(const LAMMPS_NS::Modify* modify) {
    for (int k = 0; k < modify->nfix; k++)
      if (auto* const fix = dynamic_cast<LAMMPS_NS::FixGravity*>(modify->fix[k])) {
        double g[3];
        fix->get_gravity(g);
        fields_.push_back({fix->groupbit, {g[0], g[1], g[2]}});
      }
  }

  /// On a particle of this mask.
  cohesion::Vector3 on(int mask) const {
    cohesion::Vector3 sum{};
    for (const Field& field : fields_)
      if (mask & field.groupbit) sum += field.acceleration;
    return sum;
  }

  /// A bound of what any particle can get.
  double largest() const {
    double sum = 0.0;
    for (const Field& field : fields_) sum += norm(field.acceleration);
    return sum;
  }

 private:
  struct Field {
    int groupbit;
    cohesion::Vector3 acceleration;
  };
  std::vector<Field> fields_;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
