// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "advice/contact_advice.h"
#include "advice/elastic_pair.h"
#include "advice/known_materials.h"
#include "exact_step.h"
#include "script_report.h"

namespace cohesion::tools {

/// Finds properties of a script that hold another quantity or unit, and contacts without the effect
/// of their cohesion model. Each warning has place, finding and remedy.
class ScriptWarnings {
 public:
  ScriptWarnings(const ScriptCase& script, const ContactConditions& conditions)
      : script_(script), conditions_(conditions), exact_step_(conditions) {}

  /// Contacts with the same finding at the same place are in one text.
  std::vector<std::string> texts() const {
    std::vector<std::string> texts;
    for (const MergedWarning& f : findings_)
      texts.push_back(f.place + ": " + joined(f.contacts, "; ") + (f.contacts.empty() ? "" : ": ") +
                      f.text);
    const std::string of_step = exact_step_.finding();
    if (!of_step.empty()) texts.push_back(script_.run().timestep()->place() + ": " + of_step);
    return texts;
  }

  /// Of the script as a whole.
  void check_script() {
    for (const auto& [type, grains] : script_.grains()) check_grains(type, grains);
    for (const CohesionOfScript& c : cohesions_of_scripts) check_use(c);
    if (script_.pairs()) check_scaling(*script_.pairs());
    for (const WallOfScript& wall : script_.walls()) check_scaling(wall.model);
    for (const ScriptCommand& second : script_.second_mesh_walls())
      add(second,
          "LIGGGHTS stops at a second 'fix wall/gran ... mesh': list the meshes of both in "
          "one, as in 'n_meshes 2 meshes A B'");
    for (const WallOfScript& wall : script_.walls())
      if (script_.pairs() && wall.model.cohesion != script_.pairs()->cohesion)
        add(wall.model.where, "wall '" + wall.id + "' has cohesion " + wall.model.cohesion +
                                  " and pair_style has cohesion " + script_.pairs()->cohesion +
                                  ": write the same cohesion in both unless this is intended");
  }

  void check_contact(const ContactPairOfTypes& pair) {
    check_modulus(pair);
    const ScriptContact& c = pair.smallest;
    if (c.cohesion().property && c.strength() > 0.0) {
      check_magnitude(pair);
      check_strength(pair);
    }
    check_overlap(pair);
    if (!(conditions_.step > 0.0)) return;
    if (c.has_exact_scheme() && pair.model->normal == "hertz")
      return exact_step_.add(pair.title, c.pair_with_friction());
    const double steps = c.contact_time(conditions_.speed) / conditions_.step;
    const double needed = steps_needed(c);
    if (steps < needed)
      add(pair.model->where, pair,
          digits(steps) + " time steps per contact, below " + digits(needed) +
              ": use a timestep of at most " + digits(conditions_.step * steps / needed));
  }

 private:
  /// Steps per contact of the engine's models, and of the scheme exact of this package.
  static double steps_needed(const ScriptContact& c) {
    if (!c.has_exact_scheme()) return advice::sampled_scheme.steps_for_warning;
    return c.is_hertz() ? advice::steps_per_integrated_contact
                        : advice::exact_scheme_one_pass.steps_for_warning;
  }

  /// Bond number below which the pull-off force is reported as negligible. Below 1 a contact does
  /// not carry the weight of the smallest grain; the factor of ten excludes doubtful cases.
  static constexpr double negligible_bond_number = 0.1;
  /// Energy density [J/m^3] below which a number is reported as a possible surface energy [J/m^2]:
  /// two orders above the largest of these, advice::largest_surface_energy.
  static constexpr double least_energy_density = 1e3;
  /// Young's modulus [Pa] below which a number is reported as one of another unit: one order above
  /// the modulus of the stiffest solid, diamond, in GPa.
  static constexpr double least_modulus = 1e4;
  /// Median radius [m] from which a number is reported as one of another unit: larger than grains
  /// of any powder, and that of grains of 0.1 mm written in mm.
  static constexpr double largest_radius = 0.1;
  /// Overlap over R* above which results for small overlaps are reported as inaccurate. There the
  /// area of contact of sjkr is below 2 pi R* x by 1.25 % (equal spheres) and 5 % (wall).
  static constexpr double largest_linear_overlap = 0.1;

  void check_grains(int type, const Grains& grains) {
    const advice::SiUnits* units = script_.units();
    if (!units) return;
    const std::string of_type = " of type " + std::to_string(type);
    const double density = units->density() * grains.smallest.density;
    if (density < advice::least_solid)
      add(grains.where, "density " + digits(density) + " kg/m3" + of_type +
                            " is that of no solid: write it in kg/m3 (1 g/cm3 is 1000)");
    if (density > advice::largest_solid)
      add(grains.where, "density " + digits(density) + " kg/m3" + of_type +
                            " is above that of any solid: check its unit");
    const double radius = units->length * grains.median.radius;
    if (radius >= largest_radius)
      add(grains.where, "radius " + digits(radius) + " m" + of_type +
                            " is that of no powder: write it in the length of 'units " +
                            script_.unit_name() + "', 1 mm is " + digits(1e-3 / units->length));
  }

  void check_scaling(const GranularModel& model) {
    for (const char* keyword : {"material_stiffness", "material_modulus"})
      if (model.has_on(keyword))
        add(model.where, std::string("'") + keyword +
                             " on' scales the attraction, which is evaluated without it: read the "
                             "table of liggghts-cohesion for this contact");
  }

  /// A strength that no model reads.
  void check_use(const CohesionOfScript& c) {
    const ScriptProperty* property = c.property ? script_.find(c.property) : nullptr;
    if (!property || warned_.count(c.property)) return;
    const auto reads = [&](const GranularModel& model) {
      for (const CohesionOfScript& other : cohesions_of_scripts)
        if (other.property && other.property == std::string(c.property) &&
            model.cohesion == other.name)
          return true;
      return false;
    };
    bool is_read = script_.pairs() && reads(*script_.pairs());
    for (const WallOfScript& wall : script_.walls()) is_read = is_read || reads(wall.model);
    if (is_read) return;
    warned_.insert(c.property);
    add(property->where(), std::string(c.property) + " is not used: add 'cohesion " + c.name +
                               "' to pair_style and walls, or remove this line");
  }

  /// Of impacts at a speed that script or command line have.
  void check_overlap(const ContactPairOfTypes& pair) {
    if (conditions_.is_speed_assumed) return;
    const double overlap = pair.median.overlap(conditions_.speed);
    if (overlap > advice::overlap_for_warning)
      add(pair.model->where, pair,
          "impacts press grains by " + digits(overlap) +
              " of the diameter: increase youngsModulus or kn until this is below " +
              digits(advice::overlap_for_warning));
  }

  void check_modulus(const ContactPairOfTypes& pair) {
    const ScriptProperty* property = script_.find("youngsModulus");
    const advice::SiUnits* units = script_.units();
    if (!property || !units) return;
    const bool reads = pair.model->normal == "hertz" || pair.model->normal == "hooke";
    for (const int type : {pair.i, pair.j}) {
      if (!reads || !warned_.insert("youngsModulus" + std::to_string(type)).second) continue;
      const double modulus =
          units->density() * std::pow(units->length / units->time, 2) * property->of_type(type);
      if (modulus < least_modulus)
        add(property->where(), "youngsModulus " + digits(modulus) + " Pa of type " +
                                   std::to_string(type) +
                                   " is that of no solid: write it in Pa (1 GPa is 1e9)");
    }
  }

  /// Above those of any material.
  void check_magnitude(const ContactPairOfTypes& pair) {
    const std::string name = pair.model->cohesion;
    const double strength = pair.smallest.strength();
    std::string text;
    if (name == "hamaker") text = advice::above_hamaker_constants(strength, script_.units());
    if (name == "jkr") text = advice::above_surface_energies(strength, script_.units());
    if (text.empty()) return;
    add(place(pair), pair, text.substr(0, text.find_last_not_of("; ") + 1));
  }

  void check_strength(const ContactPairOfTypes& pair) {
    const ScriptContact& c = pair.smallest;
    const double bond = c.bond_number(conditions_.gravity);
    const std::string cohesion = "cohesion " + pair.model->cohesion;
    if (c.is_area() && !c.is_hertz()) return check_linear_spring(pair, cohesion);
    if (c.overlap_at_pull_off() > largest_linear_overlap)
      add(place(pair), pair,
          cohesion + " is strongest at an overlap of " + digits(c.overlap_at_pull_off()) +
              " of the reduced radius, and values are those of small overlaps: " +
              "decrease cohesionEnergyDensity or increase youngsModulus");
    if (bond >= negligible_bond_number) return;
    std::string text = cohesion + " has a Bond number of " + digits(bond) +
                       ", too small to hold the smallest grain";
    if (c.is_area())
      text += area_remedy(c);
    else
      text += ": increase " + std::string(c.cohesion().property) + " by the factor " +
              digits(1.0 / bond) + " for a Bond number of 1";
    add(place(pair), pair, text);
  }
  /// An attraction by area and a linear spring.
  void check_linear_spring(const ContactPairOfTypes& pair, const std::string& cohesion) {
    const ScriptContact& c = pair.smallest;
    if (c.pull_off_force() > 0.0)
      add(place(pair), pair,
          cohesion + " exceeds the spring at every overlap and spheres collapse: " +
              "decrease cohesionEnergyDensity, or use 'cohesion hamaker'");
    else if (c.escape_velocity() > 0.0)
      add(place(pair), pair,
          cohesion + " reduces the spring until the dashpot damps it critically, and " +
              "contacts never separate: decrease cohesionEnergyDensity, or use " +
              "'cohesion hamaker'");
    else
      add(pair.model->where, pair,
          cohesion + " has no pull-off force with model " + pair.model->normal +
              ", whose spring exceeds it at every overlap: use model hertz, "
              "or 'cohesion hamaker'");
  }

  std::string area_remedy(const ScriptContact& c) const {
    const advice::SiUnits* units = script_.units();
    std::string text;
    const double density =
        units ? c.strength() * units->energy() / std::pow(units->length, 3) : least_energy_density;
    if (density < least_energy_density)
      text += "; " + digits(density) +
              " J/m3 is in the range of surface energies in J/m2, for which 'cohesion jkr' of this "
              "package has the property surfaceEnergy";
    return text + ": use cohesionEnergyDensity " +
           digits(c.energy_density_of(1.0, conditions_.gravity)) +
           " for a Bond number of 1 (the Bond number grows with its third power)";
  }

  /// Of the strength.
  const ScriptCommand& place(const ContactPairOfTypes& pair) const {
    return script_.need(pair.smallest.cohesion().property, *pair.model).where();
  }
  struct MergedWarning {
    std::string place, text;
    std::vector<std::string> contacts;  // none: of the script as a whole
  };
  void add(const ScriptCommand& where, const std::string& text) {
    findings_.push_back({where.place(), text, {}});
  }
  void add(const ScriptCommand& where, const ContactPairOfTypes& pair, const std::string& text) {
    for (MergedWarning& f : findings_)
      if (f.place == where.place() && f.text == text) return f.contacts.push_back(pair.title);
    findings_.push_back({where.place(), text, {pair.title}});
  }
  static std::string digits(double value) {
    std::ostringstream text;
    text.precision(3);
    text << value;
    return text.str();
  }

  const ScriptCase& script_;
  ContactConditions conditions_;
  ExactStep exact_step_;
  std::vector<MergedWarning> findings_;
  std::set<std::string> warned_;
};

}  // namespace cohesion::tools
