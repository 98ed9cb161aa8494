// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "advice/contact_numbers.h"
#include "contact/adhesive_contact.h"
#include "contact/linear_spring_dashpot.h"
#include "contact/stiffness_scaling.h"

/// What the softness of a spring changes of a cohesive contact, and what to say of it.
/// See docs/theory/soft_springs.md.
namespace cohesion::advice {

/// Numbers of a contact over those of its material, [1].
struct OverMaterial {
  double escape_velocity;  ///< 1 too where both hold every pair, or none
  double force;            ///< F_ad
};

/// Of a contact of `stiffness` (stiffness_of()) with the adhesion `used`. escape_of(adhesion): the
/// escape velocity that it has with another; with that of its material scaled to it, it has the
/// material's (StiffnessScaling). Throws InvalidParameter unless the material is given.
template <class EscapeOf>
OverMaterial over_material(const contact::Material& material, double stiffness,
                           const contact::Adhesion& used, const EscapeOf& escape_of) {
  const contact::StiffnessScaling scaling(material, stiffness);
  if (material.keep == contact::Keep::escape_velocity) return {1.0, scaling.factor()};
  const double escape = escape_of(used);
  const bool both_part = escape > 0.0 && std::isfinite(escape);
  return {both_part ? escape / escape_of(scaling.adhesion(used)) : 1.0, 1.0};
}

/// Of a linear contact.
inline OverMaterial over_material(const contact::AdhesiveContact& contact,
                                  const contact::Material& material) {
  return over_material(
      material, contact.spring().stiffness(), contact.adhesion(),
      [&](const contact::Adhesion& adhesion) {
        return contact::AdhesiveContact(contact.spring(), adhesion).escape_velocity();
      });
}

/// Below this fraction of the approach speed hardly an impact is as slow as the escape velocity: of
/// impacts at random speeds v about one in (v/v_esc)^2.
inline constexpr double escape_for_notice = 0.01;

/// Whether a stiffer spring would let pairs part that stick, at the approach speed: where adhesion
/// works more in the spring than on the way to it, unless
///   all of them stick with a rigid one, too: two particles meet at up to twice the speed; or
///   the escape velocity is far below the speed.
inline bool softness_decides(const ContactNumbers& n) {
  if (n.spring_adhesion_energy() <= n.well_energy()) return false;
  const double speed = n.parameters().speed;
  const double rigid =
      contact::AdhesiveContact(n.contact().spring(), {0.0, 0.0, n.well_energy()}).escape_velocity();
  const bool all_stick = speed > 0.0 && 2.0 * speed <= rigid;
  return std::isfinite(rigid) && !all_stick && n.escape_velocity() > escape_for_notice * speed;
}

/// `keywords`: the words by which a user tells the material; empty: there are none.
inline std::string softness_advice(std::string_view keywords) {
  const std::string sentence =
      "pairs would stick less with a stiffer spring (tail/spring below 1); if the material is "
      "stiffer, ";
  if (keywords.empty())
    return sentence +
           "its pull-off force is kept (packings, Bond number), its escape velocity is not "
           "(collisions: which pairs stick)";
  return sentence + std::string(keywords) +
         " keeps its escape velocity (collisions: which pairs stick), with 'material_keep force' "
         "its "
         "pull-off force (packings, resting beds, Bond number, tensile strength)";
}

}  // namespace cohesion::advice
