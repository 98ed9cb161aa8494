// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_PLAUSIBLE_SIZES_H
#define COHESION_PLAUSIBLE_SIZES_H

#include <string>

namespace LAMMPS_NS {

// Lengths that cannot be meant, refused before the engine makes lists with them: of both engines.
// All ranks must call these; `where` stands in front of the messages.

/// "; lengths are those of 'units si'", behind a message about one.
std::string units_of_lengths(const class LAMMPS*);

/// Stops at particles that the box cannot hold, and in SI units at those that still have the size
/// and density they were created with beside much smaller ones; in others, where they may be meant,
/// it warns once.
void require_plausible_radii(class LAMMPS*, const std::string& where);

/// Stops where partners up to this distance of the centres would be found in very many images.
void require_plausible_range(class LAMMPS*, const std::string& where, double range);

}  // namespace LAMMPS_NS

#endif
