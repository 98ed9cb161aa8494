// SPDX-License-Identifier: GPL-2.0-only
#include "contact_energy_tally.h"

#include <algorithm>

#include "atom.h"
#include "memory.h"
#include "output.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::event_stepping;
using cohesion::vector;
using cohesion::Vector3;

static constexpr int MOTION = ContactEnergyTally::OF_PARTICLE;

static void put(const Vector3& a, double* values) {
  values[0] = a.x;
  values[1] = a.y;
  values[2] = a.z;
}

static void add(ContactLosses& to, double factor, const ContactLosses& lost) {
  to.normal_damping += factor * lost.normal_damping;
  to.tangential_damping += factor * lost.tangential_damping;
  to.friction += factor * lost.friction;
  to.rolling += factor * lost.rolling;
}

ContactEnergyTally::ContactEnergyTally(LAMMPS* lammps)
    : Pointers(lammps), readers_(std::make_shared<char>()) {}

ContactEnergyTally::~ContactEnergyTally() {
  memory->destroy(pending_);
  memory->destroy(to_truth_);
}

void ContactEnergyTally::update_readers() {
  const bool ends = update->ntimestep == update->laststep ||
                    (output->restart_flag && update->ntimestep == output->next_restart);
  active_ = ends || has_readers();
  if (!active_ || room_ == atom->nmax) return;
  room_ = atom->nmax;
  memory->grow(pending_, atom->nmax, MOTION, "contact_energy_tally:pending");
  memory->grow(to_truth_, atom->nmax, MOTION, "contact_energy_tally:to_truth");
}

void ContactEnergyTally::begin_step() {
  if (!active_) return;
  add(now_.lost, 1.0, later_.lost);
  now_.external_work += later_.external_work;
  later_ = {};
  now_.stored = {};
  for (int i = 0; i < atom->nlocal + atom->nghost; i++) std::fill_n(pending_[i], MOTION, 0.0);
}

void ContactEnergyTally::store(double fraction, const StoredEnergies& stored) {
  now_.stored.tangential_spring += fraction * stored.tangential_spring;
  now_.stored.rolling_spring += fraction * stored.rolling_spring;
  store_normal(fraction, stored);
}

void ContactEnergyTally::reset_normal() { now_.stored.spring = now_.stored.adhesion = 0.0; }

void ContactEnergyTally::store_normal(double fraction, const StoredEnergies& stored) {
  now_.stored.spring += fraction * stored.spring;
  now_.stored.adhesion += fraction * stored.adhesion;
}

void ContactEnergyTally::add_losses(double fraction, const ContactLosses& lost, double later) {
  if (!active_) return;
  add(now_.lost, (1.0 - later) * fraction, lost);
  add(later_.lost, later * fraction, lost);
}

void ContactEnergyTally::add_work(double done) {
  if (!active_) return;
  now_.external_work += 0.5 * done;
  later_.external_work += 0.5 * done;
}

void ContactEnergyTally::end_step(int i, const Body& body, const Vector3& pushed,
                                  const Vector3& turned) {
  std::fill_n(to_truth_[i], MOTION, 0.0);
  if (body.inverse_mass == 0.0) return;
  put(vector(pending_[i]) - body.inverse_mass * pushed, to_truth_[i]);
  put(vector(pending_[i] + 3) - inverse_inertia(body) * turned, to_truth_[i] + 3);
}

Vector3 ContactEnergyTally::true_velocity(int i) const {
  return vector(atom->v[i]) + vector(to_truth_[i]);
}

Vector3 ContactEnergyTally::true_spin(int i) const {
  return vector(atom->omega[i]) + vector(to_truth_[i] + 3);
}

void ContactEnergyTally::save_motion(int i, double* values) const {
  if (active_)
    std::copy_n(to_truth_[i], MOTION, values);
  else
    std::fill_n(values, MOTION, 0.0);
}

void ContactEnergyTally::restore_motion(int i, const double* values) {
  std::copy_n(values, MOTION, to_truth_[i]);
}

ContactEnergyTally::Totals ContactEnergyTally::totals() const {
  const ContactLosses& lost = later_.lost;
  return {now_.stored.tangential_spring,
          now_.stored.rolling_spring,
          lost.normal_damping,
          lost.tangential_damping,
          lost.friction,
          lost.rolling,
          later_.external_work};
}

void ContactEnergyTally::restore_totals(const Totals& all) {
  now_.stored.tangential_spring = all[0];
  now_.stored.rolling_spring = all[1];
  later_.lost = {all[2], all[3], all[4], all[5]};
  later_.external_work = all[6];
}

double ContactEnergyTally::bytes() const { return 2.0 * MOTION * sizeof(double) * room_; }
