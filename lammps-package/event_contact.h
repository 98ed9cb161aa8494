// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_EVENT_CONTACT_H
#define COHESION_EVENT_CONTACT_H

#include "atom.h"
#include "event_stepping/cohesive_contact.h"
#include "fix_event_step.h"

// What pairs and walls of the event scheme share: following a contact the second time, and handing
// what it does on to the engine.

namespace LAMMPS_NS {

inline cohesion::Vector3 vector(const double* a) { return {a[0], a[1], a[2]}; }

inline void add(double* to, double factor, const cohesion::Vector3& a) {
  to[0] += factor * a.x;
  to[1] += factor * a.y;
  to[2] += factor * a.z;
}

/// What a contact does in a step, with the others and friction.
struct FollowedContact {
  cohesion::event_stepping::PairStep normal;
  cohesion::event_stepping::FrictionStep sliding;
  cohesion::Vector3 impulse;  // on j
};

/// The first pass: a contact by itself.
struct LoneContact {
  cohesion::event_stepping::PairStep normal;
  cohesion::event_stepping::PairMotion change;  // friction included
};

/// `history` is the in-range flag and, with friction, the memory of the tangential spring.
template <class Contact>
LoneContact follow_by_itself(const Contact& c, const cohesion::event_stepping::PairMotion& grid,
                             bool friction, const double* history) {
  LoneContact alone{c.advance(grid.relative, history[0] != 0.0), {}};
  alone.change.relative = alone.normal.change;
  if (friction && alone.normal.normal.contact_time > 0.0) {
    const auto sliding = c.friction(grid, {}, alone.normal, vector(history + 1));
    alone.change.relative.velocity += (1.0 / c.reduced_mass()) * sliding.spring.impulse;
    alone.change.spin_i = c.spin_share_i() * sliding.torque_i;
    alone.change.spin_j = c.spin_share_j() * sliding.torque_j;
  }
  return alone;
}

/// Adds what a contact does alone to its particle i (side -1) or j (side 1).
inline void add_alone(double* to, double side, double share, const LoneContact& alone) {
  add(to, side * share, alone.change.relative.separation);
  add(to + 3, side * share, alone.change.relative.velocity);
  add(to + 6, 1.0, side < 0.0 ? alone.change.spin_i : alone.change.spin_j);
}

/// What all contacts but this one do to its particles; nullptr: a wall.
inline cohesion::event_stepping::PairMotion others_of(const double* all_i, const double* all_j,
                                                      const LoneContact& alone) {
  const auto of_j = [&](int k) { return all_j ? vector(all_j + k) : cohesion::Vector3{}; };
  const cohesion::event_stepping::PairMotion& own = alone.change;
  return {{of_j(0) - vector(all_i) - own.relative.separation,
           of_j(3) - vector(all_i + 3) - own.relative.velocity},
          vector(all_i + 6) - own.spin_i,
          of_j(6) - own.spin_j};
}

/// The second pass: with half of what the other contacts of its particles do, `others`.
template <bool FRICTION, class Contact>
FollowedContact follow_with_others(const Contact& c,
                                   const cohesion::event_stepping::PairMotion& grid,
                                   const LoneContact& alone,
                                   const cohesion::event_stepping::PairMotion& others,
                                   double* history) {
  FollowedContact now{alone.normal, {}, {}};
  const cohesion::event_stepping::RelativeState& pushed = others.relative;
  if (dot(pushed.separation, pushed.separation) > 0.0 ||
      dot(pushed.velocity, pushed.velocity) > 0.0) {
    const cohesion::event_stepping::RelativeState middle{
        grid.relative.separation + 0.5 * pushed.separation,
        grid.relative.velocity + 0.5 * pushed.velocity};
    now.normal = c.advance(middle, history[0] != 0.0);
  }
  now.impulse = c.reduced_mass() * now.normal.change.velocity;
  if (FRICTION) {
    if (now.normal.normal.contact_time > 0.0) {
      now.sliding = c.friction(grid, others, now.normal, vector(history + 1));
      now.impulse += now.sliding.spring.impulse;
    }
    const cohesion::Vector3& memory = now.sliding.memory;
    history[1] = memory.x;
    history[2] = memory.y;
    history[3] = memory.z;
  }
  history[0] = now.normal.inside;
  return now;
}

/// Forces, torques, changes of position and the energy book of one step.
class ContactScatter {
 public:
  ContactScatter(Atom* atom, FixEventStep* step)
      : step_(step), f_(atom->f), torque_(atom->torque), kick_(step->force_per_impulse()) {}

  /// Force that stands for an impulse.
  double kick() const { return kick_; }

  template <bool FRICTION>
  void on_i(int i, double share, const FollowedContact& c) const {
    act(i, -1.0, share, c);
    if (FRICTION) add(torque_[i], kick_, c.sliding.torque_i);
  }
  template <bool FRICTION>
  void on_j(int j, double share, const FollowedContact& c) const {
    act(j, 1.0, share, c);
    if (FRICTION) add(torque_[j], kick_, c.sliding.torque_j);
  }

  /// `part`: of the contact that this process accounts for.
  template <class Contact>
  void book(const Contact& contact, double part, const FollowedContact& c) const {
    FixEventStep::Book& book = step_->book;
    if (c.normal.normal.unresolved) book.unresolved++;
    if (!book.kept) return;
    book.spring += part * contact.spring_energy(c.normal);
    book.adhesion += part * contact.adhesion_energy(c.normal);
    book.tangential_spring += part * contact.friction_energy(c.sliding.spring.displacement);
    book.normal_damping += part * c.normal.normal.dissipated;
    book.tangential_damping += part * c.sliding.spring.damped;
    book.friction += part * c.sliding.spring.friction;
  }

 private:
  void act(int i, double side, double share, const FollowedContact& c) const {
    const double kick = side * kick_;
    add(f_[i], kick, c.impulse);
    add(step_->shift[i], side * share, c.normal.change.separation);
    if (step_->book.kept)
      step_->note_force(i, kick * c.impulse.x, kick * c.impulse.y, kick * c.impulse.z);
  }

  FixEventStep* step_;
  double** f_;
  double** torque_;
  double kick_;
};

}  // namespace LAMMPS_NS

#endif
