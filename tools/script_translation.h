// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "exact_step.h"
#include "script_case.h"
#include "script_lines.h"
#include "script_report.h"
#include "script_text.h"
#include "strength_factors.h"
#include "translated_strength.h"

namespace cohesion::tools {

/// Writes a script with the properties and models of this package in place of sjkr and sjkr2.
class TranslatedScript {
 public:
  TranslatedScript(const std::string& file, const ScriptCase& script, const Translation& t,
                   const ContactConditions& conditions)
      : file_(file), script_(script), translation_(t), exact_step_(conditions) {}

  /// Add walls after pairs: a wall of a grain's type has the strength of the pair.
  void add(const ContactPairOfTypes& contact) {
    evaluated_.insert({std::min(contact.i, contact.j), std::max(contact.i, contact.j)});
    if (!contact.median.is_area()) return;
    warn_of_friction(*contact.model);
    models_.push_back(contact.model);
    const bool is_new = !strengths_.count({contact.i, contact.j});
    const double strength = translated_strength(contact.median, translation_);
    if (is_new) {
      strengths_[{contact.i, contact.j}] = strengths_[{contact.j, contact.i}] = strength;
      note(contact);
    }
    const double used = strengths_[{contact.i, contact.j}];
    check_step(contact, used);
    if (is_new) return;
    if (std::abs(used - strength) > 1e-3 * strength)
      warnings_.push_back(contact.model->where.place() + ": " + contact.title + " would need " +
                          translation_.property() + ' ' + text("%.4g", strength) + " and shares " +
                          text("%.4g", used) + " with types " + std::to_string(contact.i) +
                          " and " + std::to_string(contact.j) +
                          ": assign the wall an atom type of its own");
  }

  const std::vector<std::string>& warnings() const { return warnings_; }

  /// commands: all of the script.
  void write(const std::string& target, const std::vector<ScriptCommand>& commands) {
    if (models_.empty())
      throw std::runtime_error(file_ + ": has no cohesion sjkr or sjkr2 to translate");
    ScriptLines lines(file_);
    require_sizes();
    std::set<int> changed;
    for (const GranularModel* model : models_)
      if (changed.insert(model->where.line).second)
        lines.replace_model(model->where, translation_.law);
    StrengthFactors factors(script_, *models_.front(), translation_, strengths_);
    const std::string properties = factors.properties(commands), finding = exact_step_.finding();
    lines.replace(densities().where(),
                  comment() + (finding.empty() ? "" : "# WARNING: " + finding + '\n') + properties);
    warn_of_variables(factors.lost());
    if (!finding.empty()) warn_of_step(finding);
    lines.write(target);
  }

 private:
  /// Once for each line.
  void warn_of_friction(const GranularModel& model) {
    const auto is_same = [&](const GranularModel* other) {
      return other->where.place() == model.where.place();
    };
    if (!model.has_on("tangential_reduce") || std::any_of(models_.begin(), models_.end(), is_same))
      return;
    warnings_.push_back(model.where.place() + ": 'tangential_reduce on' is removed, and cohesion " +
                        translation_.law +
                        " does not reduce friction: check the friction "
                        "coefficients");
  }

  /// The smallest grains have the strength that is written for the median.
  void check_step(const ContactPairOfTypes& contact, double strength) {
    const ScriptContact& c = contact.smallest;
    if (contact.model->normal != "hertz") return;
    const bool is_jkr = translation_.law == "jkr", is_hamaker = !is_jkr && strength > 0.0;
    exact_step_.add(
        contact.title,
        c.pair_with_friction(
            is_hamaker ? c.hamaker_adhesion(translation_.hamaker(strength)) : contact::Adhesion{},
            is_jkr ? strength : 0.0));
  }

  /// Variables that the numbers of the script depended on.
  void warn_of_variables(const std::set<std::string>& names) {
    for (const std::string& name : names)
      warnings_.push_back(densities().where().place() + ": the script that is written has " +
                          translation_.property() +
                          " in numbers, for this value of the variable '" + name +
                          "': translate again with '--var " + name + " VALUE' for another");
  }

  /// Bond number or escape velocity of a contact, for the comment.
  void note(const ContactPairOfTypes& contact) {
    const double value = translation_.keeps_velocity
                             ? contact.median.escape_velocity()
                             : contact.median.bond_number(translation_.gravity);
    const std::string digits = text("%.4g", value);
    for (auto& [same, names] : kept_)
      if (same == digits) return names.push_back(contact.name);
    kept_.push_back({digits, {contact.name}});
  }
  std::string noted() const {
    std::vector<std::string> all;
    for (const auto& [value, names] : kept_)
      all.push_back(value + " (" + joined(names, ", ") + ')');
    return joined(all, ", ");
  }

  const ScriptProperty& densities() const {
    return script_.need(ScriptContact::area_property, *models_.front());
  }

  /// Throws std::runtime_error where a pair with an energy density was not evaluated.
  void require_sizes() const {
    const ScriptProperty& densities = this->densities();
    const int types = densities.where().integer(6, "the number of types");
    for (int i = 1; i <= types; i++)
      for (int j = i; j <= types; j++) {
        if (evaluated_.count({i, j}) || has_size(i, j) || densities.of_pair(i, j) == 0.0) continue;
        densities.where().fail("types " + std::to_string(i) + " and " + std::to_string(j) +
                               " have an energy density but no known size: specify a template, or "
                               "--diameter and --density");
      }
  }
  /// Both types are those of walls or of grains of known size.
  bool has_size(int i, int j) const {
    const auto is_known = [this](int type) {
      return script_.grains().count(type) || script_.wall_types().count(type);
    };
    return is_known(i) && is_known(j);
  }

  void warn_of_step(const std::string& finding) {
    warnings_.push_back(script_.run().timestep()->place() +
                        ": the script that is written: " + finding);
  }

  /// A line of its own.
  std::string comment() const {
    const std::string of = std::string(" of ") + models_.front()->cohesion + " for median grains",
                      property = translation_.property();
    const std::string values = " with the values of the original script: " + noted() + '\n';
    if (translation_.keeps_velocity)
      return "# " + property + " keeps the escape velocity" + of + ". Escape velocity" + values;
    return "# " + property + " = " +
           (translation_.law == "jkr" ? "F/(3 pi R*)" : "6 F H_cut^2/R*") +
           " keeps the pull-off force F" + of + ", F ~ R*^2 k^3/E*^2. Bond number" + values;
  }

  std::string file_;
  const ScriptCase& script_;
  Translation translation_;
  ExactStep exact_step_;
  std::vector<const GranularModel*> models_;
  std::set<std::pair<int, int>> evaluated_;  // the lower type first
  Strengths strengths_;
  std::vector<std::pair<std::string, std::vector<std::string>>> kept_;  // with their contacts
  std::vector<std::string> warnings_;
};

}  // namespace cohesion::tools
