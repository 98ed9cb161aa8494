// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "advice/change_detector.h"
#include "advice/contact_report.h"
#include "advice/run_changes.h"

namespace cohesion::advice {

/// The advice that a style has given of its contacts, so that it repeats none of it. Why a run must
/// not go on is never left out.
class WarningFilter {
 public:
  /// By how much speeds must have grown for the table to be printed again. Where the speed
  /// decides, a warning that was not given before brings the table at any speed.
  static constexpr double faster = 10.0;
  /// By how much particles must have become larger or heavier, or the step shorter.
  static constexpr double better = 2.0;

  /// Returns what is new in `report`. The table: where a number of a contact other than its speed
  /// has changed, to the better by more than `better`, or the speed by `faster`, or a warning is
  /// new. A warning: of a subject on which that contact had none, or with other numbers where one
  /// of the contact has changed.
  ///
  /// Within a run, where step and particles may change all the time and engines print tables of
  /// their own, the table comes with contacts alone that there were none of, and a warning once of
  /// each contact and subject. A message that stops the run ends with worse_since().
  Report only_new(Report report, const std::vector<AdvisedContact>& contacts,
                  const RunConditions& now) {
    if (now.within_run && !report.stop.empty()) report.stop += worse_since(judged_, now);
    judged_ = now;
    const std::set<std::string> changed = changed_since(contacts, now);
    report.warnings = fresh(report.warnings, changed);
    if (changed.empty() && (now.within_run || report.warnings.empty())) {
      report.table.clear();
      return report;
    }
    for (const AdvisedContact& c : contacts)
      if (c.moves()) printed_[c.name] = printed_contact(c, now.run);
    return report;
  }

 private:
  /// Of a contact, when the table was last printed.
  struct PrintedContact {
    double speed;
    double dt;
    std::vector<double> sizes;    ///< radii and masses
    std::vector<double> of_size;  ///< what grows with them, as they do at most
    std::vector<double> others;   ///< that the judgement depends on
  };

  /// The contacts that the table is printed for, by what the last one had of them.
  std::set<std::string> changed_since(const std::vector<AdvisedContact>& contacts,
                                      const RunConditions& now) const {
    std::set<std::string> changed;
    for (const AdvisedContact& c : contacts) {
      if (!c.moves()) continue;
      const auto known = printed_.find(c.name);
      if (known == printed_.end() ||
          (!now.within_run && differs(known->second, printed_contact(c, now.run))))
        changed.insert(c.name);
    }
    return changed;
  }

  /// Those of `warnings` that are new; they count as given.
  std::vector<Warning> fresh(const std::vector<Warning>& warnings,
                             const std::set<std::string>& changed) {
    std::vector<Warning> found;
    for (const Warning& warning : warnings) {
      const bool is_new =
          std::any_of(warning.contacts.begin(), warning.contacts.end(), [&](const auto& contact) {
            const auto before = warnings_.find({contact, warning.subject});
            return before == warnings_.end() ||
                   (changed.count(contact) && before->second != warning.text);
          });
      if (!is_new) continue;
      for (const std::string& contact : warning.contacts)
        warnings_[{contact, warning.subject}] = warning.text;
      found.push_back(warning);
    }
    return found;
  }

  static PrintedContact printed_contact(const AdvisedContact& c, const RunNumbers& run) {
    // Springs that are not linear are given at an overlap that depends on the speed: F/x^p does
    // not.
    const double scale = std::pow(c.springs.overlap, 1.0 - c.springs.exponent);
    const bool linear = c.springs.exponent == 1.0;
    return {approach_speed(run, c),
            run.dt,
            {c.i.radius, c.j.radius, c.i.mass, c.j.mass},
            {scale * c.springs.stiffness, linear ? c.springs.damping : 0.0,
             scale * c.springs.tangential_stiffness, scale * c.springs.rolling_stiffness,
             c.adhesion.force, c.adhesion.cutoff, c.adhesion.tail_energy},
            {c.springs.exponent, c.material.stiffness, static_cast<double>(c.material.keep),
             run.gravity, run.shear}};
  }

  static bool differs(const PrintedContact& before, const PrintedContact& after) {
    if (after.speed > faster * before.speed) return true;
    if (!grown(after.dt, before.dt, better)) return true;
    double growth = 1.0;
    for (std::size_t k = 0; k < after.sizes.size(); k++) {
      if (!grown(before.sizes[k], after.sizes[k], better)) return true;
      if (before.sizes[k] < after.sizes[k])
        growth = std::max(growth, after.sizes[k] / before.sizes[k]);
    }
    for (std::size_t k = 0; k < after.of_size.size(); k++)
      if (!grown(before.of_size[k], after.of_size[k], growth)) return true;
    for (std::size_t k = 0; k < after.others.size(); k++)
      if (!alike(before.others[k], after.others[k])) return true;
    return false;
  }

  /// Whether b is a, or larger by up to a factor.
  static bool grown(double a, double b, double factor) {
    return alike(a, b) || (a < b && b <= factor * a);
  }

  /// To the three digits that are printed.
  static bool alike(double a, double b) {
    return a == b || std::abs(a - b) <= 1e-3 * std::max(std::abs(a), std::abs(b));
  }

  RunConditions judged_{};
  std::map<std::string, PrintedContact> printed_;
  std::map<std::pair<std::string, Subject>, std::string> warnings_;
};

}  // namespace cohesion::advice
