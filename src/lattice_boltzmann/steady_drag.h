// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "constants.h"
#include "lattice_boltzmann/arrays.h"
#include "lattice_boltzmann/flow.h"
#include "lattice_boltzmann/relaxation.h"
#include "lattice_boltzmann/speed_control.h"
#include "lattice_boltzmann/walls.h"
#include "validation.h"

namespace cohesion::lattice_boltzmann {

/// Length of a vector.
inline double size_of(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

/// How a flow is driven, and when it is steady. Lattice units.
struct FlowSettings {
  double viscosity;         ///< [spacing^2/step]
  Vector body_force;        ///< [spacing/step^2]
  double speed = 0.0;       ///< superficial, along the force, to which the force is made to lead,
                            ///< [spacing/step]; 0: the force is as given
  double tolerance = 1e-6;  ///< of the velocity, or the force, that is yet to come, over it, [1]
  long most_steps = 1000000;
  long average = 0;  ///< of a flow that is not steady after so many steps the mean of as many more
                     ///< is taken; 0: it is an error not to be steady
};

/// What a steady flow through an array of fixed spheres gives, or the mean of one that swings.
struct SteadyDrag {
  Vector superficial;          ///< [spacing/step]
  Vector body_force;           ///< [spacing/step^2]
  std::vector<Vector> forces;  ///< on each sphere by its surface, F_total less V_p g: its drag
  double balance;              ///< error of their sum against the force on the fluid nodes, [1]
  long steps;
  double swing = 0.0;  ///< of a flow that is not steady: standard error of the body force over it,
                       ///< by tenths of the time of the mean, [1]
};

/// Called between samples of the flow with the number of steps and the remaining change [1].
using ProgressReport = std::function<void(long, double)>;

/// What is yet to come of a number that is looked at now and then, over it, its changes taken for a
/// geometric series; the largest of the last looks, since what swings stands still where it turns.
/// [1]
class YetToCome {
 public:
  double after(double now) {
    const double change = now - last_, earlier = last_ - before_;
    const bool shrinks = change * earlier > 0.0 && std::abs(change) < std::abs(earlier);
    const double rest = std::abs(change / now);
    before_ = last_;
    last_ = now;
    std::rotate(found_.begin(), found_.begin() + 1, found_.end());
    found_.back() = shrinks ? rest * std::abs(change / (earlier - change)) : rest;
    if (looks_++ < 3) return 1.0;
    return *std::max_element(found_.begin(), found_.end());
  }

 private:
  double before_ = 0.0, last_ = 0.0;
  std::array<double, 3> found_{};
  int looks_ = 0;
};

/// A flow through an array on its course.
class DrivenFlow {
 public:
  DrivenFlow(const Array& array, const FlowSettings& settings, const Shared& shared)
      : settings_(settings),
        grid_(array.nodes),
        walls_(grid_, array.spheres),
        flow_(grid_, walls_, Relaxation(settings.viscosity), shared),
        control_(settings.speed, grid_.volume(), static_cast<double>(walls_.fluid_nodes())),
        force_(size_of(settings.body_force)) {
    require_positive("body force", force_);
    for (int k = 0; k < 3; k++) along_[k] = settings.body_force[k] / force_;
    flow_.set_body_force(settings.body_force);
  }

  /// Goes on by so many steps, and calls each() when the forces on spheres in one are known.
  template <class F>
  void advance(int steps, F each) {
    for (int i = 0; i < steps; i++) {
      flow_.step();
      each();
      if (settings_.speed > 0.0) lead();
    }
    if (settings_.speed > 0.0) control_.set_speed(speed());
  }
  void advance(int steps) {
    advance(steps, [] {});
  }

  /// Means of so many steps more: what goes to and fro between them, sound and the momentum of
  /// every second step, is no force.
  SteadyDrag measured(int steps) {
    SteadyDrag found{{}, {}, std::vector<Vector>(walls_.spheres(), Vector{}), 0.0, 0};
    double force = 0.0, sum = 0.0;
    advance(steps, [&] {
      force += force_ / steps;
      sum += held() / steps;
      for (std::size_t s = 0; s < found.forces.size(); s++)
        for (int k = 0; k < 3; k++) found.forces[s][k] += flow_.forces()[s][k] / steps;
    });
    found.superficial = flow_.superficial_velocity();
    for (int k = 0; k < 3; k++) found.body_force[k] = force * along_[k];
    found.balance = std::abs(sum / (force * static_cast<double>(walls_.fluid_nodes())) - 1.0);
    return found;
  }

  /// Superficial, along the force.
  double speed() { return along(flow_.superficial_velocity()); }
  double force() const { return force_; }
  const Flow& flow() const { return flow_; }
  const Walls& walls() const { return walls_; }
  const Grid& grid() const { return grid_; }

 private:
  double along(const Vector& v) const {
    return v[0] * along_[0] + v[1] * along_[1] + v[2] * along_[2];
  }

  double held() const {
    double sum = 0.0;
    for (const Vector& force : flow_.forces()) sum += along(force);
    return sum;
  }

  /// To the speed, which grows over the time in which viscosity reaches some spacings from walls:
  /// at a sudden start layers at walls are thinner than nodes can follow, and fast flows blow up.
  void lead() {
    constexpr double spacings = 3.0;
    done_ += 1.0;
    const double begun = done_ * settings_.viscosity / (spacings * spacings);
    control_.ask(settings_.speed * std::min(1.0, begun));
    drive(control_.next(force_, held()));
  }

  void drive(double force) {
    force_ = force;
    Vector of{};
    for (int k = 0; k < 3; k++) of[k] = force * along_[k];
    flow_.set_body_force(of);
  }

  FlowSettings settings_;
  Grid grid_;
  Walls walls_;
  Flow flow_;
  SpeedControl control_;
  double force_;
  double done_ = 0.0;  // steps
  Vector along_{};
};

/// Throws InvalidParameter where a flow has blown up.
inline void require_finite(double speed) {
  require(std::isfinite(speed), "velocity", speed,
          "the flow is unstable: take a smaller body force or speed, or more spacings to a "
          "diameter");
}

/// Means over so many steps, and how sure they are.
inline SteadyDrag average_drag(DrivenFlow& driven, long steps, const ProgressReport& report) {
  const int parts = 10, each = static_cast<int>(steps / parts);
  SteadyDrag mean = driven.measured(each);
  std::vector<double> forces{size_of(mean.body_force)};
  for (int part = 1; part < parts; part++) {
    if (report) report(each * part, 1.0);
    const SteadyDrag next = driven.measured(each);
    forces.push_back(size_of(next.body_force));
    const double share = 1.0 / (part + 1);
    const auto take = [share](Vector& a, const Vector& b) {
      for (int k = 0; k < 3; k++) a[k] += share * (b[k] - a[k]);
    };
    take(mean.superficial, next.superficial);
    take(mean.body_force, next.body_force);
    for (std::size_t s = 0; s < mean.forces.size(); s++) take(mean.forces[s], next.forces[s]);
    mean.balance = std::max(mean.balance, next.balance);
  }
  const double middle = size_of(mean.body_force);
  double squares = 0.0;
  for (const double force : forces) squares += std::pow(force / middle - 1.0, 2);
  mean.swing = std::sqrt(squares / (parts - 1) / parts);
  return mean;
}

/// Runs a flow until what is yet to come of its velocity, or of the force that keeps it, is below
/// the tolerance; where an average is asked for and it is not within those steps, the mean of as
/// many more. Throws InvalidParameter when it is not steady within the steps given, or blows up.
inline SteadyDrag steady_drag(DrivenFlow& driven, const FlowSettings& settings,
                              const ProgressReport& report = {}) {
  const int interval = 100;
  YetToCome rest;
  long steps = 0;
  for (double left = 1.0; left > settings.tolerance;) {
    if (settings.average > 0 && steps >= settings.average) {
      SteadyDrag found = average_drag(driven, settings.average, report);
      found.steps = steps + settings.average;
      require_finite(found.balance);
      return found;
    }
    require(steps < settings.most_steps, "largest number of steps", settings.most_steps,
            "the flow is not steady by then: allow more, a larger tolerance, or an average");
    driven.advance(interval);
    steps += interval;
    const double speed = driven.speed();
    require_finite(speed);
    left = rest.after(settings.speed > 0.0 ? driven.force() : speed);
    if (settings.speed > 0.0) left = std::max(left, std::abs(speed / settings.speed - 1.0));
    if (report) report(steps, left);
  }
  SteadyDrag found = driven.measured(interval);
  found.steps = steps + interval;
  return found;
}

/// The same of a flow that starts at rest.
inline SteadyDrag steady_drag(const Array& array, const FlowSettings& settings) {
  DrivenFlow driven(array, settings, one_by_one);
  return steady_drag(driven, settings);
}

/// F = force/(3 pi mu d U) of the drag along the flow on a sphere, U superficial. [1]
inline double drag_on(const SteadyDrag& drag, const Array& array, const FlowSettings& settings,
                      std::size_t sphere) {
  double along = 0.0;
  for (int k = 0; k < 3; k++) along += drag.forces[sphere][k] * drag.body_force[k];
  return along / (size_of(drag.body_force) * 6.0 * pi * settings.viscosity *
                  array.spheres[sphere].radius * size_of(drag.superficial));
}

/// F* = F_drag/(3 pi mu d U), F_drag = (1 - phi) F_total, of the mean over the spheres, F_total = g
/// V/N: the force by which the fluid is driven in the whole box, spheres included; d the Sauter
/// mean. [1]
inline double mean_drag(const SteadyDrag& drag, const Array& array, const FlowSettings& settings) {
  const double each = volume(array) / static_cast<double>(array.spheres.size());
  return (1.0 - solid_fraction(array)) * size_of(drag.body_force) * each /
         (3.0 * pi * settings.viscosity * sauter_mean(array) * size_of(drag.superficial));
}

/// Re = U d/nu, superficial, d the Sauter mean.
inline double reynolds(const SteadyDrag& drag, const Array& array, const FlowSettings& settings) {
  return size_of(drag.superficial) * sauter_mean(array) / settings.viscosity;
}

}  // namespace cohesion::lattice_boltzmann
