// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drag/momentum_exchange.h"

/// What a gas step charges its fluid with for a particle of added mass m_a: momentum_exchange.h,
/// with the particle's response to a force smaller by the added mass.
///
/// Taken to follow (response free), a particle that is given the velocity u, the acceleration Du/Dt
/// and the pressure gradient gains in the mean of a step
///   m a = f (b (u - v_0) + m_a Du/Dt - V grad p),   f = phi(b dt/M) m/M,   M = m + m_a,
/// and the fluid loses what drag and added mass have of it,
///   m a + V grad p = c (u - v_0) + c_a Du/Dt + W grad p,   c = f b,  c_a = f m_a,  W = (1 - f) V:
/// a sphere without mass hands on all of its pressure and nothing else. Taken to keep its velocity
/// (held), it has c = b and c_a = m_a, and W with the change of the pressure. The time derivative
/// in Du/Dt is that of the step, implicit in u; u . grad u is that of its start. What is felt
/// beyond, lift included, is deferred.
///
/// Waves. Of a wave that all cells see, with sigma = rho_s/rho and no drag, free particles have
///   dv/dt = (eps + C)/(eps sigma + C) du/dt,   u' = -(1 - eps)/eps v,
/// so that with light particles and C = 1/2 nothing grows up to a share of particles of about 0.29
/// with one step of the particles in a gas step, 0.44 with five: viscous_waves.h with the kappa
/// here, whatever the gas step. Drag damps.
namespace cohesion::liquid {

/// c [force time/length]; coefficient b [force time/length], mass m, added m_a [mass], dt [time].
inline double source_coefficient(double coefficient, double mass, double added, double dt,
                                 bool free) {
  const double inertia = mass + added;
  const double c = drag::source_coefficient(coefficient, inertia, dt, free);
  return free ? c * (mass / inertia) : c;
}

/// c_a [mass].
inline double source_inertia(double coefficient, double mass, double added, double dt, bool free) {
  if (!free) return added;
  const double inertia = mass + added;
  const double phi = 1.0 + drag::ParticleDrag(coefficient, inertia, dt).force(0.0, 1.0);
  return phi * (mass / inertia) * added;
}

/// W [length^3] of a particle of `volume` V [length^3].
inline double transmitted_volume(double coefficient, double mass, double added, double volume,
                                 double dt) {
  const double inertia = mass + added;
  return drag::transmitted_volume(coefficient, inertia, volume, dt) * (mass / inertia) +
         added / inertia * volume;
}

/// Share of M of viscous_waves.h, [1], and kappa there, [1], with added mass: what viscosity does
/// to the pressure is felt by the particles without the added mass's part. void_fraction eps in (0,
/// 1), density ratio sigma = rho_s/rho [1] > 0, coefficient C [1].
inline double displaced_with_added_mass(double void_fraction, double density_ratio,
                                        double coefficient) {
  return (1.0 - void_fraction) / void_fraction * (void_fraction + coefficient) /
         (void_fraction * density_ratio + coefficient);
}
inline double viscous_share(double void_fraction, double coefficient) {
  return void_fraction / (void_fraction + coefficient);
}

}  // namespace cohesion::liquid
