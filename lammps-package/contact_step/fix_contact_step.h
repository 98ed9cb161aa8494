// SPDX-License-Identifier: GPL-2.0-only
#ifdef FIX_CLASS
// clang-format off
FixStyle(CONTACT_STEP,FixContactStep);
// clang-format on
#else

#ifndef LMP_FIX_CONTACT_STEP_H
#define LMP_FIX_CONTACT_STEP_H

#include <set>
#include <string>
#include <vector>

#include "atom.h"
#include "contact_solver/flux_parts.h"
#include "contact_solver/pair_motion.h"
#include "contact_step/altered_particles.h"
#include "contact_step/contact_impulses.h"
#include "contact_step/soft_contact_style.h"
#include "domain.h"
#include "engine/atom_numbers.h"
#include "engine/mobile_particles.h"
#include "fix.h"
#include "outputs/contact_energy_tally.h"
#include "soft_contacts/contact_advice.h"

namespace LAMMPS_NS {

/// What contacts must know of each particle and ghost.
struct Bodies {
  const double* radius;
  const double* inverse_mass;

  cohesion::contact_solver::Body operator[](int i) const { return {radius[i], inverse_mass[i]}; }
};

/// What all soft contacts share, made by the first style that has some: masses and sizes, and how
/// the forces of the last step accelerated each particle, ghosts included. That is what a contact
/// of the exact scheme knows of the others of its particles
/// (src/contact_solver/contact_solver.h). Impulses that were over within that step are left out.
///
/// A fix cannot make another one in its constructor: those that need this one call of() in
/// post_constructor().
///
/// A run that continues another, in the same input or from a restart, starts from the forces the
/// last step ended with: positions are those of n, velocities those of n-1/2, and the forces of
/// step n cannot be worked out again from the velocities at n.
class FixContactStep : public Fix {
 public:
  FixContactStep(class LAMMPS*, int, char**);
  ~FixContactStep() override;

  /// Keeps the place in the list of fixes, before those that integrate: for the constructor of a
  /// pair style, which may run while a restart file is read. The fix itself finds what the file
  /// holds for it only afterwards.
  static void reserve(class LAMMPS*);
  /// The one of this run; made when there is none. Not before a restart file has been read to its
  /// end, and not after the engine has begun to init its fixes.
  static FixContactStep* of(class LAMMPS*);

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

  /// The forces of the last step are taken over, and no contact is computed.
  bool resumes() const { return resuming; }
  /// Whether a run that does so finds the contact of i and j (below 0: a wall) other than their
  /// motion left it: AlteredParticles.
  bool is_altered(int i, int j) const { return altered.is_altered(i, j); }
  /// The last run ended early, in a step of which the energy tally, not active, keeps nothing.
  bool last_tally_unknown() const { return tally_unknown; }
  /// The first step of a run that takes over nothing.
  bool starts() const { return starting; }
  /// Particle or ghost i; a particle that nothing integrates has inverse mass 0.
  cohesion::contact_solver::Body body(int i) const { return bodies()[i]; }
  Bodies bodies() const { return {atom->radius, inverse_mass}; }
  /// Whether a fix may carry along a particle that has inverse mass 0.
  bool is_led(int i) const { return mobile.is_led(atom->mask[i]); }
  /// Whether a relative velocity [length/time] takes particle i out of the contact that is known of
  /// it. What fix freeze leaves of the velocity of a particle at rest does not.
  bool carries_along(int i, const cohesion::Vector3& velocity) const {
    constexpr double at_rest = 1e-9;  // way in a step over the radius
    return length() * norm(velocity) > at_rest * atom->radius[i];
  }
  /// A contact of the exact scheme, or a sampled one, in this step.
  template <class Contact>
  Contact contact(const cohesion::contact::ContactParameters& parameters,
                  const typename Contact::Attraction& attraction,
                  const cohesion::contact_solver::Body& i,
                  const cohesion::contact_solver::Body& j) const {
    if constexpr (Contact::is_exact)
      return {parameters, attraction, i, j, length()};
    else
      return {parameters, attraction, i, j, {starting ? 0.0 : 0.5 * length(), 0.5 * length()}};
  }
  /// Of the step, [time].
  double length() const;
  /// Of the step before, [time], and whether that is another one.
  double last_length() const { return before_dt; }
  bool has_other_length() const { return before_dt != length(); }
  /// How all forces of the last step but impulses accelerated j less i, [length/time^2]; j < 0: a
  /// wall.
  cohesion::Vector3 relative_acceleration(int i, int j) const {
    const cohesion::Vector3 of_i = cohesion::vector(accelerations.of(i));
    return j < 0 ? -of_i : cohesion::vector(accelerations.of(j)) - of_i;
  }
  /// How far these may move a pair in this step, [length].
  double moved_by_forces() const { return 2.0 * largest_acceleration * length() * length(); }
  /// Another number than in the step before if radii have changed or the list of neighbours is new.
  long version_of_radii() const { return radii_version; }
  /// How far a particle or ghost of this rank may fly in half a step, [length].
  double flight() const { return longest_flight; }

  /// What contacts do in this step.
  ContactImpulses impulses;
  /// The energy of contacts.
  ContactEnergyTally energy_tally;

  /// Sum of the contacts of pairs so far; it goes on while somebody holds what add_flux_reader()
  /// gives.
  cohesion::contact_solver::FluxParts flux;
  [[nodiscard]] ContactEnergyTally::Reader add_flux_reader() const { return flux_readers; }
  bool sums_flux() const { return flux_wanted; }

  /// Adds to the impulses of edges on a particle of this rank, [force].
  void add_impulsive_force(int i, const cohesion::Vector3& on_it) {
    impulsive_forces[i] += on_it;
    impulsive_particles.push_back(i);
  }
  /// Counts a contact whose step was cut short.
  void count_unresolved(double fraction) { unresolved += fraction; }
  /// Calls compute(), which computes the contacts of a style; the first style of a step begins it,
  /// when fixes have changed what they change before.
  template <class Compute>
  void compute_contacts(const Compute& compute) {
    const bool first = begin_step();
    compute();
    if (first) impulses.end_contacts();
  }

 private:
  bool begin_step();
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
  using NumbersOf = double* (FixContactStep::*)(int i);
  void save_accelerations();
  void forward_accelerations();
  double* acceleration_of(int i) { return accelerations.of(i); }
  void forward_flagged(std::vector<char>& flags, NumbersOf, int each);
  void end_start();
  void tally_work(bool starts);
  void begin_tallies();
  void refuse_rigid_bodies() const;
  void require_spheres();
  void warn_of_spins();
  void warn_of_unmoved();
  void warn_of_unlike_walls();
  void hold_spins();
  void keep_impulses();
  void forget_impulses();

  std::vector<SoftContactStyle*> styles;  // those of this run
  std::vector<AdvisedStyle*> advised;     // the same
  LammpsWatch watch;

  char* forwarded_flags;       // per atom and ghost, of what goes to ghosts now: whether it has any
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
  bool warned_of_unmoved = false;
  std::set<std::string> warned_of_walls;  // what was said of them
  AlteredParticles altered;               // as a run that takes over forces is set up
  double forces_dt;                       // of the step that the forces are of; 0: there was none
  AtomNumbers last;           // from the end of a run to the first step of the next: save_last()
  double before_dt = 0.0;     // of the step before
  AtomNumbers accelerations;  // by the forces of the last step, of atoms and ghosts
  double largest_acceleration = 0.0;  // of those
  bool step_due = false;              // begin_step()
  std::vector<cohesion::Vector3>
      impulsive_forces;                  // per atom: add_impulsive_force(), until the next step
  std::vector<int> impulsive_particles;  // with an impulsive force; some more than once
  bool any_exact_scheme = false;         // any style, in this run
  bool any_dynamic_group = false;        // of particles that fixes move or freeze, likewise
  std::vector<char> flagged;             // of what is forwarded
  double* inverse_mass;                  // per atom and ghost
  std::vector<double> known_masses;      // the masses inverse_mass is of; empty: of none
  std::vector<double> known_radii;       // radii_version is of these
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
