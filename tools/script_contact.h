// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <variant>

#include "advice/elastic_pair.h"
#include "advice/integrated_escape.h"
#include "advice/power_law_spring.h"
#include "contact/adhesive_contact.h"
#include "contact/area_attraction.h"
#include "contact/contact_parameters.h"
#include "hamaker/forms.h"
#include "named_table.h"
#include "script_case.h"
#include "sphere.h"

namespace cohesion::tools {

/// Cohesion models that are evaluated, and the property of their strength.
struct CohesionOfScript {
  const char* name;
  const char* property;  ///< null: none
  const char* unit;      ///< of a script in SI units
};
inline constexpr CohesionOfScript cohesions_of_scripts[] = {
    {"off", nullptr, ""},
    {"sjkr", "cohesionEnergyDensity", "[energy/length^3]"},
    {"sjkr2", "cohesionEnergyDensity", "[energy/length^3]"},
    {"hamaker", "hamakerConstant", "[energy]"},
    {"jkr", "surfaceEnergy", "[energy/length^2]"}};

/// Two grains, or a grain and a wall.
struct PairOfScript {
  int i, j;  ///< atom types; j: that of the wall
  ScriptGrain one;
  std::optional<ScriptGrain> other;  ///< none: a wall

  double reduced_radius() const {
    return other ? cohesion::reduced_radius(one.radius, other->radius) : one.radius;
  }
  double reduced_mass() const {
    return other ? cohesion::reduced_mass(one.mass(), other->mass()) : one.mass();
  }
  PairGeometry geometry() const {
    return other ? two_spheres(one.radius, other->radius) : sphere_and_plane(one.radius);
  }
  double smaller_mass() const { return other ? std::min(one.mass(), other->mass()) : one.mass(); }
  double smaller_diameter() const {
    return 2.0 * (other ? std::min(one.radius, other->radius) : one.radius);
  }
};

/// The contact of a pair with the models and properties of the script.
class ScriptContact {
 public:
  /// Of sjkr and sjkr2.
  static constexpr const char* area_property = "cohesionEnergyDensity";

  /// Throws std::runtime_error with the line where the script lacks something or has a model that
  /// is not evaluated.
  ScriptContact(const ScriptCase& script, const GranularModel& model, const PairOfScript& pair)
      : script_(script),
        model_(model),
        pair_(pair),
        spring_(spring()),
        cohesion_(known_cohesion()) {
    refuse_other_forces();
    set_cohesion();
  }

  const CohesionOfScript& cohesion() const { return cohesion_; }
  double strength() const { return strength_; }
  bool is_area() const { return model_.cohesion == "sjkr" || model_.cohesion == "sjkr2"; }
  const GranularModel& model() const { return model_; }
  const PairOfScript& pair() const { return pair_; }
  const contact::HertzSpringDashpot& hertz() const {
    return std::get<contact::HertzSpringDashpot>(spring_);
  }
  /// Of 'model hertz' and 'model hooke'.
  contact::ContactParameters elastic() const {
    const auto of = [&](int type) {
      contact::ContactParameters p;
      contact::set_hertz(p, script_.need("youngsModulus", model_).of_type(type),
                         script_.need("poissonsRatio", model_).of_type(type));
      return p;
    };
    contact::ContactParameters p = contact::mixed(of(pair_.i), of(pair_.j));
    p.restitution = of_pair("coefficientRestitution");
    return p;
  }
  /// Neither sjkr nor without cohesion.
  bool has_exact_scheme() const { return !is_area() && cohesion_.property; }
  bool is_hertz() const { return std::holds_alternative<contact::HertzSpringDashpot>(spring_); }

  /// The largest net attraction; infinite: of any load, the spheres collapse.
  double pull_off_force() const {
    if (jkr_) return jkr_->pull_off_force();
    if (!is_area()) return adhesion_.force;
    if (is_hertz()) return area().pull_off_force();
    return slope_ >= linear().stiffness() ? infinite : 0.0;
  }
  double bond_number(double gravity) const {
    return pull_off_force() / (pair_.smaller_mass() * gravity);
  }
  double escape_velocity() const {
    if (jkr_) return jkr_->escape_velocity();
    if (is_area()) return is_hertz() ? advice::escape_velocity(area()) : linear_area_escape();
    if (is_hertz()) return advice::escape_velocity(hertz(), adhesion_);
    return adhesion_.force > 0.0 ? contact::AdhesiveContact(linear(), adhesion_).escape_velocity()
                                 : 0.0;
  }
  /// Of the spring, [time].
  double contact_time(double speed) const {
    if (is_hertz()) return hertz().contact_time(speed);
    return pi * std::sqrt(linear().reduced_mass() / linear().stiffness());
  }
  /// Of the spring without dashpot and without an attraction that vanishes at touch, over the
  /// smaller diameter.
  double overlap(double speed) const {
    if (jkr_) return jkr_->largest_overlap(speed) / pair_.smaller_diameter();
    const double mass = pair_.reduced_mass();
    const double touch = std::sqrt(speed * speed + 2.0 * adhesion_.approach_energy() / mass);
    return advice::largest_overlap(springs(), mass, adhesion_.force, touch) /
           pair_.smaller_diameter();
  }
  /// The energy density of sjkr or sjkr2 in Hertz's contact that has this Bond number.
  double energy_density_of(double bond, double gravity) const {
    return contact::energy_density_of_pull_off(bond * pair_.smaller_mass() * gravity, hertz(),
                                               area_kind(), pair_.reduced_radius());
  }
  /// Where an attraction by area is largest, over the reduced radius; 0 of others.
  double overlap_at_pull_off() const {
    return is_area() && is_hertz() ? area().overlap_at_pull_off() / pair_.reduced_radius() : 0.0;
  }

  /// The adhesion of this pair, and its JKR contact, with the properties of this package.
  contact::Adhesion hamaker_adhesion(const hamaker::HamakerParameters& p) const {
    return std::visit([&](const auto& law) { return contact::adhesion_of(law, pair_.geometry()); },
                      hamaker::forms.front().law(p, false));
  }
  advice::ElasticPair jkr_pair(double surface_energy) const {
    return elastic_pair(elastic(), {}, surface_energy);
  }
  /// The contact of 'model hertz' with friction, and Hamaker or JKR adhesion or none.
  advice::ElasticPair pair_with_friction(const contact::Adhesion& adhesion,
                                         double surface_energy) const {
    contact::ContactParameters p = elastic();
    p.friction = friction("tangential", {"history", "no_history"}, "coefficientFriction");
    p.rolling_friction = friction("rolling_friction", {"epsd2"}, "coefficientRollingFriction");
    return elastic_pair(p, adhesion, surface_energy);
  }
  /// The same with the adhesion of the script.
  advice::ElasticPair pair_with_friction() const {
    return pair_with_friction(adhesion_, jkr_ ? strength_ : 0.0);
  }

 private:
  using Spring = std::variant<contact::LinearSpringDashpot, contact::HertzSpringDashpot>;
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  double of_pair(const std::string& name) const {
    return script_.need(name, model_).of_pair(pair_.i, pair_.j);
  }
  advice::ElasticPair elastic_pair(contact::ContactParameters p, const contact::Adhesion& adhesion,
                                   double surface_energy) const {
    if (surface_energy > 0.0) contact::set_surface_energy(p, surface_energy);
    return {p, pair_.reduced_radius(), pair_.reduced_mass(), adhesion};
  }
  /// Of models with a spring; 0: there is none, or LIGGGHTS stops as it lacks the property.
  double friction(const char* keyword, const std::set<std::string>& models,
                  const char* property) const {
    const ScriptCommand& c = model_.where;
    const std::size_t at = c.find(keyword) + 1;
    const bool has_spring = c.has(at) && models.count(c.words[at]);
    return has_spring && script_.find(property) ? of_pair(property) : 0.0;
  }
  Spring spring() const {
    const double mass = pair_.reduced_mass(), radius = pair_.reduced_radius();
    if (model_.normal == "hertz")
      return std::get<contact::HertzSpringDashpot>(contact::normal_law(elastic(), radius, mass));
    if (model_.normal == "hooke") {
      const contact::ContactParameters p = elastic();
      const double speed = script_.need("characteristicVelocity", model_).scalar();
      const double stiffness =
          advice::linear_springs(advice::springs_of(p, radius, mass), mass, 0.0, speed).stiffness;
      return contact::LinearSpringDashpot::from_restitution(stiffness, p.restitution, mass);
    }
    const bool absolute = model_.has_on("absolute_damping");
    if (model_.normal == "hooke/stiffness")
      return contact::LinearSpringDashpot(
          of_pair("kn"), absolute ? of_pair("gamman_abs") : mass * of_pair("gamman"), mass);
    if (model_.normal == "hertz/stiffness") {
      const double root = std::sqrt(radius);
      return contact::HertzSpringDashpot(of_pair("kn") * root,
                                         contact::HertzSpringDashpot::Damping::square_root,
                                         mass * of_pair("gamman") * root, mass);
    }
    model_.where.fail("'model " + model_.normal +
                      "' is not evaluated: use hertz, hooke, hertz/stiffness or hooke/stiffness "
                      "for this check");
  }

  const CohesionOfScript& known_cohesion() const {
    for (const CohesionOfScript& known : cohesions_of_scripts)
      if (known.name == model_.cohesion) return known;
    model_.where.fail("'cohesion " + model_.cohesion +
                      "' is not evaluated: use off, sjkr, sjkr2, hamaker or jkr for this check");
  }

  /// Keywords that change the normal force.
  void refuse_other_forces() const {
    for (const char* keyword : {"limitForce", "viscous"})
      if (model_.has_on(keyword))
        model_.where.fail(std::string("'") + keyword +
                          " on' is not evaluated: remove it for this check");
  }

  void set_cohesion() {
    if (!cohesion_.property) return;
    strength_ = of_pair(cohesion_.property);
    if (!(strength_ >= 0.0))
      script_.need(cohesion_.property, model_).where().fail("must not be negative: correct it");
    if (is_area())
      slope_ = contact::attraction_slope(strength_, area_kind(), pair_.reduced_radius());
    if (model_.cohesion == "hamaker" && strength_ > 0.0)
      adhesion_ =
          hamaker_adhesion({strength_, script_.need("hamakerSurfaceCutoff", model_).scalar(),
                            script_.need("hamakerOuterCutoff", model_).scalar()});
    if (model_.cohesion == "jkr" && model_.normal != "hertz")
      model_.where.fail("'cohesion jkr' needs 'model hertz', not 'model " + model_.normal +
                        "': write 'model hertz'");
    if (model_.cohesion == "jkr" && strength_ > 0.0) jkr_ = jkr_pair(strength_);
  }

  /// sjkr2 doubles the area between spheres only.
  contact::ContactArea area_kind() const {
    return model_.cohesion == "sjkr2" && pair_.other ? contact::ContactArea::doubled
                                                     : contact::ContactArea::circle;
  }
  /// Of a linear spring less an attraction in proportion to the overlap, which is a spring again: 0
  /// where it oscillates, infinite where the overlap never returns to zero.
  double linear_area_escape() const {
    const double c = linear().damping(), net = linear().stiffness() - slope_;
    return net > 0.0 && c * c < 4.0 * linear().reduced_mass() * net ? 0.0 : infinite;
  }
  const contact::LinearSpringDashpot& linear() const {
    return std::get<contact::LinearSpringDashpot>(spring_);
  }
  contact::HertzWithAreaAttraction area() const { return {hertz(), slope_}; }
  advice::ContactSprings springs() const {
    advice::ContactSprings s{};
    if (!is_hertz()) {
      s.stiffness = linear().stiffness();
      s.overlap = 1.0;
      return s;
    }
    s.exponent = 1.5;
    s.overlap = 1e-4 * pair_.reduced_radius();
    s.stiffness = hertz().at(s.overlap).force / s.overlap;
    return s;
  }

  const ScriptCase& script_;
  const GranularModel& model_;
  PairOfScript pair_;
  Spring spring_;
  const CohesionOfScript& cohesion_;
  double strength_ = 0.0, slope_ = 0.0;
  contact::Adhesion adhesion_{};
  std::optional<advice::ElasticPair> jkr_;
};

}  // namespace cohesion::tools
