// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "script_case.h"
#include "script_contact.h"
#include "script_text.h"
#include "script_variables.h"
#include "translated_strength.h"

namespace cohesion::tools {

/// Strengths of pairs of types.
using Strengths = std::map<std::pair<int, int>, double>;

/// The properties of a translated script, with the variables that its strengths depend on.
class StrengthFactors {
 public:
  /// model: the first that is translated.
  StrengthFactors(const ScriptCase& script, const GranularModel& model, const Translation& t,
                  const Strengths& strengths)
      : script_(script),
        model_(model),
        density_(script.need(ScriptContact::area_property, model).where()),
        translation_(t),
        strengths_(strengths) {}

  /// The lines in place of that of the energy density. commands: all of the script.
  std::string properties(const std::vector<ScriptCommand>& commands) {
    const int types = density_.integer(6, "the number of types");
    NumbersWithVariables numbers(translation_.property(), commands, density_);
    const std::string fix = "fix " + density_.words[1];
    std::string line = fix + " all property/global " + translation_.property() +
                       " peratomtypepair " + std::to_string(types);
    for (int i = 1; i <= types; i++)
      for (int j = 1; j <= types; j++) {
        const auto found = strengths_.find({i, j});
        const double strength = found == strengths_.end() ? 0.0 : found->second;
        line += ' ' + numbers(std::to_string(i) + '_' + std::to_string(j), strength,
                              factors(types, i, j));
      }
    lost_ = numbers.lost();
    line = numbers.lines() + line;
    if (translation_.law == "jkr") return line;
    return line + '\n' + fix + "_cut all property/global hamakerSurfaceCutoff scalar " +
           text("%.8g", translation_.cutoffs.at(0)) + '\n' + fix +
           "_out all property/global hamakerOuterCutoff scalar " +
           text("%.8g", translation_.cutoffs.at(1));
  }
  /// Variables of the script without effect on the properties.
  const std::set<std::string>& lost() const { return lost_; }

 private:
  /// What the strength of a pair depends on. With equal pull-off forces it grows with k^3, R* and
  /// 1/E*^2.
  std::vector<Factor> factors(int types, int i, int j) const {
    if (!strengths_.count({i, j})) return {};
    const std::size_t at = 6 + static_cast<std::size_t>(types * (i - 1) + j);
    // Equal velocities follow no power law.
    const int scales = translation_.keeps_velocity ? 0 : 1;
    std::vector<Factor> all = radius_factors(script_.grains(), i, j, scales);
    all.push_back(
        factor_of(density_, at, density_.number(at, "an energy density"), 3 * scales, true));
    if (const ScriptProperty* modulus = script_.find("youngsModulus")) {
      const auto moduli = modulus_factors(*modulus, i, j, -2 * scales);
      all.insert(all.end(), moduli.begin(), moduli.end());
    }
    const auto add_other = [&](const ScriptCommand& c) {
      all.push_back(other_factor(c, 4, c.words.size()));
    };
    if (const ScriptProperty* ratio = script_.find("poissonsRatio")) add_other(ratio->where());
    if (!translation_.keeps_velocity) return all;
    add_other(script_.need("coefficientRestitution", model_).where());
    for (const int type : {i, j})
      if (const auto found = script_.grains().find(type); found != script_.grains().end())
        add_other(found->second.where);
    return all;
  }

  const ScriptCase& script_;
  const GranularModel& model_;
  const ScriptCommand& density_;
  const Translation& translation_;
  const Strengths& strengths_;
  std::set<std::string> lost_;
};

}  // namespace cohesion::tools
