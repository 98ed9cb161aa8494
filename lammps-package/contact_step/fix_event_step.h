// SPDX-License-Identifier: GPL-2.0-only
#ifdef FIX_CLASS
// clang-format off
FixStyle(EVENT_STEP,FixEventStep);
// clang-format on
#else

#ifndef LMP_FIX_EVENT_STEP_H
#define LMP_FIX_EVENT_STEP_H

#include <vector>

#include "altered_particles.h"
#include "atom.h"
#include "atom_numbers.h"
#include "contact_advice.h"
#include "contact_energy_tally.h"
#include "contact_impulses.h"
#include "domain.h"
#include "event_stepping/flux_parts.h"
#include "event_stepping/two_pass_contact.h"
#include "fix.h"
#include "mobile_particles.h"
#include "soft_contact_style.h"

namespace LAMMPS_NS {

/// What followed contacts of a particle or ghost share in a step: `owed`, what leads from the
/// velocity and spin on the grid to the true ones; `predicted`, the change of position, velocity
/// and spin in the step; `most_kick`, no less than what they do to its velocity. Two lines of a
/// cache.
struct alignas(64) FollowedMotion {
  static constexpr int OWED = 6, PREDICTED = 9;
  double owed[OWED], predicted[PREDICTED], most_kick;
};

/// What contacts must know of each particle and ghost.
struct Bodies {
  const double* radius;
  const double* inverse_mass;

  cohesion::event_stepping::Body operator[](int i) const { return {radius[i], inverse_mass[i]}; }
};

/// What all styles of the event scheme share, made by the first of them. A contact that lasts needs
/// one force. The others are followed in closed form from the true motion at the grid point, to
/// which `owed` leads, and which needs all contacts of a particle: in a predictor each by itself,
/// what it does added to `predicted`, and in a corrector with half of what the others do.
///
/// A particle is disturbed by a followed contact with an event, and by a young one that minds
/// others and is not its only contact. Contacts of disturbed particles are followed, too, if they
/// mind others: one force among such drains energy. A disturbed particle, and one of a young
/// contact beside any other, is crowded: its contacts that begin to last are not young.
///
/// Order within a step, with its first forces: all styles classify(); find_beside_young();
/// forward_marks(); follow_disturbed(); follow_far(); couple_lasting();
/// forward_to_ghosts(owed); predict(); forward_to_ghosts(predicted). Then the corrector of each
/// style.
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
  /// Whether a run that does so finds the contact of i and j (below 0: a wall) other than their
  /// motion left it: AlteredParticles.
  bool is_altered(int i, int j) const { return altered.is_altered(i, j); }
  /// The last run ended early, in a step of which the energy tally, not active, keeps nothing.
  bool last_tally_unknown() const { return tally_unknown; }
  /// The first step of a run that takes over nothing.
  bool starts() const { return starting; }
  /// Particle or ghost i; a particle that nothing integrates has inverse mass 0.
  cohesion::event_stepping::Body body(int i) const { return bodies()[i]; }
  Bodies bodies() const { return {atom->radius, inverse_mass}; }
  /// Whether a fix may carry along a particle that has inverse mass 0.
  bool is_led(int i) const { return mobile.is_led(atom->mask[i]); }
  /// A contact of the event scheme, or a sampled one, in this step.
  template <class Contact>
  Contact contact(const cohesion::contact::ContactParameters& parameters,
                  const typename Contact::Attraction& attraction,
                  const cohesion::event_stepping::Body& i,
                  const cohesion::event_stepping::Body& j) const {
    using cohesion::event_stepping::ClosestPacking;
    if constexpr (Contact::on_grid)
      return {parameters,
              attraction,
              i,
              j,
              2.0 * half_kick(),
              domain->dimension == 2 ? ClosestPacking::in_plane() : ClosestPacking::in_space()};
    else
      return {parameters, attraction, i, j, {starting ? 0.0 : half_kick(), half_kick()}};
  }
  /// What force times this adds to the momentum until the motion of the step ends, [time].
  double half_kick() const;
  /// Another number than in the step before if radii have changed or the list of neighbours is new.
  long version_of_radii() const { return radii_version; }
  /// How far a particle or ghost of this rank may fly in half a step, [length].
  double flight() const { return longest_flight; }

  /// Adds a followed contact of particle or ghost i in this step, before it adds to `owed` or
  /// `predicted`. The first entry is what all forces but those of contacts do; ghosts have it from
  /// their owners.
  void add_followed(int i) {
    if (shares[i].contacts++ != 0) return;
    any_followed_now = true;
    add_motion(i);
    if (i >= atom->nlocal) {
      followed_ghosts.push_back(i);
      return;
    }
    followed[i] = 1;
    if (!other_forces_known) return;
    const auto does = cohesion::event_stepping::by_acceleration(
        inverse_mass[i] * cohesion::vector(other_forces.of(i)), 2.0 * half_kick());
    if (!starting) add(owed(i), 0.5 * does.velocity);
    add(predicted(i), does.separation);
    add(predicted(i) + 3, does.velocity);
  }
  /// Marks both particles of a contact that has an event; j < 0: a wall.
  void disturb(int i, int j) {
    marks[i] |= DISTURBED;
    if (j >= 0) marks[j] |= DISTURBED;
  }
  /// A young contact of both, which is alone while neither has another; two of them are not. It
  /// minds others, or does not.
  void add_young(int i, int j, bool minds) {
    any_young = true;
    add_young(i, minds ? DISTURBED : CROWDED);
    if (j >= 0) add_young(j, minds ? DISTURBED : CROWDED);
  }
  /// Where a young contact may be alone: nothing but contacts of the event scheme changes
  /// velocities in this run.
  bool only_contacts_act() const { return only_event_contacts; }
  /// Adds a contact of two particles that add_young() was not told of; j < 0: a wall.
  void add_beside_young(int i, int j) {
    marks[i] |= young_marks[i];
    if (j >= 0) marks[j] |= young_marks[j];
  }
  /// Whether i is disturbed, or j (below 0: a wall, which never is).
  bool is_disturbed(int i, int j) const { return marks_of(i, j) == DISTURBED; }
  /// The same of crowded ones.
  bool is_crowded(int i, int j) const { return (marks_of(i, j) & CROWDED) != 0; }
  /// Whether any particle or ghost is.
  bool any_disturbed() const { return any_disturbed_now; }
  /// Counts one more contact of a particle that has a followed one.
  void count_contact(int i) { shares[i].contacts++; }
  bool any_followed() const { return any_followed_now; }
  /// Whether particle or ghost i has a followed contact in this step.
  bool is_followed(int i) const { return shares[i].contacts != 0; }
  /// No less than what a followed contact does to the velocity of i, after add_followed().
  void add_kick(int i, double kick) { motions[shares[i].motion].most_kick += kick; }
  /// How far a particle of this rank may get in this step from where its velocity on the grid
  /// leads, once the forces of lasting contacts are there, [length].
  double strays(int i) const {
    const double step = 2.0 * half_kick();
    const double impulse =
        norm(cohesion::vector(atom->f[i])) / impulses.kick() +
        (other_forces_known ? step * norm(cohesion::vector(other_forces.of(i))) : 0.0);
    const double kick = is_followed(i) ? motions[shares[i].motion].most_kick : 0.0;
    return cohesion::event_stepping::most_stray(inverse_mass[i], impulse, kick, step);
  }
  /// Whether i is a particle of this rank with one contact only.
  bool has_one_contact(int i) const { return i < atom->nlocal && shares[i].contacts == 1; }

  /// Of an atom or ghost with a followed contact (FollowedMotion).
  double* owed(int i) { return motions[shares[i].motion].owed; }
  double* predicted(int i) { return motions[shares[i].motion].predicted; }
  /// What contacts do in this step.
  ContactImpulses impulses;
  /// The energy of contacts.
  ContactEnergyTally energy_tally;

  /// Sum of the contacts of pairs so far; it goes on while somebody holds what add_flux_reader()
  /// gives.
  cohesion::event_stepping::FluxParts flux;
  [[nodiscard]] ContactEnergyTally::Reader add_flux_reader() const { return flux_readers; }
  bool sums_flux() const { return flux_wanted; }

  /// Adds to what contacts do to a particle of this rank in the instants in which they begin or
  /// end, meet an edge, or pay what an edge has left, [force].
  void add_sudden_force(int i, const cohesion::Vector3& push) {
    sudden_forces[i] += push;
    suddenly_pushed.push_back(i);
  }
  /// Counts a contact whose step was cut short.
  void count_unresolved(double fraction) { unresolved += fraction; }
  /// Runs all that comes before the corrector, if it has not been run in this step, and then the
  /// corrector of the caller.
  template <class Corrector>
  void run_corrector(const Corrector& corrector) {
    const bool first = run_predictor();
    corrector();
    if (first) impulses.end_contacts();
  }

 private:
  bool run_predictor();
  void begin_step();
  void save_last(int i, double* values) const;
  void follow_renumbering();
  void find_altered();
  double* alteration(int i) { return altered.of(i); }
  void advise_if_due(bool setup);
  bool is_idle() const;
  void update_readers();
  void update_particles();
  void update_masses(int all);
  void update_masses_by_owners(int all);
  void update_radii(int all);
  void report_unresolved();
  void forward_marks();
  using NumbersOf = double* (FixEventStep::*)(int i);
  void forward_to_ghosts(NumbersOf, int each);
  void forward_flagged(std::vector<char>& flags, NumbersOf, int each);
  void begin_tallies();
  void add_young(int i, char mark) {
    marks[i] |= young_marks[i];
    if (young_marks[i] != 0) marks[i] |= mark;
    young_marks[i] |= mark;
  }
  char marks_of(int i, int j) const { return j < 0 ? marks[i] : marks[i] | marks[j]; }
  void refuse_rigid_bodies() const;
  void require_spheres();
  void warn_of_spins();
  void warn_of_unmoved();
  void warn_of_mixed_schemes();
  void hold_spins();
  bool any_driven() const;
  bool others_may_act() const;
  void save_other_forces();
  void keep_sudden_impulses();
  void forget_sudden_forces();

  void add_motion(int i) {
    if (motion_count == motions.size()) motions.resize(2 * motion_count + 64);
    motions[motion_count] = {};
    shares[i].motion = static_cast<int>(motion_count++);
  }
  static void add(double* to, const cohesion::Vector3& a) {
    to[0] += a.x;
    to[1] += a.y;
    to[2] += a.z;
  }

  std::vector<SoftContactStyle*> styles;  // those of this run
  std::vector<AdvisedStyle*> advised;     // the same
  ContactWatch watch;

  char* forwarded_flags;  // per atom and ghost, of what goes to ghosts now: whether it has any, or
                          // its marks
  NumbersOf forwarded_values;  // those, `values_each` of each
  int values_each;
  bool may_have_contacts;  // whether any pair or wall may have one, in this run
  bool idle;               // no contact is computed, and nobody reads what they do
  bool resuming;
  bool starting;
  bool running;
  bool tallies_begun;  // in this run
  bool tally_unknown;  // last_tally_unknown()
  bool warned_of_unturned, warned_of_held, warned_of_partly_held;
  bool warned_of_unmoved = false, warned_of_mixed_schemes = false;
  AlteredParticles altered;    // as a run that takes over forces is set up
  double forces_dt;            // of the step that the forces are of; 0: there was none
  AtomNumbers last;            // from the end of a run to the first step of the next: save_last()
  AtomNumbers other_forces;    // force of all but contacts at the last grid point
  bool predictor_due = false;  // in this step: run_corrector()
  std::vector<cohesion::Vector3>
      sudden_forces;                 // per atom: add_sudden_force(), until the next step
  std::vector<int> suddenly_pushed;  // who has one; some more than once
  bool any_event_scheme = false;     // any style, in this run
  bool any_dynamic_group = false;    // of particles that fixes move or freeze, likewise
  bool any_other_forces = false;     // anything but contacts, likewise, where that matters
  bool only_event_contacts = false;  // neither that, nor sampled contacts, nor driven particles
  bool other_forces_known = false;   // in `other_forces`, which is 0 otherwise
  /// What contacts of a particle or ghost share in this step: how many there are, if one is
  /// followed, and the place of the FollowedMotion; -1: there is none.
  struct Share {
    int contacts = 0, motion = -1;
  };
  std::vector<Share> shares;
  std::vector<FollowedMotion> motions;  // `motion_count` of them, in the order of the contacts
  std::size_t motion_count = 0;
  std::vector<char> followed;  // per atom: 1 if it is, or 0; of ghosts what their owners sent
  std::vector<int> followed_ghosts;
  static constexpr char CROWDED = 1, DISTURBED = 2 | CROWDED;
  std::vector<char> marks;           // per atom and ghost: those, added up
  std::vector<char> young_marks;     // the same: what its young contacts make of it beside others
  bool any_young = false;            // of those
  bool any_disturbed_now = false;    // of those that are disturbed
  bool any_followed_now = false;     // the same
  double* inverse_mass;              // per atom and ghost
  std::vector<double> known_masses;  // the masses inverse_mass is of; empty: of none
  std::vector<double> known_radii;   // radii_version is of these
  long radii_version = 0;
  double longest_flight;
  double unresolved;                        // steps of contacts that were cut short, in this run
  ContactEnergyTally::Reader flux_readers;  // copies of this are out
  bool flux_wanted;
  MobileParticles mobile;
};

}  // namespace LAMMPS_NS

#endif
#endif
