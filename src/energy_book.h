// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <numeric>

#include "vector3.h"

/// What energy there is, where it is stored and what took it: the entries of compute gran/energy.
namespace cohesion::energy_book {

/// Entries of the vector, in its order, all [energy].
enum Entry {
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
inline constexpr Entry stored[] = {KINETIC,  ROTATIONAL, SPRING,        TANGENTIAL_SPRING,
                                   ADHESION, GRAVITY,    ROLLING_SPRING};
inline constexpr Entry lost[] = {NORMAL_DAMPING, TANGENTIAL_DAMPING, FRICTION, ROLLING};

template <std::size_t N>
double sum(const double* entries, const Entry (&which)[N]) {
  return std::accumulate(which, which + N, 0.0,
                         [entries](double all, Entry entry) { return all + entries[entry]; });
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

/// The book of one script: what is missing in it since it was opened.
class Opened {
 public:
  bool is_open() const { return opened_; }
  /// Adds to entries[EXTERNAL_WORK] what was put in between runs, and sets entries[RESIDUAL]; the
  /// first time is the opening.
  void close(double* entries) {
    entries[EXTERNAL_WORK] += put_in_;
    const double now = balance(entries);
    if (!opened_) at_opening_ = now;
    opened_ = true;
    entries[RESIDUAL] = now - at_opening_;
  }
  /// The same at the end of a run.
  void close_run(double* entries) {
    close(entries);
    at_end_ = balance(entries);
  }
  /// The same where something other than motion has changed what there is since the last run: that
  /// is work which was put in. Returns it, [energy].
  double close_after_change(double* entries) {
    const double came = balance(entries) - put_in_ - at_end_;
    put_in_ += came;
    close(entries);
    return came;
  }

 private:
  bool opened_ = false;
  double at_opening_ = 0.0;
  double at_end_ = 0.0;  // of the last run
  double put_in_ = 0.0;  // between runs, [energy]
};

}  // namespace cohesion::energy_book
