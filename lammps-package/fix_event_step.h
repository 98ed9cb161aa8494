// SPDX-License-Identifier: GPL-2.0-only
#ifdef FIX_CLASS
// clang-format off
FixStyle(EVENT_STEP,FixEventStep);
// clang-format on
#else

#ifndef LMP_FIX_EVENT_STEP_H
#define LMP_FIX_EVENT_STEP_H

#include <algorithm>
#include <memory>
#include <vector>

#include "atom.h"
#include "box_sides.h"
#include "contact_advice.h"
#include "event_stepping/cohesive_contact.h"
#include "event_stepping/flux_parts.h"
#include "fix.h"
#include "mobile_particles.h"

namespace LAMMPS_NS {

/// A fix that follows contacts in the event scheme: walls. Its style calls neither pass itself in
/// the setup of a run; FixEventStep does, in the order of the scheme.
class EventContacts {
 public:
  virtual void follow_alone() = 0;
  virtual void follow_together() = 0;
  /// Books what the contacts store, where a run takes over the forces of the last one.
  virtual void book_standing() = 0;
  /// Takes particles as in or out of range as they are, where something else than their motion has
  /// brought them there.
  virtual void take_where_they_are() = 0;
  /// Whether friction turns particles of this type.
  virtual bool rubs(int type) const = 0;

 protected:
  ~EventContacts() = default;
};

/// A pair style of the event scheme: what its pairs carry is in FixEventStep::flux.
class EventPairs {
 public:
  /// Whether any pair may be followed in this run.
  virtual bool follows() const = 0;
  virtual bool rubs(int type) const = 0;

 protected:
  ~EventPairs() = default;
};

/// What all styles of the event scheme share, made by the first of them. Contacts of one particle
/// act on each other within a step: each is first followed alone, and its change of position,
/// velocity and spin added to `alone`; then it is followed again with half of what the others did.
///
/// Order within a step: this fix lets the walls (pre_force), then the pair style adds to `alone`;
/// share() brings it to the ghosts; the pair style and then the walls (post_force) follow each
/// contact the second time and add force, torque and `shift`, the change of position that goes with
/// the force.
///
/// A fix cannot make another one in its constructor: those that need this one call of() in
/// post_constructor(); the order above does not depend on the order of the fixes.
///
/// A run that continues another, in the same input or from a restart, starts from the forces the
/// last step ended with: the grid holds positions at n and velocities at n-1/2, and the forces of
/// step n cannot be worked out again from the velocities at n.
class FixEventStep : public Fix {
 public:
  FixEventStep(class LAMMPS*, int, char**);
  ~FixEventStep() override;

  /// Keeps the place in the list of fixes, before those that integrate: for the constructor of a
  /// pair style, which may run while a restart file is read. The fix itself finds what the file
  /// holds for it only afterwards.
  static void reserve(class LAMMPS*);
  /// The one of this run; made when there is none. Not before a restart file has been read to its
  /// end, and not after the engine has begun to init its fixes.
  static FixEventStep* of(class LAMMPS*);

  int setmask() override;
  void init() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void initial_integrate(int) override;
  void pre_force(int) override;
  void end_of_step() override;
  void post_run() override;

  int pack_forward_comm(int, int*, double*, int, int*) override;
  void unpack_forward_comm(int, int, double*) override;
  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double*) override;
  int unpack_exchange(int, double*) override;
  void write_restart(FILE*) override;
  void restart(char*) override;
  int pack_restart(int, double*) override;
  void unpack_restart(int, int) override;
  int maxsize_restart() override;
  int size_restart(int) override;
  double memory_usage() override;

  /// The forces of the last step are taken over: nothing may be followed.
  bool resumes() const { return resuming; }
  /// A run that does so finds another box than the last one left, and particles elsewhere.
  bool box_changed() const { return other_box; }
  /// The force that gives a particle the impulse 1 in this step, [1/time].
  double force_per_impulse() const;
  /// The stretch of time that this step's forces stand for.
  cohesion::event_stepping::StepWindow window() const;
  /// Particle or ghost i; a particle that nothing integrates has inverse mass 0.
  cohesion::event_stepping::Body body(int i) const { return {atom->radius[i], inverse_mass[i]}; }
  /// What force times this adds to the momentum until the motion of the step ends, [time].
  double half_kick() const;
  /// How long particles fly from the grid point to the end of the step, [time].
  double half_flight() const { return window().after; }

  /// Velocity and spin of a particle at the end of the step's motion.
  cohesion::Vector3 velocity_at_end(int i) const;
  cohesion::Vector3 spin_at_end(int i) const;
  /// The same, of a particle or ghost, where a run takes over the forces of the last one and the
  /// book is kept.
  cohesion::Vector3 taken_velocity(int i) const { return cohesion::vector(alone[i] + 3); }
  cohesion::Vector3 taken_spin(int i) const { return cohesion::vector(alone[i] + 6); }

  /// How far a particle or ghost of this rank may fly until the end of the step, [length].
  double flight() const { return longest_flight; }

  /// Announces a contact of particle or ghost i in this step, before it adds to `alone` or `shift`.
  void announce(int i) {
    if (contacts[i]++ != 0) return;
    std::fill_n(alone[i], ALONE, 0.0);
    std::fill_n(shift[i], 3, 0.0);
  }
  /// Whether i is a particle of this rank with one contact only.
  bool has_one_contact(int i) const { return i < atom->nlocal && contacts[i] == 1; }

  /// Brings the first `values` of `alone` to the ghosts.
  void share(int values);

  /// Per atom and ghost that has a contact: change of position, velocity and spin, each contact
  /// alone.
  static constexpr int ALONE = 9;
  double** alone;
  double** shift;  ///< per atom that has a contact: change of position of this step

  /// What somebody holds as long as something is to be summed for him.
  using Reader = std::shared_ptr<const void>;

  /// The energy of contacts; kept only while a compute asks for it, which itself takes off what was
  /// there before.
  struct Book {
    bool kept = false;
    double spring, tangential_spring, rolling_spring, adhesion;  ///< at the end of the step
    double normal_damping, tangential_damping, friction;         ///< lost so far
    double rolling;        ///< lost so far in rolling springs, dashpots and sliders
    double external_work;  ///< of other forces but gravity, and moving walls; so far
    double unresolved;     ///< steps of contacts that were cut short, in this run
  } book;
  [[nodiscard]] Reader keep_book() const { return book_readers; }

  /// Of the contacts of pairs so far; summed as the book is kept.
  cohesion::event_stepping::FluxParts flux;
  [[nodiscard]] Reader sum_flux() const { return flux_readers; }
  bool sums_flux() const { return flux_wanted; }

  /// A force of a contact on particle i, for the book.
  void note_force(int i, double fx, double fy, double fz) {
    contact_force[3 * i] += fx;
    contact_force[3 * i + 1] += fy;
    contact_force[3 * i + 2] += fz;
  }

 private:
  void clear();
  void judge(bool setup);
  bool rests() const;
  void look_for_readers();
  void look_round();
  void weigh(int all);
  void hold_last(bool);
  void report_unresolved();
  void take_over();
  void move();
  void begin_books();
  void look_for_unturned();

  std::vector<EventContacts*> walls;   // those of this run
  std::vector<AdvisedStyle*> advised;  // the same
  ContactWatch watch;

  int shared;    // of the values of `alone`
  bool follows;  // any pair or wall, in this run
  bool resting;  // nothing is followed, and nobody reads the books
  bool resuming;
  bool starting;
  bool running;
  bool books_begun;  // in this run
  bool other_box;
  bool said_unturned;
  BoxSides box;     // at the end of the last run
  double last_dt;   // of the step that `last` is from; 0: there was none
  bool holds_last;  // from the end of a run to the first step of the next
  double** last;    // per atom, while it is held: force and torque at the end of the last run
  std::vector<double> contact_force;  // per atom and ghost, while the book is kept
  int* contacts;                      // per atom and ghost, this step
  double* inverse_mass;               // per atom and ghost
  std::vector<double> weighed;        // the masses inverse_mass is of; empty: of none
  double longest_flight;
  Reader book_readers, flux_readers;  // copies of these are out
  bool flux_wanted;
  MobileParticles mobile;
};

}  // namespace LAMMPS_NS

#endif
#endif
