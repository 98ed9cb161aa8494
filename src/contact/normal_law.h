// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>

#include "contact/hertz_spring_dashpot.h"
#include "contact/jkr_spring_dashpot.h"
#include "contact/linear_spring_dashpot.h"

namespace cohesion::contact {

/// Spring and dashpot along the normal of a contact, without adhesion. To add a law: its file, its
/// alternative here, and what moves a contact under it (contact_solver/contact_motion.h).
using NormalLaw = std::variant<LinearSpringDashpot, HertzSpringDashpot, JkrSpringDashpot>;

inline double reduced_mass(const NormalLaw& law) {
  return std::visit([](const auto& l) { return l.reduced_mass(); }, law);
}

}  // namespace cohesion::contact
