// SPDX-License-Identifier: GPL-2.0-or-later
#include "model_energy_tally.h"

#include <mpi.h>

#include <cstring>

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
using cohesion::contact::SphereMotion;
using namespace cohesion::contact_solver;

namespace {

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

void ModelEnergyTally::store(const ContactModels::SurfacesIntersectData& d,
                             const OtherModels& models, StoredEnergies stored) {
  if (models.displacement >= 0)
    stored.tangential_spring = cohesion::contact::tangential_spring_energy(
        vector(d.contact_history + models.displacement), d.kt);
  stored.rolling_spring = rolling_energy(d, models);
  sums_.store(owned_fraction(d), stored);
}

void ModelEnergyTally::store_sampled(const ContactModels::SurfacesIntersectData& d,
                                     const OtherModels& models, double adhesion) {
  const double fraction = owned_fraction(d);
  sampled_.spring +=
      fraction * cohesion::contact::normal_spring_energy(d.deltan, d.kn, models.exponent);
  sampled_.adhesion += fraction * adhesion;
  store(d, models, {});
}

// What is rare comes last and in functions of its own, whose calls would cost saved registers here.
void ModelEnergyTally::add(const ContactModels::SurfacesIntersectData& d,
                           const ContactModels::ForceData& on_i,
                           const ContactModels::ForceData& on_j, const OtherModels& models,
                           const ContactEnergies* of_normal) {
  if (contacts_ == touching_.size()) return grow_and_add(d, on_i, on_j, models, of_normal);
  Touching& touching = touching_[contacts_++];
  const bool own = is_own_pair(d);
  touching.i = d.i;
  touching.j = own ? d.j : -1;
  cohesion::contact::SampledForces& c = touching.forces;
  c.lever_i = d.cri;
  c.lever_j = d.crj;
  c.normal_dashpot = 0.0;
  if (of_normal)
    sums_.lose_normal(own || d.is_wall ? 1.0 : 0.5, *of_normal);
  else
    c.normal_dashpot = cohesion::contact::normal_dashpot(d.Fn, d.deltan, d.kn);
  std::memcpy(&c.normal, d.en, sizeof(c.normal));
  c.force = vector(on_i.delta_F);
  if (models.displacement >= 0)
    c.without_dashpot = d.kt * vector(d.contact_history + models.displacement);
  if (models.displacement < 0 || !d.shearupdate || models.rolls || d.is_wall)
    add_rare(d, on_i, on_j, models);
}

void ModelEnergyTally::grow_and_add(const ContactModels::SurfacesIntersectData& d,
                                    const ContactModels::ForceData& on_i,
                                    const ContactModels::ForceData& on_j, const OtherModels& models,
                                    const ContactEnergies* of_normal) {
  touching_.resize(2 * contacts_ + 64);
  add(d, on_i, on_j, models, of_normal);
}

void ModelEnergyTally::add_rare(const ContactModels::SurfacesIntersectData& d,
                                const ContactModels::ForceData& on_i,
                                const ContactModels::ForceData& on_j, const OtherModels& models) {
  Touching& c = touching_[contacts_ - 1];
  cohesion::contact::SampledForces& f = c.forces;
  if (models.displacement < 0) f.without_dashpot = {};
  // In a set-up the engine does not shorten the spring of a contact that slides.
  if (models.displacement < 0 || !d.shearupdate) {
    const Vector3 by_dashpot = f.force + f.without_dashpot, slip{d.vtr1, d.vtr2, d.vtr3};
    if (!cohesion::contact::dashpot_acts(by_dashpot, d.gammat, slip))
      f.without_dashpot = dot(f.force, f.normal) * f.normal - f.force;
  }
  if (models.rolls) add_rolling(d, on_i, on_j, c);
  if (d.is_wall) add_wall(d, on_i, c);
}

/// The torques but those of the tangential force.
void ModelEnergyTally::add_rolling(const ContactModels::SurfacesIntersectData& d,
                                   const ContactModels::ForceData& on_i,
                                   const ContactModels::ForceData& on_j, const Touching& c) {
  rolling_torque_.resize(particles_);
  using cohesion::contact::rolling_torque;
  rolling_torque_[c.i] += rolling_torque(vector(on_i.delta_torque), d.cri, c.forces);
  if (c.j >= 0) rolling_torque_[c.j] += rolling_torque(vector(on_j.delta_torque), d.crj, c.forces);
}

void ModelEnergyTally::add_wall(const ContactModels::SurfacesCloseData& d,
                                const ContactModels::ForceData& on_i) {
  if (others_act_) {
    of_contacts_[d.i].force += vector(on_i.delta_F);
    of_contacts_[d.i].torque += vector(on_i.delta_torque);
  }
  work_of_walls_ += dot(vector(on_i.delta_F), vector(d.v_j));
}

void ModelEnergyTally::add_wall(const ContactModels::SurfacesCloseData& d,
                                const ContactModels::ForceData& on_i, const Touching& c) {
  add_wall(d, on_i);
  walls_ += cohesion::contact::wall_powers(c.forces, vector(d.v_j));
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
  contacts_ = 0;
  if (others_act_) of_contacts_.assign(particles_, {});
  rolling_torque_.clear();
  sampled_ = {};
  walls_ = {};
  work_of_walls_ = 0.0;
}

void ModelEnergyTally::begin_step(bool is_read) {
  is_read_ = is_read;
  sums_.begin_step();
  work_.begin_step();
  for (WorkOfForces* some : {&normal_dashpot_, &tangential_dashpot_, &rolling_}) some->begin_step();
  clear();
}

void ModelEnergyTally::begin_set_up(bool others_act) {
  is_read_ = true;
  others_act_ = others_act;
  mobile_ = IntegratedParticles(lmp_);
  last_ = sums_.stored();
  sums_.begin_again();
  work_.begin_again();
  for (WorkOfForces* some : {&normal_dashpot_, &tangential_dashpot_, &rolling_})
    some->begin_again();
  clear();
}

void ModelEnergyTally::end_step() {
  if (is_read_)
    end_read(&Passage::whole, false);
  else
    end_unread();
  add_work_of_walls(0.5 * lmp_->update->dt);
}

void ModelEnergyTally::end_set_up(bool starts, bool known) {
  if (!starts && known) sums_.restore_normal(last_);
  end_read(starts ? &Passage::start : &Passage::second_half, starts);
  add_work_of_walls(0.0);
  if (begun_) return;
  begun_ = true;
  add_so_far(-1.0, before_);
  before_[cohesion::energy_tally::SPRING] = 0.0;  // that is no loss
}

/// The powers of the contacts' forces; `motion_of`: of a particle.
template <class MotionOf>
[[gnu::always_inline]] inline ModelEnergyTally::ContactPowers ModelEnergyTally::powers(
    MotionOf motion_of) const {
  using cohesion::contact::contact_powers;
  ContactPowers sum;
  for (std::size_t k = 0; k < contacts_; k++) {
    const Touching& c = touching_[k];
    sum += c.j < 0 ? contact_powers(c.forces, motion_of(c.i))
                   : contact_powers(c.forces, motion_of(c.i), motion_of(c.j));
  }
  for (std::size_t i = 0; i < rolling_torque_.size(); i++)
    sum.rolling += dot(rolling_torque_[i], motion_of(static_cast<int>(i)).spin);
  return sum;
}

/// Adds what they work in the time `length`, of which `after` is after the time level.
void ModelEnergyTally::add_work(const ContactPowers& power, double length,
                                const ContactPowers& power_after, double after) {
  const auto add = [&](WorkOfForces& work, double all, double later) {
    work.add(length * all - after * later, after * later);
  };
  add(work_.friction, power.friction + power.rolling, power_after.friction + power_after.rolling);
  add(tangential_dashpot_, power.tangential_dashpot, power_after.tangential_dashpot);
  add(normal_dashpot_, power.normal_dashpot, power_after.normal_dashpot);
  add(rolling_, power.rolling, power_after.rolling);
}

ForcesAtLevel ModelEnergyTally::forces_on(int i, const Vector3& weight) const {
  const Vector3 all = vector(lmp_->atom->f[i]), torque = vector(lmp_->atom->torque[i]);
  const ForceAndTorque of_contacts =
      others_act_ ? of_contacts_[i] : ForceAndTorque{all - weight, torque};
  const bool turns = mobile_.is_free(lmp_->atom->mask[i]);
  return {
      all, of_contacts.force, weight, {}, turns ? torque : of_contacts.torque, of_contacts.torque};
}

/// Adds the work of other forces on a particle, and what one that does not move or turn freely
/// gives to others.
void ModelEnergyTally::add_external_work(int i, const ForcesAtLevel& forces,
                                         const Passage& passage) {
  const int mask = lmp_->atom->mask[i];
  if (!mobile_.moves(mask)) {
    work_.external.add(-forces.of_contacts, -forces.of_contacts_torque, passage);
    return;
  }
  if (others_act_) work_.add_external_work(forces, passage);
  if (mobile_.is_not_turned(mask)) work_.external.add({}, -forces.of_contacts_torque, passage);
}

/// Ends a step without output.
void ModelEnergyTally::end_unread() {
  const Atom* const atom = lmp_->atom;
  const double half = 0.5 * lmp_->update->dt;
  const double* const v = particles_ > 0 ? atom->v[0] : nullptr;
  const double* const omega = particles_ > 0 ? atom->omega[0] : nullptr;
  const auto motion_of = [=](int i) {
    return SphereMotion{vector(v + 3 * i), vector(omega + 3 * i)};
  };
  add_work(powers(motion_of), 2.0 * half, {}, 0.0);
  if (!others_act_ && mobile_.all_are_free()) return;
  const GravityOfFixes gravity(lmp_->modify);
  for (int i = 0; i < particles_; i++) {
    const SphereMotion m = motion_of(i);
    add_external_work(i, forces_on(i, atom->rmass[i] * gravity.on(atom->mask[i])),
                      Passage::without_output(m.velocity, m.spin, half));
  }
}

/// Ends a step with output, or the set-up.
template <class MakePassage>
void ModelEnergyTally::end_read(MakePassage make_passage, bool starts) {
  const Atom* const atom = lmp_->atom;
  const GravityOfFixes gravity(lmp_->modify);
  const double half = 0.5 * lmp_->update->dt;
  const double factor = mobile_.inertia_factor(lmp_->domain->dimension);
  std::vector<Passage> passages;
  for (int i = 0; i < particles_; i++) {
    const int mask = atom->mask[i];
    const double inverse_mass = mobile_.moves(mask) ? 1.0 / atom->rmass[i] : 0.0;
    const double inverse_inertia =
        mobile_.is_free(mask) ? inverse_mass / (factor * atom->radius[i] * atom->radius[i]) : 0.0;
    const ForcesAtLevel forces = forces_on(i, atom->rmass[i] * gravity.on(mask));
    passages.push_back(make_passage(vector(atom->v[i]), half * inverse_mass * forces.all,
                                    vector(atom->omega[i]),
                                    half * inverse_inertia * vector(atom->torque[i]), half));
    add_external_work(i, forces, passages.back());
    if (inverse_mass > 0.0 && !starts)
      work_.store_motion(forces, inverse_mass, inverse_inertia, half);
  }
  const Passage times = make_passage({}, {}, {}, {}, half);
  add_work(powers([&](int i) { return SphereMotion{passages[i].velocity, passages[i].spin}; }),
           times.length, powers([&](int i) {
             return SphereMotion{passages[i].velocity_after, passages[i].spin_after};
           }),
           times.after);
}

/// `before` [time]: how much of the step before the time level counts.
void ModelEnergyTally::add_work_of_walls(double before) {
  const double half = 0.5 * lmp_->update->dt;
  const auto add = [&](WorkOfForces& work, double power) {
    work.add(before * power, half * power);
  };
  add(work_.external, work_of_walls_);
  add(work_.friction, walls_.friction);
  add(tangential_dashpot_, walls_.tangential_dashpot);
  add(normal_dashpot_, walls_.normal_dashpot);
}

void ModelEnergyTally::add_so_far(double factor, double* entries) const {
  EnergySums sums = sums_;
  // Of the rolling torques it is not known what is spring, dashpot and slider.
  sums.lose({-normal_dashpot_.so_far(), -tangential_dashpot_.so_far(),
             -rolling_.so_far() - sums_.stored().rolling_spring});
  cohesion::contact_solver::add_so_far(sums, work_, factor, entries);
}

void ModelEnergyTally::add_to(double* entries) const {
  for (int k = 0; k < cohesion::energy_tally::ENTRIES; k++) entries[k] += before_[k];
  add_so_far(1.0, entries);
  add_stored(sums_, work_, entries);
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
