// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_restart_contacts.h"

#include <mpi.h>
// The engine's headers want mpi.h before them.
#include "fix_contact_history.h"
#include "force.h"
#include "liggghts_api.h"
#include "pair_gran.h"

namespace LIGGGHTS {
namespace Cohesion {

using namespace LAMMPS_NS;

FixRestartContacts::FixRestartContacts(LAMMPS* engine, int count, char** words)
    : Fix(engine, count, words) {
  nevery = 1;
}

int FixRestartContacts::setmask() { return FixConst::END_OF_STEP; }

/// The engine reads the copies nowhere else before it makes them anew.
void FixRestartContacts::end_of_step() {
  if (!engine_api::writes_restart(output, update->ntimestep)) return;
  auto* const pair = static_cast<PairGran*>(force->pair_match("gran", 1));
  if (FixContactHistory* const contacts = pair ? pair->get_fix_history() : nullptr)
    contacts->pre_exchange();
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
