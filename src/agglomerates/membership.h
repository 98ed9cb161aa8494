// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::agglomerates {

/// How long one particle has been part of agglomerates: from its first partner to the loss of its
/// last, whatever partners came and went in between. Source: M. Weber, thesis, chapter 4.
struct Membership {
  static constexpr double alone = -1.0;
  /// It had partners when it was first examined: when it found them is not known.
  static constexpr double unknown = -2.0;

  /// When it found its first partner, [time] not below zero, or one of the above.
  double since = alone;

  /// The state of a particle that is examined for the first time.
  static Membership at_first(bool has_partner) { return {has_partner ? unknown : alone}; }

  /// Examines the particle again, at the time `now`. Returns for how long it had partners, [time],
  /// if it has lost the last one since and the beginning is known; a negative number otherwise.
  double update(bool has_partner, double now) {
    if (has_partner) {
      if (since == alone) since = now;
      return -1.0;
    }
    const double duration = since >= 0.0 ? now - since : -1.0;
    since = alone;
    return duration;
  }
};

}  // namespace cohesion::agglomerates
