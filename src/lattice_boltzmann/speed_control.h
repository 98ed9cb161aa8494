// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::lattice_boltzmann {

/// The body force that takes a flow to a speed and keeps it there: what the spheres hold in the
/// mean of the last steps, and what is missing,
///
///   g V_fluid = <F> + V (U_asked - U)/tau,     d<F>/dt = (F - <F>)/tau_F,
///
/// along its direction; lattice units. With F = lambda V U both rates, of sum 1/tau + 1/tau_F +
/// lambda and product 1/(tau tau_F), are of flows that settle. Of the last step alone it would
/// answer to what it has itself done to the nodes at walls; and momentum that goes to and fro from
/// step to step, which nothing damps in narrow gaps, does not count.
class SpeedControl {
 public:
  /// speed [spacing/step]; volume of the box and its nodes in the fluid, [spacing^3]
  SpeedControl(double speed, double volume, double fluid_nodes)
      : asked_(speed), volume_(volume), fluid_(fluid_nodes) {}

  /// The speed that the flow has now.
  void set_speed(double speed) { speed_ = speed; }

  /// After a step with the body force `driven` in which the spheres have held `held`
  /// [spacing^4/step^2], both along the direction: the next body force, [spacing/step^2].
  double next(double driven, double held) {
    speed_ += (driven * fluid_ - held) / volume_;
    held_ += (0.5 * (held + held_before_) - held_) / mean_time;
    held_before_ = held;
    return (held_ + volume_ * (asked_ - speed_) / time) / fluid_;
  }

 private:
  static constexpr double time = 50.0, mean_time = 10.0;  // tau and tau_F, [step]

  double asked_, volume_, fluid_;
  double speed_ = 0.0, held_ = 0.0, held_before_ = 0.0;
};

}  // namespace cohesion::lattice_boltzmann
