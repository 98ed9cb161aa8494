// SPDX-License-Identifier: GPL-2.0-only
#include "contact_impulses.h"

using namespace LAMMPS_NS;

void ContactImpulses::begin_step(double kick, bool summed) {
  kick_ = kick;
  summed_ = summed;
  handed_over_ = false;
  if (!summed) return;
  impulses_.assign(atom->nlocal, {});
  turns_.assign(atom->nlocal, {});
}

void ContactImpulses::hand_over(bool what_was_summed) {
  handed_over_ = true;
  const int n = 3 * atom->nlocal;
  if (!what_was_summed || n == 0) return;
  double* const f = atom->f[0];
  double* const torque = atom->torque[0];
  const double* const pushed = &impulses_[0].x;
  const double* const turned = &turns_[0].x;
  for (int k = 0; k < n; k++) f[k] += kick_ * pushed[k];
  for (int k = 0; k < n; k++) torque[k] += kick_ * turned[k];
}

void ContactImpulses::note_others(double* forces) const {
  const int n = 3 * atom->nlocal;
  if (n == 0) return;
  const double* const f = atom->f[0];
  const double* const pushed = &impulses_[0].x;
  for (int k = 0; k < n; k++) forces[k] = f[k] - kick_ * pushed[k];
}
