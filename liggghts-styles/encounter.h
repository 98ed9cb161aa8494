// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_ENCOUNTER_H
#define COHESION_ENCOUNTER_H

#include "contact_interface.h"

namespace LIGGGHTS {
namespace Cohesion {

/// Two spheres, or a sphere and a wall, as a cohesion model sees them.
struct Encounter {
  const ContactModels::SurfacesCloseData& data;
  const double* normal;  ///< from j, or the wall, to i
  double gap;            ///< between the surfaces, negative: overlap, [length]
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
