// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "advice/softness.h"
#include "advice/stiffness_scaling.h"
#include "hamaker/parameters.h"
#include "powder/grain_contact.h"
#include "powder/plan.h"

/// The springs of a run, beside those of the material. Any consistent set of units.
namespace cohesion::powder {

/// What the springs of a run are to do.
struct Demand {
  double restitution;         ///< without cohesion, [1]
  Load load;                  ///< that presses grains together
  double overlap;             ///< that it may press them by at most, over the diameter, [1]
  advice::Keep keep;          ///< what springs softer than the material keep of it
  double given = 0.0;         ///< stiffness that is used whatever they do, [force/length]; 0: none
  Elastic elastic{0.0, 0.0};  ///< material; Young's modulus 0: the springs given are the material
};

/// Two grains in contact, of the smallest size.
struct Pair {
  double diameter;              ///< [length]
  double mass;                  ///< of one, [mass]
  hamaker::Parameters hamaker;  ///< of the attraction
  contact::Adhesion adhesion;   ///< that it has of the pair
};

/// Springs with the numbers of the pair.
struct Springs {
  PairNumbers material, used;
  advice::OverMaterial over;

  bool are_softer() const { return used.stiffness != material.stiffness; }
};

/// The least stiffness to which the attraction of a material of stiffness `real` can be scaled, its
/// cut-off growing towards the outer one: f > k (2 - k) of advice/stiffness_scaling.h, f^2 being
/// the ratio of the stiffnesses, with a tenth to spare.
inline double least_scaled_stiffness(double real, const hamaker::Parameters& p) {
  const double k = p.surface_cutoff / p.outer_cutoff;
  return 1.1 * real * std::pow(k * (2.0 - k), 2);
}

/// The springs given, or the softest that will do, in two digits; no stiffer than the material.
/// Throws InvalidParameter where those given leave the attraction no room below its outer cut-off.
inline Springs springs_of(const Pair& pair, const Demand& demand) {
  const bool elastic = demand.elastic.young > 0.0;
  const double d = pair.diameter,
               real = elastic ? sticking_stiffness(demand.elastic, d, pair.mass, demand.restitution,
                                                   pair.adhesion, demand.load.speed)
                              : demand.given;
  double soft = demand.given;
  if (soft == 0.0) {
    const bool scales = demand.keep == advice::Keep::escape_velocity;
    soft = softest_stiffness(d, pair.mass, demand.restitution, pair.adhesion.force, demand.load,
                             demand.overlap, scales ? real : 0.0);
    if (scales) soft = std::max(soft, least_scaled_stiffness(real, pair.hamaker));
    // Two digits that are not below what is needed.
    soft = std::min(two_digits_below(1.1 * soft), real);
  }
  const advice::Material material{real, demand.keep};
  contact::Adhesion used = pair.adhesion;
  if (advice::is_scaled(material, soft) && pair.adhesion.force > 0.0) {
    const advice::StiffnessScaling scaling(real, soft);
    used = scaling.adhesion(pair.adhesion);
    // As the engine will: throws where the outer cut-off leaves no room.
    scaling.hamaker(pair.hamaker);
  }
  const auto spring =
      contact::LinearSpringDashpot::from_restitution(soft, demand.restitution, 0.5 * pair.mass);
  return {pair_numbers(real, demand.restitution, pair.mass, pair.adhesion),
          pair_numbers(soft, demand.restitution, pair.mass, used),
          used.force > 0.0 ? advice::over_material(contact::AdhesiveContact(spring, used), material)
                           : advice::OverMaterial{1.0, 1.0}};
}

}  // namespace cohesion::powder
