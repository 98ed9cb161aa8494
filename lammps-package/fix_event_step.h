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
#include "atom_numbers.h"
#include "box_sides.h"
#include "contact_advice.h"
#include "contact_book.h"
#include "contact_impulses.h"
#include "event_stepping/contact_on_grid.h"
#include "event_stepping/flux_parts.h"
#include "fix.h"
#include "mobile_particles.h"

namespace LAMMPS_NS {

/// What follows contacts in the event scheme: pair styles and walls. FixEventStep::second_pass()
/// calls it, with the first forces of a step; the second pass is each one's own: Pair::compute,
/// Fix::post_force.
class EventContacts {
 public:
  /// Lets contacts that last act, and announces the others, with what leads to the true motion of
  /// their particles, which are restless.
  virtual void gather() = 0;
  /// Announces lasting contacts of restless particles, too, and takes back what they did.
  virtual void unsettle() = 0;
  /// What leads to the true motion of announced particles, of lasting contacts.
  virtual void join() = 0;
  /// The first pass.
  virtual void follow_alone() = 0;
  /// Whether friction turns particles of this type.
  virtual bool rubs(int type) const = 0;
  /// Whether any contact may be followed in this run.
  virtual bool follows() const { return true; }
  /// Whether what contacts do to each other within a step counts: scheme event.
  virtual bool within_step() const = 0;
  /// Where a run takes over the forces of the last one: what has come into range or out of it
  /// between the two, and in the book what the contacts store.
  virtual void book_standing() = 0;

 protected:
  ~EventContacts() = default;
};

/// Those of walls.
class EventWalls : public EventContacts {
 public:
  /// Takes particles as in or out of range as they are, where something else than their motion has
  /// brought them there.
  virtual void take_where_they_are() = 0;

 protected:
  ~EventWalls() = default;
};

/// What contacts must know of each particle and ghost.
struct Bodies {
  const double* radius;
  const double* inverse_mass;

  cohesion::event_stepping::Body operator[](int i) const { return {radius[i], inverse_mass[i]}; }
};

/// What all styles of the event scheme share, made by the first of them. A contact that lasts needs
/// one force. The others are followed in closed form from the true motion at the grid point, to
/// which `owed` leads, and which needs all contacts of a particle; first alone, what they do added
/// to `alone`, then with half of what the others do.
///
/// Contacts beside those are followed, too.
///
/// Order within a step, with its first forces: all styles gather(); share_restless(); unsettle();
/// join(); share(owed); follow_alone(); share(alone). Then the second pass of each.
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
  void post_force(int) override;
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
  /// The first step of a run that takes over nothing.
  bool starts() const { return starting; }
  /// Particle or ghost i; a particle that nothing integrates has inverse mass 0.
  cohesion::event_stepping::Body body(int i) const { return bodies()[i]; }
  Bodies bodies() const { return {atom->radius, inverse_mass}; }
  /// A contact of the event scheme, or a sampled one, in this step.
  template <class Contact>
  Contact contact(const cohesion::contact::ContactParameters& parameters,
                  const typename Contact::Attraction& attraction,
                  const cohesion::event_stepping::Body& i,
                  const cohesion::event_stepping::Body& j) const {
    if constexpr (Contact::on_grid)
      return {parameters, attraction, i, j, 2.0 * half_kick()};
    else
      return {parameters, attraction, i, j, {starting ? 0.0 : half_kick(), half_kick()}};
  }
  /// What force times this adds to the momentum until the motion of the step ends, [time].
  double half_kick() const;
  /// How far a particle or ghost of this rank may fly in half a step, [length].
  double flight() const { return longest_flight; }

  /// Announces a contact of particle or ghost i in this step, before it adds to `owed` or `alone`.
  /// What forces that are no contacts' do is the first entry; ghosts have it from their owners.
  void announce(int i) {
    if (contacts[i]++ != 0) return;
    some_announced = true;
    std::fill_n(owed[i], OWED, 0.0);
    std::fill_n(alone[i], ALONE, 0.0);
    if (i >= atom->nlocal) {
      announced_ghosts.push_back(i);
      return;
    }
    announced[i] = 1;
    if (!others_noted) return;
    const auto does = cohesion::event_stepping::by_acceleration(
        inverse_mass[i] * cohesion::vector(outer.of(i)), 2.0 * half_kick());
    if (!starting) add(owed[i], 0.5 * does.velocity);
    add(alone[i], does.separation);
    add(alone[i] + 3, does.velocity);
  }
  /// A contact of i and j (below 0: a wall) has an event, or is young.
  void unsettle(int i, int j) {
    restless[i] = 1;
    if (j >= 0) restless[j] = 1;
  }
  bool is_restless(int i) const { return restless[i] != 0; }
  /// Whether i is, or j (below 0: a wall).
  bool is_restless(int i, int j) const { return is_restless(i) || (j >= 0 && is_restless(j)); }
  /// Whether any particle or ghost is.
  bool any_restless() const { return some_restless; }
  /// One more contact of a particle that has been announced.
  void joins(int i) { contacts[i]++; }
  bool any_announced() const { return some_announced; }
  /// Whether a contact of particle or ghost i has been announced.
  bool is_followed(int i) const { return contacts[i] != 0; }
  /// Whether i is a particle of this rank with one contact only.
  bool has_one_contact(int i) const { return i < atom->nlocal && contacts[i] == 1; }

  /// Per atom and ghost that has been announced: what leads from the velocity and spin on the grid
  /// to the true ones; change of position, velocity and spin, each contact alone.
  static constexpr int OWED = 6, ALONE = 9;
  double** owed;
  double** alone;
  /// What contacts do in this step.
  ContactImpulses impulses;
  /// The energy of contacts.
  ContactBook book;

  /// Of the contacts of pairs so far; summed while somebody holds what sum_flux() gives.
  cohesion::event_stepping::FluxParts flux;
  [[nodiscard]] ContactBook::Reader sum_flux() const { return flux_readers; }
  bool sums_flux() const { return flux_wanted; }

  /// Counts a contact whose step was cut short.
  void note_unresolved(double part) { unresolved += part; }
  /// All that comes before the second pass, if it has not been done in this step; then what the
  /// caller's second pass does.
  template <class Pass>
  void second_pass(const Pass& pass) {
    const bool first = work_out();
    pass();
    if (first) impulses.close();
  }

 private:
  bool work_out();
  void clear();
  void note_last(int i, double* values) const;
  void judge(bool setup);
  bool rests() const;
  void look_for_readers();
  void look_round();
  void weigh(int all);
  void report_unresolved();
  void share_restless();
  void share(double** values, int each);
  void tell(std::vector<char>& flags, double** values, int each);
  void begin_books();
  void look_for_unturned();
  bool others_may_act() const;
  void note_others();

  static void add(double* to, const cohesion::Vector3& a) {
    to[0] += a.x;
    to[1] += a.y;
    to[2] += a.z;
  }

  std::vector<EventContacts*> styles;  // those of this run
  std::vector<EventWalls*> walls;      // of them
  std::vector<AdvisedStyle*> advised;  // the same
  ContactWatch watch;

  char* told;       // per atom and ghost: of which there is something to tell now
  double** shared;  // what goes to the ghosts then
  int shared_each;
  bool follows;  // any pair or wall, in this run
  bool resting;  // nothing is followed, and nobody reads the books
  bool resuming;
  bool starting;
  bool running;
  bool books_begun;  // in this run
  bool other_box;
  bool said_unturned;
  BoxSides box;                 // at the end of the last run
  double last_dt;               // of the step that `last` is from; 0: there was none
  AtomNumbers last;             // from the end of a run to the first step of the next: note_last()
  AtomNumbers outer;            // force of all but contacts at the last grid point
  bool pending = false;         // in this step: second_pass()
  bool within_step = false;     // any style, in this run
  bool others_act = false;      // anything but contacts, likewise, where that matters
  bool others_noted = false;    // in `outer`, which is 0 otherwise
  int* contacts;                // per atom and ghost, this step
  std::vector<char> announced;  // per atom: 1 if it is, or 0; of ghosts what their owners told
  std::vector<int> announced_ghosts;
  std::vector<char> restless;   // per atom and ghost: 1 with an event or a young contact, or 0
  bool some_restless = false;   // of those
  bool some_announced = false;  // the same
  double* inverse_mass;         // per atom and ghost
  std::vector<double> weighed;  // the masses inverse_mass is of; empty: of none
  double longest_flight;
  double unresolved;                 // steps of contacts that were cut short, in this run
  ContactBook::Reader flux_readers;  // copies of this are out
  bool flux_wanted;
  MobileParticles mobile;
};

}  // namespace LAMMPS_NS

#endif
#endif
