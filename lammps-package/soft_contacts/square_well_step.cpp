// SPDX-License-Identifier: GPL-2.0-only
// The steps of pair_style gran/squarewell in scheme exact, and of squarewell, the well alone.
#include "contact_solver/square_well_solver.h"
#include "soft_contacts/pair_contacts_step.h"

namespace solver = cohesion::contact_solver;

template class LAMMPS_NS::PairContacts<solver::ExactContact<solver::SquareWellSolver>>;
template class LAMMPS_NS::PairContacts<solver::ExactContact<solver::WellEdgeSolver>>;
