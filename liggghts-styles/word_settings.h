// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_WORD_SETTINGS_H
#define COHESION_WORD_SETTINGS_H

#include <string>

#include "advice/stiffness_scaling.h"

class Settings;

namespace LAMMPS_NS {
class LAMMPS;
}

namespace LIGGGHTS {
namespace Cohesion {

/// Adds the keyword `scheme`, exact or sampled, to the settings of a cohesion model, as pair_style
/// gran/hamaker and gran/square_well of the LAMMPS package have it. model: who asks; exact: what
/// was chosen. `settings` must not outlive it.
void register_scheme(const LAMMPS_NS::LAMMPS* lmp, Settings& settings, const std::string& model,
                     bool& exact);

/// Adds the keyword `material_keep`, whose value goes to `keep`. `settings` must not outlive it.
void register_keep(Settings& settings, const std::string& model, cohesion::advice::Keep& keep);

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
