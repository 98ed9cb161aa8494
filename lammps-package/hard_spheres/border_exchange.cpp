// SPDX-License-Identifier: GPL-2.0-only
#include "border_exchange.h"

using namespace LAMMPS_NS;

void BorderExchange::plan(const std::vector<Request>& requests, int owned) {
  int ranks = 1;
  MPI_Comm_size(world_, &ranks);
  std::vector<int> wanted(ranks, 0), given(ranks, 0);
  for (const Request& request : requests) wanted[request.owner]++;
  MPI_Alltoall(wanted.data(), 1, MPI_INT, given.data(), 1, MPI_INT, world_);

  peers_.clear();
  std::vector<int> peer_of(ranks, -1);
  for (int rank = 0; rank < ranks; rank++) {
    if (wanted[rank] + given[rank] == 0) continue;
    peer_of[rank] = static_cast<int>(peers_.size());
    peers_.push_back(rank);
  }
  std::vector<std::vector<int> > ask(peers_.size());
  asked_.assign(peers_.size(), {});
  for (const Request& request : requests) {
    ask[peer_of[request.owner]].push_back(request.index);
    asked_[peer_of[request.owner]].push_back(request.local);
  }
  swap(ask, told_);
  followers_.assign(owned, {});
  for (int p = 0; p < static_cast<int>(peers_.size()); p++)
    for (int slot = 0; slot < static_cast<int>(told_[p].size()); slot++)
      followers_[told_[p][slot]].push_back({p, slot});
}
