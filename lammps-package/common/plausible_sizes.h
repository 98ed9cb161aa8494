// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_PLAUSIBLE_SIZES_H
#define COHESION_PLAUSIBLE_SIZES_H

#include <string>

#include "advice/si_units.h"

namespace LAMMPS_NS {

// Units, lengths, masses and time steps that cannot be meant, refused before the engine makes lists
// with them: of both engines. All ranks must call these; `where` stands in front of the messages.

/// Those of the script; null: they stand for any, or are not known.
const cohesion::advice::SiUnits* si_units(const class LAMMPS*);

/// Stops in units in which force is not mass times acceleration: the laws of this package convert
/// nothing.
void require_mechanical_units(const class LAMMPS*, const std::string& where);

/// Stops at a time step that is not above zero: contacts and events act over the length of a step.
void require_time_step(const class LAMMPS*, const std::string& where);

/// "; lengths are those of 'units si'", behind a message about one.
std::string units_of_lengths(const class LAMMPS*);

/// Stops in other than mechanical units; at particles that the box cannot hold; in SI units at
/// those that still have the size and density they were created with beside much smaller ones (in
/// others, where they may be meant, it warns once); and at masses that are of a diameter of 1, or
/// that no density was set for.
void require_plausible_spheres(class LAMMPS*, const std::string& where);

/// Stops where partners up to this distance of the centres would be found in very many images.
void require_plausible_range(class LAMMPS*, const std::string& where, double range);

}  // namespace LAMMPS_NS

#endif
