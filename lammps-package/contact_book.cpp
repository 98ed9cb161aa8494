// SPDX-License-Identifier: GPL-2.0-only
#include "contact_book.h"

#include <algorithm>

#include "atom.h"
#include "memory.h"
#include "output.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::event_stepping;
using cohesion::vector;
using cohesion::Vector3;

static constexpr int MOTION = ContactBook::OF_PARTICLE;

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

ContactBook::ContactBook(LAMMPS* lammps) : Pointers(lammps), readers_(std::make_shared<char>()) {}

ContactBook::~ContactBook() {
  memory->destroy(owed_);
  memory->destroy(to_truth_);
}

void ContactBook::update_readers() {
  const bool ends = update->ntimestep == update->laststep ||
                    (output->restart_flag && update->ntimestep == output->next_restart);
  kept_ = ends || is_read();
  if (!kept_ || room_ == atom->nmax) return;
  room_ = atom->nmax;
  memory->grow(owed_, atom->nmax, MOTION, "contact_book:owed");
  memory->grow(to_truth_, atom->nmax, MOTION, "contact_book:to_truth");
}

void ContactBook::begin_step() {
  if (!kept_) return;
  add(now_.lost, 1.0, later_.lost);
  now_.external_work += later_.external_work;
  later_ = {};
  now_.stored = {};
  for (int i = 0; i < atom->nlocal + atom->nghost; i++) std::fill_n(owed_[i], MOTION, 0.0);
}

void ContactBook::store(double fraction, const StoredEnergies& stored) {
  now_.stored.tangential_spring += fraction * stored.tangential_spring;
  now_.stored.rolling_spring += fraction * stored.rolling_spring;
  store_again(fraction, stored);
}

void ContactBook::begin_again() { now_.stored.spring = now_.stored.adhesion = 0.0; }

void ContactBook::store_again(double fraction, const StoredEnergies& stored) {
  now_.stored.spring += fraction * stored.spring;
  now_.stored.adhesion += fraction * stored.adhesion;
}

void ContactBook::lose(double fraction, const ContactLosses& lost, double later) {
  if (!kept_) return;
  add(now_.lost, (1.0 - later) * fraction, lost);
  add(later_.lost, later * fraction, lost);
}

void ContactBook::work(double done) {
  if (!kept_) return;
  now_.external_work += 0.5 * done;
  later_.external_work += 0.5 * done;
}

void ContactBook::end_step(int i, const Body& body, const Vector3& pushed, const Vector3& turned) {
  std::fill_n(to_truth_[i], MOTION, 0.0);
  if (body.inverse_mass == 0.0) return;
  put(vector(owed_[i]) - body.inverse_mass * pushed, to_truth_[i]);
  put(vector(owed_[i] + 3) - inverse_inertia(body) * turned, to_truth_[i] + 3);
}

Vector3 ContactBook::true_velocity(int i) const {
  return vector(atom->v[i]) + vector(to_truth_[i]);
}

Vector3 ContactBook::true_spin(int i) const {
  return vector(atom->omega[i]) + vector(to_truth_[i] + 3);
}

void ContactBook::note_motion(int i, double* values) const {
  if (kept_)
    std::copy_n(to_truth_[i], MOTION, values);
  else
    std::fill_n(values, MOTION, 0.0);
}

void ContactBook::take_motion(int i, const double* values) {
  std::copy_n(values, MOTION, to_truth_[i]);
}

ContactBook::OfAll ContactBook::of_all() const {
  const ContactLosses& lost = later_.lost;
  return {now_.stored.tangential_spring,
          now_.stored.rolling_spring,
          lost.normal_damping,
          lost.tangential_damping,
          lost.friction,
          lost.rolling,
          later_.external_work};
}

void ContactBook::take_of_all(const OfAll& all) {
  now_.stored.tangential_spring = all[0];
  now_.stored.rolling_spring = all[1];
  later_.lost = {all[2], all[3], all[4], all[5]};
  later_.external_work = all[6];
}

double ContactBook::bytes() const { return 2.0 * MOTION * sizeof(double) * room_; }
