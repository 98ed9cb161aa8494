// SPDX-License-Identifier: GPL-2.0-only
#include "contact_step/contact_impulses.h"

#include <cstring>

using namespace LAMMPS_NS;

void ContactImpulses::begin_step(double kick, bool known) {
  kick_ = kick;
  known_ = known;
  ended_ = false;
}

/// Whether all numbers are 0: the first is, and each equals its successor bit by bit.
static bool all_zero(const double* numbers, int count) {
  return numbers[0] == 0.0 && std::memcmp(numbers, numbers + 1, (count - 1) * sizeof(double)) == 0;
}

void ContactImpulses::store_other(Numbers& before, const double* const* now, int particles) {
  const int n = 3 * particles;
  before.clear();
  if (n > 0 && !all_zero(now[0], n)) before.assign(now[0], now[0] + n);
}

void ContactImpulses::subtract_other(Numbers& before, const double* const* now, int particles) {
  const int n = 3 * particles;
  if (n > 0 && before.empty())
    before.assign(now[0], now[0] + n);
  else
    for (int k = 0; k < n; k++) before[k] = now[0][k] - before[k];
}

void ContactImpulses::begin_contacts() {
  if (!known_) return;
  store_other(forces_, atom->f, atom->nlocal);
  store_other(torques_, atom->torque, atom->nlocal);
}

void ContactImpulses::end_contacts() {
  if (!known_) return;
  subtract_other(forces_, atom->f, atom->nlocal);
  subtract_other(torques_, atom->torque, atom->nlocal);
  ended_ = true;
}
