// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_BOX_SHEAR_H
#define COHESION_BOX_SHEAR_H

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "lammps.h"
#include "shear/nonaffine_displacements.h"
#include "vector3.h"

// The shear of the engine's box, where particles that leave it through a sheared face change their
// velocity; without that the box may be deformed, but its images do not shear.

namespace LAMMPS_NS {

inline double middle_height(const Domain* domain) {
  return 0.5 * (domain->boxlo[1] + domain->boxhi[1]);
}

/// The shear of the box as a rate, [1/time].
inline cohesion::shear::BoxShear rate_of_shear(const Domain* domain) {
  return {domain->deform_vremap ? domain->h_rate[5] / domain->yprd : 0.0, middle_height(domain)};
}

/// The number of particles and ghosts of this rank, the first ones, that move as no other of them
/// does: on one rank ghosts move as their owners do while the box stays as it is.
inline int number_of_movers(const LAMMPS* lmp) {
  const bool alone = lmp->comm->nprocs == 1 && !lmp->domain->box_change;
  return alone ? lmp->atom->nlocal : lmp->atom->nlocal + lmp->atom->nghost;
}

/// Speed of the fastest of the first `count` particles, beyond the mean flow of a sheared box,
/// [length/time].
inline double fastest_of(const Atom* atom, const Domain* domain, int count) {
  const double* const x = count > 0 ? atom->x[0] : nullptr;
  const double* const v = count > 0 ? atom->v[0] : nullptr;
  const cohesion::shear::BoxShear flow = rate_of_shear(domain);
  double squared = 0.0;
  const auto consider = [&squared](double along, double up, double across) {
    squared = std::max(squared, along * along + up * up + across * across);
  };
  if (flow.amount == 0.0)
    for (int i = 0; i < 3 * count; i += 3) consider(v[i], v[i + 1], v[i + 2]);
  else
    for (int i = 0; i < 3 * count; i += 3)
      consider(flow.nonaffine(v[i], x[i + 1]), v[i + 1], v[i + 2]);
  return std::sqrt(squared);
}

/// The shear of the box from the time when a list of neighbours was made to a time `ago` [time]
/// before now.
inline cohesion::shear::BoxShear shear_since(const cohesion::shear::NonaffineDisplacements& list,
                                             const Domain* domain, double ago = 0.0) {
  if (!domain->deform_vremap) return {0.0, middle_height(domain)};
  return list.shear_since_reference(domain->xy - ago * domain->h_rate[5], domain->yprd,
                                    middle_height(domain));
}

/// Whether x is in the box along each periodic axis, or at most so many boxes outside.
inline bool in_box(Domain* domain, double* x, double boxes = 0.0) {
  double place[3];
  if (domain->triclinic) domain->x2lamda(x, place);
  const double* const at = domain->triclinic ? place : x;
  const double* const low = domain->triclinic ? domain->boxlo_lamda : domain->boxlo;
  const double* const high = domain->triclinic ? domain->boxhi_lamda : domain->boxhi;
  for (int k = 0; k < 3; k++) {
    const double outside = boxes * (high[k] - low[k]);
    if (domain->periodicity[k] && (at[k] < low[k] - outside || at[k] >= high[k] + outside))
      return false;
  }
  return true;
}

/// Boxes along each axis that a particle has crossed between two image flags. The difference is
/// taken modulo the range of image flags, which overflow.
inline cohesion::Vector3 boxes_between(imageint now, imageint before) {
  const auto along = [&](int shift) {
    const imageint difference = (now >> shift & IMGMASK) - (before >> shift & IMGMASK);
    return static_cast<double>(((difference + IMGMAX) & IMGMASK) - IMGMAX);
  };
  return {along(0), along(IMGBITS), along(IMG2BITS)};
}

/// Wraps own particles outside the box into it, with the velocity of the image that they become, as
/// the engine does when it makes lists: for restart files the engine wraps them with the velocity
/// that they have. All others stay as they are, to the last digit, and those at most `boxes`
/// outside.
inline void wrap_into_box(Atom* atom, Domain* domain, double boxes = 0.0) {
  const double* const rate = domain->h_rate;
  for (int i = 0; i < atom->nlocal; i++) {
    if (in_box(domain, atom->x[i], boxes)) continue;
    const imageint before = atom->image[i];
    domain->remap(atom->x[i], atom->image[i]);
    if (!domain->deform_vremap || !(atom->mask[i] & domain->deform_groupbit)) continue;
    const cohesion::Vector3 crossed = boxes_between(atom->image[i], before);
    double* const v = atom->v[i];
    v[0] -= rate[0] * crossed.x + rate[5] * crossed.y + rate[4] * crossed.z;
    v[1] -= rate[1] * crossed.y + rate[3] * crossed.z;
    v[2] -= rate[2] * crossed.z;
  }
}

/// While an object of this class lives, the own particles that wrap_into_box() has moved since the
/// list of neighbours was made are unwrapped: where ghosts and pairs of that list see them, with
/// the velocity that they had there.
class ScopedUnwrap {
 public:
  /// `listed`: image flags of the own particles when the list was made.
  ScopedUnwrap(Atom* atom, const Domain* domain, const std::vector<imageint>& listed)
      : atom_(atom) {
    if (static_cast<int>(listed.size()) != atom->nlocal) return;
    for (int i = 0; i < atom->nlocal; i++)
      if (atom->image[i] != listed[i]) unwrap(domain, i, listed[i]);
  }
  ~ScopedUnwrap() {
    for (const Moved& was : moved_) {
      std::copy_n(was.x, 3, atom_->x[was.i]);
      atom_->v[was.i][0] = was.vx;
    }
  }
  ScopedUnwrap(const ScopedUnwrap&) = delete;
  ScopedUnwrap& operator=(const ScopedUnwrap&) = delete;

 private:
  struct Moved {
    int i;
    double x[3], vx;
  };

  void unwrap(const Domain* domain, int i, imageint listed) {
    double* const x = atom_->x[i];
    moved_.push_back({i, {x[0], x[1], x[2]}, atom_->v[i][0]});
    const cohesion::Vector3 boxes = boxes_between(atom_->image[i], listed);
    const double* const h = domain->h;
    x[0] += h[0] * boxes.x + h[5] * boxes.y + h[4] * boxes.z;
    x[1] += h[1] * boxes.y + h[3] * boxes.z;
    x[2] += h[2] * boxes.z;
    if (domain->deform_vremap && (atom_->mask[i] & domain->deform_groupbit))
      atom_->v[i][0] += boxes.y * domain->h_rate[5];
  }

  Atom* atom_;
  std::vector<Moved> moved_;
};

}  // namespace LAMMPS_NS

#endif
