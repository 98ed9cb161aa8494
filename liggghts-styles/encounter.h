// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_ENCOUNTER_H
#define COHESION_ENCOUNTER_H

#include "contact_interface.h"
#include "contact_model_constants.h"

namespace LIGGGHTS {
namespace Cohesion {

/// Two spheres, or a sphere and a wall, as a cohesion model sees them.
struct Encounter {
  const ContactModels::SurfacesCloseData& data;
  const double* normal;  ///< from j, or the wall, to i
  double gap;            ///< between the surfaces, negative: overlap, [length]
};

/// Without this flag the engine forgets the contact when it makes a new list.
inline void remember(const ContactModels::SurfacesCloseData& d, bool something) {
  if (!d.contact_flags) return;
  if (something)
    *d.contact_flags |= ContactModels::CONTACT_COHESION_MODEL;
  else
    *d.contact_flags &= ~ContactModels::CONTACT_COHESION_MODEL;
}

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
