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

  /// step [time]; inverse_mass [1/mass]: the effective one of the motion that stretches the spring.
  SpringOnGrid(const contact::TangentialParameters& p, double step, double inverse_mass)
      : law_(p),
        constants_(spring_on_grid(p.stiffness, p.damping, 1.0 / inverse_mass, step)),
        ends_(ends_on_grid(p.stiffness, p.damping, 1.0 / inverse_mass, step)),
        friction_(p.friction),
        step_(step),
        inverse_mass_(inverse_mass) {}

  /// What a spring, dashpot and slider lose, [energy].
  struct Losses {
    double damped = 0.0;
    double friction = 0.0;
  };

  /// One force in a contact that lasts, from the velocity of the half step before, `rate`
  /// [length/time], and the force of normal spring and dashpot. Gives the impulse at the grid
  /// point. `lasted`: through the last step, too, whose losses are told, if asked for. A step that
  /// was followed has half of its impulse still to do.
  /// `slips`: whether the slider does at this grid point.
  [[gnu::always_inline]] Vector3 advance_lasting(const contact::Plane& plane, const Vector3& rate,
                                                 double repulsion, bool lasted, Memory& memory,
                                                 bool& slips, Losses* losses) const {
    const Vector3 turned = plane.turned_into(memory.stretch);
    const Vector3 stretched = turned + step_ * rate;
    // What was followed has slipped already, and does not stretch by the whole rate.
    const Vector3 before = lasted ? turned : stretched;
    Vector3 s = stretched;
    Vector3 force =
        lasted ? sticking_force(constants_, s, rate)
               : sticking_force(ends_.first, s, rate + (0.5 * inverse_mass_) * memory.impulse);
    const double limit = friction_ * std::max(repulsion, 0.0);
    const double square = dot(force, force);
    slips = square > limit * limit;
    if (slips) {  // spring and dashpot stretch as far as they carry the Coulomb force
      force = (limit / std::sqrt(square)) * force;
      const double drag = constants_.damping / step_;
      if (lasted && constants_.stiffness + drag > 0.0)
        s = (1.0 / (constants_.stiffness + drag)) * (drag * before - force);
    }
    const Vector3 impulse = step_ * force;
    const Vector3 mean = 0.5 * (memory.impulse + impulse);
    if (losses) {
      const double work = lasted ? -dot(mean, rate) : 0.0;
      const double lost = work + law_.stored_energy(before) - law_.stored_energy(s);
      losses->damped = slips ? constants_.damping / step_ * dot(s - before, s - before) : lost;
      losses->friction = lost - losses->damped;
    }
    memory = {s, impulse};
    return lasted ? impulse : mean;
  }

  /// After advance_lasting(), of a contact on which nothing else acts: the impulse of which half
  /// leads to the true velocity.
  Vector3 twice_owed(const Vector3& rate, bool slips, const Memory& memory) const {
    return slips ? memory.impulse : step_ * sticking_force(ends_.last, memory.stretch, rate);
  }
  /// Corrects `losses` of advance_lasting(), which takes half of each impulse for what leads to the
  /// true velocity at its time level, and half for what leads on. `from`: twice what led on from
  /// the true velocity at the last time level, given in the place of its impulse; `owed`: twice
  /// what leads to the true one at this, of which the impulse is `impulse`.
  void correct_losses(const Vector3& rate, const Vector3& from, const Vector3& impulse,
                      const Vector3& owed, Losses& losses) const {
    const double more = 0.5 * dot(impulse - owed, rate) +
                        0.125 * inverse_mass_ * (dot(from, from) - dot(owed, owed));
    // A slider gives no energy: where it begins to slip, it takes less than the step's error.
    const double all = losses.damped + losses.friction + more;
    if (losses.friction != 0.0) losses.friction = std::max(losses.friction + more, 0.0);
    losses.damped = all - losses.friction;
  }

  /// The impulse of which half leads to the true velocity of a contact that sticks, from the
  /// stretch before this time level.
  Vector3 sticking_impulse(const contact::Plane& plane, const Vector3& rate,
                           const Vector3& stretch) const {
    return step_ * sticking_force(ends_.last, plane.turned_into(stretch) + step_ * rate, rate);
  }
  /// Ends a lasting contact, after advance_lasting() with the same `rate`: sets the impulse of
  /// which half is left to do up to the true velocity, where the normal force is `last`: it sticks,
  /// with the impulse `sticking`, as far as that lets it. What it takes less of the motion than the
  /// half that was to come, of `planned`, is lost.
  void end_lasting(const Vector3& rate, const Vector3& sticking, double last,
                   const Vector3& planned, Memory& memory, Losses* losses) const {
    memory.impulse = sticking;
    const double limit = step_ * friction_ * std::max(last, 0.0), size = norm(sticking);
    if (size > limit) memory.impulse = (limit / size) * sticking;
    if (losses)
      losses->friction += 0.5 * dot(planned - memory.impulse,
                                    rate + (0.25 * inverse_mass_) * (planned + memory.impulse));
  }

  /// What is lost when a contact of one force has ended, with what the spring stored.
  double lost_at_end(const Vector3& rate, const Memory& memory) const {
    return law_.stored_energy(memory.stretch) - 0.5 * dot(memory.impulse, rate);
  }

  /// A resolved step, from `stretch` at the time level, or of a contact that begins. `rate`: of the
  /// ends without the spring itself; `mean`: with it, as the particles move; overlap_at_end
  /// [length]: at the next time level, negative in a gap.
  [[gnu::always_inline]] contact::TangentialStep follow(const contact::Plane& plane,
                                                        const Vector3& stretch, const Vector3& rate,
                                                        const NormalRecord& normal,
                                                        double overlap_at_end,
                                                        Vector3& mean) const {
    contact::TangentialStep step =
        law_.advance(plane.turned_into(stretch), rate, normal.contact_time, inverse_mass_,
                     normal.repulsion_impulse, normal.repulsion_at_end);
    mean = rate + (0.5 * inverse_mass_) * step.impulse;
    if (overlap_at_end <= 0.0) {  // parted: what the spring still stored is lost
      step.friction += law_.stored_energy(step.displacement);
      step.displacement = {};
    }
    return step;
  }

  /// (w dt)^2 of one force by itself, and what its dashpot is as good as.
  double frequency_squared() const {
    if (!is_present()) return 0.0;
    return (constants_.stiffness + 2.0 * constants_.damping / step_) * step_ * step_ *
           inverse_mass_;
  }

  /// The effective one of the motion that stretches the spring, [1/mass].
  double inverse_mass() const { return inverse_mass_; }
  /// A spring whose slider has no friction gives no force.
  bool is_present() const { return friction_ > 0.0; }
  double stored_energy(const Vector3& stretch) const { return law_.stored_energy(stretch); }

 private:
  static Vector3 sticking_force(const GridSpring& spring, const Vector3& s, const Vector3& rate) {
    return -spring.stiffness * s - spring.damping * rate;
  }

  contact::TangentialSpring law_;
  GridSpring constants_;
  GridEnds ends_;
  double friction_;
  double step_;
  double inverse_mass_;
};

}  // namespace cohesion::event_stepping
