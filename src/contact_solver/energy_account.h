// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact_solver/contact_state.h"
#include "contact_solver/damped_oscillator.h"

namespace cohesion::contact_solver {

/// The energy account R of a contact: the work of its discrete forces f_n n_n,
///
///   1/2 (f_n n_n + f_(n+1) n_(n+1)) . (r_(n+1) - r_n)    from one time level to the next,
///
/// and the energy that its motion in closed form dissipates. The kinetic energy of all particles,
/// less dt^2 F^2/(8 m) of the force F on each, changes by exactly the sum of the work over all
/// contacts. A contact that has left its range with R = 0 has therefore taken from the particles
/// what it dissipated, although it knows the other forces on them only as they were one step
/// before. What is left of R goes into the speed at which the pair flies on.
///
/// While the contact is persistent, R has besides the energy that the discrete spring stores; its
/// dissipation is a quadratic form of two staggered rates. In a resolved step the dashpot
/// dissipates eta u^2 for the time of contact with the mean rate u of the step, which the particles
/// have one step later: R changes by the difference then.
///
/// The other forces that act one step late do work at their time level, exchanged with their
/// particles there. To second order that is dt^2/8 (f_(n-2) b_(n-1) - f_(n-1) b_(n-2)), b the
/// external acceleration of the distance. Friction has no account: contacts with friction leave
/// this out, so that all accounts together change the energy by what contacts dissipate.
///
/// Source: derived here; docs/theory/exact_contacts.md, Several contacts of a particle.
class EnergyAccount {
 public:
  /// contact_distance [length]; spring, attraction [force]: the discrete force of a persistent
  /// contact; motion: its closed form; step [time].
  EnergyAccount(double contact_distance, double reduced_mass, const GridSpring& spring,
                double attraction, const DampedOscillator& motion, double step)
      : contact_distance_(contact_distance),
        reduced_mass_(reduced_mass),
        spring_(spring),
        attraction_(attraction),
        damping_(2.0 * motion.alpha() * reduced_mass),
        step_(step),
        exchange_(0.125 * step * step) {
    if (damping_ > 0.0) set_dissipation(motion);
  }

  /// Of a contact with friction.
  void leave_out_exchange() { exchange_ = 0.0; }

  /// R of a pair that is first seen where it stands, with the energy `stored` in its contact.
  static double at_start(double stored) { return -stored; }

  /// R up to this time level without the work of the force that begins here, which is not known
  /// yet, and without exchanged().
  double up_to(const StaggeredMotion& now, const ContactState& state) const {
    const double r = state.account;
    if (state.phase == ContactState::persistent)
      return r + dissipated(state.last_rate, now.mean_rate(step_)) - stored(now) -
             work(persistent_force(now), now);
    const double late = dissipated_late(now, state);
    if (state.force == 0.0) return r + late;
    const double speed_squared = now.rate * now.rate + now.sideways * now.sideways;
    const double along = now.distance * now.rate - step_ * speed_squared;
    const double distance = std::hypot(now.distance - step_ * now.rate, step_ * now.sideways);
    return r + late + 0.5 * step_ * state.force * along / distance;
  }

  /// What the force of this time level does on the way here, [energy].
  double work(double force, const StaggeredMotion& now) const {
    return 0.5 * step_ * force * now.rate;
  }
  /// The same in the first step of a run, whose velocities are those of the time level: what the
  /// other half of the way, to the next one, would count too much. `mean` [length/time]: the rate
  /// on it.
  double work_of_first_force(double force, const StaggeredMotion& now, double mean) const {
    return -0.25 * step_ * force * (mean - now.rate);
  }
  /// What the dashpot of a resolved step has dissipated with the rate at its end, [energy].
  double dissipated_late(const StaggeredMotion& now, const ContactState& state) const {
    return damping_ * state.contact_time * now.rate * now.rate;
  }
  /// What a resolved step dissipates, less what its dashpot will with the rate `mean` along the
  /// normal at its end.
  double resolved(double dissipation, double contact_time, double mean) const {
    return dissipation - damping_ * contact_time * mean * mean;
  }

  /// The dissipation in closed form from one time level to the next of a persistent contact, less
  /// the work of the discrete dashpot, from the mean rates before and after the first one. R
  /// changes by it, since the discrete spring stores what it works.
  [[gnu::always_inline]] double dissipated(double before, double after) const {
    return before * (before_before_ * before + before_after_ * after) +
           after_after_ * after * after;
  }
  /// What the other forces add to R for acting one step late. `force`: of the contact in the last
  /// step; external [length/time^2]: acceleration of the distance by other forces in it.
  [[gnu::always_inline]] double exchanged(double force, double external,
                                          const ContactState& state) const {
    return exchange_ * (force * state.external_before - state.force_before * external);
  }

  /// The energy whose decrease is the work of a persistent contact, of turning pairs, too.
  double stored(const StaggeredMotion& now) const {
    const double overlap = contact_distance_ - now.distance, across = step_ * now.sideways;
    return overlap * (0.5 * spring_.stiffness * overlap - attraction_) -
           0.25 * persistent_force(now) * across * across / now.distance;
  }

  /// Sets the force with which a pair of account `r` flies on at the speed that closes it, but not
  /// at less than half of the speed that `force`, of its motion alone, gives it. False, where it
  /// has to settle later: that energy is missing, or the pair comes back and its force stays.
  bool settle(const StaggeredMotion& now, double load, double r, double& force) const {
    const double speed = now.rate + 0.5 * step_ * load;
    if (!(speed > 0.0)) return false;
    // Down to 0 at once, and the two copies of a pair across a periodic face would part: they
    // differ by rounding, of which the root of a small difference makes far more.
    const double flies_at = speed + step_ * force / reduced_mass_;
    const double least = flies_at > 0.0 ? 0.25 * flies_at * flies_at : 0.0;
    const double left = speed * speed - 2.0 * r / reduced_mass_;
    force = reduced_mass_ * (std::sqrt(std::max(left, least)) - speed) / step_;
    return left >= least;
  }
  /// Whether what is pending of a pair that has left its range matters: R, and work of its last
  /// forces that is still to come. Positions are rounded by eps distance.
  bool is_open(const StaggeredMotion& now, double r, const ContactState& state) const {
    const double rate = std::abs(now.rate);
    const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * now.distance / step_;
    const double momentum = reduced_mass_ * (negligible * rate + rounding);
    const double force = std::max(std::abs(state.force), std::abs(state.force_before));
    return std::abs(r) > momentum * rate || force * step_ > momentum;
  }

 private:
  static constexpr double negligible = 1e-9;

  double persistent_force(const StaggeredMotion& now) const {
    return spring_.stiffness * (contact_distance_ - now.distance) -
           spring_.damping * now.mean_rate(step_) - attraction_;
  }
  void set_dissipation(const DampedOscillator& motion) {
    const DampedOscillator::Propagator p = motion.propagator(step_);
    const auto of = [&](double before, double after) {
      const double stretch =
          -(reduced_mass_ * (after - before) / step_ + spring_.damping * before) /
          spring_.stiffness;
      const double next = stretch + step_ * after;
      const double rate = (next - p.xx * stretch) / p.xv;
      const double next_rate = p.vx * stretch + p.vv * rate;
      const double lost = 0.5 * reduced_mass_ *
                          (rate * rate - next_rate * next_rate +
                           motion.w0_squared() * (stretch * stretch - next * next));
      return lost - 0.5 * spring_.damping * step_ * after * (after + before);
    };
    before_before_ = of(1.0, 0.0);
    after_after_ = of(0.0, 1.0);
    before_after_ = of(1.0, 1.0) - before_before_ - after_after_;
  }

  double contact_distance_;
  double reduced_mass_;
  GridSpring spring_;
  double attraction_;
  double damping_;  // of the contact, [mass/time]
  double step_;
  double exchange_;
  double before_before_ = 0.0, before_after_ = 0.0, after_after_ = 0.0;  // of dissipated()
};

}  // namespace cohesion::contact_solver
