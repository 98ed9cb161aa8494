// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_EVENT_CONTACT_H
#define COHESION_EVENT_CONTACT_H

#include "atom.h"
#include "event_stepping/cohesive_contact.h"
#include "fix_event_step.h"

// What pairs and walls of the event scheme share: following a contact the second time, and handing
// what it does on to the engine.
//
// Here, and where the laws of a step are, local variables of a struct type are not `const`: GCC 12
// keeps such in memory, the others in registers, which costs a sampled contact a tenth.

namespace LAMMPS_NS {

using cohesion::vector;

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

/// `history` of a contact: the in-range flag; with friction or rolling friction, the memory of the
/// tangential spring; with rolling friction, that of the rolling spring.
enum HistorySize { IN_RANGE = 1, WITH_FRICTION = 4, WITH_ROLLING = 7 };

template <bool FRICTION>
cohesion::Vector3 spring_memory(const double* history) {
  return FRICTION ? vector(history + 1) : cohesion::Vector3{};
}

/// The first pass: adds what a contact does alone, `change`, to its particle i (side -1) or j
/// (side 1).
template <bool FRICTION>
void add_alone(double* to, double side, double share,
               const cohesion::event_stepping::PairMotion& change) {
  add(to, side * share, change.relative.separation);
  add(to + 3, side * share, change.relative.velocity);
  if (FRICTION) add(to + 6, 1.0, side < 0.0 ? change.spin_i : change.spin_j);
}

/// What all contacts but this one do to its particles; nullptr: a wall.
template <bool FRICTION>
cohesion::event_stepping::PairMotion others_of(const double* all_i, const double* all_j,
                                               const cohesion::event_stepping::PairMotion& own) {
  const auto of_j = [&](int k) { return all_j ? vector(all_j + k) : cohesion::Vector3{}; };
  cohesion::event_stepping::PairMotion others;
  others.relative = {of_j(0) - vector(all_i) - own.relative.separation,
                     of_j(3) - vector(all_i + 3) - own.relative.velocity};
  if (FRICTION) {
    others.spin_i = vector(all_i + 6) - own.spin_i;
    others.spin_j = of_j(6) - own.spin_j;
  }
  return others;
}

/// `others` and the contact's own rolling spring, without what that does, `own`.
inline cohesion::event_stepping::PairMotion without(
    cohesion::event_stepping::PairMotion others, const cohesion::event_stepping::PairSpins& own) {
  others.spin_i -= own.i;
  others.spin_j -= own.j;
  return others;
}

/// The second pass: with half of what the other contacts of its particles do, `others` (nullptr:
/// nothing within the step), and what the contact's own rolling spring does (nullptr: it has none).
template <bool FRICTION, class Contact>
FollowedContact follow_with_others(const Contact& c,
                                   const cohesion::event_stepping::PairMotion& grid,
                                   const cohesion::event_stepping::PairMotion* others,
                                   const cohesion::event_stepping::PairSpins* by_rolling,
                                   double* history) {
  cohesion::event_stepping::RelativeState middle = grid.relative;
  if (others) {
    middle.separation += 0.5 * others->relative.separation;
    middle.velocity += 0.5 * others->relative.velocity;
  }
  cohesion::event_stepping::PairStep normal = c.advance(middle, history[0] != 0.0);
  cohesion::event_stepping::FrictionStep sliding;
  cohesion::Vector3 impulse = c.reduced_mass() * normal.change.velocity;
  if (FRICTION) {
    if (normal.normal.contact_time > 0.0) {
      sliding = c.friction(grid, others, normal, vector(history + 1), by_rolling);
      impulse += sliding.spring.impulse;
    }
    history[1] = sliding.memory.x;
    history[2] = sliding.memory.y;
    history[3] = sliding.memory.z;
  }
  history[0] = normal.inside;
  return {normal, sliding, impulse};
}

/// The first pass of what resists rolling: with half of what the rest of the contact does, `own`.
/// Adds what it does to both particles (all_j nullptr: a wall) and returns it, as angular impulse
/// on i.
template <class Contact>
cohesion::Vector3 roll_alone(const Contact& c, const cohesion::event_stepping::PairMotion& grid,
                             const cohesion::event_stepping::PairMotion& own,
                             const cohesion::event_stepping::PairStep& normal,
                             const double* history, double* all_i, double* all_j) {
  if (normal.normal.contact_time == 0.0) return {};
  const cohesion::Vector3 torque =
      c.rolling(grid, {}, normal, vector(history + WITH_FRICTION), {own.spin_i, own.spin_j})
          .torque_i;
  const cohesion::event_stepping::PairSpins change = c.rolled(torque);
  add(all_i + 6, 1.0, change.i);
  if (all_j) add(all_j + 6, 1.0, change.j);
  return torque;
}

/// The second pass of what resists rolling. `now`: what the rest of the contact does.
template <class Contact>
cohesion::event_stepping::RollingStep roll_with_others(
    const Contact& c, const cohesion::event_stepping::PairMotion& grid,
    const cohesion::event_stepping::PairMotion& others, const FollowedContact& now,
    double* history) {
  double* const left = history + WITH_FRICTION;
  cohesion::event_stepping::RollingStep step;
  if (now.normal.normal.contact_time > 0.0)
    step = c.rolling(
        grid, others, now.normal, vector(left),
        {c.spin_share_i() * now.sliding.torque_i, c.spin_share_j() * now.sliding.torque_j});
  left[0] = step.memory.x;
  left[1] = step.memory.y;
  left[2] = step.memory.z;
  return step;
}

/// Books what a contact stores that no step has followed since the run began.
inline void book_standing(FixEventStep::Book& book, double part,
                          const cohesion::event_stepping::StoredEnergies& stored) {
  book.spring += part * stored.spring;
  book.tangential_spring += part * stored.tangential_spring;
  book.rolling_spring += part * stored.rolling_spring;
  book.adhesion += part * stored.adhesion;
}

/// What a spring of a contact remembers, the tangential one (WITH_FRICTION) or the rolling one
/// (WITH_ROLLING); nothing, where its `values` numbers of history do not reach so far.
inline cohesion::Vector3 memory_in(const double* history, int values, HistorySize with) {
  return values >= with ? vector(history + with - 3) : cohesion::Vector3{};
}

/// Forces, torques, changes of position and the energy book of one step.
class ContactScatter {
 public:
  ContactScatter(Atom* atom, FixEventStep* step)
      : step_(step), f_(atom->f), torque_(atom->torque), kick_(step->force_per_impulse()) {}

  /// Force that stands for an impulse.
  double kick() const { return kick_; }

  template <bool FRICTION, class Contact>
  void on_i(int i, const Contact& contact, const FollowedContact& c) const {
    act<Contact::acts_within_step>(i, -1.0, contact.share_i(), c);
    if (FRICTION) add(torque_[i], kick_, c.sliding.torque_i);
  }
  template <bool FRICTION, class Contact>
  void on_j(int j, const Contact& contact, const FollowedContact& c) const {
    act<Contact::acts_within_step>(j, 1.0, contact.share_j(), c);
    if (FRICTION) add(torque_[j], kick_, c.sliding.torque_j);
  }

  void roll_i(int i, const cohesion::event_stepping::RollingStep& r) const {
    add(torque_[i], kick_, r.torque_i);
  }
  void roll_j(int j, const cohesion::event_stepping::RollingStep& r) const {
    add(torque_[j], -kick_, r.torque_i);
  }

  /// `part`: of the contact that this process accounts for.
  template <class Contact>
  void book(const Contact& contact, double part, const FollowedContact& c) const {
    FixEventStep::Book& book = step_->book;
    if (c.normal.normal.unresolved) book.unresolved += part;
    if (!book.kept) return;
    book.spring += part * contact.spring_energy(c.normal);
    book.adhesion += part * contact.adhesion_energy(c.normal);
    book.tangential_spring += part * contact.friction_energy(c.sliding.spring.displacement);
    book.normal_damping += part * c.normal.normal.dissipated;
    book.tangential_damping += part * c.sliding.spring.damped;
    book.friction += part * c.sliding.spring.friction;
  }
  template <class Contact>
  void book(const Contact& contact, double part,
            const cohesion::event_stepping::RollingStep& r) const {
    FixEventStep::Book& book = step_->book;
    if (!book.kept) return;
    book.rolling_spring += part * contact.friction_energy(r.spring.displacement);
    book.rolling += part * (r.spring.damped + r.spring.friction);
  }

 private:
  /// What is sampled changes velocities alone: no particle is announced for it, and none shifted.
  template <bool SHIFTS>
  void act(int i, double side, double share, const FollowedContact& c) const {
    const double kick = side * kick_;
    add(f_[i], kick, c.impulse);
    if (SHIFTS) add(step_->shift[i], side * share, c.normal.change.separation);
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
