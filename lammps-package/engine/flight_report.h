// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_FLIGHT_REPORT_H
#define COHESION_FLIGHT_REPORT_H

#include <string>

namespace LAMMPS_NS {

/// What a message says of a particle or ghost of this rank that flies too far in a step: which it
/// is, where, how fast; and into whom it is pressed, if that is deep enough to be the reason, or
/// else which two of the rank are pressed deepest.
/// Searches all particles of the rank: for errors alone.
std::string report_flight(const class LAMMPS*, int i);

/// The same of the fastest, particles and ghosts, beyond the mean flow of a sheared box.
std::string report_fastest(const class LAMMPS*);

}  // namespace LAMMPS_NS

#endif
