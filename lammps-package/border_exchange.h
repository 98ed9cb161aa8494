// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_BORDER_EXCHANGE_H
#define COHESION_BORDER_EXCHANGE_H

#include <mpi.h>

#include <vector>

namespace LAMMPS_NS {

/// Brings news of particles from their owners to the processes that have said they need them.
///
/// A process asks for particles by owner and index there; request number n of a process towards an
/// owner is the n-th answer slot on both sides.
class BorderExchange {
 public:
  explicit BorderExchange(MPI_Comm world) : world_(world) {}

  struct Request {
    int owner;
    int index;  ///< of the particle on its owner
    int local;  ///< what the asking process calls it
  };
  /// Who needs an own particle, and its slot there.
  struct Follower {
    int peer;  ///< index into peers()
    int slot;
  };

  /// Collective. `owned`: number of own particles.
  void plan(const std::vector<Request>&, int owned);

  /// Processes that need something of this one or the reverse.
  const std::vector<int>& peers() const { return peers_; }
  const std::vector<Follower>& followers(int index) const { return followers_[index]; }
  /// Own particles that a peer follows, by slot.
  const std::vector<int>& told(int peer) const { return told_[peer]; }
  int local(int peer, int slot) const { return asked_[peer][slot]; }

  /// Sends `out[peer]` to each peer; `in[peer]` is what came from it.
  template <class Item>
  void swap(const std::vector<std::vector<Item> >& out, std::vector<std::vector<Item> >& in);

 private:
  MPI_Comm world_;
  std::vector<int> peers_;
  std::vector<std::vector<int> > asked_;           // by peer: local names by slot
  std::vector<std::vector<int> > told_;            // by peer: own particles by slot
  std::vector<std::vector<Follower> > followers_;  // by own particle
};

template <class Item>
void BorderExchange::swap(const std::vector<std::vector<Item> >& out,
                          std::vector<std::vector<Item> >& in) {
  const int n = static_cast<int>(peers_.size());
  in.resize(n);
  std::vector<int> sizes(2 * n);
  std::vector<MPI_Request> requests(2 * n);
  for (int p = 0; p < n; p++) {
    sizes[n + p] = static_cast<int>(out[p].size());
    MPI_Irecv(&sizes[p], 1, MPI_INT, peers_[p], 0, world_, &requests[p]);
    MPI_Isend(&sizes[n + p], 1, MPI_INT, peers_[p], 0, world_, &requests[n + p]);
  }
  MPI_Waitall(2 * n, requests.data(), MPI_STATUSES_IGNORE);
  const auto bytes = [](int items) { return items * static_cast<int>(sizeof(Item)); };
  for (int p = 0; p < n; p++) {
    in[p].resize(sizes[p]);
    MPI_Irecv(in[p].data(), bytes(sizes[p]), MPI_BYTE, peers_[p], 1, world_, &requests[p]);
    MPI_Isend(out[p].data(), bytes(sizes[n + p]), MPI_BYTE, peers_[p], 1, world_, &requests[n + p]);
  }
  MPI_Waitall(2 * n, requests.data(), MPI_STATUSES_IGNORE);
}

}  // namespace LAMMPS_NS

#endif
