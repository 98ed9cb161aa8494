// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "contact/linear_spring_dashpot.h"
#include "event_stepping/damped_oscillator.h"
#include "event_stepping/pair_step.h"

namespace cohesion::event_stepping {

/// One force of a contact that lasts, along the normal, from the places of two grid points:
///
///   x_(n+1) = x_e + 2 c (x_n - x_e) - d (x_(n-1) - x_e)
///
/// which a damped overlap x obeys exactly, whatever the step (GridSpring). x_e is where the spring
/// balances the pull of the adhesion and the turning of the line of centres, L^2/D^3 with the L of
/// the grid, which central forces keep.
///
/// Source: derived here, from the closed form of damped_oscillator.h at three grid points; see
/// docs/theory/exact_contacts.md, Discrete force of a persistent contact.
class LastingNormal {
 public:
  /// distance [length]: of the centres of bodies that touch; pull [force]; step [time]; wall: does
  /// not turn about its particle.
  LastingNormal(const contact::LinearSpringDashpot& spring, double reduced_mass, double distance,
                double pull, double step, bool wall)
      : step_(step),
        inverse_step_(1.0 / step),
        half_square_(0.5 * step * step),
        reduced_mass_(reduced_mass),
        distance_(distance),
        pull_(pull),
        turns_(wall ? 0.0 : 1.0),
        damping_(spring.damping()) {
    const DampedOscillator swing(spring.stiffness() / reduced_mass,
                                 0.5 * spring.damping() / reduced_mass);
    const double inverse_square = 1.0 / swing.w0_squared();
    propagator_ = swing.propagator(step);
    constants_ = swing.on_grid(step, reduced_mass);
    curvature_ = constants_.stiffness * step * step / reduced_mass;
    kept_ = 1.0 - constants_.damping * step / reduced_mass;
    w0_squared_ = swing.w0_squared();
    rest_ = pull / reduced_mass * inverse_square;
    least_ = (1.0 - carried) * rest_;
    lifted_ = inverse_square / (distance * distance * distance);
    const double alpha = swing.alpha();
    const double square = (swing.w0_squared() - alpha * alpha) * step * step;
    const double cosine = 0.5 * (propagator_.xx + propagator_.vv) * std::exp(alpha * step);
    seen_ = square != 0.0 ? 2.0 * (1.0 - cosine) / square : 1.0;
  }

  const GridSpring& constants() const { return constants_; }

  /// What the grid shows of a contact. The distance bends by the way across, which is right to the
  /// fourth order of its angle.
  struct Sample {
    double inverse;  // of the distance
    double overlap;
    double radial;   // velocity of the half step before
    double way;      // along the normal, in a step of that velocity
    double bent;     // what a straight flight across adds to the distance in a step
    double gone;     // by how much the distance has grown in the step before
    double stretch;  // overlap beyond that of equilibrium
  };
  [[gnu::always_inline]] Sample at(const RelativeState& grid) const {
    Sample s;
    const double square = dot(grid.separation, grid.separation);
    const double distance = std::sqrt(square);
    s.inverse = 1.0 / distance;
    s.overlap = distance_ - distance;
    s.radial = s.inverse * dot(grid.separation, grid.velocity);
    s.way = step_ * s.radial;
    const double across = turns_ * (dot(grid.velocity, grid.velocity) - s.radial * s.radial);
    s.bent = half_square_ * across * s.inverse;
    s.gone = s.way - s.bent * (1.0 + s.way * s.inverse);
    s.stretch = s.overlap - rest_ + lifted_ * across * square;
    return s;
  }

  struct Force {
    double change;  ///< of the radial velocity
    bool lasts;     ///< whether the contact certainly lasts for the step
  };
  [[gnu::always_inline]] Force force(const Sample& s) const {
    return force(s, curvature_ * s.stretch + kept_ * s.gone);
  }
  /// The first one, of a pair on which nothing else acts, from the true radial velocity at the grid
  /// point, which is `ahead` more than that of the half step before.
  Force first_force(const Sample& s, double ahead) const {
    return force(s, (1.0 - propagator_.xx) * s.stretch + propagator_.xv * (s.radial + ahead));
  }
  /// The force of spring and dashpot where the radial velocity changes by `change` in a step,
  /// [force].
  double repulsion(double change) const { return reduced_mass_ * change * inverse_step_ + pull_; }

  /// The true radial velocity at the grid point, less that of the half step before.
  double ahead(const Sample& s) const { return -rates(s).after - s.radial; }

  /// What the dashpot has taken since the last grid point, [energy]. Of the square of the speed of
  /// an oscillation the grid sees (sin(q dt/2)/(q dt/2))^2.
  double damped(const Sample& s) const { return damping_ * step_ * s.radial * s.radial / seen_; }
  /// The same of a pair on which nothing else acts: what its swing has less of spring and motion.
  double damped_alone(const Sample& s) const {
    const Rates rate = rates(s);
    const double before = s.stretch + s.gone;
    return 0.5 * reduced_mass_ *
           (rate.before * rate.before - rate.after * rate.after +
            w0_squared_ * (before * before - s.stretch * s.stretch));
  }

 private:
  /// The fraction of the way of a step that the predicted overlap must exceed.
  static constexpr double certain = 0.1;
  /// The part of the pull up to which one force carries a load. By itself it would give way at K'/K
  /// of the pull, before the contact does. With more load, and so a smaller overlap than the rest
  /// of the overlap without one, the step is resolved, in which the load acts as it is. Where one
  /// takes over from the other, the overlap changes by 1 - K'/K of that at most: it stays positive.
  static constexpr double carried = 0.75;

  /// That by which the distance `grows` in the step.
  [[gnu::always_inline]] Force force(const Sample& s, double grows) const {
    const double next = grows - s.bent * (1.0 - grows * s.inverse);  // way along the normal
    const double end = s.overlap - next - 2.0 * s.bent;              // overlap, predicted
    return {next * inverse_step_ - s.radial,
            s.overlap > least_ && s.overlap > s.way && end > least_ + certain * std::abs(s.way)};
  }

  /// Of the overlap, at the grid point before and at this one.
  struct Rates {
    double before, after;
  };
  Rates rates(const Sample& s) const {
    const double before = s.stretch + s.gone;
    const double rate = (s.stretch - propagator_.xx * before) / propagator_.xv;
    return {rate, propagator_.vx * before + propagator_.vv * rate};
  }

  double step_;
  double inverse_step_;
  double half_square_;
  double reduced_mass_;
  double distance_;
  double pull_;
  double turns_;
  double damping_;
  DampedOscillator::Propagator propagator_;
  GridSpring constants_;
  double curvature_;  // 1 + d - 2 c
  double kept_;       // d
  double w0_squared_;
  double rest_;    // overlap at which spring and pull balance
  double least_;   // smallest overlap of a contact of one force
  double lifted_;  // of that, by the square of the speed across, over the distance squared
  double seen_;
};

}  // namespace cohesion::event_stepping
