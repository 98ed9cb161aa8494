// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_BORDER_EXCHANGE_H
#define COHESION_BORDER_EXCHANGE_H

#include <mpi.h>

#include <vector>

namespace LAMMPS_NS {

/// Sends data of particles from the processes that own them to those that have requested them.
///
/// A process requests particles by owner and index there. Its request number n to an owner is slot
/// n of the messages between both.
class BorderExchange {
 public:
  explicit BorderExchange(MPI_Comm world) : world_(world) {}

  struct ParticleRequest {
    int owner;
    int index;  ///< of the particle on its owner
    int local;  ///< number of the particle on the process that requests it
  };
  /// A process that has requested an own particle, and the slot of the particle there.
  struct Receiver {
    int peer;  ///< index into peers()
    int slot;
  };

  /// Collective: replaces the requests. `owned`: number of own particles.
  void set_requests(const std::vector<ParticleRequest>&, int owned);

  /// The processes that have requested particles of this one, or the reverse.
  const std::vector<int>& peers() const { return peers_; }
  /// The processes that have requested the own particle `index`.
  const std::vector<Receiver>& receivers(int index) const { return receivers_[index]; }
  /// The own particles that a peer has requested, by slot.
  const std::vector<int>& sent_particles(int peer) const { return sent_particles_[peer]; }
  /// The number on this process of the particle in a slot of a peer.
  int received_particle(int peer, int slot) const { return received_particles_[peer][slot]; }

  /// Collective among peers: sends `out[peer]` to each peer and receives `in[peer]` from it.
  template <class Item>
  void exchange(const std::vector<std::vector<Item> >& out, std::vector<std::vector<Item> >& in);

 private:
  /// The tag of the messages of exchange(). Both sides wait in exchange() for all their peers, so
  /// that no other message with this tag is on its way.
  static constexpr int TAG = 0;

  MPI_Comm world_;
  std::vector<int> peers_;
  std::vector<std::vector<int> > received_particles_;  // by peer and slot: number here
  std::vector<std::vector<int> > sent_particles_;      // by peer and slot: own particle
  std::vector<std::vector<Receiver> > receivers_;      // by own particle
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
    // MPI stops the run if the message is not a whole number of items.
    MPI_Recv(in[p].data(), static_cast<int>(in[p].size() * sizeof(Item)), MPI_BYTE, peers_[p], TAG,
             world_, MPI_STATUS_IGNORE);
  }
  MPI_Waitall(n, sent.data(), MPI_STATUSES_IGNORE);
}

}  // namespace LAMMPS_NS

#endif
