// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "script_contact.h"

namespace cohesion::tools {

/// The conditions under which contacts are evaluated, in the units of the script.
struct ContactConditions {
  double speed, gravity;
  double step;              ///< 0: the script has none
  bool is_speed_assumed;    ///< neither script nor command line has one
  bool is_gravity_assumed;  ///< the script has none
};

/// Grains of two types, or of a type at a wall: the smallest of both, and the median of both.
struct ContactPairOfTypes {
  std::string title, name;  ///< name: in --csv
  const GranularModel* model;
  int i, j;
  ScriptContact smallest, median;
};

/// Prints contacts as tables, or as comma-separated values with all digits.
class ScriptReport {
 public:
  ScriptReport(const ContactConditions& conditions, bool csv) : conditions_(conditions), csv_(csv) {
    if (csv_)
      std::puts("contact,name,smallest,median,unit");
    else
      std::printf("Impacts at %.4g [length/time]%s; gravity %.4g [length/time^2]%s\n",
                  conditions.speed, conditions.is_speed_assumed ? " (assumed)" : "",
                  conditions.gravity, conditions.is_gravity_assumed ? " (assumed)" : "");
  }

  void operator()(const ContactPairOfTypes& pair) {
    name_ = pair.name;
    if (!csv_)
      std::printf("\n%s, model %s, cohesion %s\n  %-34s %-11s %-11s\n", pair.title.c_str(),
                  pair.model->normal.c_str(), pair.model->cohesion.c_str(), "grains", "smallest",
                  "median");
    const CohesionOfScript& cohesion = pair.smallest.cohesion();
    const auto line = [&](const char* name, const char* text, const char* unit, const auto& of) {
      print(name, text, of(pair.smallest), of(pair.median), unit);
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
  }

 private:
  void print(const char* name, const char* text, double smallest, double median,
             const char* unit) const {
    if (csv_)
      std::printf("%s,%s,%.17g,%.17g,%s\n", name_.c_str(), name, smallest, median, unit);
    else
      std::printf("  %-34s %-11.4g %-11.4g %s\n", text, smallest, median, unit);
  }

  ContactConditions conditions_;
  bool csv_;
  std::string name_;
};

}  // namespace cohesion::tools
