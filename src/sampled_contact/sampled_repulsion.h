// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/normal_law.h"
#include "contact_solver/motion_along_normal.h"
#include "contact_solver/relative_state.h"

namespace cohesion::sampled_contact {

using namespace contact_solver;

/// A normal law where a pair is found: the force and the dashpot of that overlap.
class SampledRepulsion {
 public:
  explicit SampledRepulsion(const contact::NormalLaw& law)
      : law_(law), reduced_mass_(contact::reduced_mass(law)) {}

  double reduced_mass() const { return reduced_mass_; }

  /// Force of spring and dashpot at `overlap` [length] and its rate, for all of `time`, [force];
  /// positive repels. Sets what it does in `record`.
  double force(double overlap, double rate, double time, NormalRecord& record) const {
    if (!(overlap > 0.0)) return 0.0;
    const contact::LawPoint here = contact::point_of(law_, overlap);
    const double repulsion = here.force + here.damping * rate;
    record.contact_time = time;
    record.repulsion_impulse = time * repulsion;
    record.repulsion_at_end = repulsion;
    record.dissipated = time * here.damping * rate * rate;
    return repulsion;
  }

  /// Stored in the spring, [energy].
  double energy(double overlap) const {
    return overlap > 0.0 ? contact::point_of(law_, overlap).energy : 0.0;
  }

 private:
  contact::NormalLaw law_;
  double reduced_mass_;
};

}  // namespace cohesion::sampled_contact
