// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "advice/contact_report.h"

namespace cohesion::advice {

/// What the contacts of a run are judged by.
struct RunConditions {
  std::vector<LightestParticle> lightest;  ///< by type, counted from 1
  RunNumbers run;
  bool within_run;  ///< after its set-up
};

/// By which particles, step and speed contacts were last judged: within a run they are judged again
/// where these have become worse. What is better is left to the next set-up of a run.
class ChangeDetector {
 public:
  /// By how much the fastest particle must have become faster.
  static constexpr double faster = 2.0;
  /// By how much, relative to what was judged, particles must have become smaller or lighter or the
  /// step longer: what changes in every step by little is judged once in a while, and in time.
  static constexpr double change = 1e-3;

  /// Before a run, in which fixes change particles every so many steps.
  void set_up(const std::vector<int>& changed_every) { changed_every_ = changed_every; }

  /// Whether particles or step of this one may be others than before, with a list of neighbours
  /// that is new or not. Known without looking at particles, so alike on all ranks.
  bool may_differ(bool new_list, long step, double dt) const {
    // A fix that changes particles may act before or after the one that asks.
    return new_list || longer(dt) ||
           std::any_of(changed_every_.begin(), changed_every_.end(),
                       [step](int every) { return step % every <= 1; });
  }

  /// Whether contacts have to be judged again; `lightest` by type.
  bool worse(const std::vector<LightestParticle>& lightest, const RunNumbers& run) const {
    if (longer(run.dt) || run.fastest > faster * fastest_ || run.crowd > crowd_ ||
        lightest.size() != lightest_.size())
      return true;
    for (std::size_t type = 0; type < lightest.size(); type++)
      if (less(lightest[type].radius, lightest_[type].radius) ||
          less(lightest[type].mass, lightest_[type].mass))
        return true;
    return false;
  }

  void judged(const std::vector<LightestParticle>& lightest, const RunNumbers& run) {
    lightest_ = lightest;
    fastest_ = run.fastest;
    dt_ = run.dt;
    crowd_ = run.crowd;
  }

  /// Judges again, whatever is there.
  void forget() { dt_ = 0.0; }

 private:
  bool longer(double dt) const { return dt > (1.0 + change) * dt_; }
  static bool less(double value, double judged) { return value < (1.0 - change) * judged; }

  std::vector<int> changed_every_;
  std::vector<LightestParticle> lightest_;
  double fastest_ = 0.0;  // [length/time]
  double dt_ = 0.0;       // [time]; 0: nothing was judged
  Crowd crowd_ = Crowd::pair;
};

}  // namespace cohesion::advice
