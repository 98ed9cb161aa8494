// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/adhesion.h"
#include "contact/linear_spring_dashpot.h"
#include "event_stepping/damped_oscillator.h"
#include "event_stepping/first_root.h"
#include "event_stepping/grid_point.h"
#include "event_stepping/normal_motion.h"
#include "event_stepping/pair_work.h"

namespace cohesion::event_stepping {

/// Normal motion of one pair in one pass, for engines that compute contacts one after the other:
/// its grid points are exact samples of the motion. Positions x_n at t_n are the true ones, and the
/// velocity of a half step is (x_(n+1) - x_n)/dt.
///
/// In a contact that lasts, the motion about its equilibrium x_e obeys
///
///   x_(n+1) = 2 c x_n - d x_(n-1)    c = exp(-alpha dt) cos(q dt)    d = exp(-2 alpha dt)
///
/// so that one force of the usual form, from what the engine knows at n, is exact at any step:
///
///   f = -K' (x_n - x_e) - eta' v_(n-1/2)    K' = mu (1 + d - 2 c)/dt^2    eta' = mu (1 - d)/dt
///
/// A step in which the pair enters or leaves the range, is captured or turns round in the gap is
/// followed in closed form from the true state at n, under the constant acceleration that others
/// cause, and the force is the one that puts the pair where it is at n+1. Only the true velocity
/// there is not the grid's, and is remembered for one step. What others do then is known as it was
/// a step before; elastic pairs settle in the end what it did to their energy (pair_work.h).
///
/// Forces are central at grid points: angular momentum is kept to rounding. What others do within
/// the step is exact where it is constant; in a lasting contact a load F gives the overlap F/K' in
/// the place of F/K, and can be borne up to (K'/K) F_ad. A contact with an adhesion that bears more
/// is resolved within the step, so that it gives way at F_ad.
///
/// Source: derived here, see docs/theory/exact_contacts.md.
class OnePassContact {
 public:
  /// contact_distance [length]: of the centres at touch, or the radius beside a wall; step [time].
  OnePassContact(const contact::LinearSpringDashpot& spring, const contact::Adhesion& adhesion,
                 double contact_distance, double step)
      : OnePassContact(spring, adhesion, contact_distance, step, adhesion.cutoff, adhesion.cutoff) {
  }
  virtual ~OnePassContact() = default;

  double range() const { return range_; }
  double step() const { return step_; }
  /// K' and eta'.
  const GridSpring& spring() const { return spring_; }

  /// Whether anything can happen to a pair in the step that begins here. `others` [length/time^2]:
  /// acceleration of the distance by others.
  bool within_reach(const GridPoint& at, double others) const {
    const double inwards = std::max(-at.radial, 0.0) + std::max(-others, 0.0) * step_;
    return at.distance <= outer_distance() + step_ * inwards;
  }

  /// Whether lasting_force() needs to know the load: one without adhesion bears none.
  bool bears_load() const { return attraction_ > 0.0; }
  /// The acceleration of the distance by all but the contact, its turning included, as it was in
  /// the last step of one that was lasting() then, [length/time^2].
  double last_outward(const GridPoint& at, double last_radial, double last_force) const {
    return (at.radial - last_radial) / step_ - last_force / reduced_mass_;
  }

  /// Gives what a contact does that certainly lasts until the next grid point, under a load that it
  /// can bear. False, where that is not certain. For one that was in contact all through the last
  /// step. `outward`: as last_outward() gives it; any, where it does not bear loads.
  [[gnu::always_inline]] bool lasting_force(const GridPoint& at, double outward,
                                            LastingForce& now) const {
    const double overlap = contact_distance_ - at.distance;
    const double approach = -at.radial;
    const double repulsion = spring_.stiffness * overlap + spring_.damping * approach;
    double next = approach + step_ * (attraction_ - repulsion) / reduced_mass_;
    if (attraction_ > 0.0) {
      if (!(outward < bearable_)) return false;
      next -= step_ * outward;
    }
    // Between two grid points it may dip below both, most where what pulls is constant.
    const double dip = 0.125 * step_ * std::max(next - approach, 0.0);
    const double least = certain * step_ * std::abs(approach) + 2.0 * dip;
    if (!(overlap > least && overlap + step_ * next > least)) return false;
    now = {repulsion - attraction_, repulsion};
    return true;
  }
  /// The same of any pair, with all that a step tells. `others`: as in follow(); any, where it does
  /// not bear loads.
  bool follow_lasting(const GridPoint& at, double others, GridMemory& memory,
                      GridStep& step) const {
    LastingForce now;
    if (!memory.in_contact()) return false;
    if (!lasting_force(at, outward({at.distance, at.radial, at.sideways}, others), now))
      return false;
    if (elastic_ && memory.phase == GridMemory::begun)
      memory.work = work_.before(at, memory) + work_.of_force(now.force, at) + work_.stored(at);
    memory.phase = GridMemory::lasting;
    memory.ahead = at.radial;
    memory.force = now.force;
    step = {};
    step.force = now.force;
    step.repulsion = now.repulsion;
    step.normal.contact_time = step_;
    step.normal.repulsion_impulse = step_ * now.repulsion;
    step.normal.repulsion_at_end = now.repulsion;
    return true;
  }

  /// Follows any step. `others` as above, constant in the step; `kick` [time]: how long the force
  /// acts on the velocity that leads to the next grid point: step(), but half of it in the first
  /// step of a run, whose velocity is that of the grid point itself.
  virtual GridStep follow(const GridPoint& at, double others, double kick,
                          GridMemory& memory) const {
    return follow_by(at, others, kick, memory,
                     [&](Flight& now, bool& inside, NormalRecord& record) {
                       return move(now, others, inside, record);
                     });
  }

  double spring_energy(double overlap) const { return motion_.spring_energy(overlap); }
  virtual double adhesion_energy(double overlap) const { return motion_.adhesion_energy(overlap); }

 protected:
  /// range [length]: gap up to which a pair is inside, the adhesion's or that of a derived law;
  /// entry [length]: gap at which it comes inside.
  OnePassContact(const contact::LinearSpringDashpot& spring, const contact::Adhesion& adhesion,
                 double contact_distance, double step, double range, double entry)
      : motion_(spring, adhesion, step),
        oscillator_(spring.stiffness() / spring.reduced_mass(),
                    0.5 * spring.damping() / spring.reduced_mass()),
        propagator_(oscillator_.propagator(step)),
        contact_distance_(contact_distance),
        range_(range),
        entry_(entry),
        reduced_mass_(spring.reduced_mass()),
        pull_(adhesion.force / spring.reduced_mass()),
        step_(step),
        spring_(oscillator_.on_grid(step, spring.reduced_mass())),
        attraction_(spring_.stiffness * pull_ / oscillator_.w0_squared()),
        weight_(spring.stiffness() / spring_.stiffness),
        bearable_(bearable(spring.restitution())),
        elastic_(spring.damping() == 0.0 && entry == range),
        work_(contact_distance, reduced_mass_, spring_, attraction_, step) {}

  /// A pair flies in, turns and flies out again; more often only by rounding at a grazed edge.
  static constexpr int max_segments = 100;

  /// The true motion within a step; the sideways speed follows from the angular momentum.
  struct Flight {
    double distance, radial, sideways;
  };

  double contact_distance() const { return contact_distance_; }
  double outer_distance() const { return contact_distance_ + range_; }
  double entry_distance() const { return contact_distance_ + entry_; }

  /// The work up to a grid point but that of its own force, of elastic pairs.
  double work_before(const GridPoint& at, const GridMemory& memory) const {
    return elastic_ ? work_.before(at, memory) : 0.0;
  }

  /// A step in which `move` (true: there was an event) does what no lasting contact does.
  template <class Move>
  GridStep follow_by(const GridPoint& at, double others, double kick, GridMemory& memory,
                     Move move) const {
    GridStep step;
    const bool first = kick < step_;
    bool inside = memory.inside();
    // Before the first step of a run nothing has moved.
    const bool stands = (first || memory.is_new) && memory.phase == GridMemory::beyond &&
                        at.stands_within(entry_distance(), first ? 0.0 : step_);
    if (stands) inside = true;
    const GridMemory before = memory;
    const double work = first || stands ? work_at_start(at, inside) : work_before(at, memory);
    Flight now{at.distance, first ? at.radial : true_radial(at, others, memory), at.sideways};
    const Flight start = now;
    const bool lasting = inside && lasts(now, others, step.normal);
    const bool event = !lasting && move(now, inside, step.normal);
    memory = {inside ? GridMemory::within : GridMemory::beyond, 0.0, 0.0, work};
    const bool flies = !lasting && !event;
    if (flies && before.known_by_grid()) {
      if (!inside) memory.work = 0.0;
      return step;  // not to carry the rounding of no change into the force
    }
    // The distance is the pair's; direction and flight across it are the grid's.
    const double across = step_ * at.sideways;
    const double along = std::sqrt(std::max(now.distance * now.distance - across * across, 0.0));
    const double flown = (along - at.distance) / step_;
    step.force = reduced_mass_ * ((flown - at.radial) / kick - others);
    if (flies && elastic_ && !before.inside()) {
      const bool parted = before.phase == GridMemory::parted;
      if (parted) step.force = 0.0;  // but for rounding
      const bool settled = work_.settle(at, others, work, step.force);
      // Others may have changed what the step after the first one does.
      if (!parted || !settled) memory.phase = GridMemory::parted;
    }
    memory.force = step.force;
    if (elastic_)
      memory.work +=
          first ? work_.of_first_force(step.force, at, flown) : work_.of_force(step.force, at);
    // What the grid does later or earlier than the pair counts as the spring's.
    const double true_force =
        reduced_mass_ * ((now.radial - start.radial) / step_ - outward(start, others));
    step.repulsion = step.normal.repulsion_impulse / step_ + step.force - true_force;
    if (lasting) {
      memory.phase = GridMemory::begun;
    } else if (event) {
      memory.phase = inside ? GridMemory::entered : GridMemory::left;
    }
    if (!flies) {
      const double on_grid = (along * flown + across * at.sideways) / now.distance;
      memory.ahead = now.radial - on_grid - 0.5 * step_ * others;
    }
    return step;
  }

  /// Of a pair that stands where it is first seen: what it is to give back is what it has stored.
  double work_at_start(const GridPoint& at, bool inside) const {
    if (!elastic_ || !inside) return 0.0;
    const double overlap = contact_distance_ - at.distance;
    return -spring_energy(overlap) - adhesion_energy(overlap);
  }

  /// The true radial velocity at the grid point: the grid's over the half step before, what others
  /// do in half a step and what was remembered; in a contact of one force the closed form through
  /// the last two grid points.
  double true_radial(const GridPoint& at, double others, const GridMemory& memory) const {
    if (memory.phase != GridMemory::lasting) return at.radial + memory.ahead + 0.5 * step_ * others;
    const double before = std::hypot(at.distance - step_ * at.radial, step_ * at.sideways);
    const double drive = pull_ - weight_ * outward({at.distance, at.radial, at.sideways}, others);
    const double equilibrium = drive / oscillator_.w0_squared();
    const double was = contact_distance_ - before - equilibrium;
    const double is = contact_distance_ - at.distance - equilibrium;
    const double rate = (is - propagator_.xx * was) / propagator_.xv;
    return -(propagator_.vx * was + propagator_.vv * rate);
  }

  /// Centrifugal acceleration of a turning pair and that by others.
  double outward(const Flight& now, double others) const {
    const double turning = now.distance / contact_distance_ * now.sideways;
    return turning * turning / contact_distance_ + others;
  }
  /// The same in contact. A load L that one which lasts bears acts as there and gives the overlap
  /// L/K': were it another in steps with an event, spheres that bounce under their weight would
  /// gain energy. A contact is not to bear more than F_ad, and a larger load acts as it is.
  double in_contact(double outward) const {
    return outward < bearable_ ? weight_ * outward : outward;
  }
  bool lasts(Flight& now, double others, NormalRecord& record) const {
    Overlap s{contact_distance_ - now.distance, -now.radial};
    double integral = 0.0;
    const double load = in_contact(outward(now, others));
    if (!motion_.advance_lasting(s, step_, load, integral, record)) return false;
    put(now, s);
    return true;
  }

  void put(Flight& now, const Overlap& s) const {
    const double distance = contact_distance_ - s.x;
    now = {distance, -s.v, now.sideways * now.distance / distance};
  }

  /// Follows everything that can happen to a pair in a step; returns whether anything did.
  bool move(Flight& now, double others, bool& inside, NormalRecord& record) const {
    bool event = inside;
    if (!inside) inside = event = starts_inside(now);
    double left = step_;
    for (int segments = 0; left > 0.0; segments++) {
      if (segments == max_segments) {
        record.unresolved = true;
        break;
      }
      if (!inside) {
        left -= fly(now, left, others, inside);
        event = event || inside;
        continue;
      }
      left -= advance_inside(now, left, others, inside, record);
      if (record.unresolved) break;
    }
    return event;
  }

  /// Advances a pair in the range of the adhesion, until it leaves it or the time is over; returns
  /// the time it took.
  double advance_inside(Flight& now, double time, double others, bool& inside,
                        NormalRecord& record) const {
    Overlap s{contact_distance_ - now.distance, -now.radial};
    double integral = 0.0;
    const double load = outward(now, others);
    const double taken =
        motion_.advance(s, time, {load, in_contact(load)}, inside, integral, record);
    put(now, s);
    return taken;
  }

  /// Lets a pair that counts as outside, but was pushed inside, enter where it is, if it approaches
  /// or already overlaps.
  bool starts_inside(Flight& now) const {
    if (now.distance >= entry_distance()) return false;
    if (now.radial >= 0.0 && now.distance >= contact_distance_) return false;
    enter(now);
    return true;
  }

  void enter(Flight& now) const {
    now.radial = -motion_.enter({contact_distance_ - now.distance, -now.radial}).v;
  }

  /// Flies outside the range until its edge is met or the time is over; returns the time it took.
  /// Across the normal the flight is straight; along it `others` act.
  double fly(Flight& now, double time, double others, bool& inside) const {
    const double outer = entry_distance();
    const Flight start = now;
    double t = time;
    if (start.distance >= outer) {
      const double meet =
          first_root(start.distance - outer, start.radial, outward_in_flight(start, others));
      if (meet < time) {
        t = meet;
        inside = true;
      }
    }
    now = inside ? at_meeting(start, t, time, others, outer) : after(start, t, others);
    if (inside) enter(now);
    return t;
  }

  /// Acceleration of the distance as a flight begins.
  static double outward_in_flight(const Flight& start, double others) {
    return others + start.sideways * start.sideways / start.distance;
  }

  /// The flight where it is at `distance`, which it meets after `t`, at most `time`, on a parabola;
  /// that leaves out how the pair turns on its way. Corrects t.
  static Flight at_meeting(const Flight& start, double& t, double time, double others,
                           double distance) {
    Flight now = after(start, t, others);
    const bool in = now.radial < 0.0;
    for (int k = 0; k < 2 && now.radial != 0.0 && in == (now.radial < 0.0); k++) {
      t = std::min(std::max(t + (distance - now.distance) / now.radial, 0.0), time);
      now = after(start, t, others);
    }
    return now;
  }

  static Flight after(const Flight& start, double t, double others) {
    const double along = start.distance + t * (start.radial + 0.5 * t * others);
    const double speed = start.radial + t * others;
    const double across = t * start.sideways;
    const double distance = std::sqrt(along * along + across * across);
    return {distance, (along * speed + across * start.sideways) / distance,
            (along * start.sideways - across * speed) / distance};
  }

 private:
  /// The fraction of the way of a step that a contact must be away from its end to last for
  /// certain.
  static constexpr double certain = 0.1;

  /// Up to which load a contact lasts. Beyond it the overlap at rest is (F_ad - L)/K, where it was
  /// F_ad/K - L/K' before, and the contact begins to swing by the difference. What is left of that
  /// when it is to part shall not part it by a hundredth of F_ad too early: half of that, of a load
  /// that is slow, which takes ten contact times for the last part of its way.
  double bearable(double restitution) const {
    if (!(pull_ > 0.0)) return std::numeric_limits<double>::infinity();
    const double swing = (weight_ - 1.0) * std::pow(restitution, 10.0);
    return pull_ * std::min(1.0 / weight_, swing > 0.005 ? 0.005 / swing : 1.0);
  }

  NormalMotion motion_;
  DampedOscillator oscillator_;
  DampedOscillator::Propagator propagator_;
  double contact_distance_;
  double range_;
  double entry_;
  double reduced_mass_;
  double pull_;
  double step_;
  GridSpring spring_;
  double attraction_;  // that of the adhesion, as spring_ needs it
  double weight_;      // K/K': of a load, on the grid of a contact that lasts
  double bearable_;    // largest load per mu that one which lasts bears, [length/time^2]
  bool elastic_;       // it gives back what it takes
  PairWork work_;
};

}  // namespace cohesion::event_stepping
