// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <numeric>

#include "vector3.h"

/// What energy there is, where it is stored and what took it: the entries of compute gran/energy.
namespace cohesion::energy_tally {

/// Entries of the vector, in its order, all [energy].
enum EnergyEntry {
  KINETIC,
  ROTATIONAL,
  SPRING,
  TANGENTIAL_SPRING,
  ADHESION,
  NORMAL_DAMPING,
  TANGENTIAL_DAMPING,
  FRICTION,
  EXTERNAL_WORK,
  RESIDUAL,
  GRAVITY,
  ROLLING_SPRING,
  ROLLING,
  ENTRIES
};

namespace detail {

/// What stays or is stored, and what is lost.
inline constexpr EnergyEntry stored[] = {KINETIC,  ROTATIONAL, SPRING,        TANGENTIAL_SPRING,
                                         ADHESION, GRAVITY,    ROLLING_SPRING};
inline constexpr EnergyEntry lost[] = {NORMAL_DAMPING, TANGENTIAL_DAMPING, FRICTION, ROLLING};

template <std::size_t N>
double sum(const double* entries, const EnergyEntry (&which)[N]) {
  return std::accumulate(which, which + N, 0.0,
                         [entries](double all, EnergyEntry entry) { return all + entries[entry]; });
}

}  // namespace detail

/// Adds what a body has by its motion, `v` [length/time] and `omega` [1/time], and by its weight
/// [force] at `place` [length]; inertia [mass length^2].
inline void add_body(double* entries, double mass, double inertia, const Vector3& v,
                     const Vector3& omega, const Vector3& weight, const Vector3& place) {
  entries[KINETIC] += 0.5 * mass * dot(v, v);
  entries[ROTATIONAL] += 0.5 * inertia * dot(omega, omega);
  entries[GRAVITY] -= dot(weight, place);
}

/// Kinetic and stored energy, [energy].
inline double stored(const double* entries) { return detail::sum(entries, detail::stored); }

/// What stays the same: all that is stored and lost, less what was put in, [energy].
inline double balance(const double* entries) {
  return stored(entries) + detail::sum(entries, detail::lost) - entries[EXTERNAL_WORK];
}

/// What is missing in the tally of one script since it has begun.
class Residual {
 public:
  bool has_begun() const { return begun_; }
  /// Adds to entries[EXTERNAL_WORK] what was put in between runs, and sets entries[RESIDUAL]; the
  /// tally begins with the first time.
  void update(double* entries) {
    entries[EXTERNAL_WORK] += put_in_;
    const double now = balance(entries);
    if (!begun_) at_begin_ = now;
    begun_ = true;
    entries[RESIDUAL] = now - at_begin_;
  }
  /// The same at the end of a run.
  void end_run(double* entries) {
    update(entries);
    at_end_ = balance(entries);
  }
  /// The same where something other than motion has changed what there is since the last run: that
  /// is work which was put in. Returns it, [energy].
  double update_after_change(double* entries) {
    const double came = balance(entries) - put_in_ - at_end_;
    put_in_ += came;
    update(entries);
    return came;
  }

 private:
  bool begun_ = false;
  double at_begin_ = 0.0;
  double at_end_ = 0.0;  // of the last run
  double put_in_ = 0.0;  // between runs, [energy]
};

}  // namespace cohesion::energy_tally
