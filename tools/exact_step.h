// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>

#include "advice/advised_step.h"
#include "advice/contact_advice.h"
#include "advice/elastic_pair.h"
#include "script_report.h"
#include "script_text.h"

namespace cohesion::tools {

/// Finds the contact with the shortest advised step. The mean speed of impacts is a third of the
/// fastest sphere's (advised_step.h).
class ExactStep {
 public:
  explicit ExactStep(const ContactConditions& conditions) : conditions_(conditions) {}

  void add(const std::string& title, const advice::ElasticPair& pair) {
    const double mean_speed = conditions_.fastest.speed / advice::fastest_over_impact;
    const double step = pair.advised_step(mean_speed, conditions_.gravity_of_run);
    if (step >= step_) return;
    step_ = step;
    title_ = title;
  }

  /// With the remedy; empty: the step of the script is short enough, or it has none.
  std::string finding() const {
    if (conditions_.step <= step_) return "";
    return text("time step %.4g is longer than advised for the exact scheme (", conditions_.step) +
           title_ +
           text(", spheres of up to %.3g [length/time]: %s): use a timestep of at most %.3g",
                conditions_.fastest.speed, conditions_.fastest.origin.c_str(),
                advice::named_step(step_));
  }

 private:
  ContactConditions conditions_;
  double step_ = std::numeric_limits<double>::infinity();
  std::string title_;
};

}  // namespace cohesion::tools
