// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "constants.h"
#include "contact/contact_parameters.h"
#include "event_stepping/pair_motion.h"
#include "event_stepping/plane_pair.h"
#include "event_stepping/sphere_pair.h"
#include "sphere.h"

/// Runs of one pair as an engine would run them, for the tests of the event scheme.
namespace cohesion::event_stepping {

/// The particle of the thesis' bed and its contact: 1 mm, 2650 kg/m3, K = 800 N/m,
/// eta = 0.79e-3 kg/s, H_cut = 4e-10 m; SI.
namespace thesis {
constexpr double radius = 0.5e-3;
const double mass = 2650.0 * sphere_volume(radius);
const double reduced_mass = 0.5 * mass;
constexpr double range = 4e-10;
constexpr double contact_time = 9.25280015463e-5;  ///< test of LinearSpringDashpot

/// F_ad = A r/(12 H_cut^2), tail energy F_ad H_cut: the small-gap form without outer cut-off, which
/// is so far away that all it lacks is rounding.
inline contact::Adhesion adhesion(double hamaker_constant) {
  const hamaker::Law<hamaker::SmallGap> law({hamaker_constant, range, 1e8});
  return contact::adhesion_of(law, two_spheres(radius, radius));
}

inline contact::ContactParameters contact() {
  contact::ContactParameters p;
  p.stiffness = 800.0;
  p.damping = 0.79e-3;
  return p;
}
inline contact::ContactParameters elastic() {
  contact::ContactParameters p = contact();
  p.damping = 0.0;
  return p;
}
}  // namespace thesis

/// The relative coordinates of a pair on a time grid of step dt.
template <class Geometry>
class PairRun {
 public:
  /// `state` is the true one, half a step before the first grid point.
  PairRun(const contact::ContactParameters& parameters, const contact::Adhesion& adhesion,
          const Body& i, const Body& j, double dt, const RelativeState& state)
      : reduced_mass_(1.0 / (i.inverse_mass + j.inverse_mass)),
        geometry_(contact::normal_contact(parameters, reduced_mass_), adhesion, i.radius + j.radius,
                  dt),
        dt_(dt),
        true_(state) {}

  void step() {
    const RelativeState grid{true_.separation + 0.5 * dt_ * true_.velocity, true_.velocity};
    last_ = geometry_.advance(grid, {0.5 * dt_, 0.5 * dt_}, last_.inside);
    const Vector3 velocity = grid.velocity + last_.change.velocity;
    true_ = {grid.separation + last_.change.separation + 0.5 * dt_ * velocity, velocity};
    dissipated_ += last_.normal.dissipated;
    touched_ = touched_ || last_.normal.contact_time > 0.0;
    unresolved_ += last_.normal.unresolved;
    steps_++;
  }

  /// Until the pair has been in contact and left the range, or `most` steps. True: it left.
  bool run_to_escape(int most) {
    for (int n = 0; n < most; n++) {
      step();
      if (touched_ && !last_.inside) return true;
    }
    return false;
  }

  void reverse() { true_.velocity = -1.0 * true_.velocity; }
  void shift(const Vector3& by) { true_.separation += by; }
  void set_inside(bool inside, double overlap) {
    last_.inside = inside;
    last_.overlap_at_end = overlap;
  }

  const RelativeState& state() const { return true_; }
  const PairStep& last() const { return last_; }
  double dissipated() const { return dissipated_; }
  int unresolved() const { return unresolved_; }
  int steps() const { return steps_; }

  double distance() const { return norm(true_.separation); }
  double approach() const { return -dot(true_.separation, true_.velocity) / distance(); }
  double kinetic() const { return 0.5 * reduced_mass_ * dot(true_.velocity, true_.velocity); }
  double stored() const { return stored_at(last_.overlap_at_end); }
  /// What spring and adhesion would store at another overlap, [energy].
  double stored_at(double overlap) const {
    const double adhesion = last_.inside ? geometry_.adhesion_energy(overlap) : 0.0;
    return geometry_.spring_energy(overlap) + adhesion;
  }
  double energy() const { return kinetic() + stored() + dissipated_; }
  Vector3 angular_momentum() const { return cross(true_.separation, true_.velocity); }

 private:
  double reduced_mass_;
  Geometry geometry_;
  double dt_;
  RelativeState true_;
  PairStep last_{};
  double dissipated_ = 0.0;
  bool touched_ = false;
  int unresolved_ = 0;
  int steps_ = 0;
};

}  // namespace cohesion::event_stepping
