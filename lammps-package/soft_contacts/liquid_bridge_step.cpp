// SPDX-License-Identifier: GPL-2.0-only
// The steps of pair_style gran/liquidbridge in scheme exact.
#include "contact_solver/liquid_bridge_solver.h"
#include "soft_contacts/pair_contacts_step.h"

namespace solver = cohesion::contact_solver;

template class LAMMPS_NS::PairContacts<solver::ExactContact<solver::LiquidBridgeSolver>>;
