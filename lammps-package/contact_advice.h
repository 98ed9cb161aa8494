// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CONTACT_ADVICE_H
#define COHESION_CONTACT_ADVICE_H

#include <string>
#include <vector>

#include "advice/contact_advice.h"
#include "contact/contact_parameters.h"
#include "lammps.h"

namespace LAMMPS_NS {

/// The smallest particle of a type, and the lightest that moves: its contacts are the shortest.
struct LightestParticle {
  double radius;  ///< [length]; infinite for a wall and for a type without particles
  double mass;    ///< [mass]; infinite for a wall and for a type that does not move
};

/// By type, index 0 unused, over all ranks.
std::vector<LightestParticle> lightest_particles(LAMMPS*, const class FixEventStep&);

/// One contact that a run may see.
struct AdvisedContact {
  std::string name;
  LightestParticle i, j;
  cohesion::contact::ContactParameters contact;
  cohesion::contact::Adhesion adhesion;
};

/// Prints the table of numbers that decide whether the run can be right, warns where one says that
/// it will not be, and stops LAMMPS where one says that it must blow up. Approach speed: that of
/// the fastest particle, or of one that falls through its own diameter. For the set-up of a run,
/// when all forces are zero.
void advise(LAMMPS*, const std::string& style, const cohesion::advice::SchemeLimits&,
            const std::vector<AdvisedContact>&);

}  // namespace LAMMPS_NS

#endif
