// SPDX-License-Identifier: GPL-2.0-only
#include "contact_step/altered_particles.h"

#include <algorithm>
#include <cmath>

#include "domain.h"

using namespace LAMMPS_NS;
using cohesion::vector;
using cohesion::Vector3;

void AlteredParticles::save(int i, double* values) const {
  std::copy_n(atom->x[i], 3, values);
  values[3] = atom->radius[i];
  values[4] = atom->type[i];
  save_id(i, values);
}

bool AlteredParticles::compare(int i, const double* saved) {
  const Vector3 by = vector(atom->x[i]) - vector(saved);
  const bool other = atom->radius[i] != saved[3] || atom->type[i] != saved[4];
  by_[i] = {by.x, by.y, by.z, other ? 1.0 : 0.0};
  return other || is_displaced(by);
}

/// The engine wraps particles into the box when a run begins: displacements by whole boxes do not
/// count. In a tilted box it transforms coordinates there and back, with a rounding of some 2^-53
/// of the box.
bool AlteredParticles::is_displaced(const Vector3& by) const {
  constexpr double rounding = 1e-13;
  const double* const h = domain->h;
  double d[3] = {by.x, by.y, by.z};
  const auto boxes = [&](int k) {
    return domain->periodicity[k] ? std::nearbyint(d[k] / h[k]) : 0.0;
  };
  const double along_z = boxes(2);
  d[0] -= along_z * h[4];
  d[1] -= along_z * h[3];
  d[2] -= along_z * h[2];
  const double along_y = boxes(1);
  d[0] -= along_y * h[5];
  d[1] -= along_y * h[1];
  d[0] -= boxes(0) * h[0];
  return norm(vector(d)) > rounding * std::max({h[0], h[1], h[2]});
}

bool AlteredParticles::is_altered(int i, int j) const {
  if (by_.empty()) return false;
  const Alteration& of_i = by_[i];
  if (j < 0) return of_i[3] != 0.0 || is_displaced(vector(of_i.data()));
  const Alteration& of_j = by_[j];
  // A ghost may be an image through a side of the box, which the script may have moved.
  if (j >= atom->nlocal && box_.moves_image(domain, atom->x[j])) return true;
  return of_i[3] != 0.0 || of_j[3] != 0.0 ||
         is_displaced(vector(of_j.data()) - vector(of_i.data()));
}
