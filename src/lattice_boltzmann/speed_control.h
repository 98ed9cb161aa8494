// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::lattice_boltzmann {

/// The body force that takes a flow to a speed and keeps it there, set anew every T steps: what the
/// spheres have held in the mean of the last T, and what is missing,
///
///   g V_fluid = <F> + V (U_asked - U)/tau,     tau = 2 T,
///
/// along its direction; lattice units. Populations that are no flow and go to and fro within a few
/// steps, which nothing damps in narrow gaps, so do not answer to it. With F = lambda V U the error
/// falls from one setting to the next to 1 - T/tau of it where lambda T is small, and to 1 -
/// 1/(lambda tau) where it is large.
class SpeedControl {
 public:
  /// speed [spacing/step]; volume of the box and its nodes in the fluid, [spacing^3]
  SpeedControl(double speed, double volume, double fluid_nodes)
      : asked_(speed), volume_(volume), fluid_(fluid_nodes) {}

  /// Another speed to lead to, [spacing/step].
  void ask(double speed) { asked_ = speed; }

  /// The speed that the flow has now.
  void set_speed(double speed) { speed_ = speed; }

  /// After a step with the body force `driven` in which the spheres have held `held`
  /// [spacing^4/step^2], both along the direction: the next body force, [spacing/step^2].
  double next(double driven, double held) {
    speed_ += (driven * fluid_ - held) / volume_;
    held_ += held / interval;
    if (++step_ < interval) return driven;
    const double mean = held_;
    step_ = 0;
    held_ = 0.0;
    return (mean + volume_ * (asked_ - speed_) / (2.0 * interval)) / fluid_;
  }

 private:
  static constexpr int interval = 20;  // T, [step]

  double asked_, volume_, fluid_;
  double speed_ = 0.0, held_ = 0.0;
  int step_ = 0;
};

}  // namespace cohesion::lattice_boltzmann
