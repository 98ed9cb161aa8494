// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/linear_spring_dashpot.h"
#include "contact_solver/pair_step.h"

namespace cohesion::sampled_contact {

using namespace contact_solver;

/// Force of spring and dashpot at `overlap` [length] and its rate, taken for all of `time`,
/// [force]; positive repels. Sets what it does in `record`.
inline double sampled_repulsion(const contact::LinearSpringDashpot& spring, double overlap,
                                double rate, double time, NormalRecord& record) {
  if (!(overlap > 0.0)) return 0.0;
  const double repulsion = spring.stiffness() * overlap + spring.damping() * rate;
  record.contact_time = time;
  record.repulsion_impulse = time * repulsion;
  record.repulsion_at_end = repulsion;
  record.dissipated = time * spring.damping() * rate * rate;
  return repulsion;
}

}  // namespace cohesion::sampled_contact
