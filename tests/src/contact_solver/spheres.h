// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "contact_solver/exact_contact.h"
#include "contact_solver/thesis_contact.h"

namespace cohesion::contact_solver {

/// Few spheres and walls, each in contact with each, stepped as LAMMPS does: positions at time
/// levels, velocities half a step before, the accelerations of the last step. The first step begins
/// with velocities of its time level and has half an impulse.
template <class Solver, int SIZE>
class Spheres {
 public:
  struct Sphere {
    Body body;
    Vector3 x, v, spin{};
    Vector3 acceleration{}, turning{};  ///< by all forces and torques of the last step but impulses
  };
  struct Wall {
    Vector3 place, normal, velocity;  ///< normal: towards the spheres, of length 1
  };
  /// Of sphere i with sphere j, or with wall -1 - j.
  struct Contact {
    int i, j;
    ContactHistory history = ContactHistory::unknown();
    FrictionalStep last{};
    ContactEnergies energies{};
    Vector3 normal_impulse{}, friction{}, by_contact{};  ///< of all steps, on j
  };

  std::vector<Sphere> spheres;
  std::vector<Wall> walls;
  std::vector<Contact> contacts;
  Vector3 gravity{};
  bool exchanges = false;  ///< i and j in every step, with the stored values
  bool recorded = true;    ///< whether energies are asked for
  bool short_path = true;  ///< whether persistent contacts are computed by advance_persistent()
  double lost = 0.0;       ///< so far, in all
  double damped = 0.0;     ///< so far, in dashpots of friction, and in rolling
  double exchanged = 0.0;
  double energy = 0.0;   ///< kinetic, stored and lost, at the time level of the last step
  double kinetic = 0.0;  ///< of the staggered velocities around that time level

  Spheres(const contact::ContactParameters& parameters, const contact::Adhesion& adhesion,
          double step)
      : parameters_(parameters), adhesion_(adhesion), dt_(step) {}

  int add(const Body& body, const Vector3& x, const Vector3& v, const Vector3& spin = {}) {
    const int i = static_cast<int>(spheres.size());
    for (int j = 0; j < i; j++) contacts.push_back({j, i});
    spheres.push_back({body, x, v, spin});
    return i;
  }
  /// After all spheres.
  void add_wall(const Wall& wall) {
    walls.push_back(wall);
    const int number = static_cast<int>(walls.size());
    for (int i = 0; i < static_cast<int>(spheres.size()); i++) contacts.push_back({i, -number});
  }

  void step() {
    if (!first_) drift();
    const double length = first_ ? 0.5 * dt_ : dt_;
    std::vector<Sphere> next = spheres;
    for (Sphere& s : next) s.acceleration = s.turning = {};
    double stored = 0.0, in_plane = 0.0;
    for (Contact& c : contacts) {
      if (exchanges && c.j >= 0) exchange(c);
      const PairMotion now = motion(c);
      const ExactContact<Solver>& law = this->law(c);
      double before[SIZE], values[SIZE];
      c.history.store(before, SIZE);
      c.history.store(values, SIZE);
      c.last = {};
      c.energies = {};
      const Vector3 acceleration = relative_acceleration(c);
      if (last_dt_ != dt_) law.change_step(last_dt_, now, acceleration, c.history);
      ContactEnergies* const energies = recorded ? &c.energies : nullptr;
      if (short_path && !first_ && last_dt_ == dt_ && c.j >= 0 &&
          law.template advance_persistent<SIZE, ContactMotion>(InSteps{now}, values, c.last,
                                                               energies)) {
        c.history = ContactHistory::stored(values, SIZE);
        if (recorded) c.energies.stored = law.template stored_persistent<SIZE>(now, before, values);
      } else {
        c.last = law.template advance<SIZE>(now, acceleration, first_, c.history, energies);
      }
      count(law, now, c);
      const double inverse = 1.0 / length;
      const FrictionalStep& a = c.last;
      push(c, a, next);
      PairAction steady = a;
      steady.impulse -= c.last.at_edge;
      accelerate(c, steady, inverse, next);
      normal_lost_ += c.energies.before.normal_damping;
      damped += c.energies.before.tangential_damping + c.energies.before.rolling;
      exchanged += c.energies.exchanged;
      stored += c.energies.stored.spring + c.energies.stored.adhesion + c.energies.stored.load;
      in_plane += c.energies.stored.tangential_spring + c.energies.stored.rolling_spring;
    }
    for (Sphere& s : next)
      if (s.body.inverse_mass > 0.0) {
        s.v += length * gravity;
        s.acceleration += gravity;
      }
    const double power = friction_work(spheres), power_after = friction_work(next);
    friction_work_ += first_ ? 0.0 : 0.5 * power;
    lost = normal_lost_ - friction_work_ - in_plane;
    sum_up(first_ ? spheres : next, stored + in_plane);
    friction_work_ += 0.5 * (first_ ? power + power_after : power_after);
    spheres = next;
    for (const Contact& c : contacts) {
      normal_lost_ += c.energies.after.normal_damping;
      lost += c.energies.after.normal_damping;
      damped += c.energies.after.tangential_damping + c.energies.after.rolling;
    }
    last_dt_ = dt_;
    first_ = false;
  }
  void steps(int number) {
    for (int n = 0; n < number; n++) step();
  }
  /// Other steps from here on: half of each force of the last one acts for the new length.
  void change_step(double step) {
    for (Sphere& s : spheres) {
      s.v += 0.5 * (step - dt_) * s.acceleration;
      s.spin += 0.5 * (step - dt_) * s.turning;
    }
    dt_ = step;
    laws_.clear();
  }

  double dt() const { return dt_; }
  const ExactContact<Solver>& law(const Contact& c) {
    const Body& i = spheres[c.i].body;
    const Body j = c.j < 0 ? Body{0.0, 0.0} : spheres[c.j].body;
    for (const auto& law : laws_)
      if (law.is_between(i, j)) return law;
    laws_.emplace_back(parameters_, adhesion_, i, j, dt_);
    return laws_.back();
  }
  PairMotion motion(const Contact& c) const {
    const Sphere& i = spheres[c.i];
    if (c.j >= 0) {
      const Sphere& j = spheres[c.j];
      return {j.x - i.x, j.v - i.v, i.spin, j.spin};
    }
    const Wall& wall = walls[-1 - c.j];
    return {-dot(i.x - wall.place, wall.normal) * wall.normal, wall.velocity - i.v, i.spin, {}};
  }

  Vector3 momentum() const {
    Vector3 total;
    for (const Sphere& s : spheres) total += (1.0 / s.body.inverse_mass) * s.v;
    return total;
  }
  Vector3 angular_momentum() const {
    Vector3 total;
    for (const Sphere& s : spheres)
      total +=
          (1.0 / s.body.inverse_mass) * cross(s.x, s.v) + (1.0 / inverse_inertia(s.body)) * s.spin;
    return total;
  }
  /// Of the staggered motion, as of spheres that fly.
  double kinetic_energy() const { return kinetic_of(spheres); }
  bool any_in_range() const {
    for (const Contact& c : contacts)
      if (c.history.normal.in_range()) return true;
    return false;
  }
  /// All contacts are over, nothing is pending.
  bool are_apart() const {
    for (const Contact& c : contacts)
      if (c.history.normal.phase != ContactState::outside) return false;
    return true;
  }

 private:
  /// A PairMotion as ExactContact::advance_persistent() reads it.
  struct InSteps {
    const PairMotion& now;
    Vector3 separation() const { return now.separation; }
    Vector3 velocity() const { return now.velocity; }
    Vector3 spin_i() const { return now.spin_i; }
    Vector3 spin_j() const { return now.spin_j; }
  };
  void drift() {
    for (Sphere& s : spheres) s.x += dt_ * s.v;
    for (Wall& wall : walls) wall.place += dt_ * wall.velocity;
  }
  /// As engines do that store a contact as of j and i.
  static void exchange(Contact& c) {
    double values[SIZE];
    c.history.store(values, SIZE);
    for (double& value : values) value = -value;
    ContactState::restore_signs(values);
    c.history = ContactHistory::stored(values, SIZE);
    std::swap(c.i, c.j);
  }
  Vector3 relative_acceleration(const Contact& c) const {
    const Vector3 of_j = c.j < 0 ? Vector3{} : spheres[c.j].acceleration;
    return of_j - spheres[c.i].acceleration;
  }
  static void push(const Contact& c, const PairAction& a, std::vector<Sphere>& to) {
    Sphere& i = to[c.i];
    i.v -= i.body.inverse_mass * a.impulse;
    i.spin += inverse_inertia(i.body) * a.torque_i;
    if (c.j < 0) return;
    Sphere& j = to[c.j];
    j.v += j.body.inverse_mass * a.impulse;
    j.spin += inverse_inertia(j.body) * a.torque_j;
  }
  static void accelerate(const Contact& c, const PairAction& a, double inverse,
                         std::vector<Sphere>& to) {
    Sphere& i = to[c.i];
    i.acceleration -= (inverse * i.body.inverse_mass) * a.impulse;
    i.turning += (inverse * inverse_inertia(i.body)) * a.torque_i;
    if (c.j < 0) return;
    Sphere& j = to[c.j];
    j.acceleration += (inverse * j.body.inverse_mass) * a.impulse;
    j.turning += (inverse * inverse_inertia(j.body)) * a.torque_j;
  }
  static void count(const ExactContact<Solver>& law, const PairMotion& now, Contact& c) {
    c.by_contact += law.by_contact(now, c.last);
    c.friction += c.last.friction;
    c.normal_impulse += c.last.impulse - c.last.friction;
  }
  /// With the kinetic energy of the staggered velocities before and after the time level.
  void sum_up(const std::vector<Sphere>& next, double stored) {
    double potential = 0.0;
    for (const Sphere& s : spheres)
      if (s.body.inverse_mass > 0.0) potential -= dot(gravity, s.x) / s.body.inverse_mass;
    kinetic = 0.0;
    for (std::size_t i = 0; i < spheres.size(); i++)
      kinetic +=
          kinetic_energy(spheres[i].body, spheres[i].v, next[i].v, spheres[i].spin, next[i].spin);
    energy = kinetic + stored + exchanged + potential + lost;
  }
  static double kinetic_of(const std::vector<Sphere>& all) {
    double total = 0.0;
    for (const Sphere& s : all) total += kinetic_energy(s.body, s.v, s.v, s.spin, s.spin);
    return total;
  }
  static double kinetic_energy(const Body& body, const Vector3& before, const Vector3& after,
                               const Vector3& spin_before, const Vector3& spin_after) {
    if (body.inverse_mass == 0.0) return 0.0;
    return 0.5 / body.inverse_mass * dot(before, after) +
           0.5 / inverse_inertia(body) * dot(spin_before, spin_after);
  }
  /// Of all contacts on the spheres, with the velocities of `all`.
  double friction_work(const std::vector<Sphere>& all) const {
    double done = 0.0;
    for (const Contact& c : contacts) {
      const Sphere& i = all[c.i];
      const FrictionalStep& a = c.last;
      const Vector3 partner = c.j < 0 ? walls[-1 - c.j].velocity : all[c.j].v;
      done += dot(c.last.friction, partner - i.v) + dot(a.torque_i, i.spin);
      if (c.j >= 0) done += dot(a.torque_j, all[c.j].spin);
    }
    return done;
  }

  contact::ContactParameters parameters_;
  contact::Adhesion adhesion_;
  double dt_;
  double last_dt_ = dt_;
  bool first_ = true;
  double normal_lost_ = 0.0, friction_work_ = 0.0;
  std::vector<ExactContact<Solver>> laws_;
};

/// Of two spheres of the thesis' particle that are to meet the distance `edge` head-on or with a
/// speed across, `wait` after the first time level.
template <class Solver, int SIZE>
Spheres<Solver, SIZE> meeting(const contact::ContactParameters& parameters,
                              const contact::Adhesion& adhesion, double step, double edge,
                              double speed, double across, double wait) {
  Spheres<Solver, SIZE> pair(parameters, adhesion, step);
  pair.add(thesis::particle(), {}, {});
  pair.add(thesis::particle(), {edge + wait * speed, -wait * across, 0.0}, {-speed, across, 0.0});
  return pair;
}

}  // namespace cohesion::contact_solver
