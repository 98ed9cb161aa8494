// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "script_contact.h"
#include "script_text.h"

namespace cohesion::tools {

/// Of a run, by what the script or the command line has.
struct FastestSphere {
  double speed;  ///< [length/time]
  std::string origin;
};

/// The conditions under which contacts are evaluated, in the units of the script.
struct ContactConditions {
  double speed, gravity;
  double step;              ///< 0: the script has none
  bool is_speed_assumed;    ///< neither script nor command line has one
  bool is_gravity_assumed;  ///< the script has none
  double gravity_of_run;    ///< 0: the script has none
  FastestSphere fastest;
};

/// Grains of two types, or of a type at a wall: the smallest of both, and the median of both.
struct ContactPairOfTypes {
  std::string title, name;  ///< name: in --csv
  const GranularModel* model;
  int i, j;
  ScriptContact smallest, median;
};

/// Prints contacts as tables, one for all contacts with equal values, or as comma-separated values
/// with all digits.
class ScriptReport {
 public:
  ScriptReport(const ContactConditions& conditions, bool csv)
      : conditions_(conditions), csv_(csv) {}

  void add(const ContactPairOfTypes& pair) {
    const std::string values = values_of(pair);
    const auto same = std::find_if(tables_.begin(), tables_.end(),
                                   [&](const Table& table) { return table.values == values; });
    Table& table = same == tables_.end() ? tables_.emplace_back(Table{{}, values}) : *same;
    if (std::find(table.titles.begin(), table.titles.end(), pair.title) == table.titles.end())
      table.titles.push_back(pair.title);
  }

  void print() const {
    if (csv_)
      std::puts("contact,name,smallest,median,unit");
    else
      std::printf("Impacts at %.4g [length/time]%s; gravity %.4g [length/time^2]%s\n",
                  conditions_.speed, conditions_.is_speed_assumed ? " (assumed)" : "",
                  conditions_.gravity, conditions_.is_gravity_assumed ? " (assumed)" : "");
    for (const Table& table : tables_) {
      if (!csv_) std::printf("\n%s, ", joined(table.titles, ";\n").c_str());
      std::printf("%s", table.values.c_str());
    }
    std::fflush(stdout);
  }

 private:
  struct Table {
    std::vector<std::string> titles;
    std::string values;
  };

  static std::string heading_of(const GranularModel& model) {
    return "model " + model.normal + ", cohesion " + model.cohesion + '\n' +
           text("  %-34s %-11s %-11s\n", "grains", "smallest", "median");
  }

  std::string values_of(const ContactPairOfTypes& pair) const {
    std::string rows = csv_ ? "" : heading_of(*pair.model);
    const CohesionOfScript& cohesion = pair.smallest.cohesion();
    const auto line = [&](const char* name, const char* label, const char* unit, const auto& of) {
      const double smallest = of(pair.smallest), median = of(pair.median);
      rows += csv_ ? text("%s,%s,%.17g,%.17g,%s\n", pair.name.c_str(), name, smallest, median, unit)
                   : text("  %-34s %-11.4g %-11.4g %s\n", label, smallest, median, unit);
    };
    if (cohesion.property)
      line("strength", cohesion.property, cohesion.unit,
           [](const ScriptContact& c) { return c.strength(); });
    line("pull_off", "largest pull-off force", "[force]",
         [](const ScriptContact& c) { return c.pull_off_force(); });
    line("bond_number", "Bond number, pull-off over weight", "[1]",
         [&](const ScriptContact& c) { return c.bond_number(conditions_.gravity); });
    line("escape_velocity", "escape velocity", "[length/time]",
         [](const ScriptContact& c) { return c.escape_velocity(); });
    line("overlap", "overlap over diameter, impact", "[1]",
         [&](const ScriptContact& c) { return c.overlap(conditions_.speed); });
    line("contact_time", "contact time, impact", "[time]",
         [&](const ScriptContact& c) { return c.contact_time(conditions_.speed); });
    if (conditions_.step > 0.0)
      line("steps_per_contact", "time steps per contact", "[1]", [&](const ScriptContact& c) {
        return c.contact_time(conditions_.speed) / conditions_.step;
      });
    return rows;
  }

  ContactConditions conditions_;
  bool csv_;
  std::vector<Table> tables_;
};

}  // namespace cohesion::tools
