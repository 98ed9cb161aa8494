// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CONTACT_ADVICE_H
#define COHESION_CONTACT_ADVICE_H

#include <string>
#include <vector>

#include "advice/contact_report.h"
#include "contact/contact_parameters.h"
#include "lammps.h"

namespace LAMMPS_NS {

using cohesion::advice::AdvisedContact;
using cohesion::advice::LightestParticle;

/// By type, index 0 unused, over all ranks.
std::vector<LightestParticle> lightest_particles(LAMMPS*, const class FixEventStep&);

/// A contact between these two; without springs when neither moves.
AdvisedContact advised_contact(const std::string& name, const LightestParticle& i,
                               const LightestParticle& j,
                               const cohesion::contact::ContactParameters&,
                               const cohesion::contact::Adhesion&);

/// Prints the table of numbers that decide whether the run can be right, warns where one says that
/// it will not be, and stops LAMMPS where one says that it must blow up (advice/contact_report.h).
/// For the set-up of a run, when all forces are zero.
void advise(LAMMPS*, const std::string& style, const cohesion::advice::SchemeLimits&,
            const std::vector<AdvisedContact>&);

}  // namespace LAMMPS_NS

#endif
