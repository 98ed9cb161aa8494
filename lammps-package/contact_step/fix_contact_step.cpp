// SPDX-License-Identifier: GPL-2.0-only
#include "contact_step/fix_contact_step.h"

#include <algorithm>
#include <string>

#include "atom.h"
#include "comm.h"
#include "common/energy_tally_of_runs.h"
#include "common/renumbering.h"
#include "contact_solver/energy_balance.h"
#include "contact_solver/flux_parts.h"
#include "contact_step/altered_particles.h"
#include "contact_step/soft_contact_style.h"
#include "domain.h"
#include "engine/mobile_particles.h"
#include "engine/occasional_lists.h"
#include "error.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "soft_contacts/contact_advice.h"
#include "update.h"

using namespace LAMMPS_NS;
using cohesion::vector;
using cohesion::Vector3;

static constexpr char ID[] = "COHESION_CONTACT_STEP";
static constexpr char PLACE[] = "COHESION_CONTACT_STEP_PLACE";

// Offsets of the numbers of a particle that the next run needs: force, torque, force of impulses,
// and the numbers of AlteredParticles.
static constexpr int TORQUE = 3, IMPULSIVE = 6, PARTICLE = IMPULSIVE + 3,
                     LAST = PARTICLE + AlteredParticles::SAVED;

static void put(const Vector3& a, double* values) {
  values[0] = a.x;
  values[1] = a.y;
  values[2] = a.z;
}

FixContactStep::FixContactStep(LAMMPS* lammps, int narg, char** arg)
    : Fix(lammps, narg, arg),
      impulses(lammps),
      watch(std::make_unique<LammpsWatch>(lammps)),
      altered(std::make_unique<AlteredParticles>(lammps)),
      last(lammps, LAST),
      accelerations(lammps, 3),
      flux_readers(std::make_shared<char>()),
      flux_parts(std::make_unique<cohesion::contact_solver::FluxParts>()),
      particle_work(std::make_unique<cohesion::contact_solver::ParticleWork>()),
      mobile(std::make_unique<MobileParticles>()) {
  nevery = 1;
  comm_forward = 1 + AlteredParticles::EACH;
  restart_peratom = 1;
  restart_global = 1;
  create_attribute = 1;
  force_reneighbor = 1;  // styles set next_reneighbor
  next_reneighbor = -1;
  FixContactStep::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

FixContactStep::~FixContactStep() {
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
  memory->destroy(inverse_mass);
}

void FixContactStep::reserve(LAMMPS* lmp) {
  Modify* modify = lmp->modify;
  if (modify->find_fix(ID) < 0 && modify->find_fix(PLACE) < 0)
    modify->add_fix(std::string(PLACE) + " all DUMMY");
}

FixContactStep* FixContactStep::of(LAMMPS* lmp) {
  Modify* modify = lmp->modify;
  reserve(lmp);
  if (modify->find_fix(ID) < 0)
    modify->replace_fix(PLACE, std::string(ID) + " all CONTACT_STEP", 1);
  return static_cast<FixContactStep*>(modify->fix[modify->find_fix(ID)]);
}

int FixContactStep::setmask() {
  return FixConst::INITIAL_INTEGRATE | FixConst::PRE_FORCE | FixConst::POST_FORCE |
         FixConst::END_OF_STEP | FixConst::POST_RUN;
}

/// Whether no contact can act and no output needs the energies or fluxes of contacts.
bool FixContactStep::is_idle() const {
  return !may_have_contacts && !energy_tally.has_readers() && flux_readers.use_count() == 1;
}

double FixContactStep::length() const { return update->dt; }

void FixContactStep::setup_pre_force(int) {
  discard_occasional_lists(neighbor);
  forget_impulses();  // `last` contains them
  resuming = last.has_room();
  starting = !resuming;
  step_due = false;
  idle = is_idle();
  if (idle) {
    known_masses.clear();
    impulses.disable();
  }
  if (!resuming) {
    forces_dt = update->dt;
    for (int i = 0; i < atom->nlocal + atom->nghost; i++) accelerations.clear(i);
    advise_if_due(true);
    step_due = true;
    return;
  }
  update_particles();
  update_readers();
  advise_if_due(true);
  if (energy_tally.is_active()) energy_tally.reset_normal();
  find_altered();
  for (SoftContactStyle* some : styles) some->continue_run();
  altered->forget();
}

/// Finds the particles that scripts have altered since the last run, and stores the current ones in
/// their place.
void FixContactStep::find_altered() {
  altered->start();
  flagged.assign(atom->nlocal + atom->nghost, 0);
  int mine = 0, all = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    double* const saved = last.of(i) + PARTICLE;
    flagged[i] = altered->compare(i, saved);
    mine |= flagged[i];
    altered->save(i, saved);
  }
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MAX, world);
  if (all)
    forward_flagged(flagged, flagged.empty() ? nullptr : altered->of(0), AlteredParticles::EACH);
}

void FixContactStep::repeat_forces(int i, int j,
                                   const cohesion::contact_solver::PairAction& forces) const {
  const auto add = [](double* to, const Vector3& a) {
    to[0] += a.x;
    to[1] += a.y;
    to[2] += a.z;
  };
  add(atom->f[i], -forces.impulse);
  add(atom->torque[i], forces.torque_i);
  if (j < 0 || j >= atom->nlocal) return;
  add(atom->f[j], forces.impulse);
  add(atom->torque[j], forces.torque_j);
}

/// Contact histories are stored by particle ID: styles adapt them when the script has renumbered
/// the particles.
void FixContactStep::follow_renumbering() {
  if (!last.has_room()) return;
  std::vector<tagint> before;
  for (int i = 0; i < atom->nlocal; i++)
    before.push_back(AlteredParticles::id_of(last.of(i) + PARTICLE));
  const Renumbering renumbering(lmp, before);
  if (!renumbering.any()) return;
  for (SoftContactStyle* some : styles) some->renumber(renumbering);
  for (int i = 0; i < atom->nlocal; i++) altered->save_id(i, last.of(i) + PARTICLE);
}

/// Before the first step, velocities are those of the time level itself, not staggered ones.
void FixContactStep::setup(int) {
  post_force(0);
  if (idle) impulses.disable();
}

void FixContactStep::initial_integrate(int) {
  running = true;  // also in a run without set-up
  // Ends the time level before this step, from whose energies the balances start.
  update->ntimestep--;
  end_start();
  if (energy_tally.is_active() && !tallies_begun) begin_tallies();
  update->ntimestep++;
  if (resuming) {
    for (int i = 0; i < atom->nlocal; i++) {
      if (inverse_mass[i] == 0.0) continue;  // held now: fixes have set its force
      const double* const then = last.of(i);
      std::copy_n(then, 3, atom->f[i]);
      std::copy_n(then + TORQUE, 3, atom->torque[i]);
      const Vector3 impulsive = vector(then + IMPULSIVE);
      if (dot(impulsive, impulsive) > 0.0) add_impulsive_force(i, impulsive);
    }
    resuming = false;
    last.free();
  }
  if (!idle && any_exact_scheme) save_accelerations();
  keep_impulses();
}

/// At the beginning of a step, the forces of the last one are complete.
void FixContactStep::save_accelerations() {
  for (int i = 0; i < atom->nlocal; i++)
    put(inverse_mass[i] * (vector(atom->f[i]) - impulsive_forces[i]), accelerations.of(i));
}

/// A force f has already given the momentum f dt/2, and gives f dt'/2 in a step of another length.
/// For forces of persistent contacts this is right to second order. Forces that represent impulses
/// are scaled by dt/dt'. On held particles, fixes have set them to 0.
void FixContactStep::keep_impulses() {
  const double more = forces_dt / update->dt - 1.0;
  if (more != 0.0)
    for (const int i : impulsive_particles) {
      const double forces[] = {impulsive_forces[i].x, impulsive_forces[i].y, impulsive_forces[i].z};
      for (int k = 0; k < 3; k++)
        if (atom->f[i][k] != 0.0) atom->f[i][k] += more * forces[k];
      impulsive_forces[i] = {};  // the list may contain a particle twice
    }
  forget_impulses();
}

void FixContactStep::forget_impulses() {
  for (const int i : impulsive_particles) impulsive_forces[i] = {};
  impulsive_particles.clear();
}

void FixContactStep::pre_force(int) {
  if (neighbor->ago == 0) discard_occasional_lists(neighbor);
  if (idle) {
    forces_dt = update->dt;
    return;
  }
  advise_if_due(false);
  step_due = true;
}

void FixContactStep::post_force(int) {
  compute_contacts([] {});
  if (!idle && mobile->held().any()) hold_spins();
}

/// A held sphere has infinite mass for friction, too, so it must not turn. Walls act later, and
/// exert no torque on it.
void FixContactStep::hold_spins() {
  for (int i = 0; i < atom->nlocal; i++)
    if (mobile->is_held_but_turned(atom->mask[i])) std::fill_n(atom->torque[i], 3, 0.0);
}

/// Runs the time-step check when it is due: in a continued run, too, whose step, coefficients and
/// particles may have changed.
void FixContactStep::advise_if_due(bool setup) {
  if (styles.empty() || !watch->due(setup)) return;
  AdviceOfStyles advice;
  for (SoftContactStyle* some : styles) some->give_advice(watch->now(), advice);
  advice.print(lmp);
}

/// Begins the step. Returns false if another style has begun it already.
bool FixContactStep::begin_step() {
  if (!step_due) return false;
  step_due = false;
  last_dt = forces_dt;
  forces_dt = update->dt;
  update_particles();
  update_readers();
  if (any_exact_scheme && !starting) forward_accelerations();
  // A force f gives the momentum f dt/2 in the half step that follows. The half step before gave
  // the same, except in the first step of a run.
  impulses.begin_step((starting ? 2.0 : 1.0) / update->dt,
                      energy_tally.is_active() && (others_act || energy_tally.is_read()));
  energy_tally.begin_step(atom->nlocal);
  if (energy_tally.is_active()) particle_work->begin_step();
  impulses.begin_contacts();
  return true;
}

void FixContactStep::post_run() {
  end_start();
  report_unresolved();
  if (energy_tally.is_active()) {
    if (!tallies_begun) begin_tallies();
    for_each_energy_tally(modify, [](EnergyTallyCompute& compute) { compute.end_run(); });
  }
  tallies_begun = false;
  running = false;
  altered->save_box();
  if (resuming) return;  // no step was made: `last` is still valid for the next run
  tally_unknown = !idle && !energy_tally.is_read();
  last.grow(atom->nmax);
  for (int i = 0; i < atom->nlocal; i++) save_last(i, last.of(i));
}

/// Stores the numbers of a particle that the next run needs. The forces of a held particle are not
/// stored: contacts exert none on it, and those of fixes alone must not move it when it is
/// released.
void FixContactStep::save_last(int i, double* values) const {
  std::fill_n(values, PARTICLE, 0.0);
  if (inverse_mass[i] > 0.0) {
    std::copy_n(atom->f[i], 3, values);
    std::copy_n(atom->torque[i], 3, values + TORQUE);
    put(impulsive_forces[i], values + IMPULSIVE);
  }
  altered->save(i, values + PARTICLE);
}

void FixContactStep::report_unresolved() {
  double all = 0.0;
  MPI_Allreduce(&unresolved, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  unresolved = 0.0;
  if (all > 0.0 && comm->me == 0)
    error->warning(
        FLERR,
        "scheme exact: {} times in this run a pair, or a particle and a wall, turned "
        "round a hundred times or more within one step, between contact and the edge of the "
        "adhesion or along that edge, and was not resolved to the end of that step: use "
        "a smaller time step",
        all);
}
