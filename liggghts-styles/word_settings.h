// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_WORD_SETTINGS_H
#define COHESION_WORD_SETTINGS_H

#include <string>

#include "advice/stiffness_scaling.h"

class Settings;

namespace LIGGGHTS {
namespace Cohesion {

/// Adds the keyword `scheme` to the settings of a cohesion model: what LIGGGHTS can carry of what
/// pair_style gran/hamaker and gran/square_well of the LAMMPS package know. model: who asks.
void register_scheme(Settings& settings, const std::string& model);

/// Adds the keyword `material_keep`, whose value goes to `keep`. `settings` must not outlive it.
void register_keep(Settings& settings, const std::string& model, cohesion::advice::Keep& keep);

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
