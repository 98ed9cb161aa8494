// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>

#include "contact/adhesive_contact.h"
#include "contact/linear_spring_dashpot.h"
#include "hamaker/parameters.h"
#include "mixing.h"
#include "validation.h"

namespace cohesion::advice {

/// What a contact softer than its material keeps of it; both it cannot, at the same restitution.
/// As wide as a number of a restart file.
enum class Keep : std::int64_t {
  escape_velocity,  ///< which pairs stick in collisions; the adhesion is scaled (StiffnessScaling)
  force,            ///< strength and Bond number of packings; the adhesion is left as it is
};

struct KeepName {
  const char* name;
  Keep keep;
};
inline constexpr std::array keeps{KeepName{"velocity", Keep::escape_velocity},
                                  KeepName{"force", Keep::force}};

/// The material that a contact stands for, as far as users give it.
struct Material {
  double stiffness = 0.0;  ///< K, [force/length]; 0: not given
  Keep keep = Keep::escape_velocity;

  bool is_given() const { return stiffness > 0.0; }
};

/// Unlike materials: the geometric mean of the stiffnesses; given where both are.
/// Throws InvalidParameter where they keep different things.
inline Material mixed(const Material& a, const Material& b) {
  if (!a.is_given() || !b.is_given()) return {};
  if (a.keep != b.keep)
    throw InvalidParameter(
        "one of the two materials keeps the escape velocity, the other the force, and no mean of "
        "both exists: tell the pair what to keep");
  return {geometric_mean(a.stiffness, b.stiffness), a.keep};
}

/// Adhesion for a spring softer than the material, such that a pair sticks as the material does.
///
/// A soft spring dissipates more of a cohesive pair's energy: v_esc ~ F_ad/sqrt(mu K). With the
/// same mass and restitution, the whole curve of effective restitution over approach speed depends
/// on F_ad/sqrt(mu K) and W/mu alone (contact/adhesive_contact.h). The rule keeps both, with
/// f = sqrt(K_soft/K_real):
///
///   F_ad -> f F_ad      H_cut -> H_cut/f      E_tail -> E_tail      eta -> f eta
///
/// It is exact: v_esc and e_eff(v) stay to round-off. Overlaps and contact times grow by 1/f.
/// Scaling F_ad alone keeps v_esc only where W << F_ad^2/(2 K).
///
/// For the Hamaker attraction, F_ad ~ A/H_cut^2 and W ~ A (2/H_cut - 1/H_out) at any R*: with
/// k = H_cut/H_out and h = H_cut,soft/H_cut, H_out staying,
///
///   f (2 h - k h^2) = 2 - k  ->  h = (2 - k)/f/(1 + sqrt(1 - k (2 - k)/f))      A -> A f h^2
///
/// which needs f > k (2 - k); for H_out -> infinity both A and H_cut grow by 1/f.
///
/// What is not kept: the force that holds a resting pair falls to f F_ad, and so does its ratio to
/// the weight; and the attraction of a pair that does not touch reaches further. Where that matters
/// more than which pairs stick the adhesion is not scaled (Keep::force).
///
/// Source: derived here, by similarity. The purpose is that of Y. Gu, A. Ozel and S. Sundaresan
/// (2016), whose text was not at hand: the rule has not been compared with theirs.
class StiffnessScaling {
 public:
  /// K of the material and of the simulation [force/length].
  /// Throws InvalidParameter unless both are positive and finite.
  StiffnessScaling(double real_stiffness, double soft_stiffness) {
    require_positive("stiffness K of the material", real_stiffness);
    require_positive("stiffness K of the simulation", soft_stiffness);
    soft_stiffness_ = soft_stiffness;
    factor_ = std::sqrt(soft_stiffness / real_stiffness);
  }

  /// f = sqrt(K_soft/K_real), [1].
  double factor() const { return factor_; }

  /// The spring of the simulation at the same mass and restitution.
  contact::LinearSpringDashpot spring(const contact::LinearSpringDashpot& real) const {
    return {soft_stiffness_, factor_ * real.damping(), real.reduced_mass()};
  }

  contact::Adhesion adhesion(const contact::Adhesion& real) const {
    return {factor_ * real.force, real.cutoff / factor_, real.tail_energy};
  }

  /// For the small-gap form. Throws InvalidParameter as require_valid does, for rough surfaces, and
  /// unless H_out leaves room for the wider cut-off.
  hamaker::Parameters hamaker(const hamaker::Parameters& real) const {
    require_valid(real);
    require_smooth(real);
    const double k = real.surface_cutoff / real.outer_cutoff;
    require(factor_ > k * (2.0 - k), "outer cut-off", real.outer_cutoff,
            "too small for the softened contact: H_cut grows by about sqrt(K_real/K_soft) and has "
            "to stay below it; must exceed 2 H_cut sqrt(K_real/K_soft)");
    const double h = (2.0 - k) / factor_ / (1.0 + std::sqrt(1.0 - k * (2.0 - k) / factor_));
    return {real.hamaker_constant * factor_ * h * h, h * real.surface_cutoff, real.outer_cutoff};
  }

 private:
  double soft_stiffness_;
  double factor_;
};

/// Whether a contact of `stiffness` [force/length] needs another adhesion than its material.
inline bool is_scaled(const Material& material, double stiffness) {
  return material.is_given() && material.keep == Keep::escape_velocity &&
         material.stiffness != stiffness;
}

/// The Hamaker attraction of a contact of `stiffness` [force/length] from that of its material.
/// Throws InvalidParameter as StiffnessScaling.
inline hamaker::Parameters for_stiffness(double stiffness, const Material& material,
                                         const hamaker::Parameters& real) {
  if (real.hamaker_constant == 0.0 || !is_scaled(material, stiffness)) return real;
  return StiffnessScaling(material.stiffness, stiffness).hamaker(real);
}

/// What for_stiffness() changed, or left on purpose, for a log; empty where the question does not
/// arise.
inline std::string scaling_note(double stiffness, const Material& material,
                                const hamaker::Parameters& real, const hamaker::Parameters& used) {
  std::ostringstream out;
  if (!material.is_given() || material.stiffness == stiffness || real.hamaker_constant == 0.0)
    return {};
  if (is_scaled(material, stiffness))
    out << "adhesion scaled from stiffness " << material.stiffness << " to " << stiffness
        << ", which keeps the escape velocity: A " << real.hamaker_constant << " -> "
        << used.hamaker_constant << ", H_cut " << real.surface_cutoff << " -> "
        << used.surface_cutoff;
  else
    out << "adhesion of stiffness " << material.stiffness << " left at stiffness " << stiffness
        << ", which keeps the pull-off force";
  return out.str();
}

}  // namespace cohesion::advice
