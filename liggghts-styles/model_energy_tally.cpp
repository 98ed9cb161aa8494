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
    double exponent, const OtherModels& models) {
  ContactSample c;
  const Vector3 force = vector(on_i.delta_F);
  c.normal = vector(d.en);
  c.overlap = d.deltan;
  c.stiffness = d.kn;
  c.exponent = exponent;
  c.repulsion = d.Fn;
  c.tangential = force - dot(force, c.normal) * c.normal;
  c.slip = {d.vtr1, d.vtr2, d.vtr3};
  if (models.displacement >= 0) {
    c.displacement = vector(d.contact_history + models.displacement);
    c.tangential_stiffness = d.kt;
  }
  c.tangential_damping = d.gammat;
  return c;
}

double rolling_energy(const ContactModels::SurfacesIntersectData& d, const OtherModels& models) {
  if (models.rolling < 0) return 0.0;
  return cohesion::contact::rolling_spring_energy(
      vector(d.contact_history + models.rolling), d.kt,
      d.is_wall ? d.radi : cohesion::reduced_radius(d.radi, d.radj));
}

}  // namespace

/// A pair that another rank, or an image of itself, has as well.
[[gnu::always_inline]] inline double ModelEnergyTally::owned_fraction(
    const ContactModels::SurfacesCloseData& d) const {
  return !d.is_wall && d.j >= particles_ ? 0.5 : 1.0;
}

[[gnu::always_inline]] inline void ModelEnergyTally::add_friction(
    const ContactModels::SurfacesIntersectData& d, const ContactModels::ForceData& on_i,
    const ContactModels::ForceData& on_j, const ContactSample& c, const OtherModels& models,
    const Vector3& normal_dashpot) {
  OnParticle& i = on_[d.i];
  OnParticle* const j = is_own_pair(d) ? &on_[d.j] : nullptr;
  i.friction += c.tangential;
  if (j) j->friction -= c.tangential;
  const bool sticks = c.sticks();
  if (sticks) {
    const Vector3 dashpot = c.tangential_dashpot(), turn = cross(c.normal, dashpot);
    i.dashpot += dashpot;
    i.dashpot_torque -= d.cri * turn;
    if (j) {
      j->dashpot -= dashpot;
      j->dashpot_torque -= d.crj * turn;
    }
  }
  if (models.rolls) add_rolling(d, on_i, on_j, c.normal, c.tangential);
  if (d.is_wall)
    add_wall(d, on_i, c.tangential, sticks ? c.tangential_dashpot() : Vector3{}, normal_dashpot);
}

/// The torques but those of the tangential force.
[[gnu::noinline]] void ModelEnergyTally::add_rolling(const ContactModels::SurfacesIntersectData& d,
                                                     const ContactModels::ForceData& on_i,
                                                     const ContactModels::ForceData& on_j,
                                                     Vector3 normal, Vector3 tangential) {
  rolling_torque_.resize(on_.size());
  const Vector3 turn = cross(normal, tangential);
  rolling_torque_[d.i] += vector(on_i.delta_torque) + d.cri * turn;
  if (is_own_pair(d)) rolling_torque_[d.j] += vector(on_j.delta_torque) + d.crj * turn;
}

[[gnu::noinline]] void ModelEnergyTally::add_wall(const ContactModels::SurfacesCloseData& d,
                                                  const ContactModels::ForceData& on_i,
                                                  Vector3 friction, Vector3 tangential_dashpot,
                                                  Vector3 normal_dashpot) {
  const Vector3 force = vector(on_i.delta_F), v = vector(d.v_j);
  if (others_act_) {
    of_contacts_[d.i].force += force;
    of_contacts_[d.i].torque += vector(on_i.delta_torque);
  }
  wall_all_ += dot(force, v);
  wall_friction_ += dot(friction, v);
  wall_tangential_dashpot_ += dot(tangential_dashpot, v);
  wall_normal_dashpot_ += dot(normal_dashpot, v);
}

void ModelEnergyTally::add_sampled(const ContactModels::SurfacesCloseData& d,
                                   const ContactModels::ForceData& on_i, double adhesion) {
  if (!d.computeflag) return;  // a force evaluation without a step
  if (is_read_) sampled_.adhesion += owned_fraction(d) * adhesion;
  if (d.is_wall) add_wall(d, on_i);
}

void ModelEnergyTally::add_exact(const ContactModels::SurfacesCloseData& d,
                                 const ContactModels::ForceData& on_i,
                                 const ContactEnergies& of_normal) {
  if (!d.computeflag) return;
  const double fraction = owned_fraction(d);
  if (is_read_) sums_.store(fraction, of_normal.stored);
  sums_.lose_normal(fraction, of_normal);
  if (d.is_wall) add_wall(d, on_i);
}

void ModelEnergyTally::add_sampled(const ContactModels::SurfacesIntersectData& d,
                                   const ContactModels::ForceData& on_i,
                                   const ContactModels::ForceData& on_j, double exponent,
                                   const OtherModels& models, double adhesion) {
  if (!d.computeflag) return;
  const ContactSample c = contact_of(d, on_i, exponent, models);
  if (is_read_) {
    const double fraction = owned_fraction(d);
    sampled_.spring += fraction * c.spring_energy();
    sampled_.adhesion += fraction * adhesion;
    sums_.store(fraction, {0.0, c.tangential_spring_energy(), rolling_energy(d, models), 0.0});
  }
  const Vector3 dashpot = c.normal_dashpot();
  on_[d.i].normal_dashpot += dashpot;
  if (is_own_pair(d)) on_[d.j].normal_dashpot -= dashpot;
  add_friction(d, on_i, on_j, c, models, dashpot);
}

void ModelEnergyTally::add_exact(const ContactModels::SurfacesIntersectData& d,
                                 const ContactModels::ForceData& on_i,
                                 const ContactModels::ForceData& on_j, const OtherModels& models,
                                 const ContactEnergies& of_normal) {
  if (!d.computeflag) return;
  const ContactSample c = contact_of(d, on_i, 1.0, models);
  const double fraction = owned_fraction(d);
  if (is_read_) {
    StoredEnergies stored = of_normal.stored;
    stored.tangential_spring = c.tangential_spring_energy();
    stored.rolling_spring = rolling_energy(d, models);
    sums_.store(fraction, stored);
  }
  sums_.lose_normal(fraction, of_normal);
  add_friction(d, on_i, on_j, c, models, {});
}

void ModelEnergyTally::add_engine_forces(double factor) {
  if (!others_act_) return;
  const Atom* const atom = lmp_->atom;
  for (int i = 0; i < particles_; i++) {
    of_contacts_[i].force += factor * vector(atom->f[i]);
    of_contacts_[i].torque += factor * vector(atom->torque[i]);
  }
}

void ModelEnergyTally::clear() {
  particles_ = lmp_->atom->nlocal;
  on_.assign(particles_, {});
  if (others_act_) of_contacts_.assign(particles_, {});
  rolling_torque_.clear();
  sampled_ = {};
  wall_all_ = wall_friction_ = wall_normal_dashpot_ = wall_tangential_dashpot_ = 0.0;
}

void ModelEnergyTally::begin_step(bool is_read) {
  is_read_ = is_read;
  sums_.begin_step();
  for (WorkOfForces* some : {&normal_dashpot_, &tangential_dashpot_, &rolling_}) some->begin_step();
  clear();
}

void ModelEnergyTally::begin_set_up(bool others_act) {
  is_read_ = true;
  others_act_ = others_act;
  mobile_ = IntegratedParticles(lmp_);
  last_ = sums_.stored();
  sums_.begin_again();
  for (WorkOfForces* some : {&normal_dashpot_, &tangential_dashpot_, &rolling_})
    some->begin_again();
  clear();
}

void ModelEnergyTally::end_step() {
  if (is_read_ || others_act_)
    end(&Passage::whole, false);
  else
    end_without_others();
  add_work_of_walls(0.5 * lmp_->update->dt);
}

void ModelEnergyTally::end_set_up(bool starts, bool known) {
  if (!starts && known) sums_.restore_normal(last_);
  end(starts ? &Passage::start : &Passage::second_half, starts);
  add_work_of_walls(0.0);
  if (begun_) return;
  begun_ = true;
  add_so_far(-1.0, before_);
  before_[cohesion::energy_tally::SPRING] = 0.0;  // that is no loss
}

/// Adds the work of friction and of dashpots on a particle, and that of all contacts on one that
/// does not move or turn freely: it gives this to the others.
[[gnu::always_inline]] inline void ModelEnergyTally::add_work_of_contacts(
    int i, const ForcesAtLevel& forces, bool moves, bool turns, const Passage& passage) {
  const OnParticle& on = on_[i];
  sums_.friction.add(on.friction, forces.of_contacts_torque, passage);
  tangential_dashpot_.add(on.dashpot, on.dashpot_torque, passage);
  normal_dashpot_.add(on.normal_dashpot, {}, passage);
  if (!rolling_torque_.empty()) rolling_.add({}, rolling_torque_[i], passage);
  if (!moves)
    sums_.external.add(-forces.of_contacts, -forces.of_contacts_torque, passage);
  else if (!turns)
    sums_.external.add({}, -forces.of_contacts_torque, passage);
}

/// A step without output, where only contacts and gravity act.
void ModelEnergyTally::end_without_others() {
  const Atom* const atom = lmp_->atom;
  const GravityOfFixes gravity(lmp_->modify);
  const double half = 0.5 * lmp_->update->dt;
  for (int i = 0; i < particles_; i++) {
    const int mask = atom->mask[i];
    const bool moves = mobile_.moves(mask), turns = mobile_.turns(mask);
    const Vector3 weight = moves ? Vector3{} : atom->rmass[i] * gravity.on(mask);
    const Vector3 torque = vector(atom->torque[i]);
    add_work_of_contacts(i, {{}, vector(atom->f[i]) - weight, {}, {}, torque, torque}, moves, turns,
                         Passage::without_output(vector(atom->v[i]), vector(atom->omega[i]), half));
  }
}

/// Any other step, and the set-up.
template <class MakePassage>
void ModelEnergyTally::end(MakePassage make_passage, bool starts) {
  const Atom* const atom = lmp_->atom;
  const GravityOfFixes gravity(lmp_->modify);
  const double half = 0.5 * lmp_->update->dt;
  const double factor = mobile_.inertia_factor(lmp_->domain->dimension);
  for (int i = 0; i < particles_; i++) {
    const int mask = atom->mask[i];
    const bool moves = mobile_.moves(mask), turns = moves && mobile_.turns(mask);
    const Vector3 all = vector(atom->f[i]), weight = atom->rmass[i] * gravity.on(mask);
    const ForceAndTorque of_contacts =
        others_act_ ? of_contacts_[i] : ForceAndTorque{all - weight, vector(atom->torque[i])};
    const Vector3 torque = turns ? vector(atom->torque[i]) : of_contacts.torque;
    const ForcesAtLevel forces{all,    of_contacts.force, weight, on_[i].friction,
                               torque, of_contacts.torque};
    const double inverse_mass = moves ? 1.0 / atom->rmass[i] : 0.0;
    const double inverse_inertia =
        turns ? inverse_mass / (factor * atom->radius[i] * atom->radius[i]) : 0.0;
    const Vector3 velocity = vector(atom->v[i]), spin = vector(atom->omega[i]);
    const Passage passage =
        is_read_ ? make_passage(velocity, half * inverse_mass * all, spin,
                                half * inverse_inertia * vector(atom->torque[i]), half)
                 : Passage::without_output(velocity, spin, half);
    add_work_of_contacts(i, forces, moves, turns, passage);
    if (moves && others_act_) sums_.add_external_work(forces, passage);
    if (moves && is_read_ && !starts)
      sums_.store_motion(forces, inverse_mass, inverse_inertia, half);
  }
}

/// `before` [time]: how much of the step before the time level counts.
void ModelEnergyTally::add_work_of_walls(double before) {
  const double half = 0.5 * lmp_->update->dt;
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
