// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_partner_ids.h"

#include <mpi.h>
// The engine's headers want mpi.h before them.
#include <algorithm>

#include "atom.h"
#include "common/renumbering.h"
#include "fix_contact_history.h"
#include "force.h"
#include "liggghts_api.h"
#include "pair_gran.h"

namespace LIGGGHTS {
namespace Cohesion {

using namespace LAMMPS_NS;

/// The IDs of the partners of particle i, which the engine keeps to its own classes.
static int* partners(FixContactHistory& contacts, int i) {
  struct Partners : FixContactHistory {
    static int** all(FixContactHistory& contacts) { return contacts.*(&Partners::partner_); }
  };
  return Partners::all(contacts)[i];
}

FixPartnerIds::FixPartnerIds(LAMMPS* engine, int count, char** words) : Fix(engine, count, words) {
  create_attribute = 1;  // of particles that are inserted
  grow_arrays(atom->nmax);
  atom->add_callback(engine_api::GROW);
}

FixPartnerIds::~FixPartnerIds() { atom->delete_callback(id, engine_api::GROW); }

int FixPartnerIds::setmask() { return FixConst::PRE_NEIGHBOR; }

/// In a second run, before the engine uses the partners of the last run. A partner that is gone
/// gets the ID 0, which no particle has.
void FixPartnerIds::init() {
  if (!has_run_) return;
  const int particles = atom->nlocal;
  const Renumbering renumbering(lmp, {ids_.begin(), ids_.begin() + particles});
  auto* const pair = static_cast<PairGran*>(force->pair_match("gran", 1));
  FixContactHistory* const contacts = pair ? pair->get_fix_history() : nullptr;
  if (!renumbering.any() || !contacts) return;
  std::vector<tagint> partner_ids;
  for (int i = 0; i < particles; i++)
    for (int k = 0; k < contacts->n_partner(i); k++) partner_ids.push_back(contacts->partner(i, k));
  renumbering.translate(partner_ids);
  auto next = partner_ids.begin();
  for (int i = 0; i < particles; i++)
    for (int k = 0; k < contacts->n_partner(i); k++) partners(*contacts, i)[k] = *next++;
}

/// Follows set_arrays() for all particles, which the engine calls in the first set-up.
void FixPartnerIds::setup(int) {
  has_run_ = true;
  pre_neighbor();
}

void FixPartnerIds::pre_neighbor() { std::copy_n(atom->tag, atom->nlocal, ids_.begin()); }

void FixPartnerIds::grow_arrays(int most) { ids_.resize(most); }

void FixPartnerIds::copy_arrays(int i, int j, int) { ids_[j] = ids_[i]; }

void FixPartnerIds::set_arrays(int i) { ids_[i] = 0; }

int FixPartnerIds::pack_exchange(int i, double* buffer) {
  buffer[0] = ids_[i];
  return 1;
}

int FixPartnerIds::unpack_exchange(int i, double* buffer) {
  ids_[i] = static_cast<int>(buffer[0]);
  return 1;
}

double FixPartnerIds::memory_usage() { return sizeof(int) * static_cast<double>(ids_.size()); }

}  // namespace Cohesion
}  // namespace LIGGGHTS
