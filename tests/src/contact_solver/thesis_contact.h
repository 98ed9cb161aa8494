// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "contact/adhesion.h"
#include "contact/contact_parameters.h"
#include "contact_solver/pair_motion.h"
#include "hamaker/law.h"
#include "hamaker/small_gap.h"
#include "sphere.h"

/// The particle of the thesis' bed and its contact: 1 mm, 2650 kg/m3, K = 800 N/m,
/// eta = 0.79e-3 kg/s, H_cut = 4e-10 m; SI.
namespace cohesion::thesis {

constexpr double radius = 0.5e-3;
const double mass = 2650.0 * sphere_volume(radius);
const double reduced_mass = 0.5 * mass;
constexpr double range = 4e-10;
constexpr double contact_time = 9.25280015463e-5;  ///< test of LinearSpringDashpot

inline contact_solver::Body particle() { return {radius, 1.0 / mass}; }

/// F_ad = A r/(12 H_cut^2), tail energy F_ad H_cut: the small-gap form without outer cut-off, which
/// is so far away that all it lacks is rounding.
inline contact::Adhesion adhesion(double hamaker_constant) {
  static std::deque<hamaker::HamakerLaw<hamaker::SmallGap>> laws;
  laws.emplace_back(hamaker::HamakerParameters{hamaker_constant, range, 1e8});
  return contact::adhesion_with_tail(laws.back(), two_spheres(radius, radius));
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

}  // namespace cohesion::thesis
