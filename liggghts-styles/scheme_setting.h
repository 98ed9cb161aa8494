// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_SCHEME_SETTING_H
#define COHESION_SCHEME_SETTING_H

#include <string>

class Settings;

namespace LIGGGHTS {
namespace Cohesion {

/// Adds the keyword `scheme` to the settings of a cohesion model: what LIGGGHTS can carry of what
/// pair_style gran/hamaker and gran/square_well of the LAMMPS package know. model: who asks.
void register_scheme(Settings& settings, const std::string& model);

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
