// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "event_stepping/pair_run.h"
#include "event_stepping/two_pass_contact.h"

namespace cohesion::event_stepping {

/// One contact with spins on a grid, as an engine moves it, and its tally of energies.
template <class Pair, int SIZE>
class PairOnGrid {
 public:
  TwoPassContact<Pair> contact;
  Body body[2];
  double dt;
  Vector3 x[2]{}, v[2]{}, spin[2]{};
  ContactMemory memory{};
  FollowedStep<SIZE> followed{};  ///< the last step that was followed
  bool alone = true;              ///< a young contact may last
  bool may_begin = true;          ///< to act by one force
  bool lasted = false;            ///< the last step was of one force
  ContactLosses now{};            ///< of the last step
  double lost = 0.0;
  double energy = 0.0;  ///< true and stored at the grid point of the last step, and lost before it
  double normal_impulse = 0.0;
  Vector3 tangential_impulse{}, by_contact{};

  PairOnGrid(const contact::ContactParameters& p, const contact::Adhesion& adhesion, const Body& i,
             const Body& j, double step)
      : contact(p, adhesion, i, j, step), body{i, j}, dt(step) {}

  PairMotion grid() const { return {{x[1] - x[0], v[1] - v[0]}, spin[0], spin[1]}; }
  PairMotion truth() const {
    const Action owed = contact.template owed<SIZE>(grid().relative, memory);
    PairOnGrid at = *this;
    at.give(owed);
    return at.grid();
  }

  void step() {
    const PairMotion grid = this->grid();
    const bool goes_on = memory.phase == ContactMemory::lasting;
    const bool begins = !goes_on && may_begin && contact.can_last(grid.relative, memory, alone);
    Action action;
    now = {};
    if (begins) energy = true_kinetic(memory) + sum(contact.stored(grid, memory)) + lost;
    lasted = (goes_on || begins) &&
             contact.one_force().template advance_lasting<SIZE>(grid, memory, action, &now, alone);
    if (goes_on && !lasted) contact.one_force().template end_lasting<SIZE>(grid, memory, &now);
    // Since the last grid point.
    if (goes_on || begins) lost += sum(now);
    if (!begins) energy = true_kinetic(memory) + sum(contact.stored(grid, memory)) + lost;
    Vector3 by_this;
    if (lasted) {
      by_this = contact.by_contact(grid, action);
    } else {
      const bool in_range = memory.in_range();
      const FollowedStart begin = contact.template start<SIZE>(grid, truth(), memory);
      followed = contact.template follow<SIZE>(begin, {}, {}, in_range);
      followed = contact.template follow<SIZE>(begin, {}, followed.rolled(), in_range);
      action = contact.template finish<SIZE>(begin, {}, followed, memory);
      now = contact.template losses<SIZE>(followed);
      lost += sum(now);
      by_this = contact.by_contact(begin, followed.normal, action);
    }
    const Vector3 normal = (1.0 / norm(grid.relative.separation)) * grid.relative.separation;
    by_contact += by_this;
    normal_impulse += dot(by_this, normal);
    tangential_impulse += by_this - dot(by_this, normal) * normal;
    give(action);
    for (int k = 0; k < 2; k++) x[k] += dt * v[k];
  }
  void steps(int number) {
    for (int n = 0; n < number; n++) step();
  }

  Vector3 momentum() const {
    return (1.0 / body[0].inverse_mass) * v[0] + (1.0 / body[1].inverse_mass) * v[1];
  }
  Vector3 angular_momentum() const {
    Vector3 sum;
    for (int k = 0; k < 2; k++)
      sum += (1.0 / body[k].inverse_mass) * cross(x[k], v[k]) +
             (1.0 / inverse_inertia(body[k])) * spin[k];
    return sum;
  }
  double kinetic() const {
    double sum = 0.0;
    for (int k = 0; k < 2; k++)
      if (body[k].inverse_mass > 0.0)
        sum += 0.5 / body[k].inverse_mass * dot(v[k], v[k]) +
               0.5 / inverse_inertia(body[k]) * dot(spin[k], spin[k]);
    return sum;
  }

 private:
  static double sum(const ContactLosses& a) {
    return a.normal_damping + a.tangential_damping + a.friction + a.rolling;
  }
  static double sum(const StoredEnergies& a) {
    return a.spring + a.tangential_spring + a.rolling_spring + a.adhesion;
  }
  double true_kinetic(const ContactMemory& owing) const {
    PairOnGrid at = *this;
    const ContactMemory known = contact.one_force().template at_grid_point<SIZE>(grid(), owing);
    at.give(contact.template owed<SIZE>(grid().relative, known));
    return at.kinetic();
  }
  void give(const Action& a) {
    v[0] -= body[0].inverse_mass * a.impulse;
    v[1] += body[1].inverse_mass * a.impulse;
    spin[0] += inverse_inertia(body[0]) * a.torque_i;
    spin[1] += inverse_inertia(body[1]) * a.torque_j;
  }
};

}  // namespace cohesion::event_stepping
