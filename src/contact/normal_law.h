// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <variant>

#include "contact/hertz_spring_dashpot.h"
#include "contact/jkr_spring_dashpot.h"
#include "contact/linear_spring_dashpot.h"

namespace cohesion::contact {

/// Spring and dashpot along the normal of a contact, without adhesion. To add a law: its file, its
/// alternative here, what moves a contact under it (contact_solver/normal_motion.h), its LawKind
/// with kind_of_law() and normal_law() (contact/contact_parameters.h), and its loop over pairs
/// (lammps-package/soft_contacts/pair_contacts_step.h, compute_sized()).
using NormalLaw = std::variant<LinearSpringDashpot, HertzSpringDashpot, JkrSpringDashpot>;

inline bool is_linear(const NormalLaw& law) {
  return std::holds_alternative<LinearSpringDashpot>(law);
}

/// A law at an overlap [length], not below that at which contact ends.
inline LawPoint point_of(const NormalLaw& law, double overlap) {
  return std::visit(
      [overlap](const auto& l) { return l.at(std::max(overlap, l.lowest_overlap())); }, law);
}

/// The part of a tangential stretch that is left when the contact stiffens from one
/// radius_stiffness to another: the force of the spring stays. A contact that softens keeps the
/// stretch.
inline double stretch_left(double before, double now) { return now > before ? before / now : 1.0; }

/// The weight of the displacement of a step in the stretch at its end, where `left` of the stretch
/// is left: the mean of the stiffnesses at both ends of the step over the present one.
inline double displacement_weight(double left) { return 0.5 * (1.0 + left); }

/// The overlap at which a contact ends, [length]; below 0: where a neck tears.
inline double lowest_overlap(const NormalLaw& law) {
  const auto* const jkr = std::get_if<JkrSpringDashpot>(&law);
  return jkr ? jkr->lowest_overlap() : 0.0;
}

inline double reduced_mass(const NormalLaw& law) {
  return std::visit([](const auto& l) { return l.reduced_mass(); }, law);
}

}  // namespace cohesion::contact
