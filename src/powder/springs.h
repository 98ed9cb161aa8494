// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "advice/softness.h"
#include "contact/stiffness_scaling.h"
#include "hamaker/parameters.h"
#include "powder/grain_contact.h"
#include "powder/plan.h"
#include "powder/wells.h"

/// The springs of a run, beside those of the material. Any consistent set of units.
namespace cohesion::powder {

/// A contact that the springs have to bear, with the adhesion of its material.
struct Borne {
  Pressed pressed;
  contact::Adhesion adhesion;
};

/// What the springs of a run are to do.
struct Demand {
  double restitution;         ///< without cohesion, [1]
  Load load;                  ///< that presses grains together
  double overlap;             ///< that it may press them by at most, over the diameter, [1]
  contact::Keep keep;         ///< what springs softer than the material keep of it
  double given = 0.0;         ///< stiffness that is used whatever they do, [force/length]; 0: none
  Elastic elastic{0.0, 0.0};  ///< material; Young's modulus 0: the springs given are the material
  double well_ratio = 0.0;    ///< r_out/r of a well in place of the attraction; 0: no well
  std::vector<Borne> others{};  ///< that they bear besides the pair: larger grains, grains at walls
  double stiffest_material = 0.0;  ///< of all pairs, whose attraction is scaled too, [force/length]
};

/// Two grains in contact, of the smallest size.
struct GrainPair {
  double diameter;                     ///< [length]
  double mass;                         ///< of one, [mass]
  hamaker::HamakerParameters hamaker;  ///< of the attraction
  contact::Adhesion adhesion;          ///< that it has of the pair
};

/// Springs with the numbers of the pair.
struct Springs {
  PairNumbers material, used;
  advice::OverMaterial over;
};

/// The least stiffness to which the attraction of a material of stiffness `real` can be scaled, its
/// cut-off growing towards the outer one: f > k (2 - k) of contact/stiffness_scaling.h, f^(p + 1)
/// being the ratio of the stiffnesses, with a tenth to spare. exponent: p of the contact.
inline double least_scaled_stiffness(double real, const hamaker::HamakerParameters& p,
                                     double exponent = contact::linear_power) {
  const double k = p.surface_cutoff / p.outer_cutoff;
  return 1.1 * real * std::pow(k * (2.0 - k), exponent + 1.0);
}

/// Two digits that are not below what is needed, and no stiffer than `stiffest`.
inline double rounded_stiffness(double needed, double stiffest) {
  return std::min(two_digits_below(1.1 * needed), stiffest);
}

/// The stiffness of the material, as a linear spring, [force/length].
inline double material_stiffness(const GrainPair& pair, const Demand& demand) {
  if (demand.elastic.young == 0.0) return demand.given;
  return sticking_stiffness(demand.elastic, pair.diameter, pair.mass, demand.restitution,
                            pair.adhesion, demand.load.speed);
}

/// The stiffest springs that a run may need, [force/length]: those of the material, at the speed of
/// the load where it is above that of the fastest impact that sticks. Hertz's contact stiffens as
/// it is pressed.
inline double stiffest_needed(const GrainPair& pair, const Demand& demand, double material) {
  if (demand.elastic.young == 0.0) return material;
  return std::max(material, linear_stiffness(demand.elastic, pair.diameter, pair.mass,
                                             demand.load.speed, pair.adhesion.force));
}

/// The softest stiffness that bears the pair and all others. in_run(borne, K): the adhesion that
/// the run has of a contact.
template <class InRun>
double softest_of_all(const GrainPair& pair, const Demand& demand, const InRun& in_run) {
  std::vector<Borne> all = demand.others;
  all.push_back({{pair.diameter, 0.5 * pair.mass}, pair.adhesion});
  double stiffness = 0.0;
  for (const Borne& b : all)
    stiffness = std::max(stiffness,
                         softest_stiffness(
                             b.pressed, demand.restitution, [&](double k) { return in_run(b, k); },
                             demand.load, demand.overlap));
  return stiffness;
}

/// With a square well in place of the attraction (powder/wells.h), which presses nothing: springs
/// bear impacts at the speed that it gives those of the load. Throws InvalidParameter as
/// well_depth, and unless the ratio of the well is one.
inline Springs springs_with_well(const GrainPair& pair, const Demand& demand) {
  const double e = demand.restitution, mu = 0.5 * pair.mass, radius = 0.5 * pair.diameter;
  const double real = material_stiffness(pair, demand);
  const square_well::SquareWellParameters well =
      square_well::well(well_depth(real, e, mu, pair.adhesion), demand.well_ratio);
  square_well::require_valid(well);
  double soft = demand.given;
  if (soft == 0.0) {
    const auto in_run = [&](const Borne& b, double) {
      return contact::Adhesion{0.0, 0.0, well_depth(real, e, b.pressed.reduced_mass, b.adhesion)};
    };
    soft = rounded_stiffness(softest_of_all(pair, demand, in_run),
                             stiffest_needed(pair, demand, real));
  }
  const PairNumbers of_material = pair_numbers(real, e, pair.mass, pair.adhesion);
  const PairNumbers used =
      pair_numbers(soft, e, pair.mass, square_well::adhesion_of(well, radius, radius));
  if (well.depth == 0.0) return {of_material, used, {1.0, 1.0}};
  return {of_material, used, {used.escape_velocity / of_material.escape_velocity, 0.0}};
}

/// Of two escape velocities, [1]; 1 too where both contacts hold every pair, or none.
inline double ratio(double one, double other) {
  return one > 0.0 && std::isfinite(one) && other > 0.0 ? one / other : 1.0;
}

/// The springs given, or the softest that will do, in two digits; no stiffer than the material is
/// for impacts at the speed of the load. Springs above the material's stiffness for the fastest
/// impact that sticks keep its attraction.
/// Throws InvalidParameter where those given leave the attraction no room below its outer cut-off.
inline Springs springs_of(const GrainPair& pair, const Demand& demand) {
  if (demand.well_ratio > 0.0) return springs_with_well(pair, demand);
  const double real = material_stiffness(pair, demand);
  double soft = demand.given;
  if (soft == 0.0) {
    const bool scales = demand.keep == contact::Keep::escape_velocity;
    soft = softest_of_all(pair, demand, [&](const Borne& b, double stiffness) {
      return scales && b.adhesion.force > 0.0 && stiffness < real
                 ? contact::StiffnessScaling(real, stiffness).adhesion(b.adhesion)
                 : b.adhesion;
    });
    if (scales)
      soft = std::max(
          soft, least_scaled_stiffness(std::max(real, demand.stiffest_material), pair.hamaker));
    soft = rounded_stiffness(soft, stiffest_needed(pair, demand, real));
  }
  // Springs stiffer than the material has for slow impacts stand for none but themselves.
  const contact::Material material{std::max(real, soft), demand.keep};
  contact::Adhesion used = pair.adhesion;
  if (contact::is_scaled(material, soft) && pair.adhesion.force > 0.0) {
    const contact::StiffnessScaling scaling(real, soft);
    used = scaling.adhesion(pair.adhesion);
    // As the engine will: throws where the outer cut-off leaves no room.
    scaling.hamaker(pair.hamaker);
  }
  const PairNumbers of_material = pair_numbers(real, demand.restitution, pair.mass, pair.adhesion);
  const PairNumbers of_run = pair_numbers(soft, demand.restitution, pair.mass, used);
  if (soft > real)
    return {of_material, of_run, {ratio(of_run.escape_velocity, of_material.escape_velocity), 1.0}};
  const auto spring =
      contact::LinearSpringDashpot::from_restitution(soft, demand.restitution, 0.5 * pair.mass);
  return {of_material, of_run,
          used.force > 0.0 ? advice::over_material(contact::AdhesiveContact(spring, used), material)
                           : advice::OverMaterial{1.0, 1.0}};
}

}  // namespace cohesion::powder
