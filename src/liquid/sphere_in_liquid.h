// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <complex>

#include "vector3.h"

/// The motion of a sphere over a time step with drag, added mass and lift, every other force F and
/// the fluid held constant. With the slip s = u - v, the added mass m_a and M = m + m_a:
///
///   m dv/dt = b s + s x L + F + m_a (Du/Dt - dv/dt)   <=>   M dv/dt = b s + s x L + F + m_a Du/Dt,
///
/// so none of the three limits the step, however light the sphere is: a sphere without mass has M =
/// m_a. With X = (b +- i |L|) dt/M across L and b dt/M along it, the mean acceleration is
///   a = phi(X) (b s_0 + s_0 x L + F + m_a Du/Dt)/M,   phi(X) = (1 - exp(-X))/X.
///
/// Drag with the square of the slip, q |s| s, is taken as b = q times a slip in the step: the mean
/// of that at its start and of that of an implicit step. It is of second order, and in the terminal
/// velocity exact; that velocity is approached in steps of any length.
namespace cohesion::liquid {

/// drag_coefficient b [force time/length], drag_per_slip q [force time^2/length^2], mass m and
/// added_mass m_a [mass], lift L [force time/length].
struct SphereInLiquid {
  double drag_coefficient, drag_per_slip, mass, added_mass;
  Vector3 lift;

  double inertia() const { return mass + added_mass; }

  /// b [force time/length] with that of the square of the slip, over a step of `time` = dt/M.
  double coefficient(double slip, double unslowed, double time) const {
    if (drag_per_slip == 0.0) return drag_coefficient;
    // s (1 + (b + q s) dt/M) = |s_0 - F dt/M|
    const double linear = 1.0 + drag_coefficient * time;
    const double root = std::sqrt(linear * linear + 4.0 * drag_per_slip * time * unslowed);
    return drag_coefficient + drag_per_slip * 0.5 * (slip + 2.0 * unslowed / (linear + root));
  }
};

/// 1 - exp(-a + i t), without loss of digits for small ones.
inline std::complex<double> one_minus_exp(double a, double t) {
  const double half = std::sin(0.5 * t), decay = std::exp(-a);
  return {-std::expm1(-a) + 2.0 * decay * half * half, -decay * std::sin(t)};
}

/// phi of X = a - i t, or with `middle` what takes its place when the slip is that in the middle of
/// the step, (s_0 + s_1)/2 as leapfrog has it: tanh(X/2)/(X/2).
inline std::complex<double> mean_share(double a, double t, bool middle) {
  const std::complex<double> x(a, -t), gone = one_minus_exp(a, t);
  const std::complex<double> share = std::abs(x) > 0.0 ? gone / x : 1.0;
  return middle ? share / (1.0 - 0.5 * gone) : share;
}

/// `now`, the acceleration at the start of the step, in its mean: with time = dt/M.
inline Vector3 mean_acceleration(const Vector3& now, double coefficient, const Vector3& lift,
                                 double time, bool middle) {
  const double turn = norm(lift);
  const double along = mean_share(coefficient * time, 0.0, middle).real();
  if (!(turn > 0.0)) return along * now;
  const Vector3 axis = (1.0 / turn) * lift;
  const Vector3 parallel = dot(now, axis) * axis, across = now - parallel;
  const auto share = mean_share(coefficient * time, turn * time, middle);
  return along * parallel + share.real() * across + share.imag() * cross(axis, across);
}

/// Mean acceleration dv/dt over a step dt [length/time^2]: slip u - v at its start [length/time],
/// force F + m_a Du/Dt of all but drag and lift [force].
inline Vector3 acceleration(const SphereInLiquid& sphere, const Vector3& slip, const Vector3& force,
                            double dt) {
  const double time = dt / sphere.inertia();
  const double b = sphere.coefficient(norm(slip), norm(slip - time * force), time);
  const Vector3 now = b * slip + cross(slip, sphere.lift) + force;
  return (1.0 / sphere.inertia()) * mean_acceleration(now, b, sphere.lift, time, false);
}

/// The same from the slip in the middle of the step as leapfrog has it; drag with its square is
/// that of this slip.
inline Vector3 acceleration_about(const SphereInLiquid& sphere, const Vector3& middle_slip,
                                  const Vector3& force, double dt) {
  const double time = dt / sphere.inertia();
  const double b = sphere.drag_coefficient + sphere.drag_per_slip * norm(middle_slip);
  const Vector3 now = b * middle_slip + cross(middle_slip, sphere.lift) + force;
  return (1.0 / sphere.inertia()) * mean_acceleration(now, b, sphere.lift, time, true);
}

}  // namespace cohesion::liquid
