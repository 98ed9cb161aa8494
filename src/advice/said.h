// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "advice/contact_report.h"
#include "advice/watch.h"

namespace cohesion::advice {

/// What a style has said of its contacts, so that it says again only what is new. Why a run must
/// not go on is never left out.
class Said {
 public:
  /// By how much speeds must have grown for the table to be worth another look. Where the speed
  /// decides, a warning that was not said before brings the table at any speed.
  static constexpr double faster = 10.0;

  /// What is new in `report`. The table: where a number of a contact other than its speed has
  /// changed, or the speed by `faster`, or a warning is new. A warning: of a subject on which
  /// nothing was said of that contact, or with other numbers where one of the contact has changed.
  ///
  /// Within a run steps and particles may change all the time: then numbers alone bring nothing,
  /// but contacts that there were none of do.
  Report news(Report report, const std::vector<AdvisedContact>& contacts,
              const Circumstances& now) {
    const RunNumbers& run = now.run;
    bool shown = false;
    std::map<std::string, bool> other;
    for (const AdvisedContact& c : contacts) {
      if (!c.moves()) continue;
      const auto known = known_.find(c.name);
      const bool changed =
          known == known_.end() || (!now.within_run && differs(known->second, known_of(c, run)));
      other[c.name] = changed;
      shown = shown || changed;
    }
    std::vector<Warning> fresh;
    for (const Warning& warning : report.warnings) {
      bool is_new = false;
      for (const std::string& contact : warning.contacts) {
        const auto before = warnings_.find({contact, warning.subject});
        is_new = is_new || before == warnings_.end() ||
                 (other[contact] && before->second != warning.text);
      }
      if (!is_new) continue;
      for (const std::string& contact : warning.contacts)
        warnings_[{contact, warning.subject}] = warning.text;
      fresh.push_back(warning);
    }
    report.warnings = fresh;
    if (!shown && fresh.empty()) {
      report.table.clear();
      return report;
    }
    for (const AdvisedContact& c : contacts)
      if (c.moves()) known_[c.name] = known_of(c, run);
    return report;
  }

 private:
  /// Of a contact, when the table was last printed.
  struct Known {
    double speed;
    std::vector<double> numbers;  ///< all but the speed that the judgement depends on
  };

  static Known known_of(const AdvisedContact& c, const RunNumbers& run) {
    // Springs that are not linear are told at an overlap that depends on the speed: F/x^p does not.
    const double scale = std::pow(c.springs.overlap, 1.0 - c.springs.exponent);
    const bool linear = c.springs.exponent == 1.0;
    return {approach_speed(run, c),
            {c.i.radius, c.j.radius, c.i.mass, c.j.mass, c.springs.exponent,
             scale * c.springs.stiffness, linear ? c.springs.damping : 0.0,
             scale * c.springs.tangential_stiffness, scale * c.springs.rolling_stiffness,
             c.adhesion.force, c.adhesion.cutoff, c.adhesion.tail_energy, c.material.stiffness,
             static_cast<double>(c.material.keep), run.dt, run.gravity, run.shear}};
  }

  static bool differs(const Known& before, const Known& after) {
    if (after.speed > faster * before.speed) return true;
    for (std::size_t k = 0; k < after.numbers.size(); k++)
      if (!alike(before.numbers[k], after.numbers[k])) return true;
    return false;
  }

  /// To the three digits that are printed.
  static bool alike(double a, double b) {
    return a == b || std::abs(a - b) <= 1e-3 * std::max(std::abs(a), std::abs(b));
  }

  std::map<std::string, Known> known_;
  std::map<std::pair<std::string, Subject>, std::string> warnings_;
};

}  // namespace cohesion::advice
