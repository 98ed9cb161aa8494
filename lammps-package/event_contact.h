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

/// The second pass: with half of what the other contacts of its particles do (`others`, j relative
/// to i). `history` is the in-range flag and, with friction, the memory of the tangential spring.
template <bool FRICTION, class Contact>
FollowedContact follow_with_others(const Contact& c, cohesion::event_stepping::RelativeState grid,
                                   const cohesion::event_stepping::PairStep& alone,
                                   const cohesion::event_stepping::RelativeState& others,
                                   const cohesion::Vector3& spin_i, const cohesion::Vector3& spin_j,
                                   double* history) {
  FollowedContact now{alone, {}, {}};
  const cohesion::Vector3 velocity = grid.velocity;
  if (dot(others.separation, others.separation) > 0.0 ||
      dot(others.velocity, others.velocity) > 0.0) {
    grid.separation += 0.5 * others.separation;
    grid.velocity += 0.5 * others.velocity;
    now.normal = c.advance(grid, history[0] != 0.0);
  }
  now.impulse = c.reduced_mass() * now.normal.change.velocity;
  if (FRICTION) {
    if (now.normal.normal.contact_time > 0.0) {
      now.sliding = c.friction(grid, velocity, now.normal, spin_i, spin_j, vector(history + 1));
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
