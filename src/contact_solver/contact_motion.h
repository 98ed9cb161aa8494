// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>

#include "contact/normal_law.h"
#include "contact_solver/integrated_contact.h"
#include "contact_solver/linear_contact.h"

namespace cohesion::contact_solver {

/// Integrator of the motion in contact: in closed form for linear contacts, numerical for others.
using ContactMotion = std::variant<LinearContact, IntegratedContact<contact::HertzSpringDashpot>,
                                   IntegratedContact<contact::JkrSpringDashpot>>;

/// attraction [force]: constant in contact; step [time].
inline ContactMotion contact_motion(const contact::NormalLaw& law, double attraction, double step) {
  if (const auto* linear = std::get_if<contact::LinearSpringDashpot>(&law))
    return LinearContact(*linear, attraction, step);
  if (const auto* hertz = std::get_if<contact::HertzSpringDashpot>(&law))
    return IntegratedContact(*hertz, attraction, step);
  return IntegratedContact(std::get<contact::JkrSpringDashpot>(law), attraction, step);
}

}  // namespace cohesion::contact_solver
