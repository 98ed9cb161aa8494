// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "script_case.h"
#include "script_text.h"

namespace cohesion::tools {

/// Of the forms ${name}, $n and v_name in a text.
inline std::set<std::string> variables_in(const std::string& text) {
  static const std::regex variable(R"(\$\{(\w+)\}|\$(\w)|\bv_(\w+))");
  std::set<std::string> names;
  for (std::sregex_iterator at(text.begin(), text.end(), variable), end; at != end; ++at)
    names.insert((*at)[1].str() + (*at)[2].str() + (*at)[3].str());
  return names;
}

/// What a number depends on.
struct Factor {
  std::string word;  ///< of the script, with its variables; empty: it has none
  double value;
  int power;         ///< with which the number grows with the value; 0: by another law
  bool is_in_place;  ///< the variables have the same values where the number is written
};

/// Word k of a command. The number is proportional to its `power`-th power.
inline Factor factor_of(const ScriptCommand& c, std::size_t k, double value, int power,
                        bool is_in_place) {
  return {c.word_with_variables(k), value, c.is_whole(k) ? power : 0, is_in_place};
}

/// Words [first, last) of a command, on which a number depends by another law.
inline Factor other_factor(const ScriptCommand& c, std::size_t first, std::size_t last) {
  std::string words;
  for (std::size_t k = first; k < last; k++) words += c.word_with_variables(k);
  return {words, 0.0, 0, false};
}

/// The radius of a type: of its only size, or of several.
inline Factor radius_factor(const Grains& grains, int power) {
  const ScriptCommand& c = grains.where;
  const bool is_set = c.words[0] == "set";
  const std::size_t at = c.find(is_set ? "diameter" : "radius") + 1;
  const bool is_one = is_set || (c.has(at) && c.words[at] == "constant");
  if (!is_one) return other_factor(c, at, at + 4);
  const double size = is_set ? 2.0 * grains.median.radius : grains.median.radius;
  const bool is_only = grains.smallest.radius == grains.median.radius;
  return factor_of(c, is_set ? at : at + 1, size, is_only ? power : 0, false);
}

/// A quantity of two types, in proportion to that of each if both have the same word.
inline std::vector<Factor> common_factors(std::vector<Factor> of_types) {
  const bool is_common = of_types.empty() || of_types.front().word == of_types.back().word;
  if (is_common) of_types.resize(std::min<std::size_t>(of_types.size(), 1));
  if (!is_common)
    for (Factor& factor : of_types) factor.power = 0;
  return of_types;
}

/// The reduced radius of two types, or of a type and a wall.
inline std::vector<Factor> radius_factors(const std::map<int, Grains>& grains, int i, int j,
                                          int power) {
  std::vector<Factor> all;
  for (const int type : {i, j})
    if (const auto found = grains.find(type); found != grains.end())
      all.push_back(radius_factor(found->second, power));
  return common_factors(all);
}

/// The effective modulus of two types.
inline std::vector<Factor> modulus_factors(const ScriptProperty& modulus, int i, int j, int power) {
  std::vector<Factor> all;
  for (const int type : {i, j})
    all.push_back(factor_of(modulus.where(), static_cast<std::size_t>(type) + 5,
                            modulus.of_type(type), power, false));
  return common_factors(all);
}

/// Numbers of a command that is written, as equal-style variables where they depend on variables of
/// the script.
class NumbersWithVariables {
 public:
  /// commands: all of the script, in order, with the command that the written one replaces.
  NumbersWithVariables(std::string name, const std::vector<ScriptCommand>& commands,
                       const ScriptCommand& replaced)
      : name_(std::move(name)) {
    bool is_before = true;
    for (const ScriptCommand& c : commands) {
      is_before = is_before && c.place() != replaced.place();
      define(c, is_before);
    }
  }

  /// The number, or the variable with it.
  std::string operator()(const std::string& pair, double number,
                         const std::vector<Factor>& factors) {
    std::string formula = text("%.8g", number);
    for (const Factor& f : factors) {
      if (f.word.empty()) continue;
      if (f.power == 0 || f.value == 0.0 || !(f.is_in_place || are_known(f.word))) {
        for (const std::string& name : variables_in(f.word)) lost_.insert(name);
        continue;
      }
      formula += "*(" + f.word + text("/%.8g)", f.value);
      if (f.power != 1) formula += '^' + std::to_string(f.power);
    }
    if (formula.find('$') == std::string::npos) return formula;
    const auto [at, is_new] = names_.try_emplace(formula, unused(name_ + '_' + pair));
    if (is_new) lines_ += "variable " + at->second + " equal " + formula + '\n';
    return "${" + at->second + '}';
  }

  /// The commands that define the variables, each with its end of line.
  const std::string& lines() const { return lines_; }
  /// Variables without effect.
  const std::set<std::string>& lost() const { return lost_; }

 private:
  struct Definition {
    std::string text;
    bool is_before;
    int count;
  };

  void define(const ScriptCommand& c, bool is_before) {
    if (c.words[0] != "variable" || !c.has(1) || c.written.size() < 4) return;
    const std::vector<std::string> values(c.written.begin() + 3, c.written.end());
    const auto at =
        definitions_.try_emplace(c.words[1], Definition{joined(values, " "), is_before, 0});
    at.first->second.count++;
  }
  /// The name, with underscores until the script defines no such variable.
  std::string unused(std::string name) const {
    while (definitions_.count(name)) name += '_';
    return name;
  }
  /// Each is defined once, before the command, and so are those that it depends on.
  bool are_known(const std::string& word, int depth = 0) const {
    for (const std::string& name : variables_in(word)) {
      const auto found = definitions_.find(name);
      if (found == definitions_.end() || found->second.count != 1 || !found->second.is_before)
        return false;
      if (depth > 20 || !are_known(found->second.text, depth + 1)) return false;
    }
    return true;
  }

  std::string name_, lines_;
  std::map<std::string, Definition> definitions_;
  std::map<std::string, std::string> names_;  // of formulas
  std::set<std::string> lost_;
};

}  // namespace cohesion::tools
