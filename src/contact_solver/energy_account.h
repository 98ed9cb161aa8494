// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact_solver/contact_state.h"

namespace cohesion::contact_solver {

/// The energy account R of a contact: the work of its discrete forces f_n n_n,
///
///   1/2 (f_n n_n + f_(n+1) n_(n+1)) . (r_(n+1) - r_n)    from one time level to the next,
///
/// and the energy that its motion in closed form dissipates. The kinetic energy of all particles,
/// less dt^2 F^2/(8 m) of the force F on each, changes by exactly the sum of the work over all
/// contacts. A contact that has left its range with R = 0 has therefore taken exactly its
/// dissipation from the particles, although it uses the other forces of the last step. What remains
/// of R changes the speed at which the pair flies on.
///
/// The other forces that act one step late do work at their time level, exchanged with their
/// particles there. To second order that is dt^2/8 (f_(n-2) b_(n-1) - f_(n-1) b_(n-2)), b the
/// external acceleration of the distance. Friction has no account: contacts with friction leave
/// this out, so that all accounts together change the energy by what contacts dissipate.
///
/// Source: derived here; docs/theory/exact_contacts.md, Several contacts of a particle.
class EnergyAccount {
 public:
  /// step [time].
  EnergyAccount(double reduced_mass, double step) : reduced_mass_(reduced_mass), step_(step) {}

  /// Of a contact with friction.
  void leave_out_exchange() { exchanges_ = false; }
  /// Whether exchanged() is anything but 0; otherwise it needs no state.
  bool exchanges() const { return exchanges_; }

  /// R of a pair without a stored state, whose contact has the energy `stored`.
  static double at_start(double stored) { return -stored; }

  /// Work of the force of the last time level on the way here, [energy].
  double work_of_last(double force, const StaggeredMotion& now) const {
    if (force == 0.0) return 0.0;
    const double speed_squared = now.rate * now.rate + now.sideways * now.sideways;
    const double along = now.distance * now.rate - step_ * speed_squared;
    const double distance = std::hypot(now.distance - step_ * now.rate, step_ * now.sideways);
    return 0.5 * step_ * force * along / distance;
  }
  /// Work of the force of this time level on the way here, [energy].
  double work(double force, const StaggeredMotion& now) const {
    return 0.5 * step_ * force * now.rate;
  }
  /// The same in the first step of a run, whose velocities are those of the time level; it corrects
  /// the work on the way to the next time level. `mean` [length/time]: the rate on that way.
  double work_of_first_force(double force, const StaggeredMotion& now, double mean) const {
    return -0.25 * step_ * force * (mean - now.rate);
  }
  /// Change of R because the other forces act one step late. `force`: of the contact in the last
  /// step; `external` [length/time^2]: acceleration of the distance by other forces in it.
  [[gnu::always_inline]] double exchanged(double force, double external,
                                          const ContactState& state) const {
    if (!exchanges_) return 0.0;
    return 0.125 * step_ * step_ * (force * state.external_before - state.force_before * external);
  }

  /// Sets the force so that a pair with the account `r` flies on at the speed that closes it, but
  /// at no less than half of its speed under `force`. Returns false where the account has to be
  /// closed later: the energy does not suffice, or the pair comes back and keeps its force.
  bool settle(const StaggeredMotion& now, double external, double r, double& force) const {
    const double speed = now.rate + 0.5 * step_ * external;
    if (!(speed > 0.0)) return false;
    // A speed near 0 would be the root of a small difference, which amplifies round-off: the two
    // copies of a pair across a periodic face would move apart.
    const double flies_at = speed + step_ * force / reduced_mass_;
    const double least = flies_at > 0.0 ? 0.25 * flies_at * flies_at : 0.0;
    const double left = speed * speed - 2.0 * r / reduced_mass_;
    force = reduced_mass_ * (std::sqrt(std::max(left, least)) - speed) / step_;
    return left >= least;
  }
  /// Whether R and the pending work of the last forces of a pair that has left its range are above
  /// round-off. Positions are rounded by eps distance.
  bool is_open(const StaggeredMotion& now, double r, const ContactState& state) const {
    const double rate = std::abs(now.rate);
    const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * now.distance / step_;
    const double momentum = reduced_mass_ * (negligible * rate + rounding);
    const double force = std::max(std::abs(state.force), std::abs(state.force_before));
    return std::abs(r) > momentum * rate || force * step_ > momentum;
  }

 private:
  static constexpr double negligible = 1e-9;

  double reduced_mass_;
  double step_;
  bool exchanges_ = true;
};

}  // namespace cohesion::contact_solver
