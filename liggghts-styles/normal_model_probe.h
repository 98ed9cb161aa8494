// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_NORMAL_MODEL_PROBE_H
#define COHESION_NORMAL_MODEL_PROBE_H

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "advice/power_law_spring.h"
#include "contact/normal_law.h"
#include "property_registry.h"
#include "settings.h"

namespace LIGGGHTS {
namespace ContactModels {
class NormalModelBase;
struct SurfacesIntersectData;
}  // namespace ContactModels

namespace Cohesion {

/// The normal law of scheme exact between two types, made of the engine's; rj infinite: beside a
/// wall.
using ContactLaw = std::function<cohesion::contact::NormalLaw(
    const cohesion::contact::NormalLaw& normal, int itype, int jtype, double ri, double rj)>;

/// A normal model of the engine beside the one that a contact model has, with the same settings and
/// properties: asked about a contact that is not there, it tells spring and dashpot. What they are
/// stays a matter of the engine.
class NormalModelProbe {
 public:
  /// A contact to ask about.
  struct ProbedContact {
    int itype, jtype;
    double radius_i, radius_j;  ///< [length]; radius_j of no meaning beside a wall
    double reduced_mass;        ///< [mass]
    double speed;               ///< of approach: some dashpots depend on it, [length/time]
    bool is_wall;
  };

  /// `has(name)`: whether the contact model has the normal model of this name.
  NormalModelProbe(LAMMPS* lmp, const std::function<bool(const char*)>& has);
  ~NormalModelProbe();

  void registerSettings(Settings& settings);
  void connect(PropertyRegistry& registry);

  const std::string& name() const { return name_; }
  /// Whether the script specifies the stiffness of each pair of types.
  bool has_pair_stiffness() const { return name_ == "hooke/stiffness"; }
  /// Whether the script specifies Young's moduli and Poisson's ratios.
  bool has_elastic_modulus() const { return name_ == "hertz"; }

  /// The keyword by which a script gives the material of such contacts, and with its property;
  /// empty: it cannot.
  std::string_view material_keyword() const;
  std::string_view material_words() const;
  /// Of two types, where their material can be given: K, or E* of Hertz's contact; else 0.
  double stiffness(int itype, int jtype, bool is_wall) const;

  /// p of the force F ~ overlap^p.
  double exponent() const;

  /// Whether the dashpot between two types is one of several, by the speed.
  bool dashpot_varies(int itype, int jtype) const;
  /// Whether the force of two that part ends where their dashpot would pull.
  bool limits_force(int itype, int jtype) const;

  /// The model as the solver takes it (contact/normal_law.h). Throws InvalidParameter for one that
  /// is neither linear nor Hertz's.
  cohesion::contact::NormalLaw law(const ProbedContact& pair) const;

  /// At `overlap` [length], 0: a small one; and how the force changes with it.
  cohesion::advice::ContactSprings springs(const ProbedContact& pair, double overlap = 0.0) const;

 private:
  class Quiet;
  ContactModels::SurfacesIntersectData contact_data(const ProbedContact& pair,
                                                    double overlap) const;

  std::unique_ptr<Quiet> quiet_;
  std::unique_ptr<ContactModels::NormalModelBase> model_;
  std::string name_;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
