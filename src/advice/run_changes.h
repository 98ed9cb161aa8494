// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <sstream>
#include <string>

#include "advice/change_detector.h"

namespace cohesion::advice {

/// Changes since the last check that tighten the time-step limit, as the end of a sentence; empty
/// without any.
inline std::string worse_since(const RunConditions& before, const RunConditions& now) {
  std::ostringstream changes;
  changes.precision(3);
  const auto grown = [&](const char* name, double then, double after) {
    if (after > (1.0 + ChangeDetector::change) * then)
      changes << ", " << name << " rose from " << then << " to " << after;
  };
  grown("the speed of the fastest particle", before.run.fastest, now.run.fastest);
  grown("the time step", before.run.dt, now.run.dt);
  if (now.run.crowd == Crowd::several && before.run.crowd != Crowd::several)
    changes << ", a particle now has two neighbours or more";
  const std::size_t types = std::min(before.lightest.size(), now.lightest.size());
  for (std::size_t type = 1; type < types; type++) {
    const LightestParticle &then = before.lightest[type], &after = now.lightest[type];
    if (after.radius < (1.0 - ChangeDetector::change) * then.radius)
      changes << ", the smallest radius of type " << type << " is " << after.radius;
    if (after.mass < (1.0 - ChangeDetector::change) * then.mass)
      changes << ", the smallest mass of type " << type << " is " << after.mass;
  }
  const std::string found = changes.str();
  return found.empty() ? found : "; since the last check" + found.substr(1);
}

}  // namespace cohesion::advice
