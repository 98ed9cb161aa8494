// SPDX-License-Identifier: GPL-2.0-only
#include "hard_spheres/border_exchange.h"

using namespace LAMMPS_NS;

void BorderExchange::set_requests(const std::vector<ParticleRequest>& requests, int owned) {
  int ranks = 1;
  MPI_Comm_size(world_, &ranks);
  std::vector<int> received_counts(ranks, 0), sent_counts(ranks, 0);
  for (const ParticleRequest& request : requests) received_counts[request.owner]++;
  MPI_Alltoall(received_counts.data(), 1, MPI_INT, sent_counts.data(), 1, MPI_INT, world_);

  peers_.clear();
  std::vector<int> peer_by_rank(ranks, -1);
  for (int rank = 0; rank < ranks; rank++) {
    if (received_counts[rank] + sent_counts[rank] == 0) continue;
    peer_by_rank[rank] = static_cast<int>(peers_.size());
    peers_.push_back(rank);
  }
  std::vector<std::vector<int> > indices_by_peer(peers_.size());
  received_particles_.assign(peers_.size(), {});
  for (const ParticleRequest& request : requests) {
    indices_by_peer[peer_by_rank[request.owner]].push_back(request.index);
    received_particles_[peer_by_rank[request.owner]].push_back(request.local);
  }
  exchange(indices_by_peer, sent_particles_);
  receivers_.assign(owned, {});
  for (int p = 0; p < static_cast<int>(peers_.size()); p++)
    for (int slot = 0; slot < static_cast<int>(sent_particles_[p].size()); slot++)
      receivers_[sent_particles_[p][slot]].push_back({p, slot});
}
