// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "advice/integrated_escape.h"
#include "contact/jkr_spring_dashpot.h"
#include "exact_step.h"
#include "powder/grain_contact.h"
#include "script_report.h"
#include "script_variables.h"

namespace cohesion::tools {

/// What a translated script keeps of sjkr and sjkr2, for the median grains.
struct Translation {
  bool keeps_velocity = false;  ///< the escape velocity; else the pull-off force
  std::string law = "hamaker";  ///< or jkr
  std::vector<double> cutoffs;  ///< H_cut and H_out, in the units of the script
  double gravity = 0.0;

  hamaker::HamakerParameters hamaker(double constant) const {
    return {constant, cutoffs.at(0), cutoffs.at(1)};
  }
};

/// The strength of the law of `t` that gives the same pull-off force or escape velocity: Hamaker
/// constant, or surface energy. Throws std::runtime_error where sjkr is not in Hertz's contact.
inline double translated_strength(const ScriptContact& c, const Translation& t) {
  if (!c.is_hertz() || (t.law == "jkr" && c.model().normal != "hertz"))
    c.model().where.fail("'model " + c.model().normal + "' with cohesion " + c.model().cohesion +
                         (c.is_hertz() ? " has no moduli for JKR: write 'model hertz', or use "
                                         "'--law hamaker'"
                                       : " has no pull-off force to keep: write 'model hertz'"));
  if (c.strength() == 0.0) return 0.0;
  const double radius = c.pair().reduced_radius(), force = c.pull_off_force();
  const bool is_jkr = t.law == "jkr";
  const double of_force = is_jkr ? force / contact::JkrSpringDashpot::pull_off_force(
                                               radius, contact::work_of_adhesion(1.0))
                                 : powder::hamaker_of_pull_off(force, radius, t.cutoffs.at(0));
  if (!t.keeps_velocity) return of_force;
  const double speed = c.escape_velocity();
  if (!(speed > 0.0) || !std::isfinite(speed))
    c.model().where.fail(
        "no finite escape velocity to keep: use a restitution above 0 and below 1");
  const auto escape = [&](double strength) {
    return is_jkr ? c.jkr_pair(strength).escape_velocity()
                  : advice::escape_velocity(c.hertz(), c.hamaker_adhesion(t.hamaker(strength)));
  };
  double low = of_force, high = of_force;
  while (escape(low) > speed) low *= 0.5;
  while (escape(high) < speed) high *= 2.0;
  while (high > low * (1.0 + 1e-6)) {
    const double middle = std::sqrt(low * high);
    (escape(middle) < speed ? low : high) = middle;
  }
  return high;
}

/// Writes a script with the properties and models of this package in place of sjkr and sjkr2.
class TranslatedScript {
 public:
  TranslatedScript(const std::string& file, const ScriptCase& script, const Translation& t,
                   const ContactConditions& conditions)
      : file_(file), script_(script), translation_(t), exact_step_(conditions) {}

  /// Walls behind pairs: a wall of a grain's type has the strength of the pair.
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
                          property() + ' ' + text("%.4g", strength) + " and shares " +
                          text("%.4g", used) + " with types " + std::to_string(contact.i) +
                          " and " + std::to_string(contact.j) +
                          ": assign the wall an atom type of its own");
  }

  const std::vector<std::string>& warnings() const { return warnings_; }

  void write(const std::string& target) {
    if (models_.empty())
      throw std::runtime_error(file_ + ": has no cohesion sjkr or sjkr2 to translate");
    Lines lines = lines_of(file_);
    const ScriptCommand& density =
        script_.need(ScriptContact::area_property, *models_.front()).where();
    require_sizes();
    std::set<int> changed;
    for (const GranularModel* model : models_)
      if (changed.insert(model->where.line).second)
        replace(lines, model->where, with_law(model->where, text_of(lines, model->where)));
    replace(lines, density, properties(lines, density));
    std::ofstream stream(target);
    for (const std::optional<std::string>& line : lines)
      if (line) stream << *line << '\n';
    if (!stream.flush())
      throw std::runtime_error("'" + target + "' cannot be written: check its folder");
  }

 private:
  using Lines = std::vector<std::optional<std::string>>;  // empty: removed

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
    const ScriptCommand& density =
        script_.need(ScriptContact::area_property, *models_.front()).where();
    for (const std::string& name : names)
      warnings_.push_back(density.place() + ": the script that is written has " + property() +
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

  const char* property() const {
    return translation_.law == "jkr" ? "surfaceEnergy" : "hamakerConstant";
  }

  /// Throws std::runtime_error where a pair with an energy density was not evaluated.
  void require_sizes() const {
    const ScriptProperty& densities = script_.need(ScriptContact::area_property, *models_.front());
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

  static Lines lines_of(const std::string& file) {
    Lines lines;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) lines.emplace_back(line);
    return lines;
  }

  /// The lines of a command, as they are written.
  std::string text_of(const Lines& lines, const ScriptCommand& c) const {
    if (c.file != file_)
      c.fail("this line is in an included file, which is not translated: move it into '" + file_ +
             "'");
    std::string all;
    for (int k = c.line; k <= c.last_line; k++)
      all += (k > c.line ? "\n" : "") + lines[static_cast<std::size_t>(k) - 1].value_or("");
    return all;
  }
  void replace(Lines& lines, const ScriptCommand& c, const std::string& text) const {
    text_of(lines, c);
    for (int k = c.line; k <= c.last_line; k++) lines[static_cast<std::size_t>(k) - 1].reset();
    lines[static_cast<std::size_t>(c.line) - 1] = text;
  }

  /// Word k names the cohesion model, or the switch that this package lacks.
  static bool is_replaced(const ScriptCommand& c, std::size_t k) {
    const std::string &word = c.words[k], &before = k > 0 ? c.words[k - 1] : word;
    return word == "cohesion" || before == "cohesion" || word == "tangential_reduce" ||
           before == "tangential_reduce";
  }
  /// The lines of a command, with values in place of the variables that hold such words.
  static std::string expanded(const ScriptCommand& c, std::string line) {
    std::size_t at = 0, k = 0;
    for (std::size_t origin = 0; origin < c.written.size(); origin++) {
      std::vector<std::string> values;
      bool is_changed = false;
      for (; k < c.words.size() && c.origins[k] == origin; k++) {
        values.push_back(c.words[k]);
        is_changed = is_changed || is_replaced(c, k);
      }
      const std::string& written = c.written[origin];
      const std::string value = is_changed ? joined(values, " ") : written;
      const std::size_t found = line.find(written, at);
      if (found == std::string::npos) continue;  // a word in quotes, on several lines
      line.replace(found, written.size(), value);
      at = found + value.size();
    }
    return line;
  }

  std::string with_law(const ScriptCommand& c, std::string line) const {
    static const std::regex model(R"((cohesion(?:\s|&)+)sjkr2?(?!\S))"),
        reduce(R"(\s+tangential_reduce\s+(?:on|off)(?!\S))");
    line = expanded(c, line);
    if (!std::regex_search(line, model))
      c.fail("its cohesion model is in quotes: remove the quotes for a translation");
    return std::regex_replace(std::regex_replace(line, model, "$1" + translation_.law), reduce, "");
  }

  std::string properties(const Lines& lines, const ScriptCommand& density) {
    const int types = density.integer(6, "the number of types");
    NumbersWithVariables numbers = numbers_of(lines, density);
    std::string line = "fix " + density.words[1] + " all property/global " + property() +
                       " peratomtypepair " + std::to_string(types);
    for (int i = 1; i <= types; i++)
      for (int j = 1; j <= types; j++) {
        const auto found = strengths_.find({i, j});
        const double strength = found == strengths_.end() ? 0.0 : found->second;
        line += ' ' + numbers(std::to_string(i) + '_' + std::to_string(j), strength,
                              factors(density, types, i, j));
      }
    warn_of_variables(numbers.lost());
    line = comment() + '\n' + comment_of_step() + numbers.lines() + line;
    if (translation_.law == "jkr") return line;
    const std::string fix = "\nfix " + density.words[1];
    return line + fix + "_cut all property/global hamakerSurfaceCutoff scalar " +
           text("%.8g", translation_.cutoffs.at(0)) + fix +
           "_out all property/global hamakerOuterCutoff scalar " +
           text("%.8g", translation_.cutoffs.at(1));
  }

  std::string comment() const {
    const std::string of = std::string(" of the median grains with ") + models_.front()->cohesion;
    if (translation_.keeps_velocity) return "# Escape velocity" + of + ": " + noted();
    return "# Pull-off force F ~ R*^2 k^3/E*^2" + of + ": " + property() +
           (translation_.law == "jkr" ? " = F/(3 pi R*)" : " = 6 F H_cut^2/R*") +
           ", in proportion to the Bond number " + noted();
  }

  /// A line of its own; empty: none.
  std::string comment_of_step() {
    const std::string finding = exact_step_.finding();
    if (finding.empty()) return "";
    warnings_.push_back(script_.run().timestep()->place() +
                        ": the script that is written: " + finding);
    return "# WARNING: " + finding + '\n';
  }

  NumbersWithVariables numbers_of(const Lines& lines, const ScriptCommand& density) const {
    std::vector<std::string> before, behind;
    for (std::size_t k = 0; k < lines.size(); k++)
      (static_cast<int>(k) + 1 < density.line ? before : behind).push_back(lines[k].value_or(""));
    return {property(), before, behind};
  }

  /// What the strength of a pair depends on. With equal pull-off forces it grows with k^3, R* and
  /// 1/E*^2.
  std::vector<Factor> factors(const ScriptCommand& density, int types, int i, int j) const {
    if (!strengths_.count({i, j})) return {};
    const std::size_t at = 6 + static_cast<std::size_t>(types * (i - 1) + j);
    const int is_power = translation_.keeps_velocity ? 0 : 1;
    std::vector<Factor> all = radius_factors(script_.grains(), i, j, is_power);
    all.push_back(
        factor_of(density, at, density.number(at, "an energy density"), 3 * is_power, true));
    if (const ScriptProperty* modulus = script_.find("youngsModulus")) {
      const auto moduli = modulus_factors(*modulus, i, j, -2 * is_power);
      all.insert(all.end(), moduli.begin(), moduli.end());
    }
    const auto add_other = [&](const ScriptCommand& c) {
      all.push_back(other_factor(c, 4, c.words.size()));
    };
    if (const ScriptProperty* ratio = script_.find("poissonsRatio")) add_other(ratio->where());
    if (!translation_.keeps_velocity) return all;
    add_other(script_.need("coefficientRestitution", *models_.front()).where());
    for (const int type : {i, j})
      if (const auto found = script_.grains().find(type); found != script_.grains().end())
        add_other(found->second.where);
    return all;
  }

  std::string file_;
  const ScriptCase& script_;
  Translation translation_;
  ExactStep exact_step_;
  std::vector<const GranularModel*> models_;
  std::set<std::pair<int, int>> evaluated_;  // the lower type first
  std::map<std::pair<int, int>, double> strengths_;
  std::vector<std::pair<std::string, std::vector<std::string>>> kept_;  // with their contacts
  std::vector<std::string> warnings_;
};

}  // namespace cohesion::tools
