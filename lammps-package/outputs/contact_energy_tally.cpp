// SPDX-License-Identifier: GPL-2.0-only
#include "contact_energy_tally.h"

#include "atom.h"
#include "output.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::contact_solver;
using cohesion::vector;
using cohesion::Vector3;

static void add(ContactLosses& to, double factor, const ContactLosses& lost) {
  to.normal_damping += factor * lost.normal_damping;
  to.tangential_damping += factor * lost.tangential_damping;
  to.rolling += factor * lost.rolling;
}

ContactEnergyTally::ContactEnergyTally(LAMMPS* lammps)
    : Pointers(lammps), readers_(std::make_shared<char>()) {}

void ContactEnergyTally::update_readers() {
  const bool ends = update->ntimestep == update->laststep ||
                    (output->restart_flag && update->ntimestep == output->next_restart);
  active_ = ends || has_readers();
}

void ContactEnergyTally::begin_step() {
  if (!active_) return;
  add(now_.lost, 1.0, later_.lost);
  now_.external_work += later_.external_work;
  now_.friction_work += later_.friction_work;
  friction_.assign(atom->nlocal, {});
  later_ = {};
  now_.stored = {};
}

void ContactEnergyTally::store(double fraction, const ContactEnergies& energies) {
  const StoredEnergies& stored = energies.stored;
  now_.exchanged += fraction * energies.exchanged;
  now_.stored.tangential_spring += fraction * stored.tangential_spring;
  now_.stored.rolling_spring += fraction * stored.rolling_spring;
  now_.stored.load += fraction * stored.load;
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

void ContactEnergyTally::add_friction_work(double done) {
  if (!active_) return;
  now_.friction_work += 0.5 * done;
  later_.friction_work += 0.5 * done;
}

void ContactEnergyTally::end_step(int i, const Body& body, const Forces& forces, double half,
                                  bool starts) {
  const Vector3 v = vector(atom->v[i]), spin = vector(atom->omega[i]);
  const Vector3 kick = (half * body.inverse_mass) * forces.all;
  const Vector3 turn = (half * inverse_inertia(body)) * forces.torque;
  const Vector3 friction = friction_[i];
  const Vector3 others = forces.all - forces.of_contacts - forces.weight;
  if (starts) {
    const Vector3 mean = v + 0.5 * kick;
    later_.external_work += half * dot(others, mean);
    later_.friction_work +=
        half * (dot(friction, mean) + dot(forces.of_contacts_torque, spin + 0.5 * turn));
    return;
  }
  now_.external_work += half * dot(others, v - kick);
  later_.external_work += half * dot(others, v + kick);
  now_.friction_work +=
      half * (dot(friction, v - kick) + dot(forces.of_contacts_torque, spin - turn));
  later_.friction_work +=
      half * (dot(friction, v + kick) + dot(forces.of_contacts_torque, spin + turn));
  // Work is beside 1/2 m v_(n-1/2) v_(n+1/2), the engine has v_n = (v_(n-1/2) + v_(n+1/2))/2.
  // Without contacts nothing is stored.
  const auto part = [](const Vector3& all, const Vector3& of_contacts) {
    return dot(2.0 * all - of_contacts, of_contacts);
  };
  now_.stored.load -= 0.5 * half * half *
                      (body.inverse_mass * part(forces.all, forces.of_contacts) +
                       inverse_inertia(body) * part(forces.torque, forces.of_contacts_torque));
}

ContactEnergyTally::Totals ContactEnergyTally::totals() const {
  const ContactLosses& lost = later_.lost;
  return {now_.stored.tangential_spring,
          now_.stored.rolling_spring,
          lost.normal_damping,
          lost.tangential_damping,
          lost.rolling,
          later_.friction_work,
          later_.external_work,
          now_.stored.load,
          now_.exchanged};
}

void ContactEnergyTally::restore_totals(const Totals& all) {
  now_.stored.tangential_spring = all[0];
  now_.stored.rolling_spring = all[1];
  later_.lost = {all[2], all[3], all[4]};
  later_.friction_work = all[5];
  later_.external_work = all[6];
  now_.stored.load = all[7];
  now_.exchanged = all[8];
}
