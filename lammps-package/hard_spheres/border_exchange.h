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
  /// Of the messages of swap(). Neither side sends others to a peer meanwhile: every process waits
  /// in swap() for all of its peers.
  static constexpr int TAG = 0;

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
  std::vector<MPI_Request> sent(n);
  for (int p = 0; p < n; p++)
    MPI_Isend(out[p].data(), static_cast<int>(out[p].size() * sizeof(Item)), MPI_BYTE, peers_[p],
              TAG, world_, &sent[p]);
  for (int p = 0; p < n; p++) {
    MPI_Status status;
    int bytes = 0;
    MPI_Probe(peers_[p], TAG, world_, &status);
    MPI_Get_count(&status, MPI_BYTE, &bytes);
    in[p].resize(bytes / sizeof(Item));
    // A message that is no whole number of items does not fit, and MPI stops the run.
    MPI_Recv(in[p].data(), static_cast<int>(in[p].size() * sizeof(Item)), MPI_BYTE, peers_[p], TAG,
             world_, MPI_STATUS_IGNORE);
  }
  MPI_Waitall(n, sent.data(), MPI_STATUSES_IGNORE);
}

}  // namespace LAMMPS_NS

#endif
