// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/tangential_spring.h"
#include "event_stepping/damped_oscillator.h"
#include "event_stepping/pair_step.h"

namespace cohesion::event_stepping {

/// A spring, dashpot and slider in the plane of contact, of friction or against rolling, whose
/// stretch is known at grid points and grows with the motion on the grid in between.
class SpringOnGrid {
 public:
  struct Memory {
    Vector3 stretch{};  ///< that the grid's motion of the last step leads on from, [length]
    Vector3 impulse{};  ///< of the last step, half of which its force is still to do, [momentum]
  };

  /// step [time]; answer [1/mass]: the inverse mass that answers the spring.
  SpringOnGrid(const contact::TangentialParameters& p, double step, double answer)
      : law_(p),
        constants_(spring_on_grid(p.stiffness, p.damping, 1.0 / answer, step)),
        friction_(p.friction),
        step_(step),
        answer_(answer) {}

  /// One force in a contact that lasts, from the velocity of the half step before, `rate`
  /// [length/time], and the force of normal spring and dashpot. Adds to both losses [energy].
  void rub(const contact::Plane& plane, const Vector3& rate, double repulsion, Memory& memory,
           double& damped, double& lost) const {
    Vector3 s = step_ * rate;
    if (dot(memory.stretch, memory.stretch) > 0.0) s += plane.turned_into(memory.stretch);
    Vector3 force = -constants_.stiffness * s - constants_.damping * rate;
    const double limit = friction_ * std::max(repulsion, 0.0);
    const double square = dot(force, force);
    if (square > limit * limit) {
      force = (limit / std::sqrt(square)) * force;
      const Vector3 trial = s;
      if (constants_.stiffness > 0.0)
        s = (-1.0 / constants_.stiffness) * (force + constants_.damping * rate);
      lost += dot(force, s - trial);
    }
    damped += step_ * constants_.damping * dot(rate, rate);
    memory = {s, step_ * force};
  }

  /// A followed step, from `stretch` at the grid point, or of a contact that begins. `rate`: of the
  /// ends without the spring itself; `mean`: with it.
  contact::TangentialStep follow(const contact::Plane& plane, const Vector3& stretch,
                                 const Vector3& rate, const PairStep& normal, Vector3& mean) const {
    const Vector3 start = dot(stretch, stretch) > 0.0 ? plane.turned_into(stretch) : Vector3{};
    contact::TangentialStep step =
        law_.advance(start, rate, normal.normal.contact_time, answer_,
                     normal.normal.repulsion_impulse, normal.normal.repulsion_at_end);
    mean = rate + (0.5 * answer_) * step.impulse;
    if (normal.overlap_at_end <= 0.0) {  // parted: what the spring still held is lost
      step.friction += law_.stored_energy(step.displacement);
      step.displacement = {};
    }
    return step;
  }

  double stored_energy(const Vector3& stretch) const { return law_.stored_energy(stretch); }

 private:
  contact::TangentialSpring law_;
  GridSpring constants_;
  double friction_;
  double step_;
  double answer_;
};

}  // namespace cohesion::event_stepping
