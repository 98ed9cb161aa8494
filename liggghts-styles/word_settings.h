// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_WORD_SETTINGS_H
#define COHESION_WORD_SETTINGS_H

#include <string>

#include "advice/stiffness_scaling.h"

class Settings;

namespace LIGGGHTS {
namespace Cohesion {

/// Adds the keyword `scheme`, event or sampled, to the settings of a cohesion model, as pair_style
/// gran/hamaker and gran/square_well of the LAMMPS package have it. model: who asks; event: what
/// was chosen. `settings` must not outlive it.
void register_scheme(Settings& settings, const std::string& model, bool& event);

/// Adds the keyword `material_keep`, whose value goes to `keep`. `settings` must not outlive it.
void register_keep(Settings& settings, const std::string& model, cohesion::advice::Keep& keep);

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
