// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_FLIGHT_REPORT_H
#define COHESION_FLIGHT_REPORT_H

#include <string>

namespace LAMMPS_NS {

/// Describes for a message a particle or ghost of this rank that flies too far in a step: which it
/// is, where, how fast; and which particle it overlaps, if that is deeper than collisions explain,
/// or else which one it collides with and which two of the rank overlap most. Searches all
/// particles of the rank: for errors alone.
std::string report_flight(const class LAMMPS*, int i);

/// Describes the fastest particle or ghost, by its velocity beyond the mean flow of a sheared box.
std::string report_fastest(const class LAMMPS*);

}  // namespace LAMMPS_NS

#endif
