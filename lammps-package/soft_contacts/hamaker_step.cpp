// SPDX-License-Identifier: GPL-2.0-only
// The steps of pair_style gran/hamaker in scheme exact.
#include "contact_solver/contact_solver.h"
#include "soft_contacts/pair_contacts_step.h"

namespace solver = cohesion::contact_solver;

template class LAMMPS_NS::PairContacts<solver::ExactContact<solver::ContactSolver>>;
