// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/linear_spring_dashpot.h"
#include "contact_solver/damped_oscillator.h"

namespace cohesion::contact_solver {

/// The discrete force of a persistent contact, exact at any step:
///
///   f = K' x - eta' u - (K'/K) F_ad      K' = mu (1 + d - 2 c)/dt^2    eta' = mu (1 - d)/dt
///
/// with the overlap x and the mean rate u of the last step, of the distance. A load L gives the
/// overlap L/K' in the place of L/K.
///
/// Source: derived here, see docs/theory/exact_contacts.md.
class PersistentForce {
 public:
  /// attraction [force]: F_ad; step [time].
  PersistentForce(const contact::LinearSpringDashpot& spring, double attraction, double step)
      : oscillator_(spring.stiffness() / spring.reduced_mass(),
                    0.5 * spring.damping() / spring.reduced_mass()),
        propagator_(oscillator_.propagator(step)),
        spring_(oscillator_.on_grid(step, spring.reduced_mass())),
        step_(step),
        inverse_mass_(1.0 / spring.reduced_mass()),
        adhesion_(attraction),
        pull_(attraction / spring.reduced_mass()),
        attraction_(spring_.stiffness * pull_ / oscillator_.w0_squared()),
        weight_(spring.stiffness() / spring_.stiffness),
        bearable_(bearable(spring.restitution())) {}

  const DampedOscillator& oscillator() const { return oscillator_; }
  /// K' and eta'.
  const GridSpring& spring() const { return spring_; }
  /// (K'/K) F_ad, [force].
  double attraction() const { return attraction_; }

  /// The force of a contact that was in contact throughout the last step, and the part of spring
  /// and dashpot. False where it is not certain to be in contact until the next time level under
  /// the `load` [length/time^2] of the last step, or does not bear that load.
  [[gnu::always_inline]] bool at(double overlap, double rate, double load, double& force,
                                 double& repulsion) const {
    if (!(load < bearable_)) return false;
    force = spring_.stiffness * overlap - spring_.damping * rate - attraction_;
    repulsion = force + adhesion_;
    const double next = -rate - step_ * (force * inverse_mass_ + load);
    // Between two time levels it may dip below both, most where what pulls is constant.
    const double dip = 0.125 * step_ * std::max(next + rate, 0.0);
    const double least = certain * step_ * std::abs(rate) + 2.0 * dip;
    return overlap > least && overlap + step_ * next > least;
  }
  /// The part of spring and dashpot at a time level that a persistent contact has reached, [force].
  double repulsion(double overlap, double rate) const {
    return spring_.stiffness * overlap - spring_.damping * rate + (adhesion_ - attraction_);
  }
  /// The work of the discrete dashpot between two time levels, from the mean rates before and after
  /// the first one, [energy].
  double damped(double before, double after) const {
    return 0.5 * spring_.damping * step_ * after * (before + after);
  }

  /// The outward acceleration of a contact that is resolved, so that a load that a persistent
  /// contact bears gives the same overlap: were it another, spheres that bounce under their weight
  /// would gain energy. A contact is not to bear more than F_ad, and a larger load acts as it is.
  double resolved_load(double outward) const {
    return outward < bearable_ ? weight_ * outward : outward;
  }
  /// The true rate of the distance at a time level, by the closed form through the last two
  /// overlaps [length]. outward [length/time^2]: acceleration by load and turning.
  double true_rate(double overlap_before, double overlap, double outward) const {
    const double equilibrium = (pull_ - weight_ * outward) / oscillator_.w0_squared();
    const double was = overlap_before - equilibrium, is = overlap - equilibrium;
    const double rate = (is - propagator_.xx * was) / propagator_.xv;
    return -(propagator_.vx * was + propagator_.vv * rate);
  }

 private:
  /// The fraction of the way of a step that a contact must be away from its end to be certain to
  /// last.
  static constexpr double certain = 0.1;

  /// Up to which load a contact stays persistent. Beyond it the overlap at rest is (F_ad - L)/K,
  /// where it was F_ad/K - L/K' before, and the contact begins to swing by the difference. What is
  /// left of the swing when the contact is to part must not part it by a hundredth of F_ad too
  /// early: half of that, of a load that is slow, which needs ten contact times for the last part
  /// of its way.
  double bearable(double restitution) const {
    if (!(pull_ > 0.0)) return std::numeric_limits<double>::infinity();
    const double swing = (weight_ - 1.0) * std::pow(restitution, 10.0);
    return pull_ * std::min(1.0 / weight_, swing > 0.005 ? 0.005 / swing : 1.0);
  }

  DampedOscillator oscillator_;
  DampedOscillator::Propagator propagator_;
  GridSpring spring_;
  double step_;
  double inverse_mass_;
  double adhesion_;    // F_ad
  double pull_;        // F_ad/mu
  double attraction_;  // (K'/K) F_ad
  double weight_;      // K/K'
  double bearable_;    // largest load per mu, [length/time^2]
};

}  // namespace cohesion::contact_solver
