// SPDX-License-Identifier: GPL-2.0-only
#ifdef FIX_CLASS
// clang-format off
FixStyle(CONTACT_STEP,FixContactStep);
// clang-format on
#else

#ifndef LMP_FIX_CONTACT_STEP_H
#define LMP_FIX_CONTACT_STEP_H

#include <array>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "atom.h"
#include "contact/contact_parameters.h"
#include "contact_solver/pair_motion.h"
#include "contact_step/contact_energy_tally.h"
#include "contact_step/contact_impulses.h"
#include "domain.h"
#include "engine/atom_numbers.h"
#include "fix.h"

namespace cohesion::contact_solver {
struct FluxParts;
class ParticleWork;
struct Passage;
}  // namespace cohesion::contact_solver

namespace LAMMPS_NS {

class AlteredParticles;
class MobileParticles;
class SoftContactStyle;
template <class Engine>
class ContactWatch;
struct LammpsRun;

/// The data that all soft contacts share: masses, radii, and the acceleration of each particle and
/// ghost by the forces of the last step, without impulses that acted within that step. The exact
/// scheme uses this acceleration as the external one of a contact
/// (src/contact_solver/contact_solver.h). The first style with soft contacts creates this fix.
///
/// A fix cannot create another one in its constructor: fixes that need this one call of() in
/// post_constructor().
///
/// A run that continues another, in the same input or from a restart, starts from the forces of the
/// last step. They cannot be recomputed: positions are those of time level n, velocities were those
/// of n-1/2 when the forces were computed.
class FixContactStep : public Fix {
 public:
  FixContactStep(class LAMMPS*, int, char**);
  ~FixContactStep() override;

  /// Reserves the position in the list of fixes, before those that integrate. Constructors of pair
  /// styles call this, since they may run while a restart file is read, and the engine hands the
  /// data of the file to fixes only afterwards.
  static void reserve(class LAMMPS*);
  /// The fix of this engine, created if there is none. Not to be called before a restart file has
  /// been read to its end, nor after the engine has begun to init its fixes.
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

  /// Whether this set-up continues with the forces of the last step and computes no contact.
  bool resumes() const { return resuming; }
  /// Whether steps are being made; otherwise the state is that between two runs.
  bool is_running() const { return running; }
  /// What scripts have altered since the last run; filled while a continued run is set up.
  const AlteredParticles& altered_particles() const { return *altered; }
  /// Whether the last run ended in a step without stored energies, so that its totals are unknown.
  bool last_tally_unknown() const { return tally_unknown; }
  /// Whether this is the first step of a run that continues no other.
  bool starts() const { return starting; }
  /// Particle or ghost i. A particle that no fix integrates has inverse mass 0.
  cohesion::contact_solver::Body body(int i) const { return {atom->radius[i], inverse_mass[i]}; }
  const double* inverse_masses() const { return inverse_mass; }
  /// Whether a fix may move a particle that has inverse mass 0.
  bool is_led(int i) const;
  /// Whether a relative velocity [length/time] changes the contact of particle i. The residual
  /// velocity that fix freeze leaves of a particle at rest does not.
  bool carries_along(int i, const cohesion::Vector3& velocity) const {
    constexpr double at_rest = 1e-8;  // way in a step over the radius
    return length() * norm(velocity) > at_rest * atom->radius[i];
  }
  /// A contact of the exact or the sampled scheme, for this step.
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
  /// Length of the step, [time].
  double length() const;
  /// Length of the last step, [time], and whether it differs.
  double last_length() const { return last_dt; }
  bool has_other_length() const { return last_dt != length(); }
  /// Length of the step with which the current forces of contacts were computed, [time].
  double forces_length() const { return forces_dt; }
  /// Acceleration of j relative to i by the forces of the last step without impulses,
  /// [length/time^2]; j < 0: a wall.
  cohesion::Vector3 relative_acceleration(int i, int j) const {
    const cohesion::Vector3 of_i = cohesion::vector(accelerations.of(i));
    return j < 0 ? -of_i : cohesion::vector(accelerations.of(j)) - of_i;
  }
  /// Upper bound of the relative displacement by these accelerations in this step, [length].
  double moved_by_forces() const { return 2.0 * largest_acceleration * length() * length(); }
  /// Differs from the number of the last step if radii have changed or the neighbour list is new.
  long version_of_radii() const { return radii_version; }
  /// Upper bound of the displacement of a particle or ghost in half a step, [length].
  double flight() const { return longest_flight; }

  /// Impulses of the contacts in this step.
  ContactImpulses impulses;
  /// Energies of contacts.
  ContactEnergyTally energy_tally;
  /// Work of forces.
  const cohesion::contact_solver::ParticleWork& work() const { return *particle_work; }
  /// Adds work of a moving wall, and of friction on it, in the step around the time level.
  void add_wall_work(double done, double by_friction);
  /// The numbers with which a later run continues, as restart files have them; the last is 0.
  using Totals = std::array<double, 10>;

  /// Momentum fluxes of pairs, summed up as long as a handle of add_flux_reader() exists.
  const cohesion::contact_solver::FluxParts& flux() const { return *flux_parts; }
  /// Adds to them, as FluxParts::add().
  void add_flux(double fraction, const cohesion::Vector3& separation, const cohesion::Vector3& on_j,
                const cohesion::Vector3& by_contact);
  [[nodiscard]] ContactEnergyTally::Reader add_flux_reader() const { return flux_readers; }
  bool sums_flux() const { return flux_wanted; }

  /// Adds forces [force] and torques of the last step on i and j while a run that continues it is
  /// set up; j < 0: a wall.
  void repeat_forces(int i, int j, const cohesion::contact_solver::PairAction& forces) const;

  /// Adds a force [force] of an impulse at the edge of a range, on own particle i.
  void add_impulsive_force(int i, const cohesion::Vector3& on_it) {
    impulsive_forces[i] += on_it;
    impulsive_particles.push_back(i);
  }
  /// Counts a contact that was not resolved to the end of the step.
  void count_unresolved(double fraction) { unresolved += fraction; }
  /// Calls compute(), which computes the contacts of a style. The first style of a step begins the
  /// step, after fixes have changed masses, radii or groups.
  template <class Compute>
  void compute_contacts(const Compute& compute) {
    const bool first = begin_step();
    compute();
    if (first) impulses.end_contacts();
  }

 private:
  bool begin_step();
  void save_last(int i, double* values) const;
  void find_styles();
  bool other_styles_act() const;
  void follow_renumbering();
  void find_altered();
  void advise_if_due(bool setup);
  bool is_idle() const;
  void update_readers();
  void update_particles();
  void update_masses(int all);
  void update_masses_by_owners(int all);
  void update_radii(int all);
  void report_unresolved();
  void save_accelerations();
  void forward_accelerations();
  void forward_flagged(std::vector<char>& flags, double* values, int each);
  void end_start();
  void tally_work(bool starts);
  void tally_friction();
  cohesion::contact_solver::Passage passage_of(int i, bool starts, double half) const;
  cohesion::contact_solver::Passage short_passage_of(int i, double half) const;
  Totals totals() const;
  void restore_totals(const Totals&);
  bool may_end_here() const;
  void begin_tallies();
  void refuse_rigid_bodies() const;
  void require_spheres();
  void warn_of_spins();
  void warn_of_unmoved();
  void warn_of_unlike_walls();
  void warn_of_added_contacts();
  void hold_spins();
  void keep_impulses();
  void forget_impulses();

  std::vector<SoftContactStyle*> styles;  // those of this run
  std::unique_ptr<ContactWatch<LammpsRun> > watch;

  char* forwarded_flags = nullptr;  // per atom and ghost: whether it has values to forward
  // Of particle 0; `values_each` per particle, one after the other
  double* forwarded_values = nullptr;
  int values_each = 0;
  bool may_have_contacts = true;  // whether any style may have one in this run
  bool idle = false;              // no contact can act, and no output reads any
  bool resuming = false;
  bool starting = false;
  bool running = false;
  bool tallies_begun = false;  // energy balances, in this run
  bool tally_unknown = false;  // last_tally_unknown()
  bool warned_of_unturned = false, warned_of_held = false, warned_of_partly_held = false,
       warned_of_added_contacts = false;
  bool warned_of_unmoved = false;
  std::set<std::string> warned_of_walls;  // texts of the warnings so far
  std::unique_ptr<AlteredParticles> altered;
  double forces_dt = 0.0;             // forces_length(); 0 before the first step
  AtomNumbers last;                   // between two runs: save_last()
  double last_dt = 0.0;               // last_length()
  AtomNumbers accelerations;          // of atoms and ghosts, by the forces of the last step
  double largest_acceleration = 0.0;  // of these
  bool step_due = false;              // begin_step()
  std::vector<cohesion::Vector3> impulsive_forces;  // per atom, of this step: add_impulsive_force()
  std::vector<int> impulsive_particles;  // indices of atoms with such forces, with repetitions
  bool any_exact_scheme = false;         // whether any style of this run has it
  bool any_dynamic_group = false;        // whether fixes move or freeze such a group
  bool others_act = true;            // whether other forces than those of contacts and gravity act
  std::vector<char> flagged;         // storage of forwarded_flags
  double* inverse_mass = nullptr;    // per atom and ghost
  std::vector<double> known_masses;  // inverse_mass belongs to these; empty: not computed yet
  std::vector<double> known_radii;   // radii_version belongs to these
  long radii_version = 0;
  double longest_flight = 0.0;
  double unresolved = 0.0;                  // contacts not resolved to the end of a step, this run
  ContactEnergyTally::Reader flux_readers;  // its use count is the number of readers
  bool flux_wanted = false;
  std::unique_ptr<cohesion::contact_solver::FluxParts> flux_parts;        // flux()
  std::unique_ptr<cohesion::contact_solver::ParticleWork> particle_work;  // work()
  std::unique_ptr<MobileParticles> mobile;
};

}  // namespace LAMMPS_NS

#endif
#endif
