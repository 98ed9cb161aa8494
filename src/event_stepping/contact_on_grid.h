// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "event_stepping/cohesive_contact.h"
#include "event_stepping/damped_oscillator.h"

namespace cohesion::event_stepping {

/// What is remembered of a contact from one grid point to the next.
struct ContactMemory {
  /// `beyond`: out of range, known by the grid. `inside`, `left`: in range or out of it after a
  /// step that was followed. `lasting`: in contact after a step of one force, known by the grid.
  enum Phase { beyond, inside, left, lasting };
  Phase phase = beyond;
  double age = 0.0;  ///< steps since anything but lasting contact happened to it
  double ahead =
      0.0;           ///< true radial velocity over the grid's, after a followed step, [length/time]
  Vector3 spring{};  ///< of friction: stretch at the grid point before, [length]
  Vector3 carried{};  ///< impulse of friction that acted already, its force not, [momentum]

  bool in_range() const { return phase == inside || phase == lasting; }
};

/// What a contact does to its particles: the impulse acts on j, its reverse on i.
struct Action {
  Vector3 impulse{};   ///< [momentum]
  Vector3 torque_i{};  ///< angular impulses, [momentum length]
  Vector3 torque_j{};
};

/// What a followed contact does from one grid point to the next.
struct FollowedStep {
  PairStep normal;  ///< along the normal
  contact::TangentialStep sliding;
  Vector3 mean;       ///< velocity of the surfaces in contact, [length/time]
  PairMotion change;  ///< D, V and changes of the spins
};

/// One contact among others, with grid points as exact samples of the motion: positions x_n are the
/// true ones at t_n, velocities of a half step are (x_(n+1) - x_n)/dt.
///
/// A contact that lasts needs one force of the usual form with the constants of GridSpring. A step
/// with an event, and a young contact, are followed in closed form from the true velocities at t_n,
/// first alone, then with half of what the others of both particles do before it and half after.
/// Of what the contact does in the step, D to the separation and V to its rate, the force at t_n
/// does D; what V is more than D/dt is remembered and leads to the true velocity at t_(n+1).
///
/// Pair: SpherePair, PlanePair or WellPair.
template <class Pair>
class ContactOnGrid {
 public:
  using Attraction = typename Pair::Attraction;

  /// step [time].
  ContactOnGrid(const contact::ContactParameters& parameters, const Attraction& attraction,
                const Body& i, const Body& j, double step)
      : i_(i),
        j_(j),
        step_(step),
        inverse_mass_(i.inverse_mass + j.inverse_mass),
        reduced_mass_(1.0 / inverse_mass_),
        lever_i_(j.radius > 0.0 ? i.radius / (i.radius + j.radius) : 0.0),
        spin_share_i_(inverse_inertia(i)),
        spin_share_j_(inverse_inertia(j)),
        contact_distance_(i.radius + j.radius),
        normal_contact_(contact::normal_contact(parameters, reduced_mass_)),
        pair_(normal_contact_, attraction, contact_distance_, step),
        oscillator_(normal_contact_.stiffness() * inverse_mass_,
                    0.5 * normal_contact_.damping() * inverse_mass_),
        propagator_(oscillator_.propagator(step)),
        spring_(oscillator_.on_grid(step, reduced_mass_)),
        pull_(attraction.force),
        tangential_parameters_(contact::tangential_contact(parameters, normal_contact_)),
        tangential_(tangential_parameters_),
        youth_(std::ceil(2.5 * normal_contact_.contact_time() / step)) {
    const double answer = this->answer(contact_distance_ * contact_distance_);
    tangential_spring_ = spring_on_grid(tangential_parameters_.stiffness,
                                        tangential_parameters_.damping, 1.0 / answer, step);
  }

  bool joins(const Body& i, const Body& j) const { return i == i_ && j == j_; }
  double reduced_mass() const { return reduced_mass_; }
  double share_i() const { return reduced_mass_ * i_.inverse_mass; }
  double share_j() const { return reduced_mass_ * j_.inverse_mass; }
  double spin_share_i() const { return spin_share_i_; }
  double spin_share_j() const { return spin_share_j_; }
  const Pair& pair() const { return pair_; }

  bool within_reach(const RelativeState& grid) const {
    return pair_.within_reach(grid, {0.0, 2.0 * step_});
  }

  /// The force times dt of a contact that is old enough and certainly lasts. False, and nothing
  /// done, where that is not certain.
  template <bool FRICTION>
  bool follow_lasting(const PairMotion& grid, ContactMemory& memory, Action& action) const {
    if (!memory.in_range() || memory.age < youth_) return false;
    const Sample at(*this, grid.relative);
    const double overlap = contact_distance_ - at.distance;
    if (!(overlap > 0.0)) return false;
    const double before = at.straight + 0.5 * at.turning / at.straight;
    const double next = at.next(*this, before);
    const double change = (next - 0.5 * at.turning / next - at.distance) / step_ - at.radial;
    const double closing = -at.radial - change - at.turning / (step_ * at.distance);
    const double end = overlap + step_ * closing;
    const double margin = certain * step_ * std::abs(at.radial);
    if (!(end > margin && overlap - step_ * std::max(at.radial, 0.0) > 0.0 &&
          end - step_ * std::max(closing, 0.0) > 0.0))
      return false;
    const Vector3 normal = (1.0 / at.distance) * grid.relative.separation;
    const double repulsion = reduced_mass_ * change / step_ + pull_;
    action = {(reduced_mass_ * change) * normal, {}, {}};
    memory.phase = ContactMemory::lasting;
    memory.age += 1.0;
    if (FRICTION) {
      memory.carried = rub(grid, repulsion, memory.spring);
      act(grid.relative.separation, memory.carried, action);
    }
    return true;
  }

  /// Radial velocity of the true motion over that of the grid.
  double ahead(const RelativeState& grid, const ContactMemory& memory) const {
    if (memory.phase != ContactMemory::lasting) return memory.ahead;
    const Sample at(*this, grid);
    return at.true_rate(*this) - at.radial;
  }

  /// What leads from the motion on the grid to the true one at this grid point.
  Action owed(const RelativeState& grid, const ContactMemory& memory) const {
    const double radial = ahead(grid, memory);
    Action owed{(radial * reduced_mass_ / norm(grid.separation)) * grid.separation, {}, {}};
    act(grid.separation, 0.5 * memory.carried, owed);
    return owed;
  }

  /// What a contact of one force does in the step, for those beside it.
  PairMotion done(const PairMotion& grid, const Action& action, const Action& owed,
                  const ContactMemory& memory) const {
    PairMotion next = grid;
    next.relative.velocity += inverse_mass_ * action.impulse;
    next.relative.separation += step_ * next.relative.velocity;
    const Action later = this->owed(next.relative, memory);
    PairMotion change;
    change.relative.separation = (step_ * inverse_mass_) * (action.impulse - owed.impulse);
    change.relative.velocity = inverse_mass_ * (action.impulse - owed.impulse + later.impulse);
    change.spin_i = spin_share_i_ * (action.torque_i - owed.torque_i + later.torque_i);
    change.spin_j = spin_share_j_ * (action.torque_j - owed.torque_j + later.torque_j);
    return change;
  }

  /// A step of any kind from the true motion at the grid point. `others`: D, V and spins of all
  /// other contacts of both particles (zero in the first pass). `stretch`: stretch() of the grid.
  template <bool FRICTION>
  FollowedStep follow(const PairMotion& truth, const PairMotion& others,
                      const ContactMemory& memory, const Vector3& stretch) const {
    const Vector3 v = truth.relative.velocity, by_others = others.relative.velocity;
    const Vector3 shift = others.relative.separation - 0.5 * step_ * by_others;
    const RelativeState middle{truth.relative.separation + 0.5 * step_ * v + 0.5 * shift,
                               v + 0.5 * by_others};
    const double half = 0.5 * step_;
    FollowedStep f;
    f.normal = pair_.advance(middle, {half, half}, memory.in_range());
    const RelativeState& did = f.normal.change;
    f.change.relative = {did.separation + half * did.velocity, did.velocity};
    if (!FRICTION || f.normal.normal.contact_time == 0.0) return f;
    const Vector3 r = middle.separation + did.separation;
    const double square = dot(r, r);
    const contact::Plane plane{r, 1.0 / square};
    const double lever_i = this->lever_i(square);
    const Vector3 u =
        surface_velocity(plane, lever_i, middle.velocity + 0.5 * did.velocity,
                         truth.spin_i + 0.5 * others.spin_i, truth.spin_j + 0.5 * others.spin_j);
    const double answer = this->answer(square);
    const Vector3 start = dot(stretch, stretch) > 0.0 ? plane.turned_into(stretch) : Vector3{};
    f.sliding =
        tangential_.advance(start, u, f.normal.normal.contact_time, answer,
                            f.normal.normal.repulsion_impulse, f.normal.normal.repulsion_at_end);
    f.mean = u + (0.5 * answer) * f.sliding.impulse;
    const Vector3& impulse = f.sliding.impulse;
    f.change.relative.separation += (half * inverse_mass_) * impulse;
    f.change.relative.velocity += inverse_mass_ * impulse;
    const Vector3 turn = cross(r, impulse);
    f.change.spin_i = (-lever_i * spin_share_i_) * turn;
    f.change.spin_j = (-(1.0 - lever_i) * spin_share_j_) * turn;
    return f;
  }

  /// The force times dt that does what `f`, followed with `others`, does; remembers the rest.
  template <bool FRICTION>
  Action close(const PairMotion& grid, const PairMotion& truth, const PairMotion& others,
               const FollowedStep& f, ContactMemory& memory) const {
    const double ahead = this->ahead(grid.relative, memory);
    const RelativeState& did = f.normal.change;
    const Vector3 along_normal = did.separation + (0.5 * step_) * did.velocity;
    const Vector3 sliding = inverse_mass_ * f.sliding.impulse;
    const Vector3& s = truth.relative.separation;
    const double distance = norm(s);
    const Vector3 k = (1.0 / distance) * s;
    const Vector3 far =
        s + step_ * truth.relative.velocity + others.relative.separation + (0.5 * step_) * sliding;
    const Vector3 end = far + along_normal;
    const double along = dot(far, k);
    const Vector3 across = far - along * k;
    const double square = dot(end, end);
    const double push = std::sqrt(std::max(square - dot(across, across), 0.0)) - along;
    const bool event = eventful(memory, f.normal);
    Action action{(reduced_mass_ * (push / step_ + ahead)) * k, {}, {}};
    if (!event && memory.phase == ContactMemory::beyond) action.impulse = {};
    if (FRICTION) {
      act(s, 0.5 * (f.sliding.impulse + memory.carried), action);
      memory.carried = f.sliding.impulse;
      memory.spring = {};
      if (f.normal.overlap_at_end > 0.0) memory.spring = f.sliding.displacement - step_ * f.mean;
    }
    const bool was_in = memory.in_range();
    memory.ahead = 0.0;
    if (event || f.normal.inside) {
      const double reached = std::sqrt(square);
      const Vector3 k_end = (1.0 / reached) * (far + push * k);
      const Vector3 without = truth.relative.velocity + others.relative.velocity + sliding;
      memory.ahead = dot(end, without + did.velocity) / reached - dot(k_end, without) -
                     push / step_ * dot(k_end, k);
    }
    memory.age = event || !was_in ? 0.0 : memory.age + 1.0;
    memory.phase = f.normal.inside ? ContactMemory::inside
                   : event         ? ContactMemory::left
                                   : ContactMemory::beyond;
    return action;
  }

  /// Stretch of the spring of friction at this grid point, in its plane, [length].
  Vector3 stretch(const PairMotion& grid, const Vector3& spring) const {
    if (dot(spring, spring) == 0.0) return {};
    const Vector3& r = grid.relative.separation;
    const double square = dot(r, r);
    const contact::Plane plane{r, 1.0 / square};
    return plane.turned_into(spring) + step_ * surface_velocity(plane, lever_i(square),
                                                                grid.relative.velocity, grid.spin_i,
                                                                grid.spin_j);
  }

 private:
  /// Of the way of a step that the predicted overlap must be more than.
  static constexpr double certain = 0.1;
  static constexpr double rounding = 1e-9;

  /// The grid point as the recursion needs it.
  struct Sample {
    double distance, radial;
    double turning;   // dt^2 times the square of the speed across
    double straight;  // distance one step before, but for the way across
    double rest;      // overlap at which spring, adhesion and turning balance

    Sample(const ContactOnGrid& c, const RelativeState& grid) {
      distance = norm(grid.separation);
      radial = dot(grid.separation, grid.velocity) / distance;
      const double square = dot(grid.velocity, grid.velocity) - radial * radial;
      const double side = c.j_.radius > 0.0 ? std::max(square, 0.0) : 0.0;
      turning = side * c.step_ * c.step_;
      straight = distance - c.step_ * radial;
      const double leverage = distance / c.contact_distance_;
      rest = (c.pull_ * c.inverse_mass_ - leverage * leverage * side / c.contact_distance_) /
             c.oscillator_.w0_squared();
    }

    double next(const ContactOnGrid& c, double before) const {
      const double trace = c.propagator_.xx + c.propagator_.vv;
      const double lost = 1.0 - c.spring_.damping * c.step_ * c.inverse_mass_;
      const double contact = c.contact_distance_ - rest;
      return contact - trace * (contact - distance) + lost * (contact - before);
    }

    double true_rate(const ContactOnGrid& c) const {
      const double contact = c.contact_distance_ - rest;
      const double before = contact - std::sqrt(straight * straight + turning);
      const double rate = (contact - distance - c.propagator_.xx * before) / c.propagator_.xv;
      return -(c.propagator_.vx * before + c.propagator_.vv * rate);
    }
  };

  /// Whether anything but lasting contact, or flight out of range, happened in a step.
  bool eventful(const ContactMemory& memory, const PairStep& normal) const {
    if (memory.in_range()) return normal.normal.contact_time < (1.0 - rounding) * step_;
    return normal.inside || dot(normal.change.velocity, normal.change.velocity) > 0.0;
  }

  /// Friction of a contact of one force, [momentum]; `spring` as remembered, before and after.
  Vector3 rub(const PairMotion& grid, double repulsion, Vector3& spring) const {
    const Vector3& r = grid.relative.separation;
    const double square = dot(r, r);
    const contact::Plane plane{r, 1.0 / square};
    const Vector3 u =
        surface_velocity(plane, lever_i(square), grid.relative.velocity, grid.spin_i, grid.spin_j);
    spring = (dot(spring, spring) > 0.0 ? plane.turned_into(spring) : Vector3{}) + step_ * u;
    Vector3 force = -tangential_spring_.stiffness * spring - tangential_spring_.damping * u;
    const double limit = tangential_parameters_.friction * std::max(repulsion, 0.0);
    const double held = norm(force);
    if (held > limit) {
      force = (limit / held) * force;
      if (tangential_spring_.stiffness > 0.0)
        spring = (-1.0 / tangential_spring_.stiffness) * (force + tangential_spring_.damping * u);
    }
    return step_ * force;
  }

  /// Adds a tangential impulse on j at the point of contact.
  void act(const Vector3& separation, const Vector3& impulse, Action& action) const {
    const double lever_i = this->lever_i(dot(separation, separation));
    const Vector3 turn = cross(separation, impulse);
    action.impulse += impulse;
    action.torque_i -= lever_i * turn;
    action.torque_j -= (1.0 - lever_i) * turn;
  }

  /// Inverse mass that answers a tangential impulse.
  double answer(double square) const {
    const double i = lever_i(square), j = 1.0 - i;
    return inverse_mass_ + square * (i * i * spin_share_i_ + j * j * spin_share_j_);
  }

  static Vector3 surface_velocity(const contact::Plane& plane, double lever_i,
                                  const Vector3& velocity, const Vector3& spin_i,
                                  const Vector3& spin_j) {
    return plane.part_in(velocity -
                         cross(lever_i * spin_i + (1.0 - lever_i) * spin_j, plane.normal));
  }
  double lever_i(double square) const {
    return j_.radius > 0.0 ? lever_i_ : i_.radius / std::sqrt(square);
  }

  Body i_;
  Body j_;
  double step_;
  double inverse_mass_;
  double reduced_mass_;
  double lever_i_;
  double spin_share_i_;
  double spin_share_j_;
  double contact_distance_;
  contact::LinearSpringDashpot normal_contact_;
  Pair pair_;
  DampedOscillator oscillator_;
  DampedOscillator::Propagator propagator_;
  GridSpring spring_;
  double pull_;
  contact::TangentialParameters tangential_parameters_;
  contact::TangentialSpring tangential_;
  GridSpring tangential_spring_;
  double youth_;
};

}  // namespace cohesion::event_stepping
