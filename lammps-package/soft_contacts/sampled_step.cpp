// SPDX-License-Identifier: GPL-2.0-only
// The steps of all laws in scheme sampled.
#include "sampled_contact/sampled_bridge.h"
#include "sampled_contact/sampled_contact.h"
#include "sampled_contact/sampled_hamaker.h"
#include "sampled_contact/sampled_well.h"
#include "soft_contacts/pair_contacts_step.h"

namespace sampled = cohesion::sampled_contact;

template class LAMMPS_NS::PairContacts<sampled::SampledContact<sampled::SampledHamaker>>;
template class LAMMPS_NS::PairContacts<sampled::SampledContact<sampled::SampledWell>>;
template class LAMMPS_NS::PairContacts<sampled::SampledContact<sampled::SampledBridge>>;
