// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_FIX_RESTART_CONTACTS_H
#define COHESION_FIX_RESTART_CONTACTS_H

#include "fix.h"

namespace LIGGGHTS {
namespace Cohesion {

/// Brings the contacts of pairs into the files of `restart N` as they are at the end of the step.
/// The engine writes copies that it makes when lists are built, before the forces of that step;
/// contacts with walls are written as they are. Hidden (hidden_fix.h).
class FixRestartContacts : public LAMMPS_NS::Fix {
 public:
  static constexpr const char* STYLE = "cohesion_restart_contacts";

  FixRestartContacts(LAMMPS_NS::LAMMPS* engine, int count, char** words);

  int setmask() override;
  void end_of_step() override;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
