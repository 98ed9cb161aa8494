// SPDX-License-Identifier: GPL-2.0-only
#include "border_exchange.h"

using namespace LAMMPS_NS;

void BorderExchange::plan(const std::vector<Request>& requests, int owned) {
  int ranks = 1;
  MPI_Comm_size(world_, &ranks);
  std::vector<int> requested(ranks, 0), followed(ranks, 0);
  for (const Request& request : requests) requested[request.owner]++;
  MPI_Alltoall(requested.data(), 1, MPI_INT, followed.data(), 1, MPI_INT, world_);

  peers_.clear();
  std::vector<int> peer_of(ranks, -1);
  for (int rank = 0; rank < ranks; rank++) {
    if (requested[rank] + followed[rank] == 0) continue;
    peer_of[rank] = static_cast<int>(peers_.size());
    peers_.push_back(rank);
  }
  std::vector<std::vector<int> > requests_by_peer(peers_.size());
  requested_.assign(peers_.size(), {});
  for (const Request& request : requests) {
    requests_by_peer[peer_of[request.owner]].push_back(request.index);
    requested_[peer_of[request.owner]].push_back(request.local);
  }
  exchange(requests_by_peer, followed_);
  followers_.assign(owned, {});
  for (int p = 0; p < static_cast<int>(peers_.size()); p++)
    for (int slot = 0; slot < static_cast<int>(followed_[p].size()); slot++)
      followers_[followed_[p][slot]].push_back({p, slot});
}
