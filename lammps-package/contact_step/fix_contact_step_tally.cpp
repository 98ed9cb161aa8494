// SPDX-License-Identifier: GPL-2.0-only
// The part of FixContactStep that keeps the energy balance: who reads it, and the work of forces.
#include <vector>

#include "atom.h"
#include "common/energy_tally_of_runs.h"
#include "contact_solver/energy_balance.h"
#include "contact_solver/flux_parts.h"
#include "contact_step/fix_contact_step.h"
#include "engine/gravity.h"
#include "modify.h"
#include "output.h"
#include "update.h"

using namespace LAMMPS_NS;
using cohesion::vector;
using cohesion::Vector3;
using cohesion::contact_solver::ContactLosses;
using cohesion::contact_solver::ForcesAtLevel;
using cohesion::contact_solver::Passage;
using cohesion::contact_solver::StoredEnergies;

void FixContactStep::update_readers() {
  const bigint now = update->ntimestep;
  const bool may_be_continued =
      now == update->laststep || (output->restart_flag && now == output->next_restart);
  const bool read = starting || resuming || reads_energy_tally(modify, now) || may_end_here();
  energy_tally.update_readers(may_be_continued, read);
  flux_wanted = flux_readers.use_count() > 1;
}

void FixContactStep::add_flux(double fraction, const Vector3& separation, const Vector3& on_j,
                              const Vector3& by_contact) {
  flux_parts->add(fraction, separation, on_j, by_contact);
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
                               vector(&weight[3 * i]),  kick * energy_tally.friction_on(i),
                               vector(atom->torque[i]), impulses.torque(i)};
    const Passage passage = reads ? passage_of(i, starts, half) : short_passage_of(i, half);
    particle_work->friction.add(forces.friction, forces.of_contacts_torque, passage);
    if (others_act) particle_work->add_external_work(forces, passage);
    if (reads && !starts)
      particle_work->store_motion(forces, inverse_mass[i],
                                  cohesion::contact_solver::inverse_inertia(body(i)), half);
  }
}

/// The same in a step without output, where only contacts and gravity act.
void FixContactStep::tally_friction() {
  const double half = 0.5 * forces_dt, kick = impulses.kick();
  for (int i = 0; i < atom->nlocal; i++)
    if (inverse_mass[i] != 0.0)
      particle_work->friction.add(kick * energy_tally.friction_on(i), vector(atom->torque[i]),
                                  short_passage_of(i, half));
}

void FixContactStep::add_wall_work(double done, double by_friction) {
  if (!energy_tally.is_active()) return;
  particle_work->external.add(0.5 * done, 0.5 * done);
  particle_work->friction.add(0.5 * by_friction, 0.5 * by_friction);
}

FixContactStep::Totals FixContactStep::totals() const {
  const StoredEnergies& stored = energy_tally.stored();
  const ContactLosses& lost = energy_tally.lost_later();
  return {stored.tangential_spring,
          stored.rolling_spring,
          lost.normal_damping,
          lost.tangential_damping,
          lost.rolling,
          particle_work->friction.later(),
          particle_work->external.later(),
          stored.load + particle_work->motion(),
          energy_tally.exchanged()};
}

void FixContactStep::restore_totals(const Totals& all) {
  energy_tally.restore({0.0, all[0], all[1], 0.0, all[7]}, {all[2], all[3], all[4]}, all[8]);
  particle_work->friction.restore_later(all[5]);
  particle_work->external.restore_later(all[6]);
}

inline Passage FixContactStep::short_passage_of(int i, double half) const {
  return Passage::without_output(vector(atom->v[i]), vector(atom->omega[i]), half);
}

Passage FixContactStep::passage_of(int i, bool starts, double half) const {
  const double inverse_inertia = cohesion::contact_solver::inverse_inertia(body(i));
  const Vector3 kick = (half * inverse_mass[i]) * vector(atom->f[i]);
  const Vector3 turn = (half * inverse_inertia) * vector(atom->torque[i]);
  return starts ? Passage::start(vector(atom->v[i]), kick, vector(atom->omega[i]), turn, half)
                : Passage::whole(vector(atom->v[i]), kick, vector(atom->omega[i]), turn, half);
}

/// Energy balances begin when all fixes have been set up, or at the end of a run without steps.
void FixContactStep::begin_tallies() {
  for_each_energy_tally(modify, [](EnergyTallyCompute& compute) { compute.begin_run(); });
  tallies_begun = true;
}
