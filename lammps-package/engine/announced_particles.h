// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_ANNOUNCED_PARTICLES_H
#define COHESION_ANNOUNCED_PARTICLES_H

#include <vector>

#include "lammps.h"

namespace LAMMPS_NS {

/// A particle that a fix will bring.
struct AnnouncedParticle {
  int type;
  int mask;       ///< groups that it will belong to
  double radius;  ///< [length]
  double mass;    ///< [mass]
};

/// Of what each fix pour and fix deposit brings, the smallest and lightest of each kind.
std::vector<AnnouncedParticle> announced_particles(LAMMPS*);

}  // namespace LAMMPS_NS

#endif
