// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>

#include "contact/adhesive_contact.h"
#include "contact/contact_parameters.h"
#include "contact/linear_spring_dashpot.h"
#include "hamaker/parameters.h"
#include "mixing.h"
#include "validation.h"

namespace cohesion::contact {

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

/// The power p of the overlap in the force of a contact, F ~ x^p: of a linear spring, and of
/// Hertz's and JKR's contact.
inline constexpr double linear_power = 1.0, hertz_power = 1.5;

/// The material that a contact stands for, as far as users give it.
struct Material {
  /// K of a linear spring, [force/length], or E* of Hertz's and JKR's contact, [force/length^2]; 0:
  /// not given.
  double stiffness = 0.0;
  Keep keep = Keep::escape_velocity;
  double exponent = linear_power;  ///< p, [1]

  bool is_specified() const { return stiffness > 0.0; }
};

/// The material of Hertz's or JKR's contact, of which two have E* (reduced_modulus).
/// Throws InvalidParameter as that.
inline void set_hertz(Material& m, double youngs_modulus, double poissons_ratio) {
  m.stiffness = reduced_modulus(youngs_modulus, poissons_ratio);
  m.exponent = hertz_power;
}

/// Throws InvalidParameter unless the stiffness is positive, or 0, and finite.
inline void require_valid(const Material& m) {
  require_non_negative("stiffness of the material", m.stiffness);
}

/// Unlike materials, mixed as their contacts are (contact_parameters.h): the geometric mean of the
/// stiffnesses, the harmonic one of the moduli; given where both are.
/// Throws InvalidParameter where they keep different things.
inline Material mixed(const Material& a, const Material& b) {
  if (!a.is_specified() || !b.is_specified()) return {};
  if (a.keep != b.keep)
    throw InvalidParameter(
        "one of the two materials keeps the escape velocity, the other the force, and no mean of "
        "both exists: tell the pair what to keep");
  const double mean = a.exponent == linear_power ? geometric_mean(a.stiffness, b.stiffness)
                                                 : 2.0 / (1.0 / a.stiffness + 1.0 / b.stiffness);
  return {mean, a.keep, a.exponent};
}

/// Of a contact what Material::stiffness is of its material: K, or E*.
inline double stiffness_of(const ContactParameters& p) {
  return p.is_hertz() ? p.modulus : p.stiffness;
}

/// Adhesion for a contact softer than the material, such that a pair sticks as the material does.
///
/// A soft contact dissipates more of a cohesive pair's energy. Its motion, of the force k x^p with
/// a dashpot of constant restitution and the attraction F_ad, is that of the material at the same
/// speeds, with lengths and times 1/f as large and forces f times as large, where
///
///   f = (k_soft/k_real)^(1/(p + 1)) = sqrt(K_soft/K_real), (E*_soft/E*_real)^(2/5)
///
///   F_ad -> f F_ad      H_cut -> H_cut/f      E_tail -> E_tail      eta -> f eta (p = 1)
///
/// It is exact: v_esc and e_eff(v) stay to round-off. Overlaps and contact times grow by 1/f. So it
/// is for JKR's contact, whose radius a grows as f^(-1/2): w -> f w, with which go the pull-off
/// force f, the tearing gap 1/f and the work up to tearing 1.
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
  /// K, or E*, of the material and of the simulation; exponent: p of the law.
  /// Throws InvalidParameter unless both are positive and finite.
  StiffnessScaling(double real_stiffness, double soft_stiffness, double exponent = linear_power) {
    require_positive("stiffness of the material", real_stiffness);
    require_positive("stiffness of the simulation", soft_stiffness);
    factor_ = std::pow(soft_stiffness / real_stiffness, 1.0 / (exponent + 1.0));
  }
  StiffnessScaling(const Material& material, double soft_stiffness)
      : StiffnessScaling(material.stiffness, soft_stiffness, material.exponent) {}

  /// f, [1].
  double factor() const { return factor_; }

  /// w of JKR's contact, [energy/length^2].
  double work_of_adhesion(double real) const { return factor_ * real; }

  Adhesion adhesion(const Adhesion& real) const {
    return {factor_ * real.force, real.cutoff / factor_, real.tail_energy};
  }

  /// For the small-gap form. Throws InvalidParameter as require_valid does, for rough surfaces, and
  /// unless H_out leaves room for the wider cut-off.
  hamaker::HamakerParameters hamaker(const hamaker::HamakerParameters& real) const {
    require_valid(real);
    require_smooth(real);
    const double k = real.surface_cutoff / real.outer_cutoff;
    require(
        factor_ > k * (2.0 - k), "outer cut-off", real.outer_cutoff,
        "too small for the softened contact: H_cut grows by about 1/f and has to stay below it; "
        "must exceed 2 H_cut/f, f = sqrt(K_soft/K_real) or (E_soft/E_real)^(2/5)");
    const double h = (2.0 - k) / factor_ / (1.0 + std::sqrt(1.0 - k * (2.0 - k) / factor_));
    return {real.hamaker_constant * factor_ * h * h, h * real.surface_cutoff, real.outer_cutoff};
  }

 private:
  double factor_;
};

/// Whether `stiffness`, as stiffness_of(), is that of the material, to round-off.
inline bool is_of_material(const Material& material, double stiffness) {
  return std::abs(stiffness - material.stiffness) <= 1e-9 * material.stiffness;
}

/// Throws InvalidParameter where the contact is stiffer than the material that it stands for: a
/// number in another unit, most often.
inline void require_softer(const Material& material, double stiffness) {
  if (!material.is_specified() || stiffness <= material.stiffness ||
      is_of_material(material, stiffness))
    return;
  std::ostringstream text;
  text << "the " << (material.exponent == linear_power ? "stiffness" : "modulus E*")
       << " of the contact is " << stiffness << " and that of its material " << material.stiffness
       << ": a contact must not be stiffer than its material; check the units";
  throw InvalidParameter(text.str());
}

/// Whether a contact of `stiffness`, as stiffness_of(), needs another adhesion than its material.
inline bool is_scaled(const Material& material, double stiffness) {
  return material.is_specified() && material.keep == Keep::escape_velocity &&
         !is_of_material(material, stiffness);
}

/// The Hamaker attraction of a contact of `stiffness` from that of its material.
/// Throws InvalidParameter as StiffnessScaling and require_softer.
inline hamaker::HamakerParameters for_stiffness(double stiffness, const Material& material,
                                                const hamaker::HamakerParameters& real) {
  require_softer(material, stiffness);
  if (real.hamaker_constant == 0.0 || !is_scaled(material, stiffness)) return real;
  return StiffnessScaling(material, stiffness).hamaker(real);
}

/// The same of w of JKR's contact.
inline double for_stiffness(double stiffness, const Material& material, double work_of_adhesion) {
  require_softer(material, stiffness);
  if (work_of_adhesion == 0.0 || !is_scaled(material, stiffness)) return work_of_adhesion;
  return StiffnessScaling(material, stiffness).work_of_adhesion(work_of_adhesion);
}

/// How a log calls the stiffness of a material or a contact.
inline const char* name_of_stiffness(const Material& material) {
  return material.exponent == linear_power ? "stiffness" : "modulus E*";
}

namespace detail {

/// scaling_note(), with the numbers of the adhesion.
inline std::string scaling_note(double stiffness, const Material& material,
                                const std::string& numbers) {
  if (!material.is_specified() || is_of_material(material, stiffness)) return {};
  const std::string name = name_of_stiffness(material);
  std::ostringstream out;
  if (is_scaled(material, stiffness))
    out << "adhesion scaled from " << name << ' ' << material.stiffness << " to " << stiffness
        << ", which keeps the escape velocity: " << numbers;
  else
    out << "adhesion not scaled from " << name << ' ' << material.stiffness << " to " << stiffness
        << ", which keeps the pull-off force";
  return out.str();
}

}  // namespace detail

/// What for_stiffness() changed, or left on purpose, for a log; empty where the question does not
/// arise.
inline std::string scaling_note(double stiffness, const Material& material,
                                const hamaker::HamakerParameters& real,
                                const hamaker::HamakerParameters& used) {
  if (real.hamaker_constant == 0.0) return {};
  std::ostringstream numbers;
  numbers << "A " << real.hamaker_constant << " -> " << used.hamaker_constant << ", H_cut "
          << real.surface_cutoff << " -> " << used.surface_cutoff;
  return detail::scaling_note(stiffness, material, numbers.str());
}

/// The same of w of JKR's contact.
inline std::string scaling_note(double stiffness, const Material& material, double real,
                                double used) {
  if (real == 0.0) return {};
  std::ostringstream numbers;
  numbers << "work of adhesion " << real << " -> " << used;
  return detail::scaling_note(stiffness, material, numbers.str());
}

}  // namespace cohesion::contact
