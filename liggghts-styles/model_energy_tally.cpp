// SPDX-License-Identifier: GPL-2.0-or-later
#include "model_energy_tally.h"

#include <mpi.h>

#include "atom.h"
#include "domain.h"
#include "gravity_of_fixes.h"
#include "sphere.h"
#include "update.h"

namespace LIGGGHTS {
namespace Cohesion {

using namespace LAMMPS_NS;
using cohesion::vector;
using cohesion::Vector3;
using namespace cohesion::contact_solver;
using cohesion::contact::ContactSample;

namespace {

[[gnu::always_inline]] inline ContactSample contact_of(
    const ContactModels::SurfacesIntersectData& d, const ContactModels::ForceData& on_i,
    const ContactModels::ForceData& on_j, double exponent, const OtherModels& models) {
  ContactSample c;
  const Vector3 force = vector(on_i.delta_F);
  c.normal = vector(d.en);
  c.overlap = d.deltan;
  c.stiffness = d.kn;
  c.exponent = exponent;
  c.repulsion = d.Fn;
  c.attraction = d.Fn - dot(force, c.normal);
  c.tangential = force - dot(force, c.normal) * c.normal;
  c.slip = {d.vtr1, d.vtr2, d.vtr3};
  c.lever_i = d.cri;
  c.lever_j = d.is_wall ? 0.0 : d.crj;
  if (models.displacement >= 0) {
    c.displacement = vector(d.contact_history + models.displacement);
    c.tangential_stiffness = d.kt;
  }
  c.tangential_damping = d.gammat;
  c.rolls = models.rolls;
  if (!c.rolls) return c;
  const Vector3 turn = cross(c.normal, c.tangential);
  c.rolling_i = vector(on_i.delta_torque) + c.lever_i * turn;
  if (!d.is_wall) c.rolling_j = vector(on_j.delta_torque) + c.lever_j * turn;
  if (models.rolling >= 0)
    c.rolling_energy = cohesion::contact::rolling_spring_energy(
        vector(d.contact_history + models.rolling), d.kt,
        d.is_wall ? d.radi : cohesion::reduced_radius(d.radi, d.radj));
  return c;
}

}  // namespace

/// A pair that another rank, or an image of itself, has as well.
[[gnu::always_inline]] inline double ModelEnergyTally::owned_fraction(
    const ContactModels::SurfacesCloseData& d) const {
  return !d.is_wall && d.j >= lmp_->atom->nlocal ? 0.5 : 1.0;
}

[[gnu::always_inline]] inline void ModelEnergyTally::add_forces(
    const ContactModels::SurfacesCloseData& d, const ContactSample& c) {
  OnParticle& on_i = on_[d.i];
  OnParticle* const on_j = is_own_pair(d) ? &on_[d.j] : nullptr;
  on_i.friction += c.tangential;
  if (on_j) on_j->friction -= c.tangential;
  const Vector3 dashpot = c.tangential_dashpot(), turn = cross(c.normal, dashpot);
  on_i.dashpot += dashpot;
  on_i.dashpot_torque -= c.lever_i * turn;
  if (on_j) {
    on_j->dashpot -= dashpot;
    on_j->dashpot_torque -= c.lever_j * turn;
  }
  if (c.rolls) add_rolling(d, c);
  if (d.is_wall) add_wall(d, c, dashpot);
}

[[gnu::always_inline]] inline void ModelEnergyTally::add_rolling(
    const ContactModels::SurfacesCloseData& d, const ContactSample& c) {
  rolling_torque_.resize(on_.size());
  rolling_torque_[d.i] += c.rolling_i;
  if (is_own_pair(d)) rolling_torque_[d.j] += c.rolling_j;
}

[[gnu::always_inline]] inline void ModelEnergyTally::add_normal_dashpot(
    const ContactModels::SurfacesCloseData& d, const Vector3& dashpot) {
  if (normal_dashpot_force_.empty()) normal_dashpot_force_.resize(on_.size());
  normal_dashpot_force_[d.i] += dashpot;
  if (is_own_pair(d)) normal_dashpot_force_[d.j] -= dashpot;
  if (d.is_wall) wall_normal_dashpot_ += dot(dashpot, vector(d.v_j));
}

[[gnu::always_inline]] inline void ModelEnergyTally::add_wall(
    const ContactModels::SurfacesCloseData& d, const ContactSample& c, const Vector3& dashpot) {
  const Vector3 force = c.force_on_i(), v = vector(d.v_j);
  on_[d.i].force += force;
  on_[d.i].torque += c.rolling_i - c.lever_i * cross(c.normal, c.tangential);
  wall_all_ += dot(force, v);
  wall_friction_ += dot(c.tangential, v);
  wall_tangential_dashpot_ += dot(dashpot, v);
}

[[gnu::always_inline]] inline void ModelEnergyTally::add_of_sampled(
    const ContactModels::SurfacesCloseData& d, const ContactSample& c, double adhesion) {
  if (!d.computeflag) return;  // a force evaluation without a step
  if (is_read_) {
    const double fraction = owned_fraction(d);
    sampled_.spring += fraction * c.spring_energy();
    sampled_.adhesion += fraction * adhesion;
    sums_.store(fraction, {0.0, c.tangential_spring_energy(), c.rolling_energy, 0.0});
  }
  add_normal_dashpot(d, c.normal_dashpot());
  add_forces(d, c);
}

void ModelEnergyTally::add_sampled(const ContactModels::SurfacesCloseData& d,
                                   const ContactSample& c, double adhesion) {
  add_of_sampled(d, c, adhesion);
}

void ModelEnergyTally::add_sampled(const ContactModels::SurfacesIntersectData& d,
                                   const ContactModels::ForceData& on_i,
                                   const ContactModels::ForceData& on_j, double exponent,
                                   const OtherModels& models, double adhesion) {
  add_of_sampled(d, contact_of(d, on_i, on_j, exponent, models), adhesion);
}

[[gnu::always_inline]] inline void ModelEnergyTally::add_of_exact(
    const ContactModels::SurfacesCloseData& d, const ContactSample& c,
    const ContactEnergies& of_normal) {
  if (!d.computeflag) return;
  const double fraction = owned_fraction(d);
  if (is_read_) {
    StoredEnergies stored = of_normal.stored;
    stored.tangential_spring = c.tangential_spring_energy();
    stored.rolling_spring = c.rolling_energy;
    sums_.store(fraction, stored);
  }
  sums_.lose_normal(fraction, of_normal);
  add_forces(d, c);
}

void ModelEnergyTally::add_exact(const ContactModels::SurfacesCloseData& d, const ContactSample& c,
                                 const ContactEnergies& of_normal) {
  add_of_exact(d, c, of_normal);
}

void ModelEnergyTally::add_exact(const ContactModels::SurfacesIntersectData& d,
                                 const ContactModels::ForceData& on_i,
                                 const ContactModels::ForceData& on_j, const OtherModels& models,
                                 const ContactEnergies& of_normal) {
  add_of_exact(d, contact_of(d, on_i, on_j, 1.0, models), of_normal);
}

void ModelEnergyTally::add_engine_forces(double factor) {
  const Atom* const atom = lmp_->atom;
  for (int i = 0; i < atom->nlocal; i++) {
    on_[i].force += factor * vector(atom->f[i]);
    on_[i].torque += factor * vector(atom->torque[i]);
  }
}

void ModelEnergyTally::clear() {
  on_.assign(lmp_->atom->nlocal, {});
  rolling_torque_.clear();
  normal_dashpot_force_.clear();
  sampled_ = {};
  wall_all_ = wall_friction_ = wall_normal_dashpot_ = wall_tangential_dashpot_ = 0.0;
}

void ModelEnergyTally::begin_step(bool is_read) {
  is_read_ = is_read;
  sums_.begin_step();
  for (WorkOfForces* some : {&normal_dashpot_, &tangential_dashpot_, &rolling_}) some->begin_step();
  clear();
}

void ModelEnergyTally::begin_set_up() {
  is_read_ = true;
  last_ = sums_.stored();
  sums_.begin_again();
  for (WorkOfForces* some : {&normal_dashpot_, &tangential_dashpot_, &rolling_})
    some->begin_again();
  clear();
}

void ModelEnergyTally::end_step() { end(&Passage::whole, 0.5 * lmp_->update->dt, false); }

void ModelEnergyTally::end_set_up(bool starts, bool known) {
  if (!starts && known) sums_.restore_normal(last_);
  end(starts ? &Passage::start : &Passage::second_half, 0.0, starts);
  if (begun_) return;
  begun_ = true;
  add_so_far(-1.0, before_);
  before_[cohesion::energy_tally::SPRING] = 0.0;  // that is no loss
}

/// Adds the work of all forces. `before` [time]: how much of the step before the time level counts.
template <class MakePassage>
void ModelEnergyTally::end(MakePassage make_passage, double before, bool starts) {
  const Atom* const atom = lmp_->atom;
  const IntegratedParticles mobile(lmp_);
  const GravityOfFixes gravity(lmp_->modify);
  const double half = 0.5 * lmp_->update->dt;
  const double factor = mobile.inertia_factor(lmp_->domain->dimension);
  const auto forces_on = [&](int i, bool turns) {
    const OnParticle& on = on_[i];
    const Vector3 weight = atom->rmass[i] * gravity.on(atom->mask[i]);
    const Vector3 torque = turns ? vector(atom->torque[i]) : on.torque;
    return ForcesAtLevel{vector(atom->f[i]), on.force, weight, on.friction, torque, on.torque};
  };
  const auto add_work = [&](int i, bool moves, bool turns, const Passage& passage)
                            __attribute__((always_inline)) {
                              const OnParticle& on = on_[i];
                              tangential_dashpot_.add(on.dashpot, on.dashpot_torque, passage);
                              if (!rolling_torque_.empty())
                                rolling_.add({}, rolling_torque_[i], passage);
                              if (!normal_dashpot_force_.empty())
                                normal_dashpot_.add(normal_dashpot_force_[i], {}, passage);
                              if (moves) {
                                sums_.end_step(forces_on(i, turns), passage);
                                if (!turns) sums_.external.add({}, -on.torque, passage);
                              } else {
                                // What leads a particle gives to the others.
                                sums_.friction.add(on.friction, on.torque, passage);
                                sums_.external.add(-on.force, -on.torque, passage);
                              }
                            };
  for (int i = 0; i < atom->nlocal; i++) {
    const int mask = atom->mask[i];
    const bool moves = mobile.moves(mask), turns = moves && !mobile.is_not_turned(mask);
    const Vector3 velocity = vector(atom->v[i]), spin = vector(atom->omega[i]);
    if (!is_read_) {
      add_work(i, moves, turns, Passage::without_output(velocity, spin, half));
      continue;
    }
    const double inverse_mass = moves ? 1.0 / atom->rmass[i] : 0.0;
    const double inverse_inertia =
        turns ? inverse_mass / (factor * atom->radius[i] * atom->radius[i]) : 0.0;
    add_work(i, moves, turns,
             make_passage(velocity, half * inverse_mass * vector(atom->f[i]), spin,
                          half * inverse_inertia * vector(atom->torque[i]), half));
    if (moves && !starts)
      sums_.store_motion(forces_on(i, turns), inverse_mass, inverse_inertia, half);
  }
  const auto add = [&](WorkOfForces& work, double power) {
    work.add(before * power, half * power);
  };
  add(sums_.external, wall_all_);
  add(sums_.friction, -wall_friction_);
  add(tangential_dashpot_, -wall_tangential_dashpot_);
  add(normal_dashpot_, -wall_normal_dashpot_);
}

void ModelEnergyTally::add_so_far(double factor, double* entries) const {
  EnergySums sums = sums_;
  // Of the rolling torques it is not known what is spring, dashpot and slider.
  sums.lose({-normal_dashpot_.so_far(), -tangential_dashpot_.so_far(),
             -rolling_.so_far() - sums_.stored().rolling_spring});
  sums.add_so_far(factor, entries);
}

void ModelEnergyTally::add_to(double* entries) const {
  for (int k = 0; k < cohesion::energy_tally::ENTRIES; k++) entries[k] += before_[k];
  add_so_far(1.0, entries);
  sums_.add_stored(entries);
  entries[cohesion::energy_tally::SPRING] += sampled_.spring;
  entries[cohesion::energy_tally::ADHESION] += sampled_.adhesion;
}

void ModelEnergyTally::store_totals(double* values) const {
  values[0] = sums_.stored().spring;
  values[1] = sums_.stored().adhesion;
  values[2] = sums_.stored().load;
  values[3] = sums_.lost_later().normal_damping;
  values[4] = sums_.exchanged();
}

void ModelEnergyTally::restore_totals(const double* values) {
  sums_.restore({values[0], 0.0, 0.0, values[1], values[2]}, {values[3]}, values[4]);
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
