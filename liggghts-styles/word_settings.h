// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_WORD_SETTINGS_H
#define COHESION_WORD_SETTINGS_H

#include <string>

#include "contact/stiffness_scaling.h"

class Settings;

namespace LAMMPS_NS {
class FixWallGran;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace LIGGGHTS {
namespace Cohesion {

/// What a script specifies with the keyword `scheme`.
enum class SchemeChoice { none, exact, sampled };

/// Adds the keyword `scheme`, exact or sampled, to the settings of a cohesion model, as pair_style
/// gran/hamaker and gran/squarewell of the LAMMPS package have it. model: who asks. `settings`
/// must not outlive `choice`.
void register_scheme(const LAMMPS_NS::LAMMPS* lmp, Settings& settings, const std::string& model,
                     SchemeChoice& choice);

/// The scheme of a contact model, by what was specified and, if not empty, by an obstacle to scheme
/// exact: an error where exact was specified or scheme sampled does not exist, else sampled. What
/// is chosen without a keyword is printed; wall: null for pairs.
SchemeChoice scheme_of(LAMMPS_NS::LAMMPS* lmp, const std::string& model,
                       const LAMMPS_NS::FixWallGran* wall, SchemeChoice specified,
                       const std::string& obstacle, bool has_sampled);

/// Prints, where a restart file has been read, which scheme its contacts need: those of another
/// stop the engine with a message about the contact history.
void tell_of_restart_files(LAMMPS_NS::LAMMPS* lmp, const std::string& model);

/// Adds the keyword `material_keep`, whose value goes to `keep`. `settings` must not outlive it.
void register_keep(const LAMMPS_NS::LAMMPS* lmp, Settings& settings, const std::string& model,
                   cohesion::contact::Keep& keep);

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
