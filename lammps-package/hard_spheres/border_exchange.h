// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_BORDER_EXCHANGE_H
#define COHESION_BORDER_EXCHANGE_H

#include <mpi.h>

#include <vector>

namespace LAMMPS_NS {

/// Sends data of particles from the processes that own them to those that have requested them.
///
/// A process requests particles by owner and index there; its request number n to an owner is slot
/// n of the messages between both.
class BorderExchange {
 public:
  explicit BorderExchange(MPI_Comm world) : world_(world) {}

  struct Request {
    int owner;
    int index;  ///< of the particle on its owner
    int local;  ///< number of the particle on the process that requests it
  };
  /// A process that has requested an own particle, and the slot of the particle there.
  struct Follower {
    int peer;  ///< index into peers()
    int slot;
  };

  /// Collective: replaces the requests. `owned`: number of own particles.
  void plan(const std::vector<Request>&, int owned);

  /// The processes that have requested particles of this one, or the reverse.
  const std::vector<int>& peers() const { return peers_; }
  const std::vector<Follower>& followers(int index) const { return followers_[index]; }
  /// The own particles that a peer has requested, by slot.
  const std::vector<int>& followed_by(int peer) const { return followed_[peer]; }
  /// The number here of the particle in a slot of a peer.
  int local(int peer, int slot) const { return requested_[peer][slot]; }

  /// Collective among peers: sends `out[peer]` to each peer and receives `in[peer]` from it.
  template <class Item>
  void exchange(const std::vector<std::vector<Item> >& out, std::vector<std::vector<Item> >& in);

 private:
  /// The tag of the messages of exchange(). Neither side sends others to a peer meanwhile: every
  /// process waits in exchange() for all of its peers.
  static constexpr int TAG = 0;

  MPI_Comm world_;
  std::vector<int> peers_;
  std::vector<std::vector<int> > requested_;       // by peer: local names by slot
  std::vector<std::vector<int> > followed_;        // by peer: own particles by slot
  std::vector<std::vector<Follower> > followers_;  // by own particle
};

template <class Item>
void BorderExchange::exchange(const std::vector<std::vector<Item> >& out,
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
