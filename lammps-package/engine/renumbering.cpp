// SPDX-License-Identifier: GPL-2.0-only
#include "engine/renumbering.h"

#include <unordered_map>

#include "atom.h"
#include "comm.h"

using namespace LAMMPS_NS;

Renumbering::Renumbering(LAMMPS* lammps, const std::vector<tagint>& before) : Pointers(lammps) {
  int mine = 0, all = 0;
  for (std::size_t i = 0; i < before.size(); i++) {
    if (before[i] != atom->tag[i]) mine = 1;
    if (before[i] != 0) own_.push_back({before[i], atom->tag[i]});
  }
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MAX, world);
  any_ = all != 0;
}

/// Every process sees the changes of all, one process after the other: none has them all at once.
void Renumbering::translate(std::vector<tagint>& ids) const {
  using Now = std::unordered_map<tagint, tagint>;
  Now now;
  for (const tagint id : ids) now[id] = 0;
  const auto look_up = [](int count, char* changes, void* of) {
    auto& wanted = *static_cast<Now*>(of);
    const auto* const first = reinterpret_cast<const Change*>(changes);
    for (const Change* c = first; c != first + count; c++) {
      const auto found = wanted.find(c->before);
      if (found != wanted.end()) found->second = c->now;
    }
  };
  std::vector<Change> sent = own_;
  comm->ring(static_cast<int>(sent.size()), sizeof(Change), sent.data(), 1, look_up, nullptr, &now);
  for (tagint& id : ids) id = now[id];
}
