// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "contact/hertz_spring_dashpot.h"
#include "contact_solver/contact_state.h"

namespace cohesion::contact_solver {

/// A contact whose law has no closed form, with a constant attraction: integrated.
///
/// In a persistent contact the force is the law's at the time level, as Verlet's scheme has it,
/// with the rate v_n that spring, dashpot and load give there:
///
///   f = F(x_n) + c(x_n) v_n - F_ad    v_n = (u + dt/2 ((F_ad - F)/mu - b))/(1 + c dt/(2 mu))
///
/// where u is the mean rate of approach of the last step and b what other forces and turning do.
/// Its first force gives the discrete orbit the true amplitude:
///
///   v_(n+1/2) = v_n (1 - dt^2 F'/(8 mu)) + dt/2 a_n
///
/// In a resolved step the classical Runge-Kutta scheme moves x and y = v + C(x)/mu, C the integral
/// of c over the overlap, in two sub-steps: y has no jump where a dashpot sets in. Whether and with
/// which speed a pair parts is decided by its energy, not by where a sub-step ends.
///
/// The energy account (energy_account.h) holds the work of the forces and what the dashpot
/// dissipates, int |v| dC, from the speeds that the energy leaves at the time levels.
///
/// `Law` has at(x), a contact::LawPoint, reduced_mass(), is_damped(), lowest_overlap() at which a
/// contact ends, and friction_load().
///
/// Source: derived here, see docs/theory/exact_contacts.md.
template <class Law>
class IntegratedContact {
 public:
  /// attraction [force]: F_ad; step [time].
  IntegratedContact(const Law& law, double attraction, double step)
      : law_(law),
        reduced_mass_(law.reduced_mass()),
        inverse_mass_(1.0 / law.reduced_mass()),
        adhesion_(attraction),
        pull_(attraction / law.reduced_mass()),
        step_(step),
        twelfth_(step / 12.0),
        is_damped_(law.is_damped()),
        lowest_(law.lowest_overlap()),
        at_lowest_(law.at(law.lowest_overlap())),
        friction_load_(law.friction_load() + attraction) {}

  const Law& law() const { return law_; }

  double spring_energy(double x) const { return x > lowest_ ? law_.at(x).energy : 0.0; }

  /// As LinearContact has them.
  double lowest_overlap() const { return lowest_; }
  double friction_load() const { return friction_load_; }
  bool advance_whole_step(Overlap& s, double outward, NormalRecord& record) const {
    if (!(s.x > lowest_)) return false;
    ContactPath path{s, law_.at(s.x)};
    for (int k = 0; k < substeps; k++) {
      const Overlap before = path.s;
      move(path, step_ / substeps, pull_ - outward);
      if (may_part(before, path.s)) return false;
    }
    record_contact(s, path, step_, pull_ - outward, record);
    return true;
  }
  double advance(Overlap& s, double time, double outward, NormalRecord& record) const {
    const double drive = pull_ - outward;
    const int steps = std::max(1, static_cast<int>(std::ceil(substeps * time / step_ - 1e-9)));
    // Rounding may place a pair that has just touched below the lowest overlap.
    s.x = std::max(s.x, lowest_);
    ContactPath path{s, law_.at(s.x)};
    for (int k = 0; k < steps; k++) {
      const ContactPath before = path;
      move(path, time / steps, drive);
      if (!may_part(before.s, path.s)) continue;
      const ContactPath parted = part(before, drive);
      if (parted.s.v < 0.0) {
        const double taken = k * time / steps + std::min(parted.time, time / steps);
        record_contact(s, parted, taken, drive, record);
        return taken;
      }
      // The energy does not suffice: it turns within the contact.
      path.s = {std::max(path.s.x, lowest_ + turning_part * (before.s.x - lowest_)),
                std::max(path.s.v, 0.0)};
      path.at = law_.at(path.s.x);
    }
    record_contact(s, path, time, drive, record);
    return time;
  }

  /// `outward` contains the centrifugal acceleration. touch_energy [energy]: of the adhesion of a
  /// pair that just touches.
  [[gnu::always_inline]] bool advance_persistent(const ContactPoint& now, double outward,
                                                 const DistanceMotion& at,
                                                 const ContactState& state, double touch_energy,
                                                 PersistentStep& step) const {
    const Arrival here =
        arrive(now, outward, at.centrifugal, state, touch_energy - adhesion_ * now.overlap);
    const double spring_and_dashpot = here.at.force - here.at.damping * here.discrete_rate;
    step.force = spring_and_dashpot - adhesion_;
    if (!lasts(now.overlap, here.discrete_rate, outward + step.force * inverse_mass_)) return false;
    step.repulsion = spring_and_dashpot + (friction_load_ - adhesion_);
    step.account = here.work + here.dissipated +
                   0.5 * step_ * step.force * (now.rate + 0.5 * step_ * at.centrifugal);
    step.dissipated = here.dissipated;
    step.true_rate = here.rate;
    step.at = here.at;
    step.radius_stiffness_before = here.radius_stiffness_before;
    return true;
  }
  bool begin_persistent(const ContactPoint& now, double outward, const StaggeredMotion& at,
                        const ContactState& state, PersistentStep& step) const {
    const double centrifugal = at.sideways * at.sideways / at.distance;
    const double external = outward - centrifugal;
    // A contact that is first seen at rest is there because of a load.
    const bool is_new = state.is_new();
    const double rate = is_new ? at.rate : at.rate + state.velocity_offset + 0.5 * step_ * external;
    const contact::LawPoint p = point(now.overlap);
    const double own = (p.force - p.damping * rate - adhesion_) * inverse_mass_;
    const double borne = is_new ? std::max(outward, -own) : outward;
    if (!lasts(now.overlap, rate, own + borne)) return false;
    const double other = is_new ? 0.5 * own : state.velocity_offset / step_;
    const double first = other + 0.5 * own - 0.125 * step_ * p.stiffness * inverse_mass_ * rate;
    step.force = reduced_mass_ * first;
    step.repulsion = friction_load_ + reduced_mass_ * own;
    step.account = 0.5 * step_ * step.force * at.rate;
    step.true_rate = rate;
    return true;
  }
  double repulsion(const ContactPoint& now, const ContactState&) const {
    const contact::LawPoint p = point(now.overlap);
    return p.force - p.damping * now.rate + (friction_load_ - adhesion_);
  }

  double account(const ContactPoint& now, const StaggeredMotion& at, const ContactState& state,
                 double adhesion_energy) const {
    const Arrival here = arrive(now, at, state, adhesion_energy);
    return state.account + here.work + here.dissipated;
  }
  double dissipation(const ContactPoint& now, const StaggeredMotion& at, const ContactState& state,
                     double adhesion_energy) const {
    return arrive(now, at, state, adhesion_energy).dissipated;
  }
  /// A pair that parts has the speed that its energy leaves.
  double true_rate(const ContactPoint& now, const StaggeredMotion& at, double /*outward*/,
                   const ContactState& state, double adhesion_energy) const {
    const Arrival here = arrive(now, at, state, adhesion_energy);
    if (here.discrete_rate <= 0.0) return here.discrete_rate;
    return std::sqrt(std::max(here.energy_left - 2.0 * inverse_mass_ * here.dissipated, 0.0));
  }

  double late_dissipation(const StaggeredMotion&, const ContactState&) const { return 0.0; }
  double early_dissipation(double dissipation, double, double) const { return dissipation; }

 private:
  contact::LawPoint point(double x) const { return law_.at(std::max(x, lowest_)); }

  static constexpr int substeps = 2;
  /// Where a pair turns that comes near to parting, of the overlap before.
  static constexpr double turning_part = 1e-3;
  /// How far, relative to its square, the speed that the energy leaves may be from that of the
  /// discrete motion to be taken for it.
  static constexpr double trusted = 0.5;

  /// Through a contact: what is reached, the law there, and what the dashpot has dissipated.
  struct ContactPath {
    Overlap s;
    contact::LawPoint at;
    double dissipated = 0.0;  ///< [energy]
    double time = 0.0;        ///< of the way to parting, [time]
  };
  /// A persistent contact at the next time level.
  struct Arrival {
    contact::LawPoint at;
    double discrete_rate;  ///< of the distance, by the discrete motion, [length/time]
    double rate;           ///< the same, by the energy where that is near, [length/time]
    double work;           ///< of the last force on its way here, [energy]
    double energy_left;    ///< twice that of the motion along the normal per mass, undamped
    double dissipated;     ///< since the last time level, [energy]
    double radius_stiffness_before;
  };

  Arrival arrive(const ContactPoint& now, const StaggeredMotion& at, const ContactState& state,
                 double adhesion_energy) const {
    const double outward = (now.rate - state.last_rate) / step_ - state.force * inverse_mass_;
    return arrive(now, outward, at.sideways * at.sideways / at.distance, state, adhesion_energy);
  }
  [[gnu::always_inline]] Arrival arrive(const ContactPoint& now, double outward, double centrifugal,
                                        const ContactState& state, double adhesion_energy) const {
    const contact::LawPoint before = point(now.overlap + step_ * now.rate);
    Arrival here{point(now.overlap), 0.0, 0.0, 0.0, 0.0, 0.0, before.radius_stiffness};
    const double half = 0.5 * step_;
    here.discrete_rate =
        (now.rate + half * ((here.at.force - adhesion_) * inverse_mass_ + outward)) /
        (1.0 + half * inverse_mass_ * here.at.damping);
    here.rate = here.discrete_rate;
    here.work = half * state.force * (now.rate - half * centrifugal);
    const double others = now.rate + half * outward;
    here.energy_left =
        others * others -
        2.0 * inverse_mass_ * (state.account + here.work + here.at.energy + adhesion_energy);
    if (is_damped_) set_dissipation(now, before, state.velocity_offset, here);
    return here;
  }

  /// What the dashpot took on the way from the last time level, where the law was at `before` and
  /// the rate of the distance v0.
  [[gnu::always_inline]] void set_dissipation(const ContactPoint& now,
                                              const contact::LawPoint& before, double v0,
                                              Arrival& here) const {
    const double change = here.at.damping_integral - before.damping_integral;
    const double square = here.energy_left + 2.0 * inverse_mass_ * std::min(now.rate * change, 0.0);
    const double grid = here.discrete_rate * here.discrete_rate;
    if (std::abs(square - grid) < trusted * grid)
      here.rate = std::copysign(std::sqrt(square), here.discrete_rate);
    const double v = here.rate;
    // -int v dC, v and C as the cubics in time through both ends.
    const double dashpot = here.at.damping * v - before.damping * v0;
    const double force = here.at.force - before.force - dashpot;
    here.dissipated = std::max(
        twelfth_ * (change * inverse_mass_ * force + dashpot * (v - v0)) - 0.5 * change * (v0 + v),
        0.0);
  }

  /// Whether a contact whose distance changes at this rate and acceleration is certain to last for
  /// the step, whatever its load. Between two time levels it may dip below both, by half of the
  /// way at most.
  [[gnu::always_inline]] bool lasts(double overlap, double rate, double acceleration) const {
    const double change = step_ * acceleration;
    const double reach = overlap - lowest_;
    const double next_reach = reach - step_ * (rate + 0.5 * change);
    const double way = step_ * std::max(std::abs(rate), std::abs(rate + change));
    return std::min(reach, next_reach) > way && next_reach > 0.3 * reach;
  }

  /// Whether a sub-step may have ended the contact.
  bool may_part(Overlap before, Overlap after) const {
    return after.x <= lowest_ || (before.v < 0.0 && after.v > 0.0);
  }

  /// A sub-step of Runge and Kutta under a constant acceleration.
  void move(ContactPath& path, double h, double drive) const {
    const auto rate_of = [&](double y, const contact::LawPoint& p) {
      return y - p.damping_integral * inverse_mass_;
    };
    const auto at = [&](double x) { return point(x); };
    const auto push = [&](const contact::LawPoint& p) { return drive - p.force * inverse_mass_; };
    const Overlap start = path.s;
    const contact::LawPoint p1 = path.at;
    const double y = start.v + p1.damping_integral * inverse_mass_;
    const double x1 = start.v, y1 = push(p1);
    const contact::LawPoint p2 = at(start.x + 0.5 * h * x1);
    const double x2 = rate_of(y + 0.5 * h * y1, p2), y2 = push(p2);
    const contact::LawPoint p3 = at(start.x + 0.5 * h * x2);
    const double x3 = rate_of(y + 0.5 * h * y2, p3), y3 = push(p3);
    const contact::LawPoint p4 = at(start.x + h * x3);
    const double x4 = rate_of(y + h * y3, p4), y4 = push(p4);
    path.s.x = start.x + h / 6.0 * (x1 + 2.0 * x2 + 2.0 * x3 + x4);
    path.at = at(path.s.x);
    path.s.v = rate_of(y + h / 6.0 * (y1 + 2.0 * y2 + 2.0 * y3 + y4), path.at);
    if (!is_damped_) return;
    // int v dC, both as parabolas in time.
    const double x_middle = 0.5 * (start.x + path.s.x) + 0.125 * h * (start.v - path.s.v);
    const double v_middle = 1.5 * (path.s.x - start.x) / h - 0.25 * (start.v + path.s.v);
    path.dissipated +=
        std::max(work_of_dashpot(start.v, v_middle, path.s.v, p1.damping_integral,
                                 at(x_middle).damping_integral, path.at.damping_integral),
                 0.0);
  }
  /// int v dC of three points of equal distance, both as parabolas.
  static double work_of_dashpot(double v0, double v1, double v2, double c0, double c1, double c2) {
    return (v0 * (-3.0 * c0 + 4.0 * c1 - c2) + 4.0 * v1 * (c2 - c0) +
            v2 * (c0 - 4.0 * c1 + 3.0 * c2)) /
           6.0;
  }

  /// The way from a place in contact to parting, by the energy; without a speed there: the pair
  /// does not part.
  ContactPath part(const ContactPath& from, double drive) const {
    const double x = from.s.x, way = x - lowest_, speed = std::abs(from.s.v);
    // Twice the kinetic energy per mass where the overlap is `to`, if `lost` was dissipated.
    const auto square_at = [&](double to, double energy, double lost) {
      return speed * speed + 2.0 * inverse_mass_ * (from.at.energy - energy - lost) -
             2.0 * drive * (x - to);
    };
    ContactPath parted{{lowest_, 0.0}, at_lowest_};
    double lost = 0.0;
    if (is_damped_) {
      const double half_way = x - 0.5 * way;
      const contact::LawPoint middle = law_.at(half_way);
      double lost_half = 0.0;
      for (int k = 0; k < 3; k++) {
        const double at_end = std::sqrt(std::max(square_at(lowest_, at_lowest_.energy, lost), 0.0));
        const double half = std::sqrt(std::max(square_at(half_way, middle.energy, lost_half), 0.0));
        lost = -work_of_dashpot(speed, half, at_end, from.at.damping_integral,
                                middle.damping_integral, at_lowest_.damping_integral);
        lost_half = (from.at.damping_integral - middle.damping_integral) * 0.5 * (speed + half);
      }
    }
    const double square = square_at(lowest_, at_lowest_.energy, lost);
    if (!(square > 0.0)) return parted;
    parted.s.v = -std::sqrt(square);
    parted.dissipated = from.dissipated + lost + at_lowest_.energy;
    // int dx/v by three points of Gauss and Legendre.
    constexpr double places[] = {0.1127016653792583, 0.5, 0.8872983346207417};
    constexpr double weights[] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    for (int k = 0; k < 3; k++) {
      const double there = x - places[k] * way;
      const contact::LawPoint p = law_.at(there);
      const double all = from.at.damping_integral - at_lowest_.damping_integral;
      const double part = all > 0.0 ? (from.at.damping_integral - p.damping_integral) / all : 0.0;
      const double v2 = square_at(there, p.energy, part * lost);
      parted.time += v2 > 0.0 ? weights[k] * way / std::sqrt(v2) : step_;
    }
    return parted;
  }

  void record_contact(Overlap& s, const ContactPath& end, double time, double drive,
                      NormalRecord& record) const {
    record.contact_time += time;
    const double friction = friction_load_ - adhesion_;
    record.repulsion_impulse += reduced_mass_ * (drive * time - (end.s.v - s.v)) + friction * time;
    record.repulsion_at_end = end.at.force + end.at.damping * end.s.v + friction;
    record.dissipated += end.dissipated;
    s = end.s;
  }

  Law law_;
  double reduced_mass_;
  double inverse_mass_;
  double adhesion_;  // F_ad
  double pull_;      // F_ad/mu
  double step_;
  double twelfth_;  // of step_
  bool is_damped_;
  double lowest_;  // overlap at which contacts end
  contact::LawPoint at_lowest_;
  double friction_load_;  // what friction has besides spring and dashpot
};

}  // namespace cohesion::contact_solver
