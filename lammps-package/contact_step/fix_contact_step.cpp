// SPDX-License-Identifier: GPL-2.0-only
#include "contact_step/fix_contact_step.h"

#include <algorithm>
#include <string>

#include "atom.h"
#include "comm.h"
#include "common/energy_tally_of_runs.h"
#include "common/renumbering.h"
#include "domain.h"
#include "engine/gravity.h"
#include "engine/occasional_lists.h"
#include "error.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "soft_contacts/contact_advice.h"
#include "update.h"

using namespace LAMMPS_NS;
using cohesion::vector;
using cohesion::Vector3;
using cohesion::contact_solver::ForcesAtLevel;
using cohesion::contact_solver::Passage;

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
      forwarded_flags(nullptr),
      forwarded_values(nullptr),
      values_each(0),
      may_have_contacts(true),
      idle(false),
      resuming(false),
      starting(false),
      running(false),
      tallies_begun(false),
      tally_unknown(false),
      warned_of_unturned(false),
      warned_of_held(false),
      warned_of_partly_held(false),
      warned_of_added_contacts(false),
      altered(lammps),
      forces_dt(0.0),
      last(lammps, LAST),
      accelerations(lammps, 3),
      inverse_mass(nullptr),
      longest_flight(0.0),
      unresolved(0.0),
      flux_readers(std::make_shared<char>()),
      flux_wanted(false) {
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
  altered.forget();
}

/// Finds the particles that scripts have altered since the last run, and stores the current ones in
/// their place.
void FixContactStep::find_altered() {
  altered.start();
  flagged.assign(atom->nlocal + atom->nghost, 0);
  int mine = 0, all = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    double* const saved = last.of(i) + PARTICLE;
    flagged[i] = altered.compare(i, saved);
    mine |= flagged[i];
    altered.save(i, saved);
  }
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MAX, world);
  if (all)
    forward_flagged(flagged, flagged.empty() ? nullptr : altered.of(0), AlteredParticles::EACH);
}

void FixContactStep::repeat_forces(int i, int j,
                                   const cohesion::contact_solver::PairImpulse& forces) const {
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
  for (int i = 0; i < atom->nlocal; i++) altered.save_id(i, last.of(i) + PARTICLE);
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

/// Energy balances begin when all fixes have been set up, or at the end of a run without steps.
void FixContactStep::begin_tallies() {
  for_each_energy_tally(modify, [](EnergyTallyCompute& compute) { compute.begin_run(); });
  tallies_begun = true;
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
  if (!idle && mobile.held().any()) hold_spins();
}

/// A held sphere has infinite mass for friction, too, so it must not turn. Walls act later, and
/// exert no torque on it.
void FixContactStep::hold_spins() {
  for (int i = 0; i < atom->nlocal; i++)
    if (mobile.is_held_but_turned(atom->mask[i])) std::fill_n(atom->torque[i], 3, 0.0);
}

/// Runs the time-step check when it is due: in a continued run, too, whose step, coefficients and
/// particles may have changed.
void FixContactStep::advise_if_due(bool setup) {
  if (advised.empty() || !watch->due(setup)) return;
  AdviceOfStyles advice;
  for (AdvisedStyle* one : advised) one->give_advice(watch->now(), advice);
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
  impulses.begin_contacts();
  return true;
}

void FixContactStep::update_readers() {
  const bigint now = update->ntimestep;
  const bool may_be_continued =
      now == update->laststep || (output->restart_flag && now == output->next_restart);
  const bool read = starting || resuming || reads_energy_tally(modify, now) || may_end_here();
  energy_tally.update_readers(may_be_continued, read);
  flux_wanted = flux_readers.use_count() > 1;
}

/// Whether a fix halt may end the run with this step.
bool FixContactStep::may_end_here() const {
  for (int i = 0; i < modify->nfix; i++)
    if (utils::strmatch(modify->fix[i]->style, "^halt") &&
        update->ntimestep % modify->fix[i]->nevery == 0)
      return true;
  return false;
}

/// Ends the first time level of a run, when all of its forces are summed.
void FixContactStep::end_start() {
  if (starting && !idle && energy_tally.is_active()) tally_work(true);
  starting = false;
}

void FixContactStep::end_of_step() {
  if (!idle && energy_tally.is_active()) tally_work(false);
}

/// Adds the work of friction and of all other forces except contacts and gravity at this time level
/// to the energy balance.
void FixContactStep::tally_work(bool starts) {
  const bool reads = energy_tally.is_read();
  if (!others_act && !reads) return tally_friction();
  const double half = 0.5 * forces_dt;  // update->dt may be that of the next step already
  const double kick = impulses.kick();
  const std::vector<double> weight = weights(lmp);
  for (int i = 0; i < atom->nlocal; i++) {
    if (inverse_mass[i] == 0.0) continue;
    const ForcesAtLevel forces{vector(atom->f[i]),      impulses.force(i),
                               vector(&weight[3 * i]),  kick * energy_tally.friction(i),
                               vector(atom->torque[i]), impulses.torque(i)};
    const Passage passage = reads ? passage_of(i, starts, half) : short_passage_of(i, half);
    energy_tally.friction_work().add(forces.friction, forces.of_contacts_torque, passage);
    if (others_act) energy_tally.add_external_work(forces, passage);
    if (reads && !starts)
      energy_tally.store_motion(forces, inverse_mass[i],
                                cohesion::contact_solver::inverse_inertia(body(i)), half);
  }
}

/// The same in a step without output, where only contacts and gravity act.
void FixContactStep::tally_friction() {
  const double half = 0.5 * forces_dt, kick = impulses.kick();
  for (int i = 0; i < atom->nlocal; i++)
    if (inverse_mass[i] != 0.0)
      energy_tally.friction_work().add(kick * energy_tally.friction(i), vector(atom->torque[i]),
                                       short_passage_of(i, half));
}

Passage FixContactStep::passage_of(int i, bool starts, double half) const {
  const double inverse_inertia = cohesion::contact_solver::inverse_inertia(body(i));
  const Vector3 kick = (half * inverse_mass[i]) * vector(atom->f[i]);
  const Vector3 turn = (half * inverse_inertia) * vector(atom->torque[i]);
  return starts ? Passage::start(vector(atom->v[i]), kick, vector(atom->omega[i]), turn, half)
                : Passage::whole(vector(atom->v[i]), kick, vector(atom->omega[i]), turn, half);
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
  altered.save_box();
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
  altered.save(i, values + PARTICLE);
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
